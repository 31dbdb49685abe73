# The look of every figure in this folder. Change it here, then draw again: gnuplot NAME.gp
# A new report writes this file anew.
set encoding utf8

# Characters that mean something to gnuplot, for labels.
array character[126]
do for [i = 33:126] { character[i] = sprintf("%c", i) }

# Okabe and Ito's palette (2008), told apart by the colour-blind; markers tell the curves apart without colour, and
# dashes those that would repeat a colour.
colours = "#0072B2 #D55E00 #009E73 #CC79A7 #E69F00 #56B4E9 #000000"
markers = "7 5 9 11 13 4 2 6 8 10 12 1 3"
dashes = "1 11 12 13 14"
set dashtype 11 (5, 2)
set dashtype 12 (1.5, 2)
set dashtype 13 (6, 2, 1.5, 2)
set dashtype 14 (2.5, 1.5)
do for [i = 1:91] {
  set style line i lw 0.9 ps 0.45 lc rgb word(colours, (i - 1) % 7 + 1) pt int(word(markers, (i - 1) % 13 + 1)) \
    dt int(word(dashes, int((i - 1) / 7) % 5 + 1))
}
set style line 100 lw 0.4 lc rgb "#DDDDDD" dt 1
set style line 101 lw 1.3 lc rgb "#000000" dt 1

set border 3 lw 0.6
set tics out nomirror scale 0.6, 0.3
set grid xtics ytics ls 100
set key below horizontal Left reverse noenhanced samplen 2 spacing 1.1 height 0.8
set xtics noenhanced offset 0, 0.3
set xlabel offset 0, 0.85
set ylabel offset 0.5, 0

# Three outputs of the same size, 8 pt text and thin lines in each: SVG in units of a point, PDF, PNG at 300 dpi. To Cairo a
# point of text is 1/96 inch.
svg = sprintf("svg enhanced size %d,%d dynamic font 'Liberation Sans,8' linewidth 0.8 background '#FFFFFF'", \
  width_cm / 2.54 * 72, height_cm / 2.54 * 72)
pdf = sprintf("pdfcairo enhanced size %gcm,%gcm font 'Liberation Sans,8' fontscale 0.75 linewidth 1.2 pointscale 1.1", width_cm, height_cm)
png = sprintf("pngcairo enhanced size %d,%d font 'Liberation Sans,8' fontscale 3.125 linewidth 4 pointscale 3.5", \
  width_cm / 2.54 * 300, height_cm / 2.54 * 300)
