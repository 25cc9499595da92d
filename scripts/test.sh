#!/usr/bin/env bash
# Builds everything and runs every test; ends with CTest's summary. test.sh [preset], default release.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
preset=${1:-release}

bash "$root/scripts/setup.sh"
cd "$root"
say "configure and build ($preset)"
cmake --preset "$preset" >"$root/.configure.log" 2>&1 || {
  cat "$root/.configure.log"
  fail "configure"
}
grep -A6 -E '^-- rollcon [0-9]' "$root/.configure.log" || true
rm -f "$root/.configure.log"
cmake --build --preset "$preset" -j "$jobs"
say "tests"
ctest --preset "$preset" -j "$jobs"
