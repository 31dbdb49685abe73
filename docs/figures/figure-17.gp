# To draw it again: gnuplot figure-17.gp
width_cm = 8.5
height_cm = 7.0600000000000005
load 'style.gp'

set logscale y
set format y '10^{%T}'
set yrange [1e-15:1e-13]
set ytics 1e1
set mytics 10
shown(y) = y > 0 ? y : (y <= 0 ? 1e-15 : NaN)
set ylabel 'position error [cm]'
set xlabel 'point'
set xrange [0.5:20.5]
set xtics 5
set xtics add ('1' 1)
set key maxcols 3

set terminal @svg
set output 'figure-17.svg'
plot NaN notitle, \
  'figure-17.dat' index 1 using 1:(shown($2)) with linespoints lw 0.7 dt 2 pt 6 ps 0.9 lc rgb '#999999' title 'as printed', \
  'figure-17.dat' index 0 using 1:(shown($2)) with linespoints ls 1 title 'IK-BA'
set terminal @pdf
set output 'figure-17.pdf'
replot
set terminal @png
set output 'figure-17.png'
replot
unset output
