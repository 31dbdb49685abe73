# To draw it again: gnuplot figure-8.gp
width_cm = 8.5
height_cm = 7.42
load 'style.gp'

set yrange [0:1.9102539749999998]
shown(y) = y * 1000
set ylabel 'computing time [ms]'
set xlabel 'point'
set xrange [0.5:20.5]
set xtics 5
set xtics add ('1' 1)
set key maxcols 4

set terminal @svg
set output 'figure-8.svg'
plot NaN notitle, \
  'figure-8.dat' using 1:(shown($2)) with linespoints ls 1 pointinterval 1 title 'IK-BA', \
  'figure-8.dat' using 1:(shown($3)) with linespoints ls 2 pointinterval 1 title 'BA', \
  'figure-8.dat' using 1:(shown($4)) with linespoints ls 3 pointinterval 1 title 'DE', \
  'figure-8.dat' using 1:(shown($5)) with linespoints ls 4 pointinterval 1 title 'PSO', \
  'figure-8.dat' using 1:(shown($6)) with linespoints ls 5 pointinterval 1 title 'K-ABC', \
  'figure-8.dat' using 1:(shown($7)) with linespoints ls 6 pointinterval 1 title 'MO-PSO'
set terminal @pdf
set output 'figure-8.pdf'
replot
set terminal @png
set output 'figure-8.png'
replot
unset output
