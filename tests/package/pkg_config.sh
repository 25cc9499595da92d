#!/usr/bin/env bash
# Builds with a makefile's means: pkg_config.sh <prefix> <shared|static|whole> <c|fortran> <compiler> <work folder>. The
# kind "whole" links no shared library at all, which needs an archive of each: builds without SuiteSparse have them.
set -euo pipefail
prefix=$1 kind=$2 language=$3 compiler=$4 work=$5
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

rm -rf "$work"
mkdir -p "$work"
# pkg-config separates its answers by blanks, so the prefix is reached through a path without any.
plain=$(mktemp -d)
trap 'rm -rf "$plain"' EXIT
cp -r "$prefix/." "$plain/"
if [ "$kind" != shared ]; then
  rm -f "$plain"/lib*/librollcon.so* "$plain"/lib/*/librollcon.so*
fi
PKG_CONFIG_PATH=$(dirname "$(find "$plain" -name rollcon.pc)")
export PKG_CONFIG_PATH
static_flag=()
whole=()
if [ "$kind" != shared ]; then static_flag=(--static); fi
if [ "$kind" = whole ]; then whole=(-static); fi
read -r -a cflags <<<"$(pkg-config --cflags rollcon)"
read -r -a libs <<<"$(pkg-config --libs "${static_flag[@]}" rollcon)"
LD_LIBRARY_PATH=$(pkg-config --variable=libdir rollcon)
export LD_LIBRARY_PATH

cd "$work"
if [ "$language" = fortran ]; then
  sources=()
  for name in $(pkg-config --variable=fortransources rollcon); do
    sources+=("$(pkg-config --variable=fortrandir rollcon)/$name")
  done
  "$compiler" "${sources[@]}" "$here/program.f90" -o program "${whole[@]}" "${libs[@]}"
else
  "$compiler" "${cflags[@]}" "$here/program.c" -o program "${whole[@]}" "${libs[@]}"
fi
./program
if [ "$kind" = static ] && [ "$language" = c ]; then
  # The variable names the archive itself, so that it serves beside a shared library, too.
  read -r -a libs <<<"$(pkg-config --variable=static rollcon)"
  "$compiler" "${cflags[@]}" "$here/program.c" -o program "${libs[@]}"
  ./program
fi
if [ "$kind" = whole ] && ldd program >/dev/null 2>&1; then
  echo "the program loads shared libraries" >&2
  exit 1
fi
if [ "$kind" = static ] && ldd program | grep -q librollcon; then
  echo "the static program loads librollcon.so" >&2
  exit 1
fi
