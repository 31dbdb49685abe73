#include "analysis/figures/parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <cctype>
#include <cmath>
#include <iterator>

#include "base/names.hpp"
#include "base/number.hpp"

namespace ikbench::figures {

using namespace base;

namespace {

constexpr double spread_of_logarithmic = 30;
constexpr int farthest_decade = 300;

std::vector<double> drawable(std::span<const double> values) {
  std::vector<double> drawn;
  std::ranges::copy_if(values, std::back_inserter(drawn), [](double v) { return std::abs(v) <= 1e300; });
  return drawn;
}

std::string placed(char letter, double low, double high) {
  return fmt::format("place_{0}(v) = v < {1} ? {1} : v > {2} ? {2} : v\n", letter, text_of(low), text_of(high));
}

// Returns the commands for the title of an axis. The title of y stands at the left edge of the picture, because gnuplot
// does not know where the ticks end.
std::string titled(char letter, const std::string& title) {
  if (title.empty()) return "";
  return title_of(letter, shortened(title, letter == 'y' ? 34 : 44)) +
         (letter == 'x' ? "set xlabel x_title noenhanced\n"
                        : "set label y_title at screen margin(0.3), graph 0.5 center rotate noenhanced tc rgb ink\n");
}

std::string logarithmic(char letter, double low, double high) {
  return fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\n", letter, text_of(low), text_of(high));
}

// Returns the label of a tick: "100", or a power of ten in gnuplot's enhanced text.
std::string tick(double value, bool is_power) {
  if (!is_power) return fmt::format("{:.6g}", value);
  const int exponent = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  const std::string digits = fmt::format("{:.2g}", value / std::pow(10, exponent));
  return fmt::format("{}10{{/*0.7 ^{{{}{}}}}}", digits == "1" ? "" : digits + "·", exponent < 0 ? "−" : "",
                     std::abs(exponent));
}

// Returns whether the ticks of an axis are written as powers of ten, which then holds for all of them.
bool are_powers(double low, double high) { return low < 0.999e-3 || high > 1.001e5; }

// Returns ticks at powers of ten, with small ticks between them. On a short axis 2 and 5 times the powers have labels,
// too; only 3 times the powers if labels would touch.
std::string ticks_between(char letter, double low, double high, bool is_power) {
  const double decades = std::log10(high) - std::log10(low);
  const int every = 1 + static_cast<int>((decades - 1) / 4);
  const bool is_tight = letter == 'x' && decades > 1.2;
  const auto is_labelled = [&](int multiple) {
    return is_tight ? multiple == 3 && !is_power : multiple == 2 || multiple == 5;
  };
  std::vector<std::string> ticks;
  if (decades < 0.7) {
    const double step = round_step_of(high - low, 5);
    for (double i = std::ceil(low / step); i * step <= high; ++i)
      ticks.push_back(fmt::format("'{}' {}", tick(i * step, is_power), text_of(i * step)));
  }
  for (int decade = static_cast<int>(std::floor(std::log10(low))); decades >= 0.7 && decade <= farthest_decade;
       ++decade) {
    for (int multiple = 1; multiple < 10; ++multiple) {
      const double at = multiple * std::pow(10, decade);
      if (at > high * (1 + 1e-9)) break;
      if (at < low * (1 - 1e-9) || (multiple > 1 && every > 1)) continue;
      const bool has_label = decade % every == 0 && (multiple == 1 || (decades <= 2.2 && is_labelled(multiple)));
      const std::string label = has_label ? tick(at, is_power) : "";
      if (has_label || every == 1) ticks.push_back(fmt::format("'{}' {}{}", label, text_of(at), has_label ? "" : " 1"));
    }
    if (std::pow(10, decade) > high) break;
  }
  return fmt::format("set {}tics ({})\n", letter, fmt::join(ticks, ", "));
}

// Returns the room between the values and the ends of a linear axis. Equal values have a tenth of their size.
double room_beside(double smallest, double largest) {
  if (largest > smallest) return 0.06 * (largest - smallest);
  return smallest == 0 ? 1 : 0.1 * std::abs(smallest);
}

// Returns where values up to the floor stand: at the floor, or below the decade of the smallest value above it.
double edge_below(double start, double floor) { return floor >= start ? floor : start / 10; }

// Adds the margins that all figures with two axes have.
void add_margins(Figure& figure) {
  figure.settings +=
      "set lmargin at screen margin(1.7)\nset rmargin at screen 1 - margin(0.5)\n"
      "set bmargin at screen up(1 + legend_rows_cm)\nset tmargin at screen 1 - up(0.3)\n";
}

}  // namespace

std::string gnuplot_text(std::string_view text) {
  constexpr std::string_view harmless = " -_.,:()+*/=<>[]&|?^~%";  // gnuplot 5.4 looks for macros in quotes, too
  std::string result = "'";
  for (const char c : shortened(one_line(text), 60)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_harmless = byte >= 0x80 || std::isalnum(byte) != 0 || harmless.find(c) != std::string_view::npos;
    result += is_harmless ? std::string{c} : fmt::format("'.character[{}].'", byte);
  }
  return result + "'";
}

std::string title_of(char letter, std::string_view title) {
  return fmt::format("if (!exists('{0}_title')) {0}_title = {1}\n", letter, gnuplot_text(title));
}

std::string data_row(const std::vector<double>& values) {
  std::string row;
  for (const double value : values)
    row += (row.empty() ? "" : " ") + (std::isnan(value) ? "NaN" : text_of(std::clamp(value, -1e300, 1e300)));
  return row + '\n';
}

std::string plotted(const std::vector<std::string>& clauses) {
  return fmt::format("plot NaN, \\\n  {}", fmt::join(clauses, ", \\\n  "));
}

double round_step_of(double span, double places) {
  const double least = span / places, power = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1, 2, 5}) {
    if (digit * power >= least) return digit * power;
  }
  return 10 * power;
}

