# To draw it again: gnuplot figure-12.gp
width_cm = 8.5
height_cm = 6.4
load 'style.gp'

set yrange [0:1.8388814325]
shown(y) = y * 1000
set ylabel 'computing time [ms]'
unset key
set grid noxtics ytics
set xrange [0.4:6.6]
set xtics font ',7' ('IK-BA' 1, 'BA' 2, 'DE' 3, 'PSO' 4, 'K-ABC' 5, 'MO-PSO' 6)
set boxwidth 0.5
set style fill solid 0.25 border

set terminal @svg
set output 'figure-12.svg'
plot 'figure-12.dat' index 0 every ::0::0 using 1:(shown($3)):(shown($2)):(shown($6)):(shown($5)) with candlesticks ls 1 dt 1 whiskerbars 0.5, \
  'figure-12.dat' index 0 every ::1::1 using 1:(shown($3)):(shown($2)):(shown($6)):(shown($5)) with candlesticks ls 2 dt 1 whiskerbars 0.5, \
  'figure-12.dat' index 0 every ::2::2 using 1:(shown($3)):(shown($2)):(shown($6)):(shown($5)) with candlesticks ls 3 dt 1 whiskerbars 0.5, \
  'figure-12.dat' index 0 every ::3::3 using 1:(shown($3)):(shown($2)):(shown($6)):(shown($5)) with candlesticks ls 4 dt 1 whiskerbars 0.5, \
  'figure-12.dat' index 0 every ::4::4 using 1:(shown($3)):(shown($2)):(shown($6)):(shown($5)) with candlesticks ls 5 dt 1 whiskerbars 0.5, \
  'figure-12.dat' index 0 every ::5::5 using 1:(shown($3)):(shown($2)):(shown($6)):(shown($5)) with candlesticks ls 6 dt 1 whiskerbars 0.5, \
  'figure-12.dat' index 0 using ($1-0.25):(shown($4)):(0.5):(0) with vectors nohead ls 101, \
  'figure-12.dat' index 1 using 1:(shown($2)) with points pt 6 ps 0.4 lw 0.8 lc rgb '#000000'
set terminal @pdf
set output 'figure-12.pdf'
replot
set terminal @png
set output 'figure-12.png'
replot
unset output
