#include "analysis/figures/statistics_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

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

// Whether the interval holds `none`, the difference (0) or ratio (1) of equals.
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
  const RowAxis axis =
      words.are_ratios ? ratio_axis(all, words.quantity) : row_axis(all, {words.quantity, ""}, Scale::linear);
  const bool room_at_right = words.are_ratios ? axis.high * axis.low > 1 : axis.high > -axis.low;
  figure.settings += axis.settings;
  if (n > 0)
    figure.settings +=
        fmt::format("set arrow from {0}, graph 0 to {0}, graph 1 nohead back lw 0.8 lc rgb '#888888' dt 2\n", none);
  const std::string_view of_equals = words.are_ratios ? "1" : "zero";
  figure.data = fmt::format("# row, {}, low, high, whether the interval excludes {}\n",
                            words.are_ratios ? "ratio" : "difference", of_equals);
  bool unknown = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Zero zero = zero_of(rows[i], none);
    figure.data +=
        fmt::format("# {}\n{} {} {} {} {}\n", one_line(rows[i].label), i + 1, data_number(rows[i].difference),
                    data_number(rows[i].low), data_number(rows[i].high), zero == Zero::outside ? 1 : 0);
    if (zero != Zero::unknown) continue;
    unknown = true;
    const bool unbounded = std::isinf(rows[i].low) || std::isinf(rows[i].high);
    figure.settings += fmt::format(
        "set label '{}' at {}, first {} {} front offset {}, 0 font ',6' textcolor rgb "
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

Figure effect_matrix_figure(const EffectMatrix& matrix) {
  const std::size_t n = std::min(matrix.labels.size(), most_effect_labels);
  double widest_cm = 0.5;
  std::string row_ticks;

  for (std::size_t i = 0; i < n; ++i) {
    const std::string label = row_label(matrix.labels[i], longest_label);
    widest_cm = std::max(widest_cm, label_cm(label));
    row_ticks += fmt::format("{}{} {}", i == 0 ? "" : ", ", tick_label(label), i + 1);
  }
  const double cell_cm = n > 8 ? 0.72 : 0.95;
  const bool standing = widest_cm > 0.9 * cell_cm;
  constexpr double title_cm = 0.45;
  const double rows_cm = widest_cm + 0.35 + title_cm;
  const double columns_cm = standing ? rows_cm : 0.6 + title_cm;
  const double side_cm = cell_cm * static_cast<double>(std::max<std::size_t>(n, 2));
  constexpr double colours_cm = 1.5;
  Figure figure{
      .name = matrix.name, .width_cm = rows_cm + side_cm + colours_cm + 0.2, .height_cm = side_cm + columns_cm + 0.3};
  const auto screen = [](double cm, double of_cm) { return text_of(cm / of_cm); };
  figure.settings = fmt::format(
      "unset key\nunset grid\nset border 0\nset tics scale 0\nset lmargin at screen {}\nset rmargin at screen {}\n"
      "set bmargin at screen {}\nset tmargin at screen {}\nset xrange [0.5:{}.5]\nset yrange [{}.5:0.5]\n"
      "set xtics noenhanced font ',7' {}({})\nset ytics noenhanced font ',7' ({})\n"
      "set label 'the chance that this one ...' at screen {}, screen {} center rotate by 90 font ',7'\n"
      "set label '... is better than this one' at screen {}, screen {} center font ',7'\n",
      screen(rows_cm, figure.width_cm), screen(rows_cm + side_cm, figure.width_cm),
      screen(columns_cm, figure.height_cm), screen(columns_cm + side_cm, figure.height_cm), n, n,
      standing ? "rotate by 90 right " : "", row_ticks, row_ticks, screen(0.25, figure.width_cm),
      screen(columns_cm + side_cm / 2, figure.height_cm), screen(rows_cm + side_cm / 2, figure.width_cm),
      screen(0.22, figure.height_cm));
  figure.settings += fmt::format(
      "set palette defined (0 '#E69F00', 0.5 '#FFFFFF', 1 '#56B4E9')\nset cbrange [0:1]\nset cbtics 0.25 font ',6' "
      "offset -0.6, 0\nset colorbox user origin screen {}, screen {} size screen {}, screen {} noborder\n",
      screen(rows_cm + side_cm + 0.3, figure.width_cm), screen(columns_cm, figure.height_cm),
      screen(0.22, figure.width_cm), screen(side_cm, figure.height_cm));
  std::string undefined = "\n\n# not defined, and the diagonal: column, row, words\n";
  figure.data = "# column, row, the chance that the row is better than the column\n";
  bool some = false;
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column < n; ++column) {
      const bool known = row < matrix.effects.size() && column < matrix.effects[row].size();
      const double effect = known ? matrix.effects[row][column] : not_defined;
      if (row != column && effect >= 0 && effect <= 1) {
        figure.data += fmt::format("{} {} {}\n", column + 1, row + 1, data_number(effect));
        some = true;
      } else {
        undefined += fmt::format("{} {} {}\n", column + 1, row + 1, row == column ? "\"\"" : "n.d.");
      }
    }
  }
  if (!some) figure.data += "NaN NaN NaN\n";
  figure.data += undefined;
  if (n == 0) {
    figure.settings = "unset border\nunset tics\nset label 'nothing to show' at graph 0.5, graph 0.5 center\n";
    figure.plot = "plot [0:1] [0:1] NaN notitle";
    figure.caption = "No groups to compare.";
    return figure;
  }
  const std::string file = fmt::format("'{}.dat'", matrix.name);
  constexpr std::string_view cell = "($1-0.48):($1+0.48):($2-0.48):($2+0.48)";
  figure.plot = plot_command(
      {fmt::format("{} index 0 using 1:2:{}:3 with boxxyerror fs solid noborder lc palette", file, cell),
       fmt::format("{} index 1 using 1:2:{} with boxxyerror fs solid noborder lc rgb '#DDDDDD'", file, cell),
       fmt::format("{} index 0 using 1:2:(sprintf('%.2f', $3)) with labels font ',{}'", file, n > 8 ? 6 : 7),
       fmt::format("{} index 1 using 1:2:3 with labels font ',6' textcolor rgb '#666666'", file)});
  figure.caption =
      fmt::format("{}: {}; ties count half. Blue: the row tends to be better. Orange: worse. White: neither.",
                  capitalised(matrix.quantity.empty() ? "values" : matrix.quantity), matrix.meaning);
  if (undefined.find("n.d.") != std::string::npos) figure.caption += " n.d.: not defined.";
  if (n < matrix.labels.size()) {
    figure.caption += fmt::format(" Only the first {} of {} groups are shown.", n, matrix.labels.size());
  }
  return figure;
}

}  // namespace ikbench::figures