std::string colour_of(int style) { return style > 0 ? fmt::format("lc rgb colour_of({})", style) : "lc rgb '#808080'"; }

double width_cm_of(std::string_view label) {
  constexpr std::string_view narrow = "fijlrt.,:;|!'()[] -I", wide = "mwMW@%OQGDHN";
  double cm = 0;
  for (const char c : label) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) == 0x80) continue;  // not the first of a character
    const bool is_wide = wide.find(c) != std::string_view::npos || byte >= 0xE3;
    if (narrow.find(c) != std::string_view::npos)
      cm += 0.09;
    else if (is_wide)
      cm += 0.24;
    else
      cm += c >= 'A' && c <= 'Z' ? 0.2 : 0.16;
  }
  return cm;
}

double Axis::share_of(double value) const {
  const auto along = [&](double v) { return is_logarithmic ? std::log(v) : v; };
  return (along(std::clamp(std::max(value, edge), low, high)) - along(low)) / (along(high) - along(low));
}

Axis linear_axis(char letter, std::span<const double> values, const std::string& title, Begins begins) {
  const std::vector<double> drawn = drawable(values);
  const double smallest = drawn.empty() ? 0 : std::ranges::min(drawn);
  const double most = drawn.empty() ? 1 : std::ranges::max(drawn);
  const double size = std::max(std::abs(smallest), std::abs(most));
  // Values of a smaller span count as equal: their labels would be the same, and a step between them may be 0.
  const double largest = most - smallest > 1e-6 * size ? most : smallest;
  const bool is_first = begins == Begins::at_first && largest > smallest;
  const double room = is_first ? 0 : room_beside(smallest, largest);
  Axis axis{.settings = "", .low = smallest - room, .high = largest + room};
  if (begins == Begins::at_zero) {
    axis.low = std::min(0.0, 1.05 * smallest);
    axis.high = largest > 0 ? 1.05 * largest : 1;
  }
  // Points are whole numbers, so their step is at least 1.
  const double tick_step = std::max(round_step_of(axis.high - axis.low, 5), is_first ? 1.0 : 0.0);
  double ticks_cm = 0;
  for (double i = std::ceil(axis.low / tick_step); i * tick_step <= axis.high; ++i)
    ticks_cm += 0.25 + width_cm_of(fmt::format("{:.6g}", i * tick_step));
  const std::string ticks =
      letter == 'x' ? fmt::format("set xtics {} * (plot_cm < {} ? 2 : 1)\n", text_of(tick_step), text_of(ticks_cm))
                    : "";
  axis.settings = fmt::format("set {0}range [{1}:{2}]\n{3}{4}{5}", letter, text_of(axis.low), text_of(axis.high), ticks,
                              titled(letter, title), placed(letter, axis.low, axis.high));
  if (is_first) axis.settings += fmt::format("set {}tics add ({})\n", letter, text_of(smallest));
  return axis;
}

