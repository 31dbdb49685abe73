#include "analysis/figures/axis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace inference;

namespace {

constexpr double spread_for_logarithmic = 30;
constexpr double smallest_range = 1e-303;  // of a linear axis: denormal numbers have no round steps

// The unit that is drawn, and the drawn by the given value.
std::pair<std::string, double> drawn_unit(const std::string& unit, double largest) {
  if (unit != "s" || !(largest > 0) || largest >= 0.1) return {unit, 1};
  return largest < 1e-4 ? std::pair("µs", 1e6) : std::pair("ms", 1e3);
}

// Whole decades around two drawn values. Values that are too small are drawn at the lower edge, which says so; the
// ticks are those of the decades above.
void add_decades(Axis& axis, char letter, double smallest, double largest, double factor) {
  int low = static_cast<int>(std::floor(std::log10(std::max(factor * smallest, 1 / largest_drawable))));
  const int high =
      std::max(low + 1, static_cast<int>(std::ceil(std::log10(std::min(factor * largest, largest_drawable)))));
  if (axis.shows_at_edge) low -= 1;
  const int decades_per_tick = 1 + (high - low - 1) / 7;
  const int first_tick = static_cast<int>(std::ceil(static_cast<double>(low) / decades_per_tick)) * decades_per_tick;
  const std::string edge = !axis.shows_at_edge
                               ? ""
                               : fmt::format("set {}tics add ('{}' 1e{})\n", letter,
                                             axis.least > 0 ? "≤" + rounded_number(factor * axis.least, 2) : "0", low);
  axis.low = std::pow(10, low);
  axis.high = std::pow(10, high);
  axis.settings = fmt::format(
      "set logscale {7}\nset format {7} '10^{{%T}}'\nset {7}range [1e{0}:1e{1}]\nset {7}tics 1e{8}, 1e{2}\nset m{7}tics {3}\n"
      "{6}shown({7}) = {7} > {5} ? {7} * {4} : ({7} <= {5} ? 1e{0} : NaN)\n",
      low, high, decades_per_tick, decades_per_tick == 1 ? 10 : 1, text_of(factor), text_of(axis.least), edge, letter,
      first_tick);  // without it gnuplot 5.4 does not end where a step is 1e11 or more
}

void add_from_zero(Axis& axis, double smallest, double largest, double factor) {
  axis.low = std::min(0.0, 1.05 * factor * smallest);
  axis.high = largest > 0 ? 1.05 * factor * largest : 1.0;
  axis.settings =
      fmt::format("set yrange [{}:{}]\nshown(y) = y * {}\n", text_of(axis.low), text_of(axis.high), text_of(factor));
}

// A round step, and as many digits as tell its multiples apart.
void add_around(Axis& axis, double smallest, double largest, double factor) {
  smallest *= factor;
  largest *= factor;
  const double magnitude = std::max(std::abs(smallest), std::abs(largest));
  const double room = std::max({0.06 * (largest - smallest), 1e-13 * magnitude, smallest_range});
  const double around = largest > smallest ? room : (magnitude > 0 ? std::max(0.1 * magnitude, smallest_range) : 1.0);
  axis.low = smallest - around;
  axis.high = largest + around;
  const double span = axis.high - axis.low;
  const int digits = std::clamp(
      2 + static_cast<int>(std::ceil(std::log10(std::max(std::abs(axis.low), std::abs(axis.high)) / span))), 6, 17);
  axis.settings = fmt::format("set format x '%.{}g'\n{}set xrange [{}:{}]\nset xtics {}\nshown(x) = x * {}\n", digits,
                              digits > 6 ? "set rmargin 8\n" : "", text_of(axis.low), text_of(axis.high),
                              text_of(round_step(span, digits > 6 ? 3 : 7)), text_of(factor));
}

// Characters of a line that fit beside each axis.
constexpr std::size_t most_beside_x = 44, most_beside_y = 36;

// A title of at most two lines, as a gnuplot expression. A line of `most` characters fits beside the axis.
std::string axis_title(std::string_view quantity, std::size_t most) {
  const std::string text = shortened(quantity, 2 * most);
  const std::size_t bracket = text.rfind('(', most);  // the best place if the rest fits
  const bool fits = bracket != std::string::npos && text.size() - bracket <= most + 6;
  const std::size_t blank = text.rfind(' ', fits ? bracket : text.size() / 2 + 4);
  if (character_count(text) <= most || blank == std::string::npos) return gnuplot_string(text);
  return fmt::format("{}.\"\\n\".{}", gnuplot_string(text.substr(0, blank)), gnuplot_string(text.substr(blank + 1)));
}

Axis axis_of(char letter, std::span<const double> values, const NameWithUnit& quantity, Scale scale, double least) {
  std::vector<double> drawable, positive;
  std::ranges::copy_if(values, std::back_inserter(drawable), is_drawable);
  if (std::ranges::none_of(drawable, [&](double value) { return value > least; })) least = 0;
  std::ranges::copy_if(drawable, std::back_inserter(positive), [&](double value) { return value > least; });
  Axis axis{.least = least};
  const double largest = drawable.empty() ? 1.0 : std::ranges::max(drawable);
  const double smallest = drawable.empty() ? 0.0 : std::ranges::min(drawable);
  const double smallest_positive = positive.empty() ? largest : std::ranges::min(positive);
  const auto [unit, factor] = drawn_unit(quantity.unit, std::max(largest, -smallest));
  const bool is_spread = smallest >= 0 && largest > spread_for_logarithmic * smallest_positive;
  axis.quantity = text_of({quantity.name, unit});
  axis.logarithmic = !positive.empty() && (scale == Scale::logarithmic || (scale == Scale::by_spread && is_spread));
  if (axis.logarithmic) {
    axis.shows_at_edge = positive.size() < drawable.size();
    add_decades(axis, letter, smallest_positive, largest, factor);
  } else {
    (letter == 'y' ? add_from_zero : add_around)(axis, smallest, largest, factor);
  }
  axis.settings += fmt::format("set {}label {} noenhanced\n", letter,
                               axis_title(axis.quantity, letter == 'y' ? most_beside_y : most_beside_x));
  if (drawable.empty()) {
    axis.settings += fmt::format("unset {}tics\nset label 'no finite values' at graph 0.5, graph 0.5 center\n", letter);
  }
  return axis;
}

// Round ratios between two: powers of ten; 1, 2 and 5 times these; or round steps, by how far apart they are.
std::vector<double> ratio_ticks(double low, double high) {
  std::vector<double> ticks;
  const double decades = std::log10(high) - std::log10(low);
  if (decades < 0.7) {
    const double step = round_step(high - low, 5);
    for (double tick = std::ceil(low / step); tick * step <= high; ++tick) ticks.push_back(tick * step);
    return ticks;
  }
  const int every = 1 + static_cast<int>(decades / 7);
  for (int exponent = static_cast<int>(std::floor(std::log10(low))); std::pow(10, exponent) <= high; ++exponent) {
    if (exponent % every != 0) continue;
    for (const double multiple : {1.0, 2.0, 5.0}) {
      const double tick = multiple * std::pow(10, exponent);
      if (tick >= low && tick <= high && (multiple == 1 || decades <= 3)) ticks.push_back(tick);
    }
  }
  return ticks;
}

}  // namespace

