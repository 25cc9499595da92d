#!/usr/bin/env bash
# Runs rollcon-bench and rewrites docs/accuracy.md and its plots.
#   scripts/accuracy.sh [--quick] [BUILD_DIR]     (build/accuracy unless given)
set -euo pipefail
cd "$(dirname "$0")/.."
quick=()
command="scripts/accuracy.sh"
if [[ "${1:-}" == "--quick" ]]; then
  quick=(--quick)
  command+=" --quick"
  shift
fi
build="${1:-build/accuracy}"

mkdir -p "$build"
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DROLLCON_BENCH=ON -DROLLCON_TESTS=OFF \
  -DROLLCON_EXAMPLES=OFF -DROLLCON_FORTRAN=OFF > "$build/configure.log" 2>&1 \
  || { cat "$build/configure.log"; exit 1; }
cmake --build "$build" --target rollcon-bench -j "$(nproc)"
bench=$(find "$build" -name rollcon-bench -type f -perm -u+x | head -n 1)
export OPENBLAS_NUM_THREADS=1
"$bench" run all "${quick[@]}" --threads 1 --json "$build/records.jsonl"
python3 bench/report.py "$build/records.jsonl" docs "$command"
echo "wrote docs/accuracy.md"