Axis logarithmic_axis(char letter, double smallest, double largest, const std::string& title) {
  smallest = std::max(smallest, std::pow(10, -farthest_decade));
  largest = std::max(smallest * 1.02, std::min(largest, std::pow(10, farthest_decade)));
  const double room = std::pow(largest / smallest, 0.04), low = smallest / room, high = largest * room;
  return {logarithmic(letter, low, high) + ticks_between(letter, low, high, are_powers(low, high)) +
              titled(letter, title) + placed(letter, low, high),
          low, high, true};
}

Axis value_axis(char letter, std::span<const double> values, const About& about, Begins begins) {
  const std::vector<double> drawn = drawable(values);
  std::vector<double> above;
  std::ranges::copy_if(drawn, std::back_inserter(above), [&](double v) { return v > about.floor; });
  const std::string title = about.axis();
  if (about.is_share || above.empty() || std::ranges::min(drawn) < 0 ||
      std::ranges::max(drawn) <= spread_of_logarithmic * std::ranges::min(above))
    return linear_axis(letter, values, title, begins);
  const bool has_edge = above.size() < drawn.size();
  const double start = std::pow(10, std::floor(std::log10(std::ranges::min(above)) + 1e-9));
  const double most = std::ranges::max(above);
  const double high = std::min(1.3 * most, std::pow(10, std::ceil(std::log10(most) - 1e-9)));
  const double edge = has_edge ? edge_below(start, about.floor) : start;
  // Marks at the edge do not touch the axis.
  const double low = has_edge ? edge * std::pow(edge / high, 0.03) : edge;
  const bool is_power = are_powers(has_edge && about.floor > 0 ? about.floor : start, high);
  std::string settings = logarithmic(letter, low, high) +
                         ticks_between(letter, has_edge ? std::max(start, 1.01 * edge) : start, high, is_power);
  if (has_edge)
    settings += fmt::format("set {}tics add ('{}' {})\n", letter,
                            about.floor > 0 ? "≤ " + tick(about.floor, is_power) : "0", text_of(edge));
  if (has_edge && edge > about.floor) {  // the axis is broken between the edge and the first tick
    const std::string middle = text_of(std::sqrt(edge * start));
    settings += fmt::format("set label '//' at {} center front tc rgb ink\n",
                            letter == 'x' ? "first " + middle + ", graph 0" : "graph 0, first " + middle);
  }
  return {settings + titled(letter, title) + placed(letter, edge, high), low, high, true, edge};
}

