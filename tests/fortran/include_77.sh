#!/usr/bin/env bash
# Tests by include_77.sh <gfortran> <source tree> that programs of the FORTRAN 77 layer compile with fortran/rollcon.inc
# in every unit, in fixed and free form, and one that forgets an argument, or gives a number of another type, does not.
set -euo pipefail
compiler=$1 root=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
compile() { "$compiler" -fsyntax-only -I"$root/fortran" "$@"; }

for source in "$root"/examples/*_77.f; do
  # The include goes behind the first statement of each unit, continued lines included.
  awk '/^      (PROGRAM|SUBROUTINE)/ { print; due = 1; next }
    due && !/^     [^ ]/ { print "      INCLUDE '\''rollcon.inc'\''"; due = 0 } { print }' "$source" >"$work/good.f"
  grep -q INCLUDE "$work/good.f"
  compile "$work/good.f"
done
printf '%s\n' 'program free' "include 'rollcon.inc'" 'integer context, ierr' 'call rcinit(context, ierr)' \
  'if (ierr /= ROLLCON_OK) stop 1' 'end' >"$work/good.f90"
compile "$work/good.f90"

for call in 'RCINIT(I)' 'RCFREE(1D0, I)' 'RCELAS(I, 0, 2.1E5, 0.28E0, I)' "RCBODY(I, 'half', I, I)"; do
  printf '      %s\n' 'PROGRAM WRONG' "INCLUDE 'rollcon.inc'" 'INTEGER I' "CALL $call" 'END' >"$work/wrong.f"
  if compile "$work/wrong.f" 2>/dev/null; then
    echo "$call compiles" >&2
    exit 1
  fi
  echo "$call: refused"
done
