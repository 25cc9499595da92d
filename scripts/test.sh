#!/usr/bin/env bash
# Builds the library with its tests, in the way that takes a compiler least, and runs the quick tests; ends with their
# number: test.sh [preset], default quick. .ci/run and scripts/nightly.sh run the others.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
preset=${1:-quick}

bash "$root/scripts/setup.sh"
cd "$root"
say "configure and build ($preset)"
configure "$preset"
cmake --build --preset "$preset" -j "$jobs"
say "quick tests"
run_tests "$preset" "$preset" -LE '^(long|nightly)$'
