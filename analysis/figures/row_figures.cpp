#include "analysis/figures/row_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/figures/figure_parts.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace numerics;
using namespace statistics;
using namespace inference;

namespace {

// Above the rows: who is better on each side of the line, by name if that is the same in all rows; in a narrow figure
// on two lines.
std::string side_labels(const std::vector<DifferenceRow>& rows, const DifferencesWords& words) {
  constexpr double room_cm = 1.6;  // for a name
  const auto common = [&](std::string DifferenceRow::*side, const std::string& other) {
    const std::string& name = rows.front().*side;
    const bool is_same = std::ranges::all_of(rows, [&](const DifferenceRow& row) { return row.*side == name; });
    return is_same && label_cm(name) <= room_cm ? name : other;
  };
  std::string left = common(&DifferenceRow::first, "first"), right = common(&DifferenceRow::second, "second");
  if (words.larger_is_better) std::swap(left, right);
  left = fmt::format("← {} better", left);
  right = fmt::format("{} better →", right);
  return fmt::format(
      "lines = (1 - rows_margin) * width_cm < {} * text / 8 ? 2 : 1\n"
      "set label {} at graph 0, graph 1 left offset 0, lines - 0.3 noenhanced font names\n"
      "set label {} at graph 1, graph 1 right offset 0, 0.7 noenhanced font names\nset tmargin 0.6 + lines\n",
      text_of(label_cm(left) + label_cm(right) + 0.4), gnuplot_string(left), gnuplot_string(right));
}

// In a narrow figure the title of the axis stands below the whole figure, not below the axis alone.
std::string title_place(const std::string& title) {
  constexpr double larger = 8.0 / 7;  // than the names that label_cm measures
  return fmt::format(
      "if ((1 - rows_margin) * width_cm < {} * text / 8) set xlabel offset screen -rows_margin / 2, character 0.85\n",
      text_of(larger * label_cm(title)));
}

}  // namespace

Figure differences_figure(const std::vector<DifferenceRow>& rows, const DifferencesWords& words) {
  const double of_equals = words.are_ratios ? 1 : 0;
  const auto is_known = [&](const DifferenceRow& row) {  // a logarithmic axis shows no zero
    return is_drawable(row.low) && is_drawable(row.high) && is_drawable(row.difference) &&
           (!words.are_ratios || row.low > 0);
  };
  std::vector<std::string> labels;
  std::vector<double> all{of_equals};
  for (const DifferenceRow& row : rows) {
    labels.push_back(fmt::format("{} {} {}", row_label(row.first, longest_label), words.are_ratios ? "/" : "-",
                                 row_label(row.second, longest_label)));
    if (is_known(row)) all.insert(all.end(), {row.low, row.difference, row.high});
  }
  Figure figure{.name = words.name};
  add_rows(figure, labels, 0.42);
  const auto [smallest, largest] = std::ranges::minmax(all);
  const Axis axis =
      words.are_ratios ? ratio_axis(smallest, largest, words.quantity) : row_axis(all, words.quantity, Scale::linear);
  figure.settings += axis.settings + title_place(axis.quantity);
  if (!rows.empty()) {
    figure.height_cm += 0.3;
    figure.settings += side_labels(rows, words);
    figure.settings += fmt::format(
        "set arrow from {0}, graph 0 to {0}, graph 1 nohead back lw 0.8 lc rgb '#888888' dt 2\n", of_equals);
  }
  const bool room_at_right = words.are_ratios ? axis.high * axis.low > 1 : axis.high > -axis.low;
  const std::string_view equals = words.are_ratios ? "1" : "zero";
  figure.caption = fmt::format(
      "{}: simultaneous {} intervals ({}). Blue with a filled dot: the interval excludes {}. Grey with a ring: it "
      "does not. Left of {}, {}.",
      capitalised(axis.quantity.empty() ? "difference" : axis.quantity), rounded_number(100 * words.level, 6) + " %",
      words.method, equals, equals,
      words.larger_is_better ? "the second of a row is better" : "the first of a row is better");
  figure.data = fmt::format("# row, {}, low, high, whether the interval excludes {}; -1: not known, not drawn\n",
                            words.are_ratios ? "ratio" : "difference", equals);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const DifferenceRow& row = rows[i];
    const int excludes = !is_known(row) ? -1 : row.low > of_equals || row.high < of_equals ? 1 : 0;
    figure.data += fmt::format("# {}\n{} {} {} {} {}\n", one_line(labels[i]), i + 1, data_number(row.difference),
                               data_number(row.low), data_number(row.high), excludes);
    if (excludes >= 0) continue;
    figure.settings +=
        fmt::format("set label '{}' at {}, first {} {} front offset {}, 0 font remarks textcolor rgb '#666666'\n",
                    std::isinf(row.low) || std::isinf(row.high) ? "unbounded" : "not defined", of_equals, i + 1,
                    room_at_right ? "left" : "right", room_at_right ? 1 : -1);
  }
  if (!std::ranges::all_of(rows, is_known)) figure.caption += " Undefined and unbounded intervals are labelled.";
  std::vector<std::string> clauses{"NaN"};
  for (const auto& [excludes, style] : {std::pair{0, "pt 6 lc rgb '#888888'"}, {1, "pt 7 lc rgb word(colours, 1)"}}) {
    clauses.push_back(
        fmt::format("data using ($5=={} ? shown($3) : NaN):1:(shown($4)-shown($3)):(0) with vectors nohead lw 1.4 {}",
                    excludes, style));
    clauses.push_back(fmt::format("data using ($5=={} && $3==$3 ? shown($2) : NaN):1 with points ps 0.55 lw 1.2 {}",
                                  excludes, style));
  }
  figure.plot = plot_command(clauses);
  return figure;
}

Figure rates_figure(const std::vector<std::string>& rows, const std::vector<RateSeries>& series,
                    const RatesWords& words) {
  Figure figure{.name = words.name, .caption = words.caption};
  add_rows(figure, rows, std::max(0.42, 0.2 * static_cast<double>(series.size())));
  figure.settings += fmt::format("set xrange [0:100]\nset xtics 20\nset xlabel {}\n",
                                 gnuplot_string(fmt::format("{} [%]", words.quantity)));
  figure.data = "# a block a series: row, share, low, high [%]\n";
  std::vector<std::string> clauses{"NaN"}, labels;
  for (std::size_t k = 0; k < series.size(); ++k) {
    const RateSeries& one = series[k];
    const double place = 0.8 * (static_cast<double>(k) + 0.5) / static_cast<double>(series.size()) - 0.4;
    figure.data += fmt::format("{}# {}\n", k == 0 ? "" : "\n\n", one_line(one.name));
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const Estimate& share = one.shares[row];
      figure.data +=
          fmt::format("{} {} {} {}\n", text_of(static_cast<double>(row + 1) + place), data_number(100 * share.value),
                      data_number(100 * share.low), data_number(100 * share.high));
    }
    labels.push_back(shortened(one.name, longest_label));
    clauses.push_back(fmt::format("data index {} using 3:1:($4-$3):(0) with vectors nohead ls {}", k, one.colour));
    clauses.push_back(fmt::format("data index {} using 2:1 with points ls {} pt {} title {}", k, one.colour,
                                  one.is_ring ? "6 ps 0.8" : "7 ps 0.55", gnuplot_string(labels.back())));
  }
  add_legend(figure, labels);
  figure.plot = plot_command(clauses);
  return figure;
}

}  // namespace ikbench::figures
