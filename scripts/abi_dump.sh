#!/usr/bin/env bash
# Stores the binary interface of a library built with tests (GCC, x86-64) as tests/abi/rollcon.abi. Run it when
# functions were added, or with a new ABI number: abi_dump.sh [build folder]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
build=${1:-$root/build/release}
if [ ! -e "$build/librollcon.so" ]; then
  fail "no librollcon.so in $build: build it first (cmake --preset release, cmake --build --preset release)"
fi
abidw --exported-interfaces-only --no-corpus-path --no-comp-dir-path --no-show-locs --drop-private-types \
  --headers-dir "$root/include" --out-file "$root/tests/abi/rollcon.abi" "$build/librollcon.so"
sed -i "s|path='$root/|path='|" "$root/tests/abi/rollcon.abi"
say "stored in tests/abi/rollcon.abi: $(grep -c 'elf-symbol-id=' "$root/tests/abi/rollcon.abi") functions"
