#include "analysis/figures/differences_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/row_chart.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace statistics;
using namespace inference;

namespace {

enum class Zero { inside, outside, unknown };

// Returns whether the interval holds `none`, the difference (0) or ratio (1) of equals.
Zero zero_of(const DifferenceRow& row, double none) {
  if (!is_drawable(row.low) || !is_drawable(row.high) || !is_drawable(row.difference)) return Zero::unknown;
  if (none == 1 && !(row.low > 0)) return Zero::unknown;  // a logarithmic axis cannot show it
  return row.low > none || row.high < none ? Zero::outside : Zero::inside;
}

}  // namespace

Figure differences_figure(const std::vector<DifferenceRow>& rows, const DifferencesWords& words) {
  const std::size_t n = std::min(rows.size(), most_rows);
  std::vector<std::string> labels;
  const double none = words.are_ratios ? 1 : 0;
  std::vector<double> all{none};
  for (std::size_t i = 0; i < n; ++i) {
    labels.push_back(rows[i].label);
    if (zero_of(rows[i], none) != Zero::unknown) all.insert(all.end(), {rows[i].low, rows[i].difference, rows[i].high});
  }
  Figure figure{.name = words.name};
  add_rows(figure, labels, 0.42);
  const auto [smallest, largest] = std::ranges::minmax(all);
  const Axis axis = words.are_ratios ? ratio_axis(smallest, largest, words.quantity)
                                     : row_axis(all, {words.quantity, ""}, Scale::linear);
  const bool room_at_right = words.are_ratios ? axis.high * axis.low > 1 : axis.high > -axis.low;
  figure.settings += axis.settings;
  if (n > 0)
    figure.settings +=
        fmt::format("set arrow from {0}, graph 0 to {0}, graph 1 nohead back lw 0.8 lc rgb '#888888' dt 2\n", none);
  const std::string_view of_equals = words.are_ratios ? "1" : "zero";
  figure.data = fmt::format("# row, {}, low, high, whether the interval excludes {}; -1: not known, not drawn\n",
                            words.are_ratios ? "ratio" : "difference", of_equals);
  bool unknown = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Zero zero = zero_of(rows[i], none);
    figure.data += fmt::format("# {}\n{} {} {} {} {}\n", one_line(rows[i].label), i + 1,
                               data_number(rows[i].difference), data_number(rows[i].low), data_number(rows[i].high),
                               zero == Zero::unknown   ? -1
                               : zero == Zero::outside ? 1
                                                       : 0);
    if (zero != Zero::unknown) continue;
    unknown = true;
    const bool unbounded = std::isinf(rows[i].low) || std::isinf(rows[i].high);
    figure.settings += fmt::format(
        "set label '{}' at {}, first {} {} front offset {}, 0 font remarks textcolor rgb "
        "'#666666'\n",
        unbounded ? "unbounded" : "not defined", none, i + 1, room_at_right ? "left" : "right", room_at_right ? 1 : -1);
  }
  const auto clauses_for = [&](int excludes, std::string_view colour, std::string_view marker) {
    const std::string chosen = fmt::format("'{}.dat' using ($5=={} ? $3 : NaN):1", words.name, excludes);
    return std::vector<std::string>{
        fmt::format("{}:($4-$3):(0) with vectors nohead lw 1.4 lc rgb {}", chosen, colour),
        fmt::format("'{}.dat' using ($5=={} && $3==$3 ? $2 : NaN):1 with points {} ps 0.55 lw 1.2 lc rgb {}",
                    words.name, excludes, marker, colour)};
  };
  std::vector<std::string> clauses = clauses_for(0, "'#888888'", "pt 6");
  for (std::string& clause : clauses_for(1, "word(colours, 1)", "pt 7")) clauses.push_back(std::move(clause));
  figure.plot = n > 0 ? plot_command(clauses) : "plot NaN notitle";
  figure.caption = fmt::format(
      "{}: simultaneous {} intervals ({}). Blue with a filled dot: the interval excludes {}. Grey with a ring: it "
      "does not.",
      capitalised(words.quantity.empty() ? "difference" : words.quantity), rounded_number(100 * words.level, 6) + " %",
      words.method, of_equals);
  if (unknown) figure.caption += " Undefined and unbounded intervals are labelled.";
  if (n < rows.size()) figure.caption += fmt::format(" Only the first {} of {} rows are shown.", n, rows.size());
  return figure;
}

}  // namespace ikbench::figures
