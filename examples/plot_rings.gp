# Draws what two_rings left in a folder, after the paper's figures 7(b) and 8:
#   gnuplot -e "folder='out'" plot_rings.gp
# Signs are rollcon's: slip of the lower ring relative to the upper one, tractions on the lower.
reset
if (!exists("folder")) folder = "."
stem = folder . "/two_rings"
nodes = stem . "_nodes.txt"
patches = stem . "_patches.txt"
section = stem . "_section.txt"
lower = stem . "_lower.txt"
upper = stem . "_upper.txt"
mu = 0.1
a = 0.94525  # Hertz's half-width [mm] and pressure [MPa], long cylinders
p0 = 103.87
stats nodes using 1 nooutput name "x"
stats nodes using 8 nooutput name "gap"
stats nodes using (sqrt($6**2 + $7**2)) nooutput name "slip"
half = x_max
stick_blue = "#2a6fbb"
slip_red = "#d1495b"
dark = "#333333"

set terminal pngcairo size 1500,1330 font "DejaVu Sans,15" background "white"
set output stem . ".png"
set encoding utf8
set multiplot
set tics out nomirror scale 0.6 tc rgb dark
set key off

# ---- the rings
set origin 0, 0.465
set size 0.49, 0.46
unset border
unset tics
set view 72, 24, 1.0, 1
set view equal xyz
set xrange [-52:52]
set yrange [-52:52]
set zrange [-52:152]
unset colorbox
set pm3d depthorder border lc rgb "#5b6b7a" lw 0.35
set label 1 "Two equal rings" at screen 0.24, 0.965 center font ",17" tc rgb "black"
set label 2 "boundary elements, hubs held; one body, placed twice" at screen 0.24, 0.943 center font ",13" tc rgb dark
color(tag) = tag < 3 ? 0xdfe9f2 : tag == 3 ? 0x8a98a6 : 0xc4d1dc
splot lower using 1:2:3:(color($4)) with pm3d fc rgb variable, \
      upper using 1:2:3:(color($4)) with pm3d fc rgb variable
unset label
set zrange [*:*]
set origin 0, 0
set size 1, 1

# ---- maps: the frame seen along n, rolling to the right; x is stretched
set border 15 lw 1 lc rgb "#888888"
set view map
set size noratio
set xrange [-half:half]
set yrange [-4:4]
set xtics 0.5 offset 0, 0.6 scale 0.6
set ytics 1 offset 0.5, 0 scale 0.6
set xlabel "x along t_1 [mm]" offset 0, 1.2
set ylabel "y along t_2 [mm]" offset 1, 0
set pm3d scansautomatic map interpolate 10,10 corners2color mean noborder

set lmargin at screen 0.56; set rmargin at screen 0.90
set bmargin at screen 0.545; set tmargin at screen 0.945
set title "Pressure [MPa] and tractions on the lower ring" font ",17" offset 0, -0.4
set palette defined (0 "#ffffff", 0.06 "#e6f4f4", 0.35 "#8fd0d2", 0.7 "#3b93b3", 1 "#17477e")
set cbrange [0:120]
set cbtics 20
set colorbox user origin 0.92, 0.60 size 0.012, 0.28
splot patches using 1:2:3 with pm3d, \
      patches using 1:2:(0) with lines lw 0.35 lc rgb "#b0606060", \
      nodes using ($9 > 0 ? $1 : 1/0):2:(0):(0.021*$4):(0.021*$5):(0) \
        with vectors head filled size 0.035, 20 lw 1.7 lc rgb "#c1440e"

set lmargin at screen 0.06; set rmargin at screen 0.44
set bmargin at screen 0.06; set tmargin at screen 0.44
set title "Stick and slip zones, slip velocity of the lower ring"
set label 2 "stick" at 0.97*half, 3.55 right tc rgb stick_blue font ",17" front
set label 3 "slip" at -0.97*half, 3.55 left tc rgb slip_red font ",17" front
unset colorbox
splot patches using 1:2:(0) with lines lw 0.35 lc rgb "#b0808080", \
      nodes using ($9 == 1 ? $1 : 1/0):2:(0) with points pt 7 ps 1.7 lc rgb stick_blue, \
      nodes using ($9 == 2 ? $1 : 1/0):2:(0) with points pt 7 ps 1.7 lc rgb "#f2cdd2", \
      nodes using ($9 == 2 ? $1 : 1/0):2:(0):(5*$6):(5*$7):(0) \
        with vectors head filled size 0.035, 20 lw 1.7 lc rgb slip_red
unset label

# ---- section at mid-plane, as the paper normalises it
set border 3 lw 1.2 lc rgb "#555555"
set xtics 0.5 offset 0, 0.2
set xlabel "x / a" offset 0, 0.4
unset ylabel
set xrange [-half/a:half/a]
set yrange [0:1.45]
set ytics 0.25
set grid ytics lc rgb "#e4e4e4" lw 1
set lmargin at screen 0.56; set rmargin at screen 0.96
set bmargin at screen 0.075; set tmargin at screen 0.43
set title "Mid-plane y = 0, as fractions"
set key left top Left reverse maxrows 3 samplen 2.2 width -2 spacing 1.15 tc rgb dark
plot (abs(x) < 1 ? sqrt(1 - x*x) : 1/0) with lines lw 2 dt 2 lc rgb "#888888" title "Hertz", \
     section using ($1/a):($3/p0) smooth unique with linespoints pt 7 ps 0.8 lw 2.5 lc rgb "#17477e" title "p / p_0", \
     section using ($1/a):($4/(mu*p0)) smooth unique with linespoints pt 7 ps 0.8 lw 2.5 lc rgb "#c1440e" title "t_1 / μp_0", \
     section using ($1/a):($8/gap_max) smooth unique with linespoints pt 7 ps 0.8 lw 2 lc rgb "#5fa777" \
       title sprintf("gap / %.4f mm", gap_max), \
     section using ($1/a):(sqrt($6**2 + $7**2)/slip_max) smooth unique with linespoints pt 7 ps 0.8 lw 2 lc rgb slip_red \
       title sprintf("slip / %.4f mm/s", slip_max)
unset multiplot
