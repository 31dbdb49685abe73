#include "analysis/figures/raincloud_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/row_chart.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/kernel_density.hpp"

namespace ikbench::figures {

using namespace statistics;
using namespace inference;

namespace {

constexpr std::size_t most_violins = 12;
constexpr std::size_t most_strip_values = 200;

// Heights of the parts, as shares of a row measured from its middle, downwards.
struct Layout {
  double row_cm;
  double violin_base;
  double violin_top;  // equal to the base: no violins
  double box;         // its middle
  double box_half;
  double strip;  // its middle
  double strip_half;
};

Layout layout_of(std::size_t groups) {
  if (groups > most_violins) return {0.5, 0, 0, -0.14, 0.1, 0.2, 0.12};
  return {groups > 6 ? 0.95 : 1.25, -0.07, -0.45, 0.03, 0.06, 0.26, 0.12};
}

std::vector<double> drawable_values(const Group& group) {
  std::vector<double> values;
  std::ranges::copy_if(group.values, std::back_inserter(values), is_drawable);
  std::ranges::sort(values);
  return values;
}

// All sorted values, or as many at even ranks, the extremes among them.
std::vector<double> strip_values(const std::vector<double>& sorted) {
  if (sorted.size() <= most_strip_values) return sorted;
  std::vector<double> chosen;
  for (std::size_t i = 0; i < most_strip_values; ++i) {
    chosen.push_back(sorted[i * (sorted.size() - 1) / (most_strip_values - 1)]);
  }
  return chosen;
}

std::string strip_block(std::size_t row, const std::vector<double>& sorted, const Layout& layout) {
  constexpr double golden_ratio = 0.6180339887498949;  // multiples of it fill an interval evenly
  std::string block;
  std::size_t i = 0;
  for (const double value : strip_values(sorted)) {
    const double jitter = 2 * std::fmod(golden_ratio * static_cast<double>(++i), 1.0) - 1;
    block += fmt::format("{} {:.4f}\n", data_number(value),
                         static_cast<double>(row) + layout.strip + layout.strip_half * jitter);
  }
  return block.empty() ? "NaN NaN\n" : block;
}

// The outline, closed along its base.
std::string violin_block(std::size_t row, const std::vector<double>& sorted, const RowAxis& axis,
                         const Layout& layout) {
  std::vector<double> values;
  for (const double value : sorted) {
    if (!axis.logarithmic) values.push_back(value);
    if (axis.logarithmic && value > 0) values.push_back(std::log10(value));
  }
  const std::vector<DensityPoint> density = kernel_density(values);
  if (density.empty() || layout.violin_base == layout.violin_top) return "NaN NaN\n";
  const double highest = std::ranges::max(density, {}, &DensityPoint::density).density;
  const double base = static_cast<double>(row) + layout.violin_base;
  const auto line = [&](double value, double height) {
    return fmt::format("{} {:.4f}\n", data_number(axis.logarithmic ? std::pow(10, value) : value),
                       base + (layout.violin_top - layout.violin_base) * height);
  };
  std::string block = line(density.front().value, 0);
  for (const DensityPoint& point : density) block += line(point.value, point.density / highest);
  return block + line(density.back().value, 0);
}

// No box where a part of it cannot be drawn: it would seem to end where the rest does.
std::string box_line(std::size_t row, Box b) {
  if (!is_drawable(b.q1) || !is_drawable(b.q3) || !is_drawable(b.whisker_low) || !is_drawable(b.whisker_high)) {
    b.whisker_low = b.q1 = b.median = b.q3 = b.whisker_high = not_defined;
  }
  return fmt::format("{} {} {} {} {} {} {} {}\n", row, data_number(b.whisker_low), data_number(b.q1),
                     data_number(b.median), data_number(b.q3), data_number(b.whisker_high), b.n, b.not_finite);
}

// What is drawn of group `row`, whose blocks in the data file are 1 (box), 2 row (violin) and 2 row + 1 (strip).
std::vector<std::string> clauses_of(const std::string& name, std::size_t row, const Layout& layout) {
  const std::string colour = fmt::format("lc rgb word(colours, {})", (row - 1) % 7 + 1);
  const std::size_t line = row - 1;
  const std::string box_data = fmt::format("'{}.dat' index 0 every ::{}::{} using", name, line, line);
  const double middle = layout.box;
  const double half = layout.box_half;
  std::vector<std::string> clauses;
  if (layout.violin_base != layout.violin_top) {
    const std::string violin = fmt::format("'{}.dat' index {} using (shown($1)):2", name, 2 * row - 1);
    clauses.push_back(fmt::format("{} with filledcurves closed {} fs solid 0.3 noborder", violin, colour));
    clauses.push_back(fmt::format("{} with lines lw 0.8 dt 1 {}", violin, colour));
  }
  clauses.push_back(
      fmt::format("'{}.dat' index {} using (shown($1)):2 with points pt 6 ps 0.3 lw 0.7 {}", name, 2 * row, colour));
  clauses.push_back(fmt::format("{} (shown($2)):($1+{}):(shown($6)-shown($2)):(0) with vectors nohead lw 0.9 {}",
                                box_data, middle, colour));
  clauses.push_back(
      fmt::format("{0} (shown($4)):($1+{1}):(shown($3)):(shown($5)):($1+{2}):($1+{3}) with boxxyerror fs "
                  "solid 0.15 border lw 0.9 {4}",
                  box_data, middle, middle - half, middle + half, colour));
  clauses.push_back(fmt::format("{} (shown($4)):($1+{}):(0):({}) with vectors nohead lw 1.6 lc rgb '#000000'", box_data,
                                middle - half, 2 * half));
  return clauses;
}

}  // namespace

Figure raincloud_figure(const Observations& observations, QuantileType quartiles, const std::string& name) {
  const std::size_t n = std::min(observations.groups.size(), most_rows);
  const std::span<const Group> groups(observations.groups.data(), n);
  const Layout layout = layout_of(n);
  std::vector<std::string> labels;
  std::vector<double> all;
  for (const Group& group : groups) {
    labels.push_back(group.name);
    all.insert(all.end(), group.values.begin(), group.values.end());
  }
  Figure figure{.name = name};
  add_rows(figure, labels, layout.row_cm);
  const RowAxis axis = row_axis(all, observations.quantity, Scale::by_spread);
  figure.settings += axis.settings;

  std::string boxes = "# row, lower whisker, q1, median, q3, upper whisker, observations, of those not finite\n";
  std::string blocks;
  std::vector<std::string> clauses;
  bool thinned = false;
  bool undrawn = false;
  for (std::size_t row = 1; row <= n; ++row) {
    const Group& group = groups[row - 1];
    const std::vector<double> sorted = drawable_values(group);
    const std::size_t lost = group.values.size() - sorted.size();
    thinned = thinned || sorted.size() > most_strip_values;
    undrawn = undrawn || lost > 0 || sorted.empty();
    const std::string title = one_line(group.name);
    boxes += fmt::format("# {}\n{}", title, box_line(row, box(group.values, quartiles)));
    blocks += fmt::format("\n\n# density of {}: value, height\n{}", title, violin_block(row, sorted, axis, layout));
    blocks += fmt::format("\n\n# values of {}: value, height\n{}", title, strip_block(row, sorted, layout));
    if (lost > 0 || sorted.empty()) {
      const std::string words = group.values.empty() ? "no\\nvalues" : fmt::format("{} not\\ndrawn", lost);
      figure.settings +=
          fmt::format("set label \"{}\" at graph 1, first {} left offset 0.6, 0 font ',6'\n", words, row);
    }
    for (std::string& clause : clauses_of(name, row, layout)) clauses.push_back(std::move(clause));
  }
  if (clauses.empty()) clauses.emplace_back("NaN notitle");
  figure.data = boxes + blocks;
  figure.plot = plot_command(clauses);

  if (undrawn) figure.settings += "set rmargin 6\n";

  figure.caption = capitalised(observations.quantity.empty() ? "values" : observations.quantity) + ": ";
  if (n <= most_violins) {
    figure.caption += fmt::format(
        "density (Gaussian kernel, Silverman's bandwidth{}; cut at the extremes, equal heights, at least 5 values), ",
        axis.logarithmic ? ", of the logarithm" : "");
  }
  figure.caption +=
      fmt::format("box plot (quartiles: Hyndman-Fan type {}; whiskers: last value within 1.5 box heights) and ",
                  static_cast<int>(quartiles));
  figure.caption += thinned
                        ? fmt::format("the values; of more than {0} in a group, {0} at even ranks.", most_strip_values)
                        : "every value.";
  if (!observations.replicate.empty()) figure.caption += fmt::format(" One value is {}.", observations.replicate);
  if (axis.shows_at_edge) figure.caption += " Values of zero are drawn at the lower edge and are not in the density.";
  if (undrawn)
    figure.caption +=
        " Values beyond 1e300 and values that are not finite are not drawn; the row gives their number. They keep "
        "their ranks, and values that are not a number rank last. If a quartile is one of them, there is no box.";
  if (n < observations.groups.size()) {
    figure.caption += fmt::format(" Only the first {} of {} groups are shown.", n, observations.groups.size());
  }
  if (!observations.flaw.empty()) figure.caption += fmt::format(" Flawed: {}", observations.flaw);
  return figure;
}

}  // namespace ikbench::figures
