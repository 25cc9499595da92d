# Draws what wheel_on_rail left in a folder:  gnuplot -e "folder='out'" plot_wheel.gp
# The wheel's mesh, pressure and tractions, stick and slip, and sections along the rolling axis.
reset
if (!exists("folder")) folder = "."
stem = folder . "/wheel_on_rail"
nodes = stem . "_nodes.txt"
patches = stem . "_patches.txt"
section = stem . "_section.txt"
wheel = stem . "_wheel.txt"
mu = 0.1
stick_blue = "#2a6fbb"
slip_red = "#d1495b"
dark = "#333333"

set terminal pngcairo size 1500,1290 font "DejaVu Sans,15" background "white"
set output stem . ".png"
set encoding utf8
set multiplot
set tics out nomirror scale 0.6 tc rgb dark
set key off

# ---- the wheel upside down, zone on top
set origin 0, 0.46
set size 0.49, 0.52
unset border
unset tics
set view 56, 330, 1.3, 1
set view equal xyz
set xrange [-66:66]
set yrange [-66:66]
set zrange [-67:5]
unset colorbox
set pm3d depthorder border lc rgb "#5b6b7a" lw 0.35
set label 1 "Boundary elements of the wheel's rim" at screen 0.235, 0.965 center font ",17" tc rgb "black"
set label 2 "turned over; 1952 quadrilaterals; in red the frame of 14 × 15,\nhub side and cut faces held" \
    at screen 0.235, 0.943 center font ",13" tc rgb dark
color(tag) = tag == 2 ? 0xd1495b : tag == 1 ? 0xdfe9f2 : tag == 3 ? 0x8a98a6 : tag > 5 ? 0xa9b6c2 : 0xc4d1dc
splot wheel using 1:(-$2):(-$3):(color($4)) with pm3d fc rgb variable
unset label
set zrange [*:*]
set origin 0, 0
set size 1, 1

# ---- maps: the frame seen along n, rolling to the right
set border 15 lw 1 lc rgb "#888888"
set view map
set size ratio -1
set xrange [-2.745:2.745]
set yrange [-2.6:2.6]
set xtics 1 offset 0, 0.6 scale 0.6
set ytics 1 offset 0.5, 0 scale 0.6
set xlabel "x along t_1 [mm]" offset 0, 1.2
set ylabel "y along t_2 [mm]" offset 1, 0
set arrow 1 from 1.35, 2.3 to 2.55, 2.3 head filled size 0.15, 20 lw 2.5 lc rgb dark front
set label 1 "rolling" at 1.25, 2.3 right tc rgb dark front

set lmargin at screen 0.545; set rmargin at screen 0.915
set bmargin at screen 0.535; set tmargin at screen 0.945
set title "Pressure [MPa] and tractions on the wheel" font ",17" offset 0, -0.4
set palette defined (0 "#ffffff", 0.06 "#e6f4f4", 0.35 "#8fd0d2", 0.7 "#3b93b3", 1 "#17477e")
set cbrange [0:60]
set cbtics 20
set colorbox user origin 0.932, 0.60 size 0.012, 0.28
set pm3d scansautomatic map interpolate 10,10 corners2color mean noborder
splot patches using 1:2:3 with pm3d, \
      patches using 1:2:(0) with lines lw 0.35 lc rgb "#b0606060", \
      nodes using ($9 > 0 ? $1 : 1/0):2:(0):(0.085*$4):(0.085*$5):(0) \
        with vectors head filled size 0.09, 20 lw 1.7 lc rgb "#c1440e"

set lmargin at screen 0.06; set rmargin at screen 0.43
set bmargin at screen 0.05; set tmargin at screen 0.46
set title "Stick and slip zones, slip velocity of the wheel"
set label 2 "stick" at -2.55, 2.28 left tc rgb stick_blue font ",17" front
set label 3 "slip" at -2.55, 1.86 left tc rgb slip_red font ",17" front
unset colorbox
splot patches using 1:2:(0) with lines lw 0.35 lc rgb "#b0808080", \
      nodes using ($9 == 1 ? $1 : 1/0):2:(0) with points pt 7 ps 1.9 lc rgb stick_blue, \
      nodes using ($9 == 2 ? $1 : 1/0):2:(0) with points pt 7 ps 1.9 lc rgb "#f2cdd2", \
      nodes using ($9 == 2 ? $1 : 1/0):2:(0):(6*$6):(6*$7):(0) \
        with vectors head filled size 0.09, 20 lw 1.7 lc rgb slip_red
unset label
unset arrow

# ---- section along the rolling axis
set size noratio
set border 11 lw 1.2 lc rgb "#555555"
set xtics offset 0, 0.2
set xlabel offset 0, 0.4
set xrange [-2.745:2.745]
set grid ytics lc rgb "#e4e4e4" lw 1
set lmargin at screen 0.545; set rmargin at screen 0.925
set bmargin at screen 0.065; set tmargin at screen 0.42
set title "Along y = 0"
set ylabel "traction, friction bound [MPa]" offset 1, 0
set yrange [0:8]
set ytics 2
set y2range [0:0.08]
set y2tics 0.02 tc rgb slip_red
set y2label "slip speed [mm/s]" tc rgb slip_red offset -0.5, 0
set key horizontal maxcols 2 left top Left reverse samplen 2.2 spacing 1.15 tc rgb dark
plot section using 1:(mu*$3) smooth unique with lines lw 3 lc rgb "#17477e" title "μ p", \
     section using 1:4 smooth unique with lines lw 3 lc rgb "#c1440e" title "traction t_1", \
     section using 1:($3 > 0 ? (abs($6) < 1e-9 ? 0 : -$6) : 1/0) axes x1y2 smooth unique with lines lw 2.5 lc rgb slip_red dt 4 \
       title "slip speed -s_1 (right)"
unset multiplot
