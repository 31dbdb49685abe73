# The look of every figure in this folder. Change it here, then draw again: gnuplot NAME.gp
set encoding utf8

# Characters that mean something to gnuplot, for labels.
array character[126]
do for [i = 33:126] { character[i] = sprintf("%c", i) }

# A palette that the colour-blind can tell apart, and none of it too pale for white; markers tell the curves apart without
# colour, and dashes those that would repeat a colour.
colours = "COLOURS"
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
set key below horizontal Left reverse noenhanced noautotitle samplen 2 spacing 1.1 height 0.8
set xtics noenhanced offset 0, 0.3
set xlabel offset 0, 0.85
set ylabel offset 0.5, 0

# The size of text [pt]. Names beside an axis are smaller, remarks smaller still. Heights, margins and legends follow it.
text = 8
height_cm = height_cm * text / 8
names = sprintf(",%g", 0.875 * text)
remarks = sprintf(",%g", 0.75 * text)
margin(cm) = cm * text / 8 < 0.65 * width_cm ? cm * text / 8 / width_cm : 0.65
columns(cm) = cm * text / 8 < width_cm ? int(width_cm / cm / text * 8) : 1

# Three outputs of the same size, with thin lines in each: SVG in units of a point, PDF, PNG at 300 dpi. To Cairo a point of
# text is 1/96 inch.
svg = sprintf("svg enhanced size %d,%d dynamic font 'Liberation Sans,%g' linewidth 0.8 background '#FFFFFF'", \
  width_cm / 2.54 * 72, height_cm / 2.54 * 72, text)
pdf = sprintf("pdfcairo enhanced size %gcm,%gcm font 'Liberation Sans,%g' fontscale 0.75 linewidth 1.2 pointscale 1.1", \
  width_cm, height_cm, text)
png = sprintf("pngcairo enhanced size %d,%d font 'Liberation Sans,%g' fontscale 3.125 linewidth 4 pointscale 3.5", \
  width_cm / 2.54 * 300, height_cm / 2.54 * 300, text)
