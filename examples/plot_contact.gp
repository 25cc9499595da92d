# Draws what sphere_on_plane left in a folder:  gnuplot -e "folder='out'" plot_contact.gp
# Pressure and tractions, stick and slip, and two sections along the rolling axis.
if (!exists("folder")) folder = "."
nodes = folder . "/nodes.txt"
patches = folder . "/patches.txt"
section = folder . "/section.txt"
mu = 0.1
a = 1.0063  # Hertz's radius [mm] and pressure [MPa]
p0 = 140.8
lim = 1.34
stick_blue = "#2a6fbb"
slip_red = "#d1495b"
dark = "#333333"

set terminal pngcairo size 1500,1280 font "DejaVu Sans,15" background "white"
set output folder . "/sphere_on_plane.png"
set encoding utf8
set multiplot
set tics out nomirror scale 0.6 tc rgb dark
set border 15 lw 1 lc rgb "#888888"
set key off

# ---- maps: the frame seen along n, rolling to the right
set view map
set size ratio -1
set xrange [-lim:lim]
set yrange [-lim:lim]
set xtics 0.5 offset 0, 0.6
set ytics 0.5 offset 0.5, 0
set xlabel "x along t_1 [mm]" offset 0, 1.4
set ylabel "y along t_2 [mm]" offset 2.5, 0
set arrow 1 from 0.72, 1.27 to 1.26, 1.27 head filled size 0.07, 20 lw 2.5 lc rgb dark front
set label 1 "rolling" at 0.99, 1.17 center tc rgb dark front
set label 2 "leading edge" at 1.2, 0 rotate by -90 center tc rgb dark front
set label 3 "trailing edge" at -1.22, 0 rotate by 90 center tc rgb dark front

set lmargin at screen 0.055; set rmargin at screen 0.455
set bmargin at screen 0.46; set tmargin at screen 0.935
set title "Pressure [MPa], tractions on the sphere, frame" font ",17" offset 0, -0.4
set palette defined (0 "#ffffff", 0.06 "#e6f4f4", 0.35 "#8fd0d2", 0.7 "#3b93b3", 1 "#17477e")
set cbrange [0:150]
set cbtics 50
set colorbox user origin 0.462, 0.56 size 0.010, 0.28
set pm3d map interpolate 3,3 corners2color mean noborder
splot patches using 1:2:3 with pm3d, \
      patches using 1:2:(0) with lines lw 0.35 lc rgb "#b0606060", \
      nodes using ($8 > 0 ? $1 : 1/0):2:(0):(0.0125*$4):(0.0125*$5):(0) \
        with vectors head filled size 0.03, 20 lw 1.5 lc rgb "#c1440e"

set lmargin at screen 0.58; set rmargin at screen 0.98
unset ylabel
set title "Stick and slip zones, slip velocity of the sphere" font ",17"
set label 4 "stick" at -1.26, 1.25 left tc rgb stick_blue font ",17" front
set label 5 "slip" at -1.26, 1.10 left tc rgb slip_red font ",17" front
unset colorbox
splot patches using 1:2:(0) with lines lw 0.35 lc rgb "#b0808080", \
      nodes using ($8 == 1 ? $1 : 1/0):2:(0) with points pt 7 ps 1.5 lc rgb stick_blue, \
      nodes using ($8 == 2 ? $1 : 1/0):2:(0) with points pt 7 ps 1.5 lc rgb "#f2cdd2", \
      nodes using ($8 == 2 ? $1 : 1/0):2:(0):(3.2*$6):(3.2*$7):(0) \
        with vectors head filled size 0.03, 20 lw 1.5 lc rgb slip_red
unset label
unset arrow

# ---- sections along the rolling axis
set size noratio
set border 3 lw 1.2 lc rgb "#555555"
set xtics offset 0, 0.2
set xlabel offset 0, 0.5
set xrange [-1.32:1.32]
set key left top Left reverse samplen 2.2 spacing 1.15 tc rgb dark
set grid ytics lc rgb "#e4e4e4" lw 1
set bmargin at screen 0.065; set tmargin at screen 0.36

set lmargin at screen 0.065; set rmargin at screen 0.455
set title "Pressure along y = 0"
set ylabel "[MPa]" offset 1, 0
set yrange [0:185]
set ytics 50
plot p0*sqrt(1-(x/a)**2) with lines lw 2 dt 2 lc rgb "#888888" title "Hertz, no friction", \
     section using 1:3 smooth unique with lines lw 3 lc rgb "#17477e" title "rollcon, μ = 0.1"

set lmargin at screen 0.575; set rmargin at screen 0.9
set title "Friction along y = 0"
set ylabel "traction [MPa]" offset 1, 0
set yrange [0:21]
set ytics 5
set y2range [0:0.105]
set y2tics 0.025 tc rgb slip_red
set y2label "slip speed [mm/s]" tc rgb slip_red offset -1.5, 0
set border 11
set key horizontal maxcols 2
plot section using 1:(mu*$3) smooth unique with lines lw 2 dt 2 lc rgb "#888888" title "μ p", \
     section using 1:4 smooth unique with lines lw 3 lc rgb "#c1440e" title "traction t_1", \
     section using 1:($3 > 0 ? (abs($6) < 1e-9 ? 0 : -$6) : 1/0) axes x1y2 smooth unique with lines lw 2.5 lc rgb slip_red dt 4 \
       title "slip speed -s_1 (right)"
unset multiplot
