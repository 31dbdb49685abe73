# To draw it again: gnuplot statistics-error-effects.gp
width_cm = 8.729999999999999
height_cm = 7.329999999999999
load 'style.gp'

unset key
unset grid
set border 0
set tics scale 0
set lmargin at screen 0.152348224513173
set rmargin at screen 0.8052691867124857
set bmargin at screen 0.1814461118690314
set tmargin at screen 0.9590723055934516
set xrange [0.5:6.5]
set yrange [6.5:0.5]
set xtics noenhanced font ',7' rotate by 90 right ('IK-BA' 1, 'BA' 2, 'DE' 3, 'PSO' 4, 'K-ABC' 5, 'MO-PSO' 6)
set ytics noenhanced font ',7' ('IK-BA' 1, 'BA' 2, 'DE' 3, 'PSO' 4, 'K-ABC' 5, 'MO-PSO' 6)
set palette defined (0 '#E69F00', 0.5 '#FFFFFF', 1 '#56B4E9')
set cbrange [0:1]
set cbtics 0.25 font ',6' offset -0.6, 0
set colorbox user origin screen 0.8396334478808706, screen 0.1814461118690314 size screen 0.025200458190148916, screen 0.7776261937244202 noborder

set terminal @svg
set output 'statistics-error-effects.svg'
plot 'statistics-error-effects.dat' index 0 using 1:2:($1-0.48):($1+0.48):($2-0.48):($2+0.48):3 with boxxyerror fs solid noborder lc palette, \
  'statistics-error-effects.dat' index 1 using 1:2:($1-0.48):($1+0.48):($2-0.48):($2+0.48) with boxxyerror fs solid noborder lc rgb '#DDDDDD', \
  'statistics-error-effects.dat' index 0 using 1:2:(sprintf('%.2f', $3)) with labels font ',7', \
  'statistics-error-effects.dat' index 1 using 1:2:3 with labels font ',6' textcolor rgb '#666666'
set terminal @pdf
set output 'statistics-error-effects.pdf'
replot
set terminal @png
set output 'statistics-error-effects.png'
replot
unset output
