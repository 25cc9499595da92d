#!/usr/bin/env bash
# Goes from nothing to a result: installs what is missing, builds the library, rolls a wheel meshed by boundary elements
# over a rigid rail head through the public C API, prints the numbers and draws tractions and slip; then a sphere on a
# plane, a ring of finite elements on a half-space, and a wheelset on its track from two profiles.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
build=$root/build/demo
out=$root/out/demo

bash "$root/scripts/setup.sh" build demo
say "configure and build (Release)"
cmake --preset examples -S "$root" -B "$build" -DROLLCON_FORTRAN=OFF -DROLLCON_STATIC=OFF | grep -A6 -E '^-- rollcon [0-9]'
cmake --build "$build" -j "$jobs" --target sphere_on_plane_c ring_on_halfspace_c wheel_on_rail_c manchester_c

mkdir -p "$out"
cd "$out"
rm -f ./*.png

# Runs a program and draws its picture: run PROGRAM PICTURE SCRIPT...
run() {
  local program=$1 picture=$out/$2 script
  shift 2
  say "examples/$program.c"
  "$build/examples/${program}_c" "$out"
  for script in "$@"; do
    gnuplot "$root/examples/$script"
  done
  [ -s "$picture" ] || fail "no picture was drawn: $picture"
}

run wheel_on_rail wheel_on_rail.png plot_wheel.gp plot_wheel_fields.gp
run sphere_on_plane sphere_on_plane.png plot_contact.gp
run ring_on_halfspace ring_on_halfspace.png plot_ring_on_halfspace.gp
run manchester manchester.png plot_manchester.gp
say "pictures: $out/wheel_on_rail.png (and manchester.png, manchester_profiles.png, wheel_on_rail_fields.png, ring_on_halfspace.png, sphere_on_plane.png)"
