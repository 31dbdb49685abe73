# To draw it again: gnuplot statistics-time-observations.gp
width_cm = 8.5
height_cm = 8.9
load 'style.gp'

unset key
set yrange [6.5:0.5]
set ytics noenhanced font ',7' ('IK-BA' 1, 'BA' 2, 'DE' 3, 'PSO' 4, 'K-ABC' 5, 'MO-PSO' 6)
set border 1
set ytics scale 0
set grid noytics
set xtics enhanced
set format x '%.6g'
set xrange [0.00018628681200000003:0.0018399021880000001]
set xtics 5e-04
shown(x) = x
set xlabel 'computing time [s]' noenhanced

set terminal @svg
set output 'statistics-time-observations.svg'
plot 'statistics-time-observations.dat' index 1 using (shown($1)):2 with filledcurves closed lc rgb word(colours, 1) fs solid 0.3 noborder, \
  'statistics-time-observations.dat' index 1 using (shown($1)):2 with lines lw 0.8 dt 1 lc rgb word(colours, 1), \
  'statistics-time-observations.dat' index 2 using (shown($1)):2 with points pt 6 ps 0.3 lw 0.7 lc rgb word(colours, 1), \
  'statistics-time-observations.dat' index 0 every ::0::0 using (shown($2)):($1+0.03):(shown($6)-shown($2)):(0) with vectors nohead lw 0.9 lc rgb word(colours, 1), \
  'statistics-time-observations.dat' index 0 every ::0::0 using (shown($4)):($1+0.03):(shown($3)):(shown($5)):($1+-0.03):($1+0.09) with boxxyerror fs solid 0.15 border lw 0.9 lc rgb word(colours, 1), \
  'statistics-time-observations.dat' index 0 every ::0::0 using (shown($4)):($1+-0.03):(0):(0.12) with vectors nohead lw 1.6 lc rgb '#000000', \
  'statistics-time-observations.dat' index 3 using (shown($1)):2 with filledcurves closed lc rgb word(colours, 2) fs solid 0.3 noborder, \
  'statistics-time-observations.dat' index 3 using (shown($1)):2 with lines lw 0.8 dt 1 lc rgb word(colours, 2), \
  'statistics-time-observations.dat' index 4 using (shown($1)):2 with points pt 6 ps 0.3 lw 0.7 lc rgb word(colours, 2), \
  'statistics-time-observations.dat' index 0 every ::1::1 using (shown($2)):($1+0.03):(shown($6)-shown($2)):(0) with vectors nohead lw 0.9 lc rgb word(colours, 2), \
  'statistics-time-observations.dat' index 0 every ::1::1 using (shown($4)):($1+0.03):(shown($3)):(shown($5)):($1+-0.03):($1+0.09) with boxxyerror fs solid 0.15 border lw 0.9 lc rgb word(colours, 2), \
  'statistics-time-observations.dat' index 0 every ::1::1 using (shown($4)):($1+-0.03):(0):(0.12) with vectors nohead lw 1.6 lc rgb '#000000', \
  'statistics-time-observations.dat' index 5 using (shown($1)):2 with filledcurves closed lc rgb word(colours, 3) fs solid 0.3 noborder, \
  'statistics-time-observations.dat' index 5 using (shown($1)):2 with lines lw 0.8 dt 1 lc rgb word(colours, 3), \
  'statistics-time-observations.dat' index 6 using (shown($1)):2 with points pt 6 ps 0.3 lw 0.7 lc rgb word(colours, 3), \
  'statistics-time-observations.dat' index 0 every ::2::2 using (shown($2)):($1+0.03):(shown($6)-shown($2)):(0) with vectors nohead lw 0.9 lc rgb word(colours, 3), \
  'statistics-time-observations.dat' index 0 every ::2::2 using (shown($4)):($1+0.03):(shown($3)):(shown($5)):($1+-0.03):($1+0.09) with boxxyerror fs solid 0.15 border lw 0.9 lc rgb word(colours, 3), \
  'statistics-time-observations.dat' index 0 every ::2::2 using (shown($4)):($1+-0.03):(0):(0.12) with vectors nohead lw 1.6 lc rgb '#000000', \
  'statistics-time-observations.dat' index 7 using (shown($1)):2 with filledcurves closed lc rgb word(colours, 4) fs solid 0.3 noborder, \
  'statistics-time-observations.dat' index 7 using (shown($1)):2 with lines lw 0.8 dt 1 lc rgb word(colours, 4), \
  'statistics-time-observations.dat' index 8 using (shown($1)):2 with points pt 6 ps 0.3 lw 0.7 lc rgb word(colours, 4), \
  'statistics-time-observations.dat' index 0 every ::3::3 using (shown($2)):($1+0.03):(shown($6)-shown($2)):(0) with vectors nohead lw 0.9 lc rgb word(colours, 4), \
  'statistics-time-observations.dat' index 0 every ::3::3 using (shown($4)):($1+0.03):(shown($3)):(shown($5)):($1+-0.03):($1+0.09) with boxxyerror fs solid 0.15 border lw 0.9 lc rgb word(colours, 4), \
  'statistics-time-observations.dat' index 0 every ::3::3 using (shown($4)):($1+-0.03):(0):(0.12) with vectors nohead lw 1.6 lc rgb '#000000', \
  'statistics-time-observations.dat' index 9 using (shown($1)):2 with filledcurves closed lc rgb word(colours, 5) fs solid 0.3 noborder, \
  'statistics-time-observations.dat' index 9 using (shown($1)):2 with lines lw 0.8 dt 1 lc rgb word(colours, 5), \
  'statistics-time-observations.dat' index 10 using (shown($1)):2 with points pt 6 ps 0.3 lw 0.7 lc rgb word(colours, 5), \
  'statistics-time-observations.dat' index 0 every ::4::4 using (shown($2)):($1+0.03):(shown($6)-shown($2)):(0) with vectors nohead lw 0.9 lc rgb word(colours, 5), \
  'statistics-time-observations.dat' index 0 every ::4::4 using (shown($4)):($1+0.03):(shown($3)):(shown($5)):($1+-0.03):($1+0.09) with boxxyerror fs solid 0.15 border lw 0.9 lc rgb word(colours, 5), \
  'statistics-time-observations.dat' index 0 every ::4::4 using (shown($4)):($1+-0.03):(0):(0.12) with vectors nohead lw 1.6 lc rgb '#000000', \
  'statistics-time-observations.dat' index 11 using (shown($1)):2 with filledcurves closed lc rgb word(colours, 6) fs solid 0.3 noborder, \
  'statistics-time-observations.dat' index 11 using (shown($1)):2 with lines lw 0.8 dt 1 lc rgb word(colours, 6), \
  'statistics-time-observations.dat' index 12 using (shown($1)):2 with points pt 6 ps 0.3 lw 0.7 lc rgb word(colours, 6), \
  'statistics-time-observations.dat' index 0 every ::5::5 using (shown($2)):($1+0.03):(shown($6)-shown($2)):(0) with vectors nohead lw 0.9 lc rgb word(colours, 6), \
  'statistics-time-observations.dat' index 0 every ::5::5 using (shown($4)):($1+0.03):(shown($3)):(shown($5)):($1+-0.03):($1+0.09) with boxxyerror fs solid 0.15 border lw 0.9 lc rgb word(colours, 6), \
  'statistics-time-observations.dat' index 0 every ::5::5 using (shown($4)):($1+-0.03):(0):(0.12) with vectors nohead lw 1.6 lc rgb '#000000'
set terminal @pdf
set output 'statistics-time-observations.pdf'
replot
set terminal @png
set output 'statistics-time-observations.png'
replot
unset output
