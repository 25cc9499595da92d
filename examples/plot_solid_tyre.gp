# Draws what solid_tyre.py left in a folder:  gnuplot -e "folder='out'" plot_solid_tyre.gp
# Rolling resistance over speed; the part of the power that each harmonic of the way round the tyre loses.
reset
if (!exists("folder")) folder = "."
dark = "#333333"
set terminal pngcairo size 1400,620 font "DejaVu Sans,14" background "white"
set output folder . "/solid_tyre.png"
set encoding utf8
set datafile separator ","
set tics out nomirror tc rgb dark
set multiplot layout 1,2
set logscale x
set format x "10^{%T}"
set xlabel "rolling speed, mm/s"
set ylabel "rolling resistance, N"
set yrange [0:*]
unset key
plot folder . "/solid_tyre.csv" every ::1 using 1:2 with linespoints lw 2 pt 7 lc rgb "#c0392b"
unset logscale x
set format x "%g"
set xlabel "harmonic of the way round"
set ylabel "part of the power lost"
set key top right
plot for [k=2:5] folder . "/solid_tyre_harmonics.csv" every ::1 using 1:k \
  with lines lw 2 title sprintf("10^{%d} mm/s", k-1)
unset multiplot
