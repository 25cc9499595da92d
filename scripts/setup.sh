#!/usr/bin/env bash
# Installs what building, testing and drawing need on Debian 12; the only place that names packages.
# Does nothing, and uses no network, when all are there. Needs root or sudo otherwise.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

packages=(
  # compilers and build
  g++ gcc gfortran make cmake ninja-build pkg-config git
  # libraries
  libopenblas-dev libsuitesparse-dev libfftw3-dev libboost-dev libgtest-dev libbenchmark-dev
  # checks: a second compiler with its OpenMP and sanitizer runtimes, format, lint, ABI, memory
  clang clang-format clang-tidy libomp-dev libclang-rt-dev binutils abigail-tools valgrind
  # examples, one of which runs on several processes; plots, readers of the output files
  mpich libmpich-dev python3 python3-numpy python3-meshio gnuplot-nox
)

missing=()
for package in "${packages[@]}"; do
  # shellcheck disable=SC2016
  if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
    missing+=("$package")
  fi
done
if [ ${#missing[@]} -eq 0 ]; then
  say "setup: all ${#packages[@]} packages are installed"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || fail "root or sudo is needed to install: ${missing[*]}"
  as_root=(sudo)
fi
say "setup: installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -q -y --no-install-recommends "${missing[@]}"
