#!/usr/bin/env bash
# Runs what is too long for every change. Goes on where a stage fails, and ends with a table of all.
#   nightly.sh [stage...]        default: all of them, in this order
#     tests        everything compiled source by source as users do, with rollcon-bench; all tests
#     sanitizers   all tests in all rooms under the address and undefined-behaviour sanitizers
#     tidy         clang-tidy on all sources, to the analyzer's own limit
#     components   builds without components
#     documents    the installation that README.md shows, from nothing, and its first program
#     random       random scenes from seeds that nobody has tried before
#     fuzz         the fuzzers, ROLLCON_FUZZ_TIME seconds (3600)
#     valgrind     memcheck
#     mutants      ROLLCON_MUTANTS mutants (300, seed 1) against the tests that run for every change
#     accuracy     the tables of the documents anew; `git diff docs` then says what changed
# Logs go to build/nightly; docs/testing.md has a summary.
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cd "$root"
logs=$root/build/nightly
mkdir -p "$logs"
[ $# -gt 0 ] || set -- tests sanitizers tidy components documents random fuzz valgrind mutants accuracy

stage_tests() {
  bash scripts/setup.sh octave
  configure release -DROLLCON_WERROR=ON -DROLLCON_BENCH=ON
  cmake --build --preset release -j "$jobs"
  run_tests nightly release
}
stage_sanitizers() {
  configure asan
  cmake --build --preset asan -j "$jobs"
  run_tests nightly-asan asan -LE '^nightly$'
}
stage_tidy() {
  configure tsan
  cmake --build --preset tsan -j "$jobs" --target rollcon_objects
  "$python" scripts/tidy.py build/tsan "$jobs" --deep
}
stage_components() { bash scripts/check_components.sh; }
stage_documents() { "$python" scripts/run_documents.py --install; }
stage_random() {
  configure release -DROLLCON_WERROR=ON -DROLLCON_BENCH=ON
  cmake --build --preset release -j "$jobs" --target test_stability
  # The seed is named here, so that what fails can be drawn again.
  export ROLLCON_FIRST_SEED=${ROLLCON_FIRST_SEED:-$(($(date +%s) / 1000 * 1000 % 2000000000))}
  say "seeds from $ROLLCON_FIRST_SEED on"
  OMP_WAIT_POLICY=passive "$python" tests/watch.py --processor 3600 -- \
    build/release/tests/test_stability --gtest_filter='*random_scenes*'
}
stage_fuzz() { bash scripts/fuzz.sh "${ROLLCON_FUZZ_TIME:-3600}"; }
stage_valgrind() { bash scripts/valgrind.sh; }
stage_mutants() {
  "$python" scripts/mutations.py --work build/mutants --sample "${ROLLCON_MUTANTS:-300}" --seed 1 \
    --jobs "$jobs" --equivalent docs/testing.md --least 95
}
stage_accuracy() {
  bash scripts/accuracy.sh all
  git diff --stat docs
}

table=()
failed=0
for stage in "$@"; do
  declare -F "stage_$stage" >/dev/null || fail "no stage $stage: the head of nightly.sh lists them"
done
for stage in "$@"; do
  say "$stage: $logs/$stage.log"
  began=$SECONDS
  (set -e; "stage_$stage") >"$logs/$stage.log" 2>&1
  status=$?
  [ $status -eq 0 ] && outcome=passed || outcome="FAILED ($status)"
  [ $status -eq 0 ] || failed=$((failed + 1))
  tail -3 "$logs/$stage.log"
  last=$(tail -1 "$logs/$stage.log" | cut -c1-100)
  table+=("$(printf '| %-10s | %-12s | %6d s | %s |' "$stage" "$outcome" $((SECONDS - began)) "$last")")
done
printf '%s\n' "| stage | result | time | last line |" "| --- | --- | ---: | --- |" "${table[@]}" |
  tee "$logs/summary.md"
[ $failed -eq 0 ] || fail "$failed stages"
