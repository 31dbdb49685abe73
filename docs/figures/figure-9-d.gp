# To draw it again: gnuplot figure-9-d.gp
width_cm = 8.5
height_cm = 7.78
load 'style.gp'

set title 'PSO' noenhanced offset 0, -0.6
set tmargin 2
set ylabel 'joint angle [deg]'
set yrange [-180:180]
set ytics 60
set xlabel 'point'
set xrange [0.5:20.5]
set xtics 5
set xtics add ('1' 1)
set key maxcols 3

set terminal @svg
set output 'figure-9-d.svg'
plot 'figure-9-d.dat' using 1:($2) with linespoints ls 1 title 'joint 1', \
  'figure-9-d.dat' using 1:($3) with linespoints ls 2 title 'joint 2', \
  'figure-9-d.dat' using 1:($4) with linespoints ls 3 title 'joint 3', \
  'figure-9-d.dat' using 1:($5) with linespoints ls 4 title 'joint 4', \
  'figure-9-d.dat' using 1:($6) with linespoints ls 5 title 'joint 5', \
  'figure-9-d.dat' using 1:($7) with linespoints ls 6 title 'joint 6', \
  'figure-9-d.dat' using 1:($8) with linespoints ls 7 title 'joint 7'
set terminal @pdf
set output 'figure-9-d.pdf'
replot
set terminal @png
set output 'figure-9-d.png'
replot
unset output
