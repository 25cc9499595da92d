#!/usr/bin/env bash
# Runs test programs under valgrind's memcheck and sums up errors and leaks (docs/testing.md).
#   valgrind.sh [--build DIR] [room...]    default: all rooms but validation and stability
# Without --build, build/valgrind is configured and built first. Under valgrind everything takes 20
# to 50 times as long: tests that last seconds without it are left out below.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

build=
rooms=()
while [ $# -gt 0 ]; do
  case $1 in
  --build)
    build=$(realpath "$2")
    shift
    ;;
  *) rooms+=("$1") ;;
  esac
  shift
done
[ ${#rooms[@]} -gt 0 ] || rooms=(support linalg mesh io capi capi_inside bodies contact)
command -v valgrind >/dev/null || fail "valgrind is not installed (scripts/setup.sh)"

if [ -z "$build" ]; then
  build=${ROLLCON_VALGRIND_BUILD:-$root/build/valgrind}
  # The build has line numbers for the reports, and otherwise the code that users run.
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS=-g1 \
    -DROLLCON_TESTS=ON -DROLLCON_FORTRAN=OFF >/dev/null
  targets=()
  for room in "${rooms[@]}"; do targets+=("test_$room"); done
  cmake --build "$build" -j "$jobs" --target "${targets[@]}"
fi

# Each room has a filter of GoogleTest without what takes minutes there and runs the same code as its neighbours: long
# tests (tests/CMakeLists.txt), and these.
filter() {
  local more=
  case $1 in
  # Valgrind has its own operator new, knows no floating-point traps and no flushed subnormals, and
  # takes address space for itself.
  support) more='QuietFloatingPoint.*:HostFloatingPoint.*:MemoryLimit.*' ;;
  capi) more='MemoryLimits.*:floating_point.*:allocation*:out_of_memory*:body_save.damaged_files_*:'\
'fem_tags_and_frames.going_back_*:procedure_statuses.*:procedures.*:time_loop.every_step_*:'\
'cancel_preparation.stops_a_solve_*:solve_many_threads.*' ;;
  # Valgrind computes long double with the digits of double, too few for the first of these.
  bodies) more='LatticeKernel.EqualsThe*:*halfspace_compliance.*:halfspace_constants.rigid_*:*refinement*:'\
'*OffFrame*:*the_body_follows_*:*IncompressibleWalls*:*PatchBending.*:*PatchLoad.*:*PatchMaterials.*:*ThickWalls*:*Cantilever*:'\
'Expanded.*bod*:Expanded.by_shape_*:BoundaryRows.single_layer_*:*BodyModels.reciprocity*:'\
'*BodyModels.written_out*:*positive_definite*:*exact_integrals*:*RuleSelection*:*as_the_mesh_refines*:'\
'*error_of_the_integrals*:*units*:*every_input_counts*:ForgedFiles.of_boundary*:*KelvinRules*:'\
'*loads_superpose*:*well_conditioned*' ;;
  contact) more='monolithic_system.*:sensitivity.costs_*:*setter_of_a_meshed_scene*:tilted_plane.*:'\
'sensitivity.of_boundary_*:sensitivity.asking_does_not_*:sensitivity.under_every_*' ;;
  mesh) more='*Converge*:*ManyNodes*:VolumeCheck.DoesNotCompareAllNodes' ;;
  linalg) more='*sparse_factor*.both_methods_agree_*:*sparse_factor.a_body_in_the_air_*:'\
'*sparse_factor.too_large_*:*sparse_factor*threads*:*sparse_factor.*_against_dense:'\
'FactoredMatrix.condition_is_estimated_*:FactoredMatrix.nothing_that_is_not_finite_*' ;;
  esac
  echo "-*_long.*:*_long/*:*_nightly.*:*_nightly/*:$more"
}

# Valgrind knows no AVX-512: its processor says so, and OpenBLAS and rollcon take AVX2. OpenBLAS is told besides,
# because its own detection reads more than that. Waiting threads must not spin, because one runs at a time.
export OPENBLAS_CORETYPE=Haswell OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=2 OMP_WAIT_POLICY=passive
logs=$build/memcheck
mkdir -p "$logs"
failed=0
printf '%-14s %7s %8s %8s %14s\n' room tests seconds errors 'bytes leaked'
for room in "${rooms[@]}"; do
  log=$logs/$room.log
  began=$SECONDS
  set +e
  (cd "$build/tests" && valgrind --error-exitcode=99 --leak-check=full \
    --show-leak-kinds=definite,indirect,possible --errors-for-leak-kinds=definite,indirect,possible \
    --num-callers=30 --suppressions="$root/tests/valgrind.supp" --log-file="$log" \
    "./test_$room" --gtest_filter="$(filter "$room")" >"$logs/$room.out" 2>&1)
  status=$?
  set -e
  tests=$(sed -n 's/^\[==========\] \([0-9]*\) tests\{0,1\} .* ran.*/\1/p' "$logs/$room.out")
  errors=$(sed -n 's/.*ERROR SUMMARY: \([0-9,]*\) errors.*/\1/p' "$log" | tail -1)
  leaked=$(sed -n 's/.* \(definitely\|indirectly\|possibly\) lost: \([0-9,]*\) bytes.*/\2/p' "$log" |
    tr -d , | awk '{ sum += $1 } END { print sum + 0 }')
  printf '%-14s %7s %8d %8s %14s\n' "$room" "${tests:-?}" $((SECONDS - began)) "${errors:-?}" "$leaked"
  if [ $status -ne 0 ]; then
    failed=1
    say "$room: status $status; $log and $logs/$room.out"
  fi
done
[ $failed -eq 0 ] || fail "memcheck"