void add_labelled_rows(Figure& figure, const std::vector<std::string>& labels, double row_cm) {
  std::vector<std::string> ticks, lines;
  double widest_cm = 0;
  for (const std::string& label : labels) {
    boost::split(lines, label, [](char c) { return c == '\n'; });
    for (std::string& line : lines) {
      widest_cm = std::max(widest_cm, width_cm_of(line));
      line = gnuplot_text(boost::replace_all_copy(one_line(line), "%", "%%"));  // gnuplot takes a label as a format
    }
    row_cm = std::max(row_cm, 0.37 * static_cast<double>(lines.size()));
    ticks.push_back(fmt::format("{} {}", fmt::join(lines, ".\"\\n\"."), ticks.size() + 1));
  }
  figure.sides_cm = widest_cm + 0.95;
  add_margins(figure);
  figure.height_cm = 1.3 + row_cm * static_cast<double>(labels.size());
  figure.settings += fmt::format(
      "unset key\nset yrange [{}.5:0.5]\nset ytics noenhanced scale 0 ({})\nset border 1\nset grid noytics\n"
      "set lmargin at screen margin({})\n",
      labels.size(), fmt::join(ticks, ", "), text_of(widest_cm + 0.35));
}

void add_names(Figure& figure, std::vector<Named> marks) {
  add_margins(figure);
  if (marks.size() < 2) return;
  constexpr double around_cm = 1.3, row_cm = 0.34, stroke_cm = 0.6;
  const std::size_t n = marks.size();
  double widest_cm = 0;
  for (const Named& mark : marks) widest_cm = std::max(widest_cm, width_cm_of(mark.label));
  const bool is_below = widest_cm > 2;
  const std::size_t columns = widest_cm > 3.4 ? 1 : 2;  // of names below the figure
  if (is_below) {
    figure.legend = (n + columns - 1) / columns;
    figure.sides_cm = std::max(figure.sides_cm, 0.65 * static_cast<double>(columns) * (widest_cm + stroke_cm));
  } else {
    figure.height_cm = std::max(figure.height_cm, around_cm + row_cm * static_cast<double>(n));
    figure.sides_cm = 1.8 + stroke_cm + widest_cm;
    figure.settings += fmt::format("set rmargin at screen 1 - margin({})\n", text_of(widest_cm + stroke_cm + 0.15));
    std::ranges::stable_sort(marks, std::ranges::greater(), &Named::y);
  }
  // No name may cover another. So a name stands halfway between its lowest place, counted from the top down, and its
  // highest place, counted from the bottom up.
  const double row = row_cm / (figure.height_cm - around_cm);
  std::vector<double> at(n), up(n);
  for (std::size_t i = 0; i < n; ++i) at[i] = i == 0 ? marks[i].y : std::min(marks[i].y, at[i - 1] - row);
  for (std::size_t i = n; i-- > 0;) up[i] = i + 1 == n ? marks[i].y : std::max(marks[i].y, up[i + 1] + row);
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [label, style, y, x] = marks[i];
    const double height =
        std::clamp((at[i] + up[i]) / 2, row * static_cast<double>(n - 1 - i), 1 - row * static_cast<double>(i));
    std::string at_name = fmt::format("screen 1 - margin({}), graph {}", text_of(widest_cm + 0.3), text_of(height));
    if (is_below) {
      const std::size_t row_from_below = figure.legend - i / columns;
      at_name = fmt::format("screen {}, screen up({})", i % columns == 0 ? 0.05 : 0.53,
                            text_of(0.35 * static_cast<double>(row_from_below)));
    }
    // The marker has a label of its own, because SVG raises the text of a label with a point.
    figure.settings += fmt::format(
        "set label {} at {} left offset 1, 0 noenhanced tc rgb ink\nset label '' at {} point {}\n", gnuplot_text(label),
        at_name, at_name, style > 0 ? fmt::format("ls {}", style) : "pt 6 ps 0.9 " + colour_of(style));
    if (!is_below)
      figure.settings += fmt::format("set arrow from graph {}, graph {} to {} nohead back lw 0.5 dt 3 {}\n", text_of(x),
                                     text_of(y), at_name, colour_of(style));
  }
}

void add_legend(Figure& figure, std::size_t entries) {
  figure.legend = entries > 1 ? entries : 0;
  figure.settings +=
      entries > 1 ? "set key at screen 0.5, screen up(0.1) bottom center vertical maxcols 1\n" : "unset key\n";
}

}  // namespace ikbench::figures
