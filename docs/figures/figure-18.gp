# To draw it again: gnuplot figure-18.gp
width_cm = 8.5
height_cm = 7.0600000000000005
load 'style.gp'

set logscale y
set format y '10^{%T}'
set yrange [1e-15:1e0]
set ytics 1e3
set mytics 1
shown(y) = y > 0 ? y : (y <= 0 ? 1e-15 : NaN)
set ylabel 'average position error [cm]'
set xlabel 'iteration'
set xrange [0:1000]
set key maxcols 2

set terminal @svg
set output 'figure-18.svg'
plot 'figure-18.dat' index 0 using 1:(shown($2)) with lines ls 1 lw 1.3 title 'IK-BA', \
  6.563976925264363e-15 with lines lw 0.9 dt 2 lc rgb '#777777' title 'order of rounding'
set terminal @pdf
set output 'figure-18.pdf'
replot
set terminal @png
set output 'figure-18.png'
replot
unset output
