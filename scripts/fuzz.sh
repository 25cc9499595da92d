#!/usr/bin/env bash
# Searches for inputs that break the library: builds the targets of tests/fuzz with Clang, libFuzzer,
# address and undefined-behaviour sanitizers and runs them one after the other, on one core.
# fuzz.sh [seconds in all] [target ...], default 600 and calls mesh saved meshfile. What is found goes to
# build/fuzz/found; inputs that reach something new to build/fuzz/corpus, and with
# fuzz.sh merge [target ...] the least number of them to tests/fuzz/corpus, which all builds of the tests
# replay.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cd "$root"
seconds=${1:-600}
shift || true
[ $# -gt 0 ] || set -- calls mesh saved meshfile

folder=${ROLLCON_FUZZ_BUILD:-$root/build/fuzz}
mkdir -p "$folder"
cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1" -DCMAKE_C_COMPILER=clang \
  -DCMAKE_CXX_COMPILER=clang++ "-DROLLCON_SANITIZE=address;undefined" -DROLLCON_FUZZ=ON -DROLLCON_PRECOMPILE=ALL \
  -DROLLCON_UNITY=ALL -DROLLCON_FORTRAN=OFF -DROLLCON_TESTS=ON >"$folder.log" 2>&1 || {
  cat "$folder.log"
  fail "configure"
}
targets=()
for target in "$@"; do targets+=("fuzz_$target"); done
cmake --build "$folder" -j "$jobs" --target "${targets[@]}"

export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 ASAN_OPTIONS=quarantine_size_mb=16
limits=(-len_control=0 -timeout=60 -rss_limit_mb=2048 -malloc_limit_mb=1024)
longest() { [ "$1" = calls ] && echo 800 || echo 400; }

if [ "$seconds" = merge ]; then
  for target in "$@"; do
    least=$(mktemp -d)
    "$folder/tests/fuzz/fuzz_$target" "${limits[@]}" -set_cover_merge=1 "$least" \
      "tests/fuzz/corpus/$target" "$folder/corpus/$target" 2>&1 | tail -1
    # Inputs with names stay, because they once failed.
    find "tests/fuzz/corpus/$target" -type f -regextype sed -regex '.*/[0-9a-f]\{40\}' -delete
    cp "$least"/* "tests/fuzz/corpus/$target"
    rm -rf "$least"
  done
  exit
fi

# Searches, and prints one line of what was tried and reached, and what was found; fails with it: search <target>
# <folder for new inputs> <options...>
search() {
  local target=$1 new=$2 status=0 log=$folder/$1.log
  shift 2
  mkdir -p "$new" "$folder/found/$target"
  nice "$folder/tests/fuzz/fuzz_$target" "${limits[@]}" -max_len="$(longest "$target")" "$@" \
    -artifact_prefix="$folder/found/$target/" -print_final_stats=1 \
    "$new" "tests/fuzz/corpus/$target" >"$log" 2>&1 || status=$?
  executed=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -1)
  covered=$(grep -o 'cov: [0-9]* ft: [0-9]*' "$log" | tail -1 || true)
  say "$target: ${executed:-?} inputs; $covered (edges, features)"
  [ "$status" -eq 0 ] && return
  say "$target: status $status"
  grep -E "broken promise|ERROR:|runtime error|SUMMARY" "$log" || tail -20 "$log"
  # Inputs are printed as text, too, for machines that leave nothing but their output.
  sed -n 's/.*Test unit written to //p' "$log" | while read -r file; do
    say "$file, base64: $(base64 -w 0 "$file")"
  done
  return "$status"
}

found=0
for target in "$@"; do
  end=$(($(date +%s) + seconds / $#))
  # A search ends at the first failure, so it is repeated until the time is over.
  while left=$((end - $(date +%s))) && [ "$left" -gt 0 ]; do
    search "$target" "$folder/corpus/$target" -max_total_time="$left" && break
    found=$((found + 1))
  done
done
[ "$found" -eq 0 ] || fail "$found failures; the inputs are in $folder/found"
