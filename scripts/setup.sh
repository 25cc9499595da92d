#!/usr/bin/env bash
# Installs what is needed on Debian 12; the only place that names packages. Does nothing, and uses no network, when all
# are there. Needs root or sudo otherwise.
#   setup.sh [set...]      default: build demo test
#     build      compilers, CMake, libraries: what the library needs
#     demo       what draws the pictures of scripts/demo.sh
#     test       what tests and checks of every change need beside those (.ci/run)
#     docs       what scripts/site.sh makes the documents' site with
#     octave     what compiles and tests the package for Octave, and draws its pictures; optional
#     package    what scripts/package.sh makes and checks packages with
#     windows    compilers for Windows, and what runs their programs here; optional (docs/build.md)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

declare -A sets=(
  [build]="g++ gcc gfortran make cmake ninja-build pkg-config
    libopenblas-dev libsuitesparse-dev libfftw3-dev python3 python3-numpy"
  [demo]="gnuplot-nox"
  # The list has test libraries; a second compiler with its OpenMP and sanitizer runtimes, format, lint, ABI, memory; an
  # example that runs on several processes and one in an integrator; factorisations for builds without the GPL and for
  # processes that share one; pictures of the Python package, readers of the output files; the program of the how-to on
  # CalculiX.
  [test]="git libgtest-dev libbenchmark-dev clang clang-format clang-tidy libomp-dev libclang-rt-dev binutils
    abigail-tools valgrind openmpi-bin libopenmpi-dev libmumps-dev libmumps-seq-dev libhmat-oss-dev
    libsundials-dev python3-matplotlib python3-meshio calculix-ccx"
  [docs]="mkdocs mkdocs-material libjs-mathjax fonts-mathjax codespell python3-matplotlib"
  [octave]="octave octave-dev gnuplot-nox ghostscript fonts-freefont-otf"
  [windows]="g++-mingw-w64-x86-64-posix gfortran-mingw-w64-x86-64-posix wine64"
  [package]="dpkg-dev fakeroot lintian debhelper file python3-pip python3-venv"
)
[ $# -gt 0 ] || set -- build demo test

packages=()
for name in "$@"; do
  [ -n "${sets[$name]:-}" ] || fail "no set '$name' of packages: ${!sets[*]}"
  read -r -d '' -a more <<<"${sets[$name]}" || true
  packages+=("${more[@]}")
done

missing=()
for package in "${packages[@]}"; do
  # shellcheck disable=SC2016
  if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
    missing+=("$package")
  fi
done
if [ ${#missing[@]} -eq 0 ]; then
  say "setup ($*): all ${#packages[@]} packages are installed"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || fail "root or sudo is needed to install: ${missing[*]}"
  as_root=(sudo)
fi
say "setup ($*): installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -q -y --no-install-recommends "${missing[@]}"
