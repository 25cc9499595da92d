#!/usr/bin/env bash
# Reports which lines of src/ the tests reach: builds the preset coverage (everything, no sanitizers), runs every test
# and prints the report of scripts/coverage.py with the lines that were not reached. CI takes its report from the
# sanitizers' build, which counts as well.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

bash "$root/scripts/setup.sh"
cd "$root"
say "configure and build (coverage)"
cmake --preset coverage >/dev/null
cmake --build --preset coverage -j "$jobs"
say "tests"
find build/coverage -name '*.gcda' -delete
ctest --preset coverage -j "$jobs" -LE '^(package|abi)$'
say "lines reached"
"$python" scripts/coverage.py build/coverage --lines --documented docs/testing.md
