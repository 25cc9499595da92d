#!/usr/bin/env bash
# Builds with a makefile's means: pkg_config.sh <prefix> <shared|static> <c|fortran> <compiler> <work folder>
set -euo pipefail
prefix=$1 kind=$2 language=$3 compiler=$4 work=$5
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

rm -rf "$work"
mkdir -p "$work"
# pkg-config separates its answers by blanks, so the prefix is reached through a path without any.
plain=$(mktemp -d)
trap 'rm -rf "$plain"' EXIT
cp -r "$prefix/." "$plain/"
if [ "$kind" = static ]; then
  rm -f "$plain"/lib*/librollcon.so* "$plain"/lib/*/librollcon.so*
fi
PKG_CONFIG_PATH=$(dirname "$(find "$plain" -name rollcon.pc)")
export PKG_CONFIG_PATH
static_flag=()
if [ "$kind" = static ]; then static_flag=(--static); fi
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
  "$compiler" "${sources[@]}" "$here/program.f90" -o program "${libs[@]}"
else
  "$compiler" "${cflags[@]}" "$here/program.c" -o program "${libs[@]}"
fi
./program
if [ "$kind" = static ] && ldd program | grep -q librollcon; then
  echo "the static program loads librollcon.so" >&2
  exit 1
fi
