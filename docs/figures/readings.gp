# To draw it again: gnuplot readings.gp
width_cm = 17
height_cm = 17.9
load 'style.gp'

set xrange [0:1.8]
set yrange [-34.6:0.6]
set xtics ('1e-04' 0.20437094229422564, '0.01' 0.44701406845651587, '1' 0.689657194618806, '100' 0.9323003207810963, '0.5' 1.1687313932741097, '1' 1.3544208722903681, '2' 1.5401103513066263, '5' 1.7855784905432155)
set ytics noenhanced font ',7' ('default' -0, 'path.tool=eq27' -1, 'path.phase=cos_sin' -2, 'path.start_deg=90' -3, 'path.start_deg=180' -4, 'path.start_deg=270' -5, 'path.spacing=k_over_n_minus_1' -6, 'search=all_joints' -7, 'bounds=initial' -8, 'bounds=clamp' -9, 'IK-BA.step_factor=1' -10, 'IK-BA.epsilon=truncated' -11, 'IK-BA.acceptance=loudness' -12, 'IK-BA.acceptance=yang2020' -13, 'IK-BA.bounds=clamp' -14, 'IK-BA.f_max=0' -15, 'PSO.coefficients=as_printed' -16, 'PSO.bounds=initial' -17, 'BA.best_of=evaluated' -18, 'BA.bounds=initial' -19, 'K-ABC.colony=half' -20, 'K-ABC.neighbour=random' -21, 'K-ABC.fitness_unit=m' -22, 'K-ABC.bounds=initial' -23, 'MO-PSO.leader=per_particle' -24, 'MO-PSO.final_point=knee' -25, 'MO-PSO.archive=100' -26, 'MO-PSO.archive=200' -27, 'DE.replacement=generation' -28, 'DE.bounds=reflect' -29, 'DE.bounds=resample' -30, 'DE.bounds=initial' -31, 'wrist_branch=positive' -32, 'wrist_branch=negative' -33, 'wrist_branch=inside' -34)
set xlabel 'ours by printed'
set tmargin 1.6
set bars 0.4
set key maxcols 6
set label 'position error' at 0.5, graph 1 center offset 0, 0.7
set arrow from 0.689657194618806, graph 0 to 0.689657194618806, graph 1 nohead back lw 1.2 lc rgb '#000000'
set arrow from 0.6836294810775845, graph 0 to 0.6836294810775845, graph 1 nohead back ls 1 lw 0.7 dt 2
set arrow from 0.6828145888223889, graph 0 to 0.6828145888223889, graph 1 nohead back ls 2 lw 0.7 dt 2
set arrow from 0.663743009550537, graph 0 to 0.663743009550537, graph 1 nohead back ls 3 lw 0.7 dt 2
set arrow from 0.6892255963735799, graph 0 to 0.6892255963735799, graph 1 nohead back ls 4 lw 0.7 dt 2
set arrow from 0.6832961615087288, graph 0 to 0.6832961615087288, graph 1 nohead back ls 5 lw 0.7 dt 2
set arrow from 0.7197303461467156, graph 0 to 0.7197303461467156, graph 1 nohead back ls 6 lw 0.7 dt 2
set label 'angles variation' at 1.44, graph 1 center offset 0, 0.7
set arrow from 1.3544208722903681, graph 0 to 1.3544208722903681, graph 1 nohead back lw 1.2 lc rgb '#000000'
set arrow from 1.173987468559443, graph 0 to 1.173987468559443, graph 1 nohead back ls 1 lw 0.7 dt 2
set arrow from 1.3307416530221448, graph 0 to 1.3307416530221448, graph 1 nohead back ls 2 lw 0.7 dt 2
set arrow from 1.359367450229767, graph 0 to 1.359367450229767, graph 1 nohead back ls 3 lw 0.7 dt 2
set arrow from 1.3797979653913022, graph 0 to 1.3797979653913022, graph 1 nohead back ls 4 lw 0.7 dt 2
set arrow from 1.3457615488725685, graph 0 to 1.3457615488725685, graph 1 nohead back ls 5 lw 0.7 dt 2
set arrow from 1.1460603695882066, graph 0 to 1.1460603695882066, graph 1 nohead back ls 6 lw 0.7 dt 2
set arrow from 1.04, graph 0 to 1.04, graph 1 nohead back lw 0.5 lc rgb '#888888'

