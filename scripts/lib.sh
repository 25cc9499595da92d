# Holds what the scripts of this folder have in common; to be sourced.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=$(nproc)
# The system's interpreter is the one with the system's numpy; another may come first on the path.
python=/usr/bin/python3
# CTest leaves one record for each stage that ran tests.
results=$root/build/results

say() { printf '== %s\n' "$*"; }
fail() {
  printf 'FAILED: %s\n' "$*" >&2
  exit 1
}

configure() {  # configure PRESET [OPTION...]
  local log
  log=$(mktemp)
  cmake --preset "$@" >"$log" 2>&1 || {
    cat "$log"
    fail "configure"
  }
  grep -A6 -E '^-- rollcon [0-9]' "$log" || true
  rm -f "$log"
}

run_tests() {  # run_tests NAME PRESET [OPTION OF CTEST...]: the last line says how many passed
  local name=$1 preset=$2 status=0
  shift 2
  mkdir -p "$results"
  rm -f "$results/$name.xml"
  ctest --preset "$preset" -j "$jobs" --progress --test-output-size-passed 100000 \
    --output-junit "$results/$name.xml" "$@" || status=$?
  "$python" "$root/scripts/count_tests.py" "$results/$name.xml" || status=1
  return "$status"
}

if command -v ccache >/dev/null; then
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  # The cache would not store anything that was compiled with a precompiled header, without this.
  export CCACHE_SLOPPINESS=pch_defines,time_macros
fi
