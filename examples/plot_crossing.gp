# Draws what crossing left in a folder:  gnuplot -e "folder='out'" plot_crossing.gp
# The crossing from above with the patches of the passing wheel, and forces and height over distance.
reset
if (!exists("folder")) folder = "."
data = folder . "/crossing.txt"
dark = "#333333"
nose(x) = x < 560 ? NaN : 12 + 0.1 * (x - 560) # right side of the nose, and the running edge of the wing rail
wing(x) = 56 + 0.1 * (x - 560)

set terminal pngcairo size 1200,1100 font "DejaVu Sans,14" background "white"
set output folder . "/crossing.png"
set encoding utf8
set multiplot layout 3,1 margins 0.09,0.87,0.07,0.96 spacing 0.02,0.08
set tics out nomirror scale 0.6 tc rgb dark
set grid lc rgb "#dddddd"
set xrange [490:840]
set samples 600

set title "from above: patches, largest pressure in MPa by colour, area by normal force"
set ylabel "y, mm"
set yrange [150:-8]
set palette defined (0 "#2a6fbb", 1 "#e9c46a", 2 "#d1495b")
set style fill solid 0.35 noborder
set key off
plot "+" using 1:(wing($1)):(wing($1) + 70) with filledcurves lc rgb "#aaaaaa", \
     "+" using 1:(nose($1)):(0) with filledcurves lc rgb "#aaaaaa", \
     data using 2:3:(sqrt($5) / 120):9 with points pt 7 ps variable lc palette

unset colorbox
set title "forces on the rail, kN"
set ylabel "kN"
set yrange [*:*]
set key center right
plot data using 1:($3 > nose($1) + 22 || $1 < 560 ? $5 / 1000 : NaN) with points pt 7 lc rgb dark title "normal, wing rail", \
     data using 1:($3 < nose($1) + 22 ? $5 / 1000 : NaN) with points pt 6 lc rgb "#d1495b" title "normal, nose", \
     data using 1:($7 / 1000) with lines lw 2 lc rgb "#2a6fbb" title "longitudinal", \
     data using 1:($8 / 1000) with lines lw 2 lc rgb "#2a9d5b" title "lateral"

set xlabel "x, mm"
set title "height of the wheel, mm (z is down)"
set ylabel "mm"
set yrange [] reverse
plot data using 1:6 with lines lw 2 lc rgb dark notitle
unset multiplot
