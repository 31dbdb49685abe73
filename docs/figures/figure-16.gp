# To draw it again: gnuplot figure-16.gp
width_cm = 8.5
height_cm = 7.42
load 'style.gp'

set arrow from graph 0, first -90 to graph 1, first -90 nohead lw 0.7 dt 2 lc rgb word(colours, 1)
set arrow from graph 0, first 90 to graph 1, first 90 nohead lw 0.7 dt 2 lc rgb word(colours, 1)
set arrow from graph 0, first 0 to graph 1, first 0 nohead lw 0.7 dt 2 lc rgb word(colours, 2)
set arrow from graph 0, first 85 to graph 1, first 85 nohead lw 0.7 dt 2 lc rgb word(colours, 2)
set arrow from graph 0, first -10 to graph 1, first -10 nohead lw 0.7 dt 2 lc rgb word(colours, 3)
set arrow from graph 0, first 95 to graph 1, first 95 nohead lw 0.7 dt 2 lc rgb word(colours, 3)
set yrange [-99.25:104.25]
set ytics 30
set ylabel 'joint angle [deg]'
set xlabel 'point'
set xrange [0.5:20.5]
set xtics 5
set xtics add ('1' 1)
set key maxcols 3

set terminal @svg
set output 'figure-16.svg'
plot NaN notitle, \
  'figure-16.dat' index 1 using 1:2 with points pt 6 ps 0.9 lc rgb '#999999' title 'as printed', \
  'figure-16.dat' index 1 using 1:3 with points pt 6 ps 0.9 lc rgb '#999999' notitle, \
  'figure-16.dat' index 1 using 1:4 with points pt 6 ps 0.9 lc rgb '#999999' notitle, \
  'figure-16.dat' index 0 using 1:2 with linespoints ls 1 title 'joint 1', \
  'figure-16.dat' index 0 using 1:3 with linespoints ls 2 title 'joint 2', \
  'figure-16.dat' index 0 using 1:4 with linespoints ls 3 title 'joint 3'
set terminal @pdf
set output 'figure-16.pdf'
replot
set terminal @png
set output 'figure-16.png'
replot
unset output
