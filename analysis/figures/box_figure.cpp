#include "analysis/figures/box_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "analysis/figures/dark.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/row_chart.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/text.hpp"

namespace ikbench::figures {

using namespace results;
using namespace statistics;
using namespace inference;

namespace {

constexpr std::size_t most_strip_values = 200;

// Heights of the parts, measured from the middle of a row, downwards.
constexpr double row_cm = 0.6, box_middle = -0.14, box_half = 0.1, strip_middle = 0.2, strip_half = 0.12,  // in rows
    marks_middle = 0.4;

std::vector<double> drawable_values(const Group& group) {
  std::vector<double> values;
  std::ranges::copy_if(group.values, std::back_inserter(values), is_drawable);
  std::ranges::sort(values);
  return values;
}

// All sorted values, or as many as fit at even ranks, including the extremes.
std::vector<double> strip_values(const std::vector<double>& sorted) {
  if (sorted.size() <= most_strip_values) return sorted;
  std::vector<double> chosen;
  for (std::size_t i = 0; i < most_strip_values; ++i) {
    chosen.push_back(sorted[i * (sorted.size() - 1) / (most_strip_values - 1)]);
  }
  return chosen;
}

std::string strip_block(std::size_t row, const std::vector<double>& sorted) {
  constexpr double golden_ratio = 0.6180339887498949;  // multiples of it fill an interval evenly
  std::string block;
  std::size_t i = 0;
  for (const double value : strip_values(sorted)) {
    const double jitter = 2 * std::fmod(golden_ratio * static_cast<double>(++i), 1.0) - 1;
    block +=
        fmt::format("{} {:.4f}\n", data_number(value), static_cast<double>(row) + strip_middle + strip_half * jitter);
  }
  return block.empty() ? "NaN NaN\n" : block;
}

// Draws no box if a part of it cannot be drawn: it would seem to end where the rest does.
std::string box_line(std::size_t row, Box b) {
  if (!is_drawable(b.q1) || !is_drawable(b.q3) || !is_drawable(b.whisker_low) || !is_drawable(b.whisker_high)) {
    b.whisker_low = b.q1 = b.median = b.q3 = b.whisker_high = not_defined;
  }
  return fmt::format("{} {} {} {} {} {} {} {}\n", row, data_number(b.whisker_low), data_number(b.q1),
                     data_number(b.median), data_number(b.q3), data_number(b.whisker_high), b.n, b.not_finite);
}

std::string marks_block(std::span<const Group> groups, const std::vector<Mark>& marks) {
  std::string block = "\n\n# marks: row, smallest, median, largest, whether the smallest is less\n";
  for (const Mark& mark : marks) {
    const auto group = std::ranges::find(groups, mark.group, &Group::name);
    if (group == groups.end()) continue;
    block += fmt::format("{} {} {} {} {}\n", group - groups.begin() + 1, data_number(mark.min),
                         data_number(mark.median), data_number(mark.max), mark.is_open ? 1 : 0);
  }
  return block;
}

// The parts of group `row`, whose box is a line of block 0 and whose values are block `row`.
std::vector<std::string> clauses_of(const std::string& name, std::size_t row, std::size_t place) {
  const std::string colour = fmt::format("lc rgb word(colours, {})", place % series_colours.size() + 1);
  const std::string box_data = fmt::format("'{}.dat' index 0 every ::{}::{} using", name, row - 1, row - 1);
  std::vector<std::string> clauses;
  clauses.push_back(
      fmt::format("'{}.dat' index {} using (shown($1)):2 with points pt 6 ps 0.3 lw 0.7 {}", name, row, colour));
  clauses.push_back(fmt::format("{} (shown($2)):($1+{}):(shown($6)-shown($2)):(0) with vectors nohead lw 0.9 {}",
                                box_data, box_middle, colour));
  clauses.push_back(
      fmt::format("{0} (shown($4)):($1+{1}):(shown($3)):(shown($5)):($1+{2}):($1+{3}) with boxxyerror fs "
                  "solid 0.15 border lw 0.9 {4}",
                  box_data, box_middle, box_middle - box_half, box_middle + box_half, colour));
  clauses.push_back(fmt::format("{} (shown($4)):($1+{}):(0):({}) with vectors nohead lw 1.6 lc rgb '#000000'", box_data,
                                box_middle - box_half, 2 * box_half));
  return clauses;
}

}  // namespace

Figure box_figure(const Observations& observations, QuantileType quartiles, const std::string& name,
                  const std::vector<Mark>& marks) {
  const std::size_t n = std::min(observations.groups.size(), most_rows);
  const std::span<const Group> groups(observations.groups.data(), n);
  std::vector<std::string> labels;
  std::vector<double> all;
  for (const Group& group : groups) {
    labels.push_back(group.name);
    all.insert(all.end(), group.values.begin(), group.values.end());
  }
  for (const Mark& mark : marks) all.insert(all.end(), {mark.min, mark.median, mark.max});
  Figure figure{.name = name};
  add_rows(figure, labels, row_cm);
  const Axis axis = row_axis(all, {split_unit(observations.quantity).name, observations.unit}, Scale::by_spread);
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
    blocks += fmt::format("\n\n# values of {}: value, height\n{}", title, strip_block(row, sorted));
    if (lost > 0 || sorted.empty()) {
      const std::string words = group.values.empty() ? "no\\nvalues" : fmt::format("{} not\\ndrawn", lost);
      figure.settings +=
          fmt::format("set label \"{}\" at graph 1, first {} left offset 0.6, 0 font remarks\n", words, row);
    }
    for (std::string& clause : clauses_of(name, row, group.place.value_or(row - 1)))
      clauses.push_back(std::move(clause));
  }
  if (clauses.empty()) clauses.emplace_back("NaN notitle");
  figure.data = boxes + blocks;
  if (!marks.empty()) {
    figure.data += marks_block(groups, marks);
    const std::string source = fmt::format("'{}.dat' index {} using", name, n + 1);
    for (const auto& [is_open, head] : {std::pair{0, "nohead"}, {1, "backhead filled size graph 0.02, 25"}}) {
      clauses.push_back(
          fmt::format("{} ($5=={} ? shown($2) : NaN):($1+{}):(shown($4)-shown($2)):(0) with vectors {} lw 1.6 lc rgb "
                      "'#808080'",
                      source, is_open, marks_middle, head));
    }
    clauses.push_back(fmt::format("{} (shown($3)):($1+{}):(0):(0.12) with vectors nohead lw 1.6 lc rgb '#404040'",
                                  source, marks_middle - 0.06));
  }
  figure.plot = plot_command(clauses);

