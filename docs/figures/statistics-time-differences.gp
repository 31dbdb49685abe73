# To draw it again: gnuplot statistics-time-differences.gp
width_cm = 8.5
height_cm = 7.699999999999999
load 'style.gp'

unset key
set yrange [15.5:0.5]
set ytics noenhanced font ',7' ('IK-BA - BA' 1, 'IK-BA - DE' 2, 'IK-BA - PSO' 3, 'IK-BA - K-ABC' 4, 'IK-BA - MO-PSO' 5, 'BA - DE' 6, 'BA - PSO' 7, 'BA - K-ABC' 8, 'BA - MO-PSO' 9, 'DE - PSO' 10, 'DE - K-ABC' 11, 'DE - MO-PSO' 12, 'PSO - K-ABC' 13, 'PSO - MO-PSO' 14, 'K-ABC - MO-PSO' 15)
set border 1
set ytics scale 0
set grid noytics
set xtics enhanced
set format x '%.6g'
set xrange [-0.001389412354837792:0.0008238257264939619]
set xtics 5e-04
shown(x) = x
set xlabel 'difference: computing time [s]' noenhanced
set arrow from 0, graph 0 to 0, graph 1 nohead back lw 0.8 lc rgb '#888888' dt 2

set terminal @svg
set output 'statistics-time-differences.svg'
plot 'statistics-time-differences.dat' using ($5==0 ? $3 : NaN):1:($4-$3):(0) with vectors nohead lw 1.4 lc rgb '#888888', \
  'statistics-time-differences.dat' using ($5==0 && $3==$3 ? $2 : NaN):1 with points pt 6 ps 0.55 lw 1.2 lc rgb '#888888', \
  'statistics-time-differences.dat' using ($5==1 ? $3 : NaN):1:($4-$3):(0) with vectors nohead lw 1.4 lc rgb word(colours, 1), \
  'statistics-time-differences.dat' using ($5==1 && $3==$3 ? $2 : NaN):1 with points pt 7 ps 0.55 lw 1.2 lc rgb word(colours, 1)
set terminal @pdf
set output 'statistics-time-differences.pdf'
replot
set terminal @png
set output 'statistics-time-differences.png'
replot
unset output
