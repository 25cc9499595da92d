# The six fields of the paper's figure 19, from what wheel_on_rail left in a folder:
#   gnuplot -e "folder='out'" plot_wheel_fields.gp
# Signs are rollcon's: slip of the wheel relative to the rail, tractions on the wheel.
reset
if (!exists("folder")) folder = "."
stem = folder . "/wheel_on_rail"
patches = stem . "_patches.txt"
set terminal pngcairo size 1660,1330 font "DejaVu Sans,14" background "white"
set output stem . "_fields.png"
set encoding utf8
set multiplot layout 2,3 columnsfirst margins 0.04, 0.925, 0.055, 0.955 spacing 0.105, 0.10
set tics out nomirror scale 0.6
set border 15 lw 1 lc rgb "#888888"
set key off
set title font ",16" offset 0, -0.3
set view map
set size ratio -1
set xrange [-2.745:2.745]
set yrange [-3.5:3.5]
set xtics 1 offset 0, 0.5
set ytics 1 offset 0.5, 0
set xlabel "x along t_1 (rolling) [mm]" offset 0, 0.9
set ylabel "y along t_2 [mm]" offset 0, 0
set pm3d map interpolate 10,10 corners2color mean noborder
signed = "defined (-1 '#8c2d04', -0.6 '#e08214', -0.2 '#fee0b6', 0 '#ffffff', 0.2 '#d8daeb', 0.6 '#8073ac', 1 '#2d004b')"
mesh = "patches using 1:2:(0) with lines lw 0.3 lc rgb '#c0707070'"
set macros
set palette @signed
set cbrange [-0.07:0.07]
set cbtics 0.02
set title "(a) slip velocity s_1 [mm/s]"
splot patches using 1:2:6 with pm3d, @mesh
set cbrange [-5:5]
set cbtics 2
set title "(b) traction λ_1 [MPa]"
splot patches using 1:2:4 with pm3d, @mesh
set cbrange [-0.025:0.025]
set cbtics 0.01
set title "(c) slip velocity s_2 [mm/s]"
splot patches using 1:2:7 with pm3d, @mesh
set cbrange [-5:5]
set cbtics 2
set title "(d) traction λ_2 [MPa]"
splot patches using 1:2:5 with pm3d, @mesh
set palette defined (0 "#ffffff", 0.25 "#d0e6d0", 0.6 "#5fa777", 1 "#16502d")
set cbrange [0:0.025]
set cbtics 0.005
set title "(e) normal gap k_n [mm]"
splot patches using 1:2:8 with pm3d, @mesh
set palette defined (0 "#17477e", 0.3 "#3b93b3", 0.65 "#8fd0d2", 0.94 "#e6f4f4", 1 "#ffffff")
set cbrange [-60:0]
set cbtics 20
set title "(f) normal traction λ_n [MPa]"
splot patches using 1:2:(-$3) with pm3d, @mesh
unset multiplot