  if (undrawn) figure.settings += "set rmargin 6\n";

  figure.caption = capitalised(observations.quantity.empty() ? "values" : axis.quantity) + ": ";
  figure.caption +=
      fmt::format("box plot (quartiles: Hyndman-Fan type {}; whiskers: last value within 1.5 box heights) and ",
                  static_cast<int>(quartiles));
  figure.caption += thinned
                        ? fmt::format("the values; of more than {0} in a group, {0} at even ranks.", most_strip_values)
                        : "every value.";
  if (!observations.replicate.empty()) figure.caption += fmt::format(" One value is {}.", observations.replicate);
  for (const std::string& note : observations.counting) figure.caption += ' ' + note;
  if (axis.shows_at_edge) figure.caption += " Values of zero are drawn at the lower edge.";
  if (undrawn)
    figure.caption +=
        " Values beyond 1e300 and values that are not finite are not drawn; the row gives their number. They keep "
        "their ranks, and values that are not a number rank last. If a quartile is one of them, there is no box.";
  if (n < observations.groups.size()) {
    figure.caption += fmt::format(" Only the first {} of {} groups are shown.", n, observations.groups.size());
  }
  if (!observations.flaws.empty()) figure.caption += fmt::format(" Flawed: {}", words_of(observations.flaws));
  return figure;
}

Figure box_figure(const StudyResults& study, Metric metric, const std::string& name, const std::vector<Mark>& marks) {
  const NameWithUnit quantity = with_unit(metric);
  Observations observations{.name = name, .quantity = text_of(quantity), .unit = quantity.unit};
  for (const Sample& sample : samples(study, metric)) {
    observations.groups.push_back(
        {.name = sample.solver, .values = sample.values, .place = place_of(study, sample.solver)});
  }
  observations.replicate = study.plan.unit == Unit::point ? "a point"
                           : is_of_run(metric)            ? "that of a run"
                                                          : fmt::format("the {} of a run", average_name(metric));
  if (info_of(metric).kind == Kind::time) observations.flaws = times_doubts(study);
  return box_figure(observations, quantile_type(study.plan.quartiles), name, marks);
}

}  // namespace ikbench::figures
