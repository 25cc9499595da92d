#!/usr/bin/env bash
# Runs rollcon-bench and rewrites docs/accuracy.md (half-spaces), docs/accuracy_bodies.md (bodies of
# boundary elements) and docs/accuracy_fem.md (of finite elements) with their plots.
#   scripts/accuracy.sh [--quick] [half-spaces|bodies|fem|all] [BUILD_DIR]   (all, build/accuracy)
set -euo pipefail
cd "$(dirname "$0")/.."
quick=()
command="scripts/accuracy.sh"
if [[ "${1:-}" == "--quick" ]]; then
  quick=(--quick)
  command+=" --quick"
  shift
fi
part="${1:-all}"
build="${2:-build/accuracy}"
half_spaces=(hertz carter kalker creep_curve case_a case_b example3 linear_solver kernel)
bodies=(ring_loads rings wheel growth)
fem=(location fem_growth ring_loads fem_ring_loads same_block ring_pairs example2)

mkdir -p "$build"
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DROLLCON_BENCH=ON -DROLLCON_TESTS=OFF \
  -DROLLCON_EXAMPLES=OFF -DROLLCON_FORTRAN=OFF > "$build/configure.log" 2>&1 \
  || { cat "$build/configure.log"; exit 1; }
cmake --build "$build" --target rollcon-bench -j "$(nproc)"
bench=$(find "$build" -name rollcon-bench -type f -perm -u+x | head -n 1)

if [[ $part == half-spaces || $part == all ]]; then
  "$bench" run "${half_spaces[@]}" "${quick[@]}" --threads 1 --json "$build/records.jsonl"
  python3 bench/report.py "$build/records.jsonl" docs "$command half-spaces"
  echo "wrote docs/accuracy.md"
fi
if [[ $part == bodies || $part == all ]]; then
  "$bench" run "${bodies[@]}" "${quick[@]}" --threads 1 --json "$build/bodies1.jsonl"
  "$bench" run growth "${quick[@]}" --threads 2 --json "$build/bodies2.jsonl"
  cat "$build/bodies1.jsonl" "$build/bodies2.jsonl" > "$build/bodies.jsonl"
  python3 bench/report_bodies.py "$build/bodies.jsonl" docs "$command bodies"
  echo "wrote docs/accuracy_bodies.md"
fi
if [[ $part == fem || $part == all ]]; then
  "$bench" run "${fem[@]}" "${quick[@]}" --threads 1 --json "$build/fem1.jsonl"
  "$bench" run fem_growth "${quick[@]}" --threads 2 --json "$build/fem2.jsonl"
  cat "$build/fem1.jsonl" "$build/fem2.jsonl" > "$build/fem.jsonl"
  python3 bench/report_fem.py "$build/fem.jsonl" docs "$command fem"
  echo "wrote docs/accuracy_fem.md"
fi
