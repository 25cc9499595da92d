#!/usr/bin/env bash
# From nothing to a result: installs what is missing, builds the library, rolls an elastic sphere over
# a rigid plane through the public C API, prints the numbers and draws the tractions.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
build=$root/build/demo
out=$root/out/demo

bash "$root/scripts/setup.sh"
say "configure and build (Release)"
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DROLLCON_TESTS=OFF \
  -DROLLCON_FORTRAN=OFF | grep -A6 -E '^-- rollcon [0-9]'
cmake --build "$build" -j "$jobs"

say "a sphere rolls on a plane (examples/sphere_on_plane.c)"
mkdir -p "$out"
cd "$out"
"$build/examples/sphere_on_plane_c" "$out"
gnuplot "$root/examples/plot_contact.gp"
picture=$(find "$out" -name '*.png' -newer "$build/examples/sphere_on_plane_c" | head -n 1)
[ -n "$picture" ] || fail "no picture was drawn in $out"
say "picture: $picture"
