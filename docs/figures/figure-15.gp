# To draw it again: gnuplot figure-15.gp
width_cm = 8.5
height_cm = 8
load 'style.gp'

set label '1' at 26.149999999999995, 16, -8.049116928532385e-15 center tc rgb word(colours, 2) front
set label '8' at 10.03397968923138, 24.21152249290572, -8.049116928532385e-15 center tc rgb word(colours, 3) front
set label '15' at 12.863477507094291, 6.346776359604183, 8.049116928532385e-15 center tc rgb word(colours, 4) front
set xrange [-1.1500000000000004:24.15]
set xtics 10 offset 0, 0
set yrange [-1.1500000000000004:24.15]
set ytics 10 offset 0, 0
set zrange [-5.30327840491663:19.996721595083372]
set ztics 10 offset 0, 0
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
set output 'figure-15.svg'
splot 'figure-15.dat' index 2 using 1:2:3 with linespoints lw 1.5 pt 7 ps 0.45 lc rgb word(colours, 2), \
  'figure-15.dat' index 3 using 1:2:3 with linespoints lw 1.5 pt 7 ps 0.45 lc rgb word(colours, 3), \
  'figure-15.dat' index 4 using 1:2:3 with linespoints lw 1.5 pt 7 ps 0.45 lc rgb word(colours, 4), \
  'figure-15.dat' index 1 using 1:2:3 with lines lw 0.7 lc rgb '#888888', \
  '' index 0 using 1:2:3 with points pt 7 ps 0.35 lc rgb '#000000' title 'target', \
  '' index 0 using 4:5:6 with points pt 6 ps 0.9 lw 0.9 lc rgb '#0072B2' title 'reached'
set terminal @pdf
set output 'figure-15.pdf'
replot
set terminal @png
set output 'figure-15.png'
replot
unset output
