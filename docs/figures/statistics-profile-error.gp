# To draw it again: gnuplot statistics-profile-error.gp
width_cm = 8.5
height_cm = 7.42
load 'style.gp'

set logscale x 2
set xtics enhanced 1, 2**7
set format x '2^{%L}'
set xrange [0.4931163522466796:2251799813685248]
shown_x(x) = x < 0.4931163522466796 ? 0.4931163522466796 : (x > 2251799813685248 ? 2251799813685248 : x)
set xlabel 'position error / smallest of all solvers'
set ylabel 'share of problems'
set yrange [-0.02:1.02]
set ytics 0.2
set key maxcols 4

set terminal @svg
set output 'statistics-profile-error.svg'
plot NaN notitle, \
  'statistics-profile-error.dat' index 0 using (shown_x($1)):2 with lines ls 1 notitle, \
  'statistics-profile-error.dat' index 0 using (shown_x($1)):2 every 37::1 with points ls 1 dt 1 notitle, \
  keyentry with linespoints ls 1 title 'IK-BA', \
  'statistics-profile-error.dat' index 1 using (shown_x($1)):2 with lines ls 2 notitle, \
  'statistics-profile-error.dat' index 1 using (shown_x($1)):2 every 38::6 with points ls 2 dt 1 notitle, \
  keyentry with linespoints ls 2 title 'BA', \
  'statistics-profile-error.dat' index 2 using (shown_x($1)):2 with lines ls 3 notitle, \
  'statistics-profile-error.dat' index 2 using (shown_x($1)):2 every 38::11 with points ls 3 dt 1 notitle, \
  keyentry with linespoints ls 3 title 'DE', \
  'statistics-profile-error.dat' index 3 using (shown_x($1)):2 with lines ls 4 notitle, \
  'statistics-profile-error.dat' index 3 using (shown_x($1)):2 every 22::16 with points ls 4 dt 1 notitle, \
  keyentry with linespoints ls 4 title 'PSO', \
  'statistics-profile-error.dat' index 4 using (shown_x($1)):2 with lines ls 5 notitle, \
  'statistics-profile-error.dat' index 4 using (shown_x($1)):2 every 37::21 with points ls 5 dt 1 notitle, \
  keyentry with linespoints ls 5 title 'K-ABC', \
  'statistics-profile-error.dat' index 5 using (shown_x($1)):2 with lines ls 6 notitle, \
  'statistics-profile-error.dat' index 5 using (shown_x($1)):2 every 38::26 with points ls 6 dt 1 notitle, \
  keyentry with linespoints ls 6 title 'MO-PSO'
set terminal @pdf
set output 'statistics-profile-error.pdf'
replot
set terminal @png
set output 'statistics-profile-error.png'
replot
unset output
