#!/usr/bin/env bash
# Measures what tests cost, in seconds of processors, and writes those that cost most into tests/costs.txt, by which
# tests/CMakeLists.txt says what runs when. Other work may run at the same time.
#   costs.sh plain [ROOM...]        quick and long tests of the preset quick
#   costs.sh sanitized [ROOM...]    quick tests of the preset quick-asan
# The build folder of both is build/quick; without rooms, all are measured: some twenty minutes of a processor.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cd "$root"
library=${1:-}
shift || true
# What costs less is not listed.
case $library in
plain) filter='-*_nightly.*:*_nightly/*' least=0.5 ;;
sanitized) filter='-*_long.*:*_long/*:*_nightly.*:*_nightly/*' least=2 ;;
*) fail "costs.sh plain|sanitized [ROOM...]" ;;
esac
if [ $# -eq 0 ]; then
  set -- support linalg mesh geometry io bodies contact framing tables wheelrail capi capi/inside
  [ "$library" = sanitized ] || set -- "$@" validation stability
fi
export OMP_WAIT_POLICY=passive
for room in "$@"; do
  threads=()
  # CTest runs two tests of this room at a time, one core each.
  [ "$room" != validation ] || threads=(OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1)
  log=$(mktemp)
  env "${threads[@]}" "$python" tests/watch.py --processor 3600 --times "$least" -- \
    "build/quick/tests/test_${room//\//_}" --gtest_filter="$filter" | tee "$log"
  {
    grep -v "^$room $library " tests/costs.txt
    sed -n "s,^ *\([0-9.]*\) s \(.*\),$room $library \2 \1,p" "$log"
  } | LC_ALL=C sort -k1,2 -k4,4nr -k3,3 >"$log.all"
  mv "$log.all" tests/costs.txt
  rm "$log"
done
