# To draw it again: gnuplot figure-5.gp
width_cm = 8.5
height_cm = 8
load 'style.gp'

set xrange [33.875:86.125]
set xtics 20 offset 0, 0
set yrange [-26.124999999999996:26.124999999999996]
set ytics 20 offset 0, 0
set zrange [7.6250000000000036:59.875]
set ztics 20 offset 0, 0
set xlabel 'x [cm]' offset -1, 0.3
set ylabel 'y [cm]'
set zlabel 'z [cm]' rotate parallel
set view 62, 32, 1.1
set view equal xyz
set xyplane relative 0
set border 127 lw 0.5 lc rgb '#AAAAAA'
set tics textcolor rgb '#000000'
set grid xtics ytics ztics
unset key

set terminal @svg
set output 'figure-5.svg'
splot 'figure-5.dat' using 1:2:3 with lines lw 0.7 lc rgb '#888888', \
  'figure-5.dat' using 1:2:3 with points pt 7 ps 0.35 lc rgb '#000000', \
  'figure-5.dat' using 4:5:6 with points pt 6 ps 0.8 lw 0.8 lc rgb '#0072B2', \
  'figure-5.dat' using 1:2:3:('start') every ::0::0 with labels right offset -0.9,0.4
set terminal @pdf
set output 'figure-5.pdf'
replot
set terminal @png
set output 'figure-5.png'
replot
unset output
