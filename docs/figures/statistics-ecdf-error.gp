# To draw it again: gnuplot statistics-ecdf-error.gp
width_cm = 8.5
height_cm = 7.42
load 'style.gp'

set logscale x
set xtics enhanced 1e-18, 1e3
set format x '10^{%T}'
set mxtics 1
set xrange [6.578265469094981e-16:47.5303976352167]
shown_x(x) = x < 6.578265469094981e-16 ? 6.578265469094981e-16 : (x > 47.5303976352167 ? 47.5303976352167 : x)
set xlabel 'position error [cm]'
set ylabel 'share of solves'
set yrange [-0.02:1.02]
set ytics 0.2
set key maxcols 4

set terminal @svg
set output 'statistics-ecdf-error.svg'
plot NaN notitle, \
  'statistics-ecdf-error.dat' index 0 using (shown_x($1)):2 with lines ls 1 notitle, \
  'statistics-ecdf-error.dat' index 0 using (shown_x($1)):2 every 34::1 with points ls 1 dt 1 notitle, \
  keyentry with linespoints ls 1 title 'IK-BA', \
  'statistics-ecdf-error.dat' index 1 using (shown_x($1)):2 with lines ls 2 notitle, \
  'statistics-ecdf-error.dat' index 1 using (shown_x($1)):2 every 38::6 with points ls 2 dt 1 notitle, \
  keyentry with linespoints ls 2 title 'BA', \
  'statistics-ecdf-error.dat' index 2 using (shown_x($1)):2 with lines ls 3 notitle, \
  'statistics-ecdf-error.dat' index 2 using (shown_x($1)):2 every 35::11 with points ls 3 dt 1 notitle, \
  keyentry with linespoints ls 3 title 'DE', \
  'statistics-ecdf-error.dat' index 3 using (shown_x($1)):2 with lines ls 4 notitle, \
  'statistics-ecdf-error.dat' index 3 using (shown_x($1)):2 every 34::16 with points ls 4 dt 1 notitle, \
  keyentry with linespoints ls 4 title 'PSO', \
  'statistics-ecdf-error.dat' index 4 using (shown_x($1)):2 with lines ls 5 notitle, \
  'statistics-ecdf-error.dat' index 4 using (shown_x($1)):2 every 28::21 with points ls 5 dt 1 notitle, \
  keyentry with linespoints ls 5 title 'K-ABC', \
  'statistics-ecdf-error.dat' index 5 using (shown_x($1)):2 with lines ls 6 notitle, \
  'statistics-ecdf-error.dat' index 5 using (shown_x($1)):2 every 37::26 with points ls 6 dt 1 notitle, \
  keyentry with linespoints ls 6 title 'MO-PSO'
set terminal @pdf
set output 'statistics-ecdf-error.pdf'
replot
set terminal @png
set output 'statistics-ecdf-error.png'
replot
unset output
