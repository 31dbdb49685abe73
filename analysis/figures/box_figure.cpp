#include "analysis/figures/box_figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/text.hpp"

namespace ikbench::figures {

using namespace results;
using namespace statistics;
using namespace inference;

namespace {

constexpr std::size_t most_drawn = 200;  // groups, and values of a group

// All sorted values, or as many as fit at even ranks, including the extremes.
std::string strip_block(std::size_t row, const std::vector<double>& sorted) {
  constexpr double golden_ratio = 0.6180339887498949;  // multiples of it fill an interval evenly
  const std::size_t n = std::min(sorted.size(), most_drawn);
  std::string block;
  for (std::size_t i = 0; i < n; ++i) {
    const double value = sorted[n == sorted.size() ? i : i * (sorted.size() - 1) / (n - 1)];
    const double jitter = 0.12 * (2 * std::fmod(golden_ratio * static_cast<double>(i + 1), 1.0) - 1);
    block += fmt::format("{} {:.4f}\n", data_number(value), static_cast<double>(row) + 0.2 + jitter);
  }
  return block.empty() ? "NaN NaN\n" : block;
}

// Draws no box if a part of it cannot be drawn: it would seem to end where the rest does.
std::string box_line(double row, const Box& b) {
  const bool is_drawn = std::ranges::all_of(std::array{b.q1, b.q3, b.whisker_low, b.whisker_high}, is_drawable);
  const double n = b.n, lost = b.not_finite;
  if (!is_drawn) return data_line({row, not_defined, not_defined, not_defined, not_defined, not_defined, n, lost});
  return data_line({row, b.whisker_low, b.q1, b.median, b.q3, b.whisker_high, n, lost});
}

// Adds marks below their rows.
void add_marks(Figure& figure, std::vector<std::string>& clauses, std::span<const Group> groups,
               const std::vector<Mark>& marks) {
  figure.data += "\n\n# marks: row, smallest, median, largest, whether the smallest is less\n";
  for (const Mark& mark : marks) {
    const auto group = std::ranges::find(groups, mark.group, &Group::name);
    if (group == groups.end()) continue;
    const auto row = static_cast<double>(group - groups.begin() + 1);
    figure.data += data_line({row, mark.min, mark.median, mark.max, mark.is_open ? 1.0 : 0.0});
  }
  const std::string source = fmt::format("data index {} using", groups.size() + 1);
  for (const auto& [is_open, head] : {std::pair{0, "nohead"}, {1, "backhead filled size graph 0.02, 25"}}) {
    clauses.push_back(fmt::format(
        "{} ($5=={} ? shown($2) : NaN):($1+0.4):(shown($4)-shown($2)):(0) with vectors {} lw 1.6 lc rgb '#808080'",
        source, is_open, head));
  }
  clauses.push_back(source + " (shown($3)):($1+0.34):(0):(0.12) with vectors nohead lw 1.6 lc rgb '#404040'");
}

}  // namespace

Box box(std::span<const double> values, QuantileType type) {
  Box result;
  result.n = static_cast<int>(values.size());
  std::vector<double> ranked = ranked_values(values);
  result.q1 = quantile(ranked, 0.25, type);
  result.median = quantile(ranked, 0.5, type);
  result.q3 = quantile(ranked, 0.75, type);
  result.not_finite = static_cast<int>(std::erase_if(ranked, [](double value) { return !std::isfinite(value); }));
  if (!std::isfinite(result.q1) || !std::isfinite(result.q3)) return result;
  const double reach = 1.5 * (result.q3 - result.q1);
  result.whisker_low = result.q1;  // used if no value lies between the fence and the box
  result.whisker_high = result.q3;
  for (const double value : ranked) {
    if (value < result.q1 - reach || value > result.q3 + reach) continue;
    result.whisker_low = std::min(result.whisker_low, value);
    result.whisker_high = std::max(result.whisker_high, value);
  }
  return result;
}

// In a row the box is above the middle, the values are below it, and marks are lowest. The boxes are block 0 of the
// data; the values of row 1, 2, ... are block 1, 2, ...
Figure box_figure(const Observations& observations, QuantileType quartiles, const std::string& name,
                  const std::vector<Mark>& marks) {
  const std::size_t n = std::min(observations.groups.size(), most_drawn);
  const std::span<const Group> groups(observations.groups.data(), n);
  std::vector<std::string> labels;
  std::vector<int> styles;
  std::vector<double> all;
  for (const Group& group : groups) {
    styles.push_back(group.style.value_or(static_cast<int>(labels.size()) + 1));
    labels.push_back(group.name);
    all.insert(all.end(), group.values.begin(), group.values.end());
  }
  for (const Mark& mark : marks) all.insert(all.end(), {mark.min, mark.median, mark.max});
  Figure figure{.name = name};
  add_rows(figure, labels, 0.6);
  const Axis axis = row_axis(all, {split_unit(observations.quantity).name, observations.unit}, Scale::by_spread);
  figure.settings += axis.settings;
  figure.settings += fmt::format("colour(row) = colour_of(int(word('{}', row)))\n", fmt::join(styles, " "));
  figure.data = "# row, lower whisker, q1, median, q3, upper whisker, observations, of those not finite\n";
  std::string blocks;
  bool thinned = false, undrawn = false;
  for (std::size_t row = 1; row <= n; ++row) {
    const Group& group = groups[row - 1];
    std::vector<double> sorted;
    std::ranges::copy_if(group.values, std::back_inserter(sorted), is_drawable);
    std::ranges::sort(sorted);
    const std::size_t lost = group.values.size() - sorted.size();
    thinned = thinned || sorted.size() > most_drawn;
    figure.data +=
        fmt::format("# {}\n{}", one_line(group.name), box_line(static_cast<double>(row), box(group.values, quartiles)));
    blocks += fmt::format("\n\n# values of {}: value, height\n{}", one_line(group.name), strip_block(row, sorted));
    if (lost == 0 && !sorted.empty()) continue;
    undrawn = true;
    const std::string words = group.values.empty() ? "no\\nvalues" : fmt::format("{} not\\ndrawn", lost);
    figure.settings +=
        fmt::format("set label \"{}\" at graph 1, first {} left offset 0.6, 0 font remarks\n", words, row);
  }
  figure.data += blocks;
  std::vector<std::string> clauses{"NaN"};
  if (n > 0) {
    const std::string values = fmt::format("for [row=1:{}] data index row using", n),
                      box_of_row = fmt::format("for [row=1:{}] data index 0 every ::row-1::row-1 using", n);
    clauses.push_back(values + " (shown($1)):2 with points pt 6 ps 0.3 lw 0.7 lc rgb colour(row)");
    clauses.push_back(box_of_row +
                      " (shown($2)):($1-0.14):(shown($6)-shown($2)):(0) with vectors nohead lw 0.9 lc rgb colour(row)");
    clauses.push_back(box_of_row +
                      " (shown($4)):($1-0.14):(shown($3)):(shown($5)):($1-0.24):($1-0.04) with boxxyerror fs solid "
                      "0.15 border lw 0.9 lc rgb colour(row)");
    clauses.emplace_back(
        "data index 0 using (shown($4)):($1-0.24):(0):(0.2) with vectors nohead lw 1.6 lc rgb '#000000'");
  }
  if (!marks.empty()) add_marks(figure, clauses, groups, marks);
  if (undrawn) figure.settings += "set rmargin 6\n";
  figure.plot = plot_command(clauses);

  figure.caption =
      fmt::format("{}: box plot (quartiles: Hyndman-Fan type {}; whiskers: last value within 1.5 box heights) and {}",
                  capitalised(observations.quantity.empty() ? "values" : axis.quantity), static_cast<int>(quartiles),
                  thinned ? fmt::format("the values; of more than {0} in a group, {0} at even ranks.", most_drawn)
                          : "every value.");
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

Figure box_figure(const StudyResults& all, Metric metric, const std::string& name, const std::vector<Mark>& marks) {
  const StudyResults study = drawn_part(all);
  const NameWithUnit quantity = with_unit(metric);
  Observations observations{.name = name, .quantity = text_of(quantity), .unit = quantity.unit};
  for (const Sample& sample : samples(study, metric)) {
    observations.groups.push_back(
        {.name = sample.solver, .values = sample.values, .style = style_of(study, sample.solver)});
  }
  observations.replicate =
      study.plan.unit == Unit::point ? "a point" : fmt::format("the {} of a run", average_name(metric));
  if (info_of(metric).kind == Kind::time) observations.flaws = times_doubts(study);
  return box_figure(observations, QuantileType{study.plan.quartiles}, name, marks);
}

}  // namespace ikbench::figures