double round_step(double span, double places) {
  const double least = span / places, power = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1, 2, 5}) {
    if (digit * power >= least) return digit * power;
  }
  return 10 * power;
}

bool is_drawable(double value) { return std::abs(value) <= largest_drawable; }

Axis value_axis(std::span<const double> values, const NameWithUnit& quantity, Scale scale, double least) {
  return axis_of('y', values, quantity, scale, least);
}

Axis row_axis(std::span<const double> values, const NameWithUnit& quantity, Scale scale) {
  return axis_of('x', values, quantity, scale, 0);
}

Axis ratio_axis(double smallest, double largest, const NameWithUnit& quantity) {
  const auto [unit, factor] = drawn_unit(quantity.unit, largest);
  Axis axis{.logarithmic = true, .low = 1, .high = 10, .quantity = text_of({quantity.name, unit})};
  std::vector<std::string> ticks;
  if (smallest > 0 && largest >= smallest && std::isfinite(largest)) {
    const auto drawable = [](double x) { return std::clamp(x, 1 / largest_drawable, largest_drawable); };
    const double room = std::max(1.01, std::pow(largest, 0.05) * std::pow(smallest, -0.05));
    axis.low = drawable(drawable(smallest) / room);
    axis.high = drawable(drawable(largest) * room);
    const bool has_many_decades = axis.high / 1e3 > axis.low;
    for (const double tick : ratio_ticks(factor * axis.low, factor * axis.high)) {
      const std::string label = tick == 1          ? "1"
                                : has_many_decades ? fmt::format("10^{{{:.0f}}}", std::log10(tick))
                                                   : fmt::format("{:.4g}", tick);
      ticks.push_back(fmt::format("'{}' {}", label, text_of(tick)));
    }
  }
  axis.settings = fmt::format(
      "set logscale x\nset xrange [{0}:{1}]\n{2}set xlabel {3} noenhanced\n"
      "shown_x(x) = x * {4} < {0} ? {0} : (x * {4} > {1} ? {1} : x * {4})\nshown(x) = x * {4}\n",
      text_of(factor * axis.low), text_of(factor * axis.high),
      ticks.empty() ? "unset xtics\n" : fmt::format("set xtics enhanced ({})\n", fmt::join(ticks, ", ")),
      axis_title(axis.quantity, most_beside_x), text_of(factor));
  return axis;
}

}  // namespace ikbench::figures
