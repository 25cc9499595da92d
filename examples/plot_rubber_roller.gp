# Draws what rubber_roller left in a folder:  gnuplot -e "folder='out'" plot_rubber_roller.gp
# Rolling resistance over speed; how far the roller sinks in, and how far ahead of its middle the pressure acts.
reset
if (!exists("folder")) folder = "."
table = folder . "/rubber_roller.csv"
dark = "#333333"

set terminal pngcairo size 1400,620 font "DejaVu Sans,14" background "white"
set output folder . "/rubber_roller.png"
set encoding utf8
set datafile separator ","
set tics out nomirror tc rgb dark
set logscale x
set format x "10^{%T}"
set xlabel "rolling speed, mm/s"
set multiplot layout 1,2
set ylabel "rolling resistance over load"
set yrange [0:*]
unset key
plot table every ::1 using 1:2 with linespoints lw 2 pt 7 lc rgb "#c0392b"
set ylabel "mm"
set key top right
plot table every ::1 using 1:3 with linespoints lw 2 pt 7 title "approach", \
  table every ::1 using 1:5 with linespoints lw 2 pt 5 title "pressure ahead of the middle"
unset multiplot
