#!/usr/bin/env bash
# The library without components: each build links and contains nothing of what it leaves out, says so
# by rollcon_has_feature, and passes the quick tests. Each build has a folder of its own.
#   check_components.sh [build...]     default: all, by the names below
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cd "$root"

all=(FEM BEM PROCEDURES VTU OPENMP CHOLMOD MUMPS UMFPACK FFTW HMAT MPI)
# Each entry has the name and the components of a build.
builds=(
  "everything: FEM BEM PROCEDURES VTU OPENMP CHOLMOD UMFPACK FFTW HMAT"
  "without the GPL: BEM PROCEDURES VTU OPENMP"
  "finite elements without the GPL: FEM BEM PROCEDURES VTU OPENMP MUMPS"
  "finite elements alone: FEM OPENMP CHOLMOD"
  "boundary elements alone: BEM OPENMP"
  "no OpenMP: FEM BEM PROCEDURES VTU CHOLMOD UMFPACK FFTW"
  "no UMFPACK: FEM BEM PROCEDURES VTU OPENMP CHOLMOD FFTW"
  "lists over ranks: OPENMP MPI"
  "factorisations over ranks: FEM OPENMP CHOLMOD MUMPS MPI"
  "half-spaces alone:"
)
if [ $# -gt 0 ]; then
  named=()
  for name in "$@"; do
    for build in "${builds[@]}"; do
      [ "${build%%:*}" != "$name" ] || named+=("$build")
    done
    [[ ${named[*]} == *"$name:"* ]] || fail "no build '$name'"
  done
  builds=("${named[@]}")
fi
# Symbols, or for files the text that they begin with, show that a library has the component.
declare -A symbols=(
  [FEM]='rollcon::fem::(System|Assembly|element_stiffness)|rollcon::volume_rule'
  [BEM]='rollcon::bem::(System|BoundaryIntegrals|kelvin)'
  [PROCEDURES]='rollcon::(Gnmls::solve|StepSystem::solve)'
  [OPENMP]=' (GOMP_|omp_get_|__kmpc_)'
  [CHOLMOD]=' U cholmod_'
  [MUMPS]=' U dmumps_c'
  [UMFPACK]=' U umfpack_'
  [FFTW]=' U fftwf?_'
  [HMAT]=' U hmat_'
  [MPI]=' U MPI_Allreduce'
)
declare -A needed=([OPENMP]='lib(gomp|omp|iomp5)\.' [CHOLMOD]='libcholmod' [MUMPS]='libdmumps' [UMFPACK]='libumfpack'
  [FFTW]='libfftw3' [HMAT]='libhmat' [MPI]='lib(mpi|mpich)\.')

options() {  # of a build with these components
  local name
  for name in "${all[@]}"; do
    [[ " $* " == *" $name "* ]] && echo "-DROLLCON_WITH_$name=ON" || echo "-DROLLCON_WITH_$name=OFF"
  done
}

shows() {  # shows <component> <library>
  if [ "$1" = VTU ]; then
    grep -q VTKFile "$2"
  else
    grep -qE "${symbols[$1]}" "$work/symbols"
  fi
}

check_library() {  # check_library <folder> <components...>
  local library=$1/librollcon.so name sources
  sources=$(grep -c -- '-o CMakeFiles/rollcon_objects.dir/src/' "$1/compile_commands.json")
  shift
  nm -C "$library" >"$work/symbols"
  objdump -p "$library" | awk '/NEEDED/ { print $2 }' >"$work/needed"
  for name in "${all[@]}"; do
    local feature wanted=0
    feature=$("$python" -c "import ctypes, sys
print(ctypes.CDLL(sys.argv[1]).rollcon_has_feature(sys.argv[2].encode()))" "$library" "${name,,}")
    [[ " $* " == *" $name "* ]] && wanted=1
    [ "$feature" = $wanted ] || fail "rollcon_has_feature(\"${name,,}\") is $feature, not $wanted"
    # Symbols that show up where the component is prove that none is overlooked where it must not be.
    if [ $wanted = 1 ]; then
      shows "$name" "$library" || fail "nothing of $name is in a library that has it"
      [ -z "${needed[$name]:-}" ] || grep -qE "${needed[$name]}" "$work/needed" ||
        fail "a library with $name does not link ${needed[$name]}"
    else
      ! shows "$name" "$library" || fail "a library without $name contains some of it"
      [ -z "${needed[$name]:-}" ] || ! grep -E "${needed[$name]}" "$work/needed" ||
        fail "a library without $name links it"
    fi
  done
  if [[ " $* " != *" CHOLMOD "* && " $* " != *" UMFPACK "* ]] &&
    ldd "$library" | grep -E 'suitesparse|metis|amd\.so'; then
    fail "a library without SuiteSparse loads parts of it"
  fi
  strip -o "$work/stripped" "$library"
  say "$sources sources; $(stat -c %s "$work/stripped") bytes stripped; links $(tr '\n' ' ' <"$work/needed")"
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for build in "${builds[@]}"; do
  name=${build%%:*}
  read -r -a components <<<"${build#*:}"
  folder=$root/build/components/${name// /-}
  mapfile -t flags < <(options "${components[@]}")
  start=$SECONDS
  # Sources are compiled one by one: tests take single objects of the helpers, and leave those whose component is
  # absent.
  cmake --preset quick -DROLLCON_UNITY=TESTS -B "$folder" "${flags[@]}" >"$work/log" 2>&1 || {
    cat "$work/log"
    fail "$name: configure"
  }
  cmake --build "$folder" -j "$jobs" >"$work/log" 2>&1 || {
    tail -50 "$work/log"
    fail "$name: build"
  }
  say "$name"
  check_library "$folder" "${components[@]}"
  # Debian has no archive of METIS, which SuiteSparse needs; all other libraries have one.
  if [[ " ${components[*]} " != *" CHOLMOD "* && " ${components[*]} " != *" UMFPACK "* ]]; then
    cmake --install "$folder" --prefix "$work/prefix" >/dev/null
    bash tests/package/pkg_config.sh "$work/prefix" whole c cc "$work/consumer" || fail "$name: a program without shared libraries"
    rm -rf "$work/prefix"
  fi
  ctest --test-dir "$folder" -j "$jobs" -LE '^(abi|long|nightly)$' --output-on-failure -Q || fail "$name: tests"
  say "$((SECONDS - start)) s"
done
