# The look of every figure in this folder.
set encoding utf8

# Characters that mean something to gnuplot, for labels.
array character[126]
do for [i = 33:126] { character[i] = sprintf("%c", i) }

# What [figures] of the study or --style says: size of text [pt] and font; width and height of every figure [cm], 0: each
# its own; colours, and whether the background is dark.
text = TEXT_PT
font = "FONT"
all_width_cm = WIDTH_CM
all_height_cm = HEIGHT_CM
colours = "COLOURS"
hues = words(colours)
dark = DARK
paper = dark ? "#14171C" : "#FFFFFF"
ink = dark ? "#F2F2F2" : "#000000"
faint = dark ? "#3A3F47" : "#DDDDDD"
filled = dark ? "transparent solid" : "solid"
shade(i) = word(dark ? "#E0E0E0 #A8A8A8 #707070" : "#303030 #707070 #A8A8A8", i)

# Markers tell the curves apart without colour, and dashes those of one colour. Rings are what is printed.
markers = "7 4 9 10 13 2 3 12 5 8 11 1 15"
dashes = "1 11 12 13 14"
set dashtype 11 (5, 2)
set dashtype 12 (1.5, 2)
set dashtype 13 (6, 2, 1.5, 2)
set dashtype 14 (2.5, 1.5)
colour_of(i) = word(colours, (i - 1) % hues + 1)
do for [i = 1:13 * hues] {
  set style line i lw 0.9 ps 0.6 lc rgb colour_of(i) pt int(word(markers, (i - 1) % 13 + 1)) \
    dt int(word(dashes, (i - 1) / hues % 5 + 1))
}
set style line 1000 lw 0.4 lc rgb faint dt 1

set border 3 lw 0.6 lc rgb ink
set tics out nomirror scale 0.6, 0.3 textcolor rgb ink
set format '%h'  # by default with room for a sign, beside the tick in a PNG
set grid xtics ytics ls 1000
set key below Left reverse noenhanced noautotitle samplen 2 width -0.5 textcolor rgb ink
set xtics offset 0, 0.3
set xlabel offset 0, 0.85 textcolor rgb ink
set ylabel textcolor rgb ink
set zlabel textcolor rgb ink

# Heights, margins and legends follow the size of text: up() is a height as a share of the figure's.
# Labels that leave no room for the plot make the text of their figure smaller; rows that leave none in the given height do
# so down to 8 pt, then it grows.
if (all_width_cm > 0) width_cm = all_width_cm
if (sides_cm * text / 8.0 > 0.65 * width_cm) text = 8.0 * 0.65 * width_cm / sides_cm
legend_rows_cm = legend > 0 ? 0.2 + 0.35 * legend : 0
least_cm = 0.8 * height_cm + legend_rows_cm
fitting = 8.0 * all_height_cm / least_cm
if (all_height_cm > 0 && text > 8 && fitting < text) text = fitting > 8 ? fitting : 8
least_cm = least_cm * text / 8.0
plot_cm = width_cm * 8.0 / text - sides_cm
height_cm = (height_cm + legend_rows_cm) * text / 8.0
if (all_height_cm > 0) height_cm = all_height_cm > least_cm ? all_height_cm : least_cm
up(cm) = cm * text / 8.0 / height_cm
margin(cm) = cm * text / 8.0 / width_cm

weight = text > 8 ? text / 8.0 : 1  # of lines and points
# Three outputs of the same size, with thin lines in each: SVG in units of a point, PDF, PNG at 300 dpi. To Cairo a point of
# text is 1/96 inch. Legends have rows of one height in all.
svg_rows = 0.83
pdf_rows = 1.12
png_rows = 1.12
svg = sprintf("svg enhanced size %d,%d dynamic font '%s,%g' linewidth %g background '%s'", \
  width_cm / 2.54 * 72, height_cm / 2.54 * 72, font, text, 0.8 * weight, paper)
ground = dark ? sprintf(" background '%s'", paper) : ""
pdf = sprintf("pdfcairo enhanced size %gcm,%gcm font '%s,%g' fontscale 0.75 linewidth %g pointscale %g%s", \
  width_cm, height_cm, font, text, 1.2 * weight, 1.1 * weight, ground)
png = sprintf("pngcairo enhanced size %d,%d font '%s,%g' fontscale 3.125 linewidth %g pointscale %g%s", \
  width_cm / 2.54 * 300, height_cm / 2.54 * 300, font, text, 4 * weight, 3.5 * weight, ground)
