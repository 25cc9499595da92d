#!/usr/bin/env bash
# Compares the binary interface of the library just built with the stored dump:
# compare.sh <stored dump> <library> <include folder>
set -euo pipefail
stored=$1 library=$2 include=$3

if ! command -v abidiff >/dev/null; then
  echo "abidiff is not installed"
  exit 77
fi
status=0
abidiff --exported-interfaces-only --headers-dir2 "$include" --drop-private-types "$stored" "$library" || status=$?
# The status is a set of bits: 1 and 2 errors, 4 a change, 8 one that is surely incompatible.
if ((status & 12)); then
  echo "The binary interface is not the stored one. If functions were only added, store it with"
  echo "scripts/abi_dump.sh; anything else breaks callers: undo it, or raise the ABI number."
elif ((status)); then
  echo "abidiff failed with status $status."
else
  echo "binary interface as stored"
fi
exit "$status"
