#include "analysis/figures/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace inference;

namespace {

constexpr double spread_for_logarithmic = 30;

struct Drawn {
  double smallest, largest, factor, least;
  bool room_for_least;
};

std::string logarithmic_settings(const Drawn& of) {
  // Whole decades, at most 300 either way, since gnuplot works in doubles.
  int low = static_cast<int>(std::floor(std::log10(std::max(of.factor * of.smallest, 1e-300))));
  const int high = std::max(low + 1, static_cast<int>(std::ceil(std::log10(std::min(of.factor * of.largest, 1e300)))));
  if (of.room_for_least) low -= 1;
  const int decades_per_tick = 1 + (high - low - 1) / 7;
  // Too small values are drawn at the lower edge, which says so; the ticks are those of the decades above.
  const std::string edge = !of.room_for_least
                               ? ""
                               : fmt::format("set ytics add ('{}' 1e{})\n",
                                             of.least > 0 ? "≤" + rounded_number(of.factor * of.least, 2) : "0", low);
  return fmt::format(
      "set logscale y\nset format y '10^{{%T}}'\nset yrange [1e{0}:1e{1}]\nset ytics 1e{2}\nset mytics {3}\n"
      "{6}shown(y) = y > {5} ? y * {4} : (y <= {5} ? 1e{0} : NaN)\n",
      low, high, decades_per_tick, decades_per_tick == 1 ? 10 : 1, text_of(of.factor), text_of(of.least), edge);
}

}  // namespace

DrawnUnit drawn_unit(const std::string& unit, double largest) {
  if (unit != "s" || !(largest > 0) || largest >= 0.1) return {.unit = unit};
  return largest < 1e-4 ? DrawnUnit{.unit = "µs", .factor = 1e6} : DrawnUnit{.unit = "ms", .factor = 1e3};
}

Axis value_axis(std::span<const double> values, const inference::NameWithUnit& quantity, Scale scale, double least) {
  std::vector<double> finite;
  std::ranges::copy_if(values, std::back_inserter(finite), [](double value) { return std::isfinite(value); });
  if (std::ranges::none_of(finite, [&](double value) { return value > least; })) least = 0;
  std::vector<double> positive;
  std::ranges::copy_if(finite, std::back_inserter(positive), [&](double value) { return value > least; });

  Axis axis{.has_values = !finite.empty(), .least = least};
  const double largest = finite.empty() ? 1.0 : std::ranges::max(finite);
  const double smallest = finite.empty() ? 0.0 : std::ranges::min(finite);
  const auto [unit, factor] = drawn_unit(quantity.unit, largest);
  axis.quantity = text_of({quantity.name, unit});
  if (!positive.empty() && scale != Scale::linear) {
    const double smallest_shown = std::ranges::min(positive);
    axis.logarithmic = scale == Scale::logarithmic || largest > spread_for_logarithmic * smallest_shown;
  }
  if (axis.logarithmic) {
    axis.shows_at_edge = positive.size() < finite.size();
    axis.settings = logarithmic_settings({.smallest = std::ranges::min(positive),
                                          .largest = largest,
                                          .factor = factor,
                                          .least = least,
                                          .room_for_least = axis.shows_at_edge});
  } else {
    const double top = largest > 0 ? 1.05 * factor * largest : 1.0;
    axis.settings = fmt::format("set yrange [{}:{}]\nshown(y) = y * {}\n",
                                text_of(std::min(0.0, 1.05 * factor * smallest)), text_of(top), text_of(factor));
  }
  axis.settings += fmt::format("set ylabel {}\n", gnuplot_string(axis.quantity));
  if (!axis.has_values) axis.settings += "unset ytics\nset label 'no finite values' at graph 0.5, graph 0.5 center\n";
  return axis;
}

}  // namespace ikbench::figures
