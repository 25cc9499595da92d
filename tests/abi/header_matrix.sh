#!/usr/bin/env bash
# Compiles the public headers alone, in two translation units of one program, under every standard a caller may use:
# header_matrix.sh <include folder> <work folder> <c compiler> <c++ compiler>
set -euo pipefail
include=$1 work=$2 cc=$3 cxx=$4

for compiler in "$cc" "$cxx"; do
  if ! command -v "$compiler" >/dev/null; then
    echo "$compiler is not installed"
    exit 77
  fi
done
rm -rf "$work"
mkdir -p "$work"
cd "$work"
printf '#include <rollcon_layers.h>\n' >unit.c
cat >main.c <<'PROGRAM'
#include <rollcon.h>
#include <rollcon_layers.h>
#include <rollcon.h>
#include <rollcon_layers.h>
int main(void) { return ROLLCON_OK; }
PROGRAM
cp unit.c unit.cpp
cp main.c main.cpp

strict=(-pedantic -Wall -Wextra -Werror "-I$include")
count=0
for standard in c90 c99 c11 c17; do
  "$cc" -std=$standard "${strict[@]}" -Wstrict-prototypes unit.c main.c -o "program-$standard"
  "./program-$standard"
  count=$((count + 1))
done
for standard in c++98 c++03 c++11 c++14 c++17 c++20; do
  "$cxx" -std=$standard "${strict[@]}" unit.cpp main.cpp -o "program-$standard"
  "./program-$standard"
  count=$((count + 1))
done
echo "rollcon.h and rollcon_layers.h: $count standards, $cc and $cxx"
