# To draw it again: gnuplot figure-14.gp
width_cm = 8.5
height_cm = 8.86
load 'style.gp'

set size ratio -1
set xlabel 'x [cm]'
set ylabel 'y [cm]'
set xrange [6.899999999999988:25.1]
set yrange [6.899999999999993:25.10000000000001]
set key maxcols 3

set terminal @svg
set output 'figure-14.svg'
plot 'figure-14.dat' index 1 using 1:2 with lines lw 0.7 lc rgb '#888888' title 'circle', \
  '' index 0 using 1:2 with points pt 7 ps 0.35 lc rgb '#000000' title 'target', \
  '' index 0 using 4:5 with points pt 6 ps 0.9 lw 0.9 lc rgb '#0072B2' title 'reached', \
  '' index 2 using 1:2:(sprintf('%d', $3)) with labels notitle
set terminal @pdf
set output 'figure-14.pdf'
replot
set terminal @png
set output 'figure-14.png'
replot
unset output
