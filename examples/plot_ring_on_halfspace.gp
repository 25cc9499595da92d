# Draws what ring_on_halfspace left in a folder, after the paper's figures 9 and 10:
#   gnuplot -e "folder='out'" plot_ring_on_halfspace.gp
# Signs are rollcon's: slip of the ring relative to the ground, tractions on the ring.
reset
if (!exists("folder")) folder = "."
stem = folder . "/ring_on_halfspace"
nodes = stem . "_nodes.txt"
patches = stem . "_patches.txt"
section = stem . "_section.txt"
long = stem . "_long.txt"
ring = stem . "_ring.txt"
ground = stem . "_ground.txt"
mu = 0.1
a = 0.9918  # Hertz's half-width [mm] and pressure [MPa], long cylinder on a plane
p0 = 107.91
stats nodes using 1 nooutput name "x"
stats nodes using 8 nooutput name "gap"
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

# ---- the ring on the ground; its side is meshed like every section across the axle
set origin 0, 0.465
set size 0.36, 0.46
unset border
unset tics
set view 74, 28, 1.65, 1
set view equal xyz
set xrange [-52:52]
set yrange [-52:52]
set zrange [-2:102]
unset colorbox
set cbrange [0:1]  # of no use here
set pm3d depthorder border lc rgb "#5b6b7a" lw 0.35
set label 1 "Ring on a half-space" at screen 0.24, 0.965 center font ",17" tc rgb "black"
set label 2 "finite elements, hub held" at screen 0.24, 0.943 center font ",13" tc rgb dark
color(tag) = tag < 3 ? 0xdfe9f2 : tag == 3 ? 0x8a98a6 : 0xc4d1dc
splot ground using 1:2:3:(0xe9dfcf) with pm3d fc rgb variable  # first: the ring hides it
unset label
splot ring using 1:2:3:(color($4)) with pm3d fc rgb variable

# ---- its elements near the contact, seen along the axle
set size 1, 1
set origin 0, 0
set view map
set size noratio
set lmargin at screen 0.325; set rmargin at screen 0.485
set bmargin at screen 0.56; set tmargin at screen 0.74
set xrange [-2.7:2.7]
set yrange [-0.35:5.05]
set zrange [*:*]
set pm3d scansautomatic border lc rgb "#5b6b7a" lw 0.7 clip4in
set label 1 "elements at the contact, 5.4 mm" at screen 0.405, 0.753 center font ",12" tc rgb dark
set object 1 rectangle from graph 0, 0 to graph 1, 1 fs empty border lc rgb "#5b6b7a" front
set object 2 rectangle from -2.7, -0.35 to 2.7, 0 fc rgb "#e9dfcf" fs solid noborder behind
splot ring using 1:($4 == 4 ? $3 : 1/0):(0):(color($4)) with pm3d fc rgb variable
unset object
unset label

# ---- maps: the frame seen along n, rolling to the right; x is stretched
set border 15 lw 1 lc rgb "#888888"
set xrange [-half:half]
set yrange [-4:4]
set xtics 0.5 offset 0, 0.6 scale 0.6
set ytics 1 offset 0.5, 0 scale 0.6
set xlabel "x along t_1 [mm]" offset 0, 1.2
set ylabel "y along t_2 [mm]" offset 0.2, 0
set pm3d scansautomatic map interpolate 10,10 corners2color mean noborder clip1in

set lmargin at screen 0.56; set rmargin at screen 0.90
set bmargin at screen 0.545; set tmargin at screen 0.945
set title "Pressure [MPa] and tractions on the ring" font ",17" offset 0, -0.4
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
set title "Stick and slip zones, slip velocity of the ring"
set label 2 "stick" at 0.97*half, 3.55 right tc rgb stick_blue font ",17" front
set label 3 "slip" at -0.97*half, 3.55 left tc rgb slip_red font ",17" front
unset colorbox
splot patches using 1:2:(0) with lines lw 0.35 lc rgb "#b0808080", \
      nodes using ($9 == 1 ? $1 : 1/0):2:(0) with points pt 7 ps 1.7 lc rgb stick_blue, \
      nodes using ($9 == 2 ? $1 : 1/0):2:(0) with points pt 7 ps 1.7 lc rgb "#f2cdd2", \
      nodes using ($9 == 2 ? $1 : 1/0):2:(0):(5*$6):(5*$7):(0) \
        with vectors head filled size 0.035, 20 lw 1.7 lc rgb slip_red
unset label

# ---- section at mid-plane beside long cylinders
set border 3 lw 1.2 lc rgb "#555555"
set xtics 0.5 nomirror offset 0, 0.2
set xlabel "x / a" offset 0, 0.4
unset ylabel
set xrange [-half/a:half/a]
set yrange [0:1.3]
set ytics 0.25 nomirror
set grid ytics lc rgb "#e4e4e4" lw 1
set lmargin at screen 0.56; set rmargin at screen 0.96
set bmargin at screen 0.075; set tmargin at screen 0.43
set title "Mid-plane y = 0, as fractions (dashed: long cylinders)"
set key left top Left reverse maxrows 2 samplen 2.2 width -2 spacing 1.15 tc rgb dark
plot (abs(x) < 1 ? sqrt(1 - x*x) : 1/0) with lines lw 2 dt 2 lc rgb "#17477e" notitle, \
     long using ($1/a):($4/(mu*p0)) smooth unique with lines lw 2 dt 2 lc rgb "#c1440e" notitle, \
     long using ($3 > 0 ? $1/a : 1/0):(abs($6)/0.1) smooth unique with lines lw 2 dt 2 lc rgb slip_red notitle, \
     section using ($1/a):($3/p0) smooth unique with linespoints pt 7 ps 0.8 lw 2.5 lc rgb "#17477e" title "p / p_0", \
     section using ($1/a):($4/(mu*p0)) smooth unique with linespoints pt 7 ps 0.8 lw 2.5 lc rgb "#c1440e" title "t_1 / μp_0", \
     section using ($1/a):($8/gap_max) smooth unique with linespoints pt 7 ps 0.8 lw 2 lc rgb "#5fa777" \
       title sprintf("gap / %.4f mm", gap_max), \
     section using ($1/a):(sqrt($6**2 + $7**2)/0.1) smooth unique with linespoints pt 7 ps 0.8 lw 2 lc rgb slip_red \
       title "slip / 0.1 mm/s"
unset multiplot
