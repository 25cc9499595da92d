#!/usr/bin/env bash
# Runs rollcon-bench and rewrites documents with their tables and plots:
#   frames           docs/frames.md, frames made by the library
#   tables           docs/tables.md, creep-force tables
#   wheels           docs/wheelrail.md, wheels on rails
#   half-spaces      docs/accuracy.md, scenes of half-spaces in detail
#   work-precision   docs/accuracy.md, error over time and memory of every method
#   estimates        docs/accuracy.md, error estimates beside true errors
#   bodies           docs/accuracy_bodies.md, bodies of boundary elements
#   fem              docs/accuracy_fem.md, bodies of finite elements
#   procedures       docs/procedures.md, solution procedures
#   speed            docs/speed.md, regular frames and repeated solves
#   sizes            docs/howto/choose.md, time and memory of all models over their size
#   stability        docs/stability.md, stiff and extreme scenes (about an hour)
#   scripts/accuracy.sh [--quick] [PART[,PART...]|all] [BUILD_DIR]   (all, build/accuracy)
# Records are kept in BUILD_DIR/records, one file for each case and number of threads; each case
# runs once however many parts need it.
set -euo pipefail
cd "$(dirname "$0")/.."
quick=()
command="scripts/accuracy.sh"
if [[ "${1:-}" == "--quick" ]]; then
  quick=(--quick)
  command+=" --quick"
  shift
fi
part="${1:-all}"
build="${2:-build/accuracy}"
for name in ${part//,/ }; do
  case "$name" in
    frames|tables|wheels|half-spaces|work-precision|estimates|bodies|fem|procedures|speed|sizes|stability|all) ;;
    *) echo "no part $name: frames, tables, wheels, half-spaces, work-precision, estimates, bodies, fem, procedures, speed, sizes, stability or all" >&2; exit 2 ;;
  esac
done
half_spaces=(hertz carter kalker creep_curve case_a case_b example3 linear_solver kernel)
work_precision=(hertz hertz_block carter case_e case_a case_b kalker_meshes creep_curve_meshes lame
  example1 example2 example3 example4)
bodies=(bem_kernel ring_loads rings ring_sections wheel growth)
fem=(location fem_growth ring_loads fem_ring_loads same_block ring_pairs ring_on_halfspace)
procedures=(procedures_example3 procedures_density procedures_example4 procedures_examples
  procedures_speed preconditioners procedures_random)
speed=(lattice irregular stresses resolve table many time_loop loop curve saved_body)

mkdir -p "$build/records"
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DROLLCON_BENCH=ON \
  -DROLLCON_FORTRAN=OFF -DROLLCON_STATIC=ON -DROLLCON_WITH_HMAT=AUTO > "$build/configure.log" 2>&1 \
  || { cat "$build/configure.log"; exit 1; }
cmake --build "$build" --target rollcon-bench -j "$(nproc)"
bench=$(find "$build" -name rollcon-bench -type f -perm -u+x | head -n 1)

declare -A ran
# Runs cases and leaves the names of their record files in the array `files`: run_cases THREADS CASE...
run_cases() {
  local threads=$1 name
  shift
  files=()
  for name in "$@"; do
    local file="$build/records/$name-$threads.jsonl"
    files+=("$file")
    [[ -n "${ran[$file]:-}" ]] && continue
    echo "== $name, $threads thread(s)"
    OPENBLAS_NUM_THREADS=$threads "$bench" run "$name" "${quick[@]}" --threads "$threads" --json "$file.new"
    mv "$file.new" "$file"
    ran[$file]=1
  done
}

wanted() { [[ ",$part," == *",$1,"* || $part == all ]]; }

if wanted frames; then
  run_cases 1 automatic_frames vehicle_loop
  cat "${files[@]}" > "$build/frames.jsonl"
  python3 bench/report_frames.py "$build/frames.jsonl" docs "$command frames"
  echo "wrote docs/frames.md"
fi
if wanted tables; then
  run_cases 2 creep_table creep_table_unlike equivalent_ellipse
  cat "${files[@]}" > "$build/tables.jsonl"
  python3 bench/report_tables.py "$build/tables.jsonl" docs "$command tables"
  echo "wrote docs/tables.md"
fi
if wanted wheels; then
  run_cases 1 wheel_rail manchester wheelset
  cat "${files[@]}" > "$build/wheels.jsonl"
  python3 bench/report_wheels.py "$build/wheels.jsonl" docs "$command wheels"
  echo "wrote docs/wheelrail.md, errors and times"
fi
if wanted half-spaces; then
  run_cases 1 "${half_spaces[@]}"
  cat "${files[@]}" > "$build/half_spaces.jsonl"
  python3 bench/report.py "$build/half_spaces.jsonl" docs "$command half-spaces"
  echo "wrote docs/accuracy.md, half-spaces"
fi
if wanted work-precision; then
  run_cases 1 "${work_precision[@]}"
  python3 bench/report_precision.py docs "$command work-precision" "${files[@]}"
  echo "wrote docs/accuracy.md, work-precision"
fi
if wanted estimates; then
  run_cases 1 effectivity
  python3 bench/report_estimates.py "${files[0]}" docs "$command estimates"
  echo "wrote docs/accuracy.md, estimates"
fi
if wanted bodies; then
  run_cases 1 "${bodies[@]}"
  cat "${files[@]}" > "$build/bodies.jsonl"
  run_cases 2 growth
  cat "${files[@]}" >> "$build/bodies.jsonl"
  python3 bench/report_bodies.py "$build/bodies.jsonl" docs "$command bodies"
  echo "wrote docs/accuracy_bodies.md"
fi
if wanted fem; then
  run_cases 1 "${fem[@]}"
  cat "${files[@]}" > "$build/fem.jsonl"
  run_cases 2 fem_growth
  cat "${files[@]}" >> "$build/fem.jsonl"
  python3 bench/report_fem.py "$build/fem.jsonl" docs "$command fem"
  echo "wrote docs/accuracy_fem.md"
fi
if wanted procedures; then
  run_cases 1 "${procedures[@]}"
  cat "${files[@]}" > "$build/procedures.jsonl"
  python3 bench/report_procedures.py "$build/procedures.jsonl" docs "$command procedures"
  echo "wrote docs/procedures.md"
fi
if wanted speed; then
  run_cases 1 "${speed[@]}"
  cat "${files[@]}" > "$build/speed.jsonl"
  python3 bench/report_speed.py "$build/speed.jsonl" docs "$command speed"
  echo "wrote docs/speed.md"
fi
if wanted sizes; then
  rm -f "$build/sizes.jsonl"
  ROLLCON_LIBRARY=$(find "$(realpath "$build")" -name librollcon.so | head -n 1) PYTHONPATH=$PWD/bindings/python \
    python3 bench/crossings.py measure "$build/sizes.jsonl" "${quick[@]}"
  python3 bench/crossings.py report "$build/sizes.jsonl" docs "$command sizes"
  echo "wrote docs/howto/choose.md, sizes"
fi
if wanted stability; then
  run_cases 1 stability_named stability_random stability_forces stability_bodies
  cat "${files[@]}" > "$build/stability.jsonl"
  python3 bench/report_stability.py "$build/stability.jsonl" docs "$command stability"
  echo "wrote docs/stability.md"
fi
python3 scripts/wrap_docs.py