set terminal @svg
set output 'readings.svg'
plot 'readings.dat' index 0 using (0+($2-(-5.684539311099491))*0.12132156308114511):1:(0+($3-(-5.684539311099491))*0.12132156308114511):(0+($4-(-5.684539311099491))*0.12132156308114511) with xerrorbars ls 1 ps 0.55 title 'IK-BA', \
  'readings.dat' index 0 using (1.08+($5-(-0.4448766533964075))*0.6168470972691057):1:(1.08+($6-(-0.4448766533964075))*0.6168470972691057):(1.08+($7-(-0.4448766533964075))*0.6168470972691057) with xerrorbars ls 1 ps 0.55 notitle, \
  'readings.dat' index 1 using (0+($2-(-5.684539311099491))*0.12132156308114511):1:(0+($3-(-5.684539311099491))*0.12132156308114511):(0+($4-(-5.684539311099491))*0.12132156308114511) with xerrorbars ls 2 ps 0.55 title 'BA', \
  'readings.dat' index 1 using (1.08+($5-(-0.4448766533964075))*0.6168470972691057):1:(1.08+($6-(-0.4448766533964075))*0.6168470972691057):(1.08+($7-(-0.4448766533964075))*0.6168470972691057) with xerrorbars ls 2 ps 0.55 notitle, \
  'readings.dat' index 2 using (0+($2-(-5.684539311099491))*0.12132156308114511):1:(0+($3-(-5.684539311099491))*0.12132156308114511):(0+($4-(-5.684539311099491))*0.12132156308114511) with xerrorbars ls 3 ps 0.55 title 'DE', \
  'readings.dat' index 2 using (1.08+($5-(-0.4448766533964075))*0.6168470972691057):1:(1.08+($6-(-0.4448766533964075))*0.6168470972691057):(1.08+($7-(-0.4448766533964075))*0.6168470972691057) with xerrorbars ls 3 ps 0.55 notitle, \
  'readings.dat' index 3 using (0+($2-(-5.684539311099491))*0.12132156308114511):1:(0+($3-(-5.684539311099491))*0.12132156308114511):(0+($4-(-5.684539311099491))*0.12132156308114511) with xerrorbars ls 4 ps 0.55 title 'PSO', \
  'readings.dat' index 3 using (1.08+($5-(-0.4448766533964075))*0.6168470972691057):1:(1.08+($6-(-0.4448766533964075))*0.6168470972691057):(1.08+($7-(-0.4448766533964075))*0.6168470972691057) with xerrorbars ls 4 ps 0.55 notitle, \
  'readings.dat' index 4 using (0+($2-(-5.684539311099491))*0.12132156308114511):1:(0+($3-(-5.684539311099491))*0.12132156308114511):(0+($4-(-5.684539311099491))*0.12132156308114511) with xerrorbars ls 5 ps 0.55 title 'K-ABC', \
  'readings.dat' index 4 using (1.08+($5-(-0.4448766533964075))*0.6168470972691057):1:(1.08+($6-(-0.4448766533964075))*0.6168470972691057):(1.08+($7-(-0.4448766533964075))*0.6168470972691057) with xerrorbars ls 5 ps 0.55 notitle, \
  'readings.dat' index 5 using (0+($2-(-5.684539311099491))*0.12132156308114511):1:(0+($3-(-5.684539311099491))*0.12132156308114511):(0+($4-(-5.684539311099491))*0.12132156308114511) with xerrorbars ls 6 ps 0.55 title 'MO-PSO', \
  'readings.dat' index 5 using (1.08+($5-(-0.4448766533964075))*0.6168470972691057):1:(1.08+($6-(-0.4448766533964075))*0.6168470972691057):(1.08+($7-(-0.4448766533964075))*0.6168470972691057) with xerrorbars ls 6 ps 0.55 notitle
set terminal @pdf
set output 'readings.pdf'
replot
set terminal @png
set output 'readings.png'
replot
unset output
