# Draws what manchester left in a folder:  gnuplot -e "folder='out'" plot_manchester.gp
# Over the lateral shift of the wheelset: where the wheels touch, rolling radii, forces and pressures.
reset
if (!exists("folder")) folder = "."
data = folder . "/manchester.txt"
right_blue = "#2a6fbb"
left_red = "#d1495b"
dark = "#333333"

set terminal pngcairo size 1400,1000 font "DejaVu Sans,14" background "white"
set output folder . "/manchester.png"
set encoding utf8
set multiplot layout 2,2 margins 0.08,0.97,0.08,0.95 spacing 0.1,0.12
set tics out nomirror scale 0.6 tc rgb dark
set grid lc rgb "#dddddd"
set xlabel "lateral shift of the wheelset, mm"
set key left top samplen 1
side(name) = sprintf("< awk '$2 == \"%s\"' %s", name, data)
set style data points

set title "where the wheels touch: distance from the track's middle, mm"
set key left center
plot side("right") using 1:4 pt 7 lc rgb right_blue title "right", \
     side("left") using 1:(-$4) pt 5 lc rgb left_red title "left"

set title "difference of the rolling radii, mm"
set key left top
plot "< awk '$2 == \"set\"' " . data using 1:6 with linespoints pt 7 lc rgb dark notitle

set title "forces on the rails, N: normal, and lateral along the patch"
plot side("right") using 1:12 pt 7 lc rgb right_blue title "right, lateral", \
     side("left") using 1:12 pt 5 lc rgb left_red title "left, lateral", \
     side("right") using 1:10 pt 6 lc rgb right_blue title "right, normal", \
     side("left") using 1:10 pt 4 lc rgb left_red title "left, normal"

set title "largest pressure, MPa"
plot side("right") using 1:14 pt 7 lc rgb right_blue title "right", \
     side("left") using 1:14 pt 5 lc rgb left_red title "left"
unset multiplot

# The right wheel on its rail with the pressures of its patches, and the equivalent conicity.
set output folder . "/manchester_profiles.png"
set multiplot layout 2,2 margins 0.08,0.97,0.08,0.95 spacing 0.1,0.14
set style fill solid 0.6 noborder
set xlabel "y in the track, mm"
set ylabel "z, downwards, mm" offset 1
set yrange [*:*] reverse
set size ratio -1
wheel_at(y) = sprintf("%s/manchester_%.1f.txt", folder, y)
array shift[3] = [0, 5, 6.5]
array from_y[3] = [730, 710, 700]
do for [i = 1:3] {
  file = wheel_at(shift[i])
  set xrange [*:*]
  set yrange [*:*]
  stats file using 1 nooutput
  set title sprintf("lateral shift %.1f mm; pressures 4 mm for 1000 MPa", shift[i])
  set xrange [from_y[i]:from_y[i] + 50]
  set yrange [20:-12]
  plot file index 0 with lines lw 2 lc rgb right_blue title "wheel", \
       file index 1 with lines lw 2 lc rgb dark title "rail", \
       for [k = 2:int(STATS_blocks) - 2] file index k with filledcurves closed lc rgb left_red notitle
}
set size noratio
set xrange [0:*]
set yrange [0:*] noreverse
unset ylabel
set xlabel "amplitude of the lateral motion, mm"
set title "equivalent conicity (EN 15302)"
plot folder . "/manchester_conicity.txt" with lines lw 2 lc rgb dark notitle
unset multiplot
