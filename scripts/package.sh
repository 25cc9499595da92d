#!/usr/bin/env bash
# Makes Debian packages and a Python wheel, in out/packages, checked by lintian.
# package.sh [--make]     Then, as root and without --make: installs the packages, uses them from C, Fortran 2008,
# FORTRAN 77, Python and (where it is installed) Octave, removes them, and uses the wheel in an environment of its own
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cd "$root"
build=$root/build/package
out=$root/out/packages

bash scripts/setup.sh build package
rm -rf "$out"
mkdir -p "$out"
say "configure and build"
# These are the flags with which Debian compiles libraries.
CXXFLAGS=$(dpkg-buildflags --get CXXFLAGS | sed 's/-g //; s/-ffile-prefix-map=[^ ]*//; s/-O2//')
CPPFLAGS=$(dpkg-buildflags --get CPPFLAGS)
LDFLAGS=$(dpkg-buildflags --get LDFLAGS)
export CXXFLAGS="$CXXFLAGS $CPPFLAGS" LDFLAGS
cmake --preset library -B "$build" -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_INSTALL_DOCDIR=share/doc/rollcon-doc/rollcon \
  -DROLLCON_PYTHON=ON -DROLLCON_DOCS=ON >/dev/null
cmake --build "$build" -j "$jobs" | tail -1
say "Debian packages"
(cd "$build" && umask 022 && cpack -G DEB -B "$out" >"$build/cpack.log" 2>&1) || {
  cat "$build/cpack.log"
  fail "cpack"
}
rm -rf "$out/_CPack_Packages"
# CPack 3.25 calls ldconfig from scripts of its own; Debian wants the trigger, which the package has.
library=$(find "$out" -name 'librollcon[0-9]*.deb')
dpkg-deb --raw-extract "$library" "$build/repacked"
rm "$build/repacked/DEBIAN/postinst" "$build/repacked/DEBIAN/postrm"
dpkg-deb --root-owner-group --build "$build/repacked" "$library" >/dev/null
rm -rf "$build/repacked"
lintian --fail-on error,warning --suppress-tags initial-upload-closes-no-bugs "$out"/*.deb
say "wheel"
unset CXXFLAGS LDFLAGS
"$python" packaging/python/wheel_build.py "$out" >"$build/wheel.log" 2>&1 || {
  cat "$build/wheel.log"
  fail "wheel"
}
tail -3 "$build/wheel.log"
ls -l "$out"
[ "${1:-}" != --make ] || exit 0
if [ "$(id -u)" -ne 0 ]; then
  say "packages: made, and not tried, which needs root"
  exit 0
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
unset ROLLCON_LIBRARY LD_LIBRARY_PATH PYTHONPATH PKG_CONFIG_PATH
say "install"
dpkg --install "$out"/*.deb >/dev/null
cp "$root/examples/first_contact.c" "$root"/examples/six_steps* .
cc first_contact.c $(pkg-config --cflags --libs rollcon) -o first_contact
./first_contact
mkdir fortran
printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(user LANGUAGES Fortran)' \
  'find_package(rollcon REQUIRED COMPONENTS Fortran)' 'foreach(name IN ITEMS six_steps.f90 six_steps_77.f)' \
  '  string(REPLACE "." "_" target ${name})' '  add_executable(${target} ../${name})' \
  '  target_link_libraries(${target} PRIVATE rollcon::fortran)' 'endforeach()' >fortran/CMakeLists.txt
cmake -S fortran -B fortran/build -G Ninja >/dev/null
cmake --build fortran/build >/dev/null
fortran/build/six_steps_f90 >six_steps_f90.txt
fortran/build/six_steps_77_f >six_steps_77.txt
"$python" six_steps.py >six_steps_py.txt
"$python" -c 'import rollcon; print(rollcon.library_path, rollcon.Table.standard(rollcon.Context()))'
for text in six_steps_77.txt six_steps_py.txt; do
  cmp six_steps_f90.txt "$text" || fail "$text differs from six_steps_f90.txt"
done
languages="C, Fortran 2008, FORTRAN 77 and Python"
if command -v mkoctfile >/dev/null; then
  # Users may not write where the package is, so they build in a copy.
  cp -r /usr/share/rollcon/octave octave
  octave-cli -q --no-history --eval "addpath('octave'); rollcon_build(); context = rollcon.context_create();
    table = rollcon.table_standard(context); disp(rollcon.version_string())"
  languages="$languages, and Octave"
fi
say "remove"
dpkg --purge rollcon-doc python3-rollcon librollcon-dev librollcon1 >/dev/null
left=$(find /usr/lib /usr/share /usr/include -iname '*rollcon*' -not -name rollconv.ps -not -path "$root/*" || true)
[ -z "$left" ] || fail "left behind: $left"
say "wheel, in an environment of its own"
"$python" -m venv --system-site-packages environment
environment/bin/pip install --quiet --no-index --no-deps "$out"/*.whl
environment/bin/python six_steps.py | cmp - six_steps_f90.txt || fail "the wheel's results differ"
environment/bin/python -c 'import rollcon; print(rollcon.__version__, rollcon.library_path, rollcon.Table.standard(rollcon.Context()))'
say "packages: installed, used from $languages, removed without a trace; the wheel is used, too"
