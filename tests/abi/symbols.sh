#!/usr/bin/env bash
# Checks that the shared library exports the API table and nothing else, that its SONAME is the ABI number, and that it
# asks for no executable stack: symbols.sh <library> <version script> <abi number>
set -euo pipefail
library=$1 map=$2 abi=$3

exported=$(nm -D --defined-only "$library" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' |
  LC_ALL=C sort)
table=$(sed 's|/\*.*\*/||; s/#.*//' "$map" | tr ';{}' '\n' | sed 's/^[[:space:]]*//; s/[[:space:]]*$//' |
  grep -E '^rollcon_[a-z0-9_]+$' | LC_ALL=C sort)
if [ "$exported" != "$table" ]; then
  echo "exported symbols (<) differ from $map (>):"
  diff <(echo "$exported") <(echo "$table")
  exit 1
fi

soname=$(readelf -d "$library" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
if [ "$soname" != "librollcon.so.$abi" ]; then
  echo "SONAME is '$soname', expected librollcon.so.$abi"
  exit 1
fi
if readelf -lW "$library" | grep GNU_STACK | grep -q 'RWE'; then
  echo "$library asks for an executable stack"
  exit 1
fi
echo "$(wc -l <<<"$table") symbols, SONAME $soname"
