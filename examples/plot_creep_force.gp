# Draws what creep_force_table left in a folder:  gnuplot -e "folder='out'" plot_creep_force.gp
# Longitudinal and lateral force over longitudinal creepage, for lateral creepages and spins.
reset
if (!exists("folder")) folder = "."
table = folder . "/creep_force_table.csv"
load = 100000
limit = 0.3 * load
dark = "#333333"

set terminal pngcairo size 1400,620 font "DejaVu Sans,14" background "white"
set output folder . "/creep_force_table.png"
set encoding utf8
set datafile separator ","
set tics out nomirror tc rgb dark
set key bottom right
set xlabel "longitudinal creepage, per mille"
set xrange [-5:5]
set yrange [-1.05:1.05]
set multiplot layout 1,2
# One line of the table: a wheel load, a spin and a lateral creepage.
line(column_of_force, spin, lateral) = \
  (abs($1 - load) < 1 && abs($2 - spin) < 1e-9 && abs($3 - lateral) < 1e-9) ? \
  column(column_of_force) / limit : NaN
do for [force = 5:6] {
  set ylabel sprintf("F%d / (mu P)", force - 4)
  plot for [k = 0:4] table every ::1 using (1000 * $4):(line(force, 0, 1.25e-3 * k)) \
    with lines lw 2 title sprintf("lateral %.2f per mille", 1.25 * k), \
    table every ::1 using (1000 * $4):(line(force, 5e-4, 0)) with lines lw 2 dt 2 lc rgb dark \
    title "spin 0.5 per m"
}
unset multiplot
