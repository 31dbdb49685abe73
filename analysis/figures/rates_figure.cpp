#include "analysis/figures/rates_figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/row_chart.hpp"
#include "analysis/inference/text.hpp"
#include "numerics/number.hpp"

namespace ikbench::figures {

using namespace inference;
using namespace numerics;

Figure rates_figure(const std::vector<std::string>& rows, const std::vector<RateSeries>& series,
                    const RatesWords& words) {
  Figure figure{.name = words.name, .caption = words.caption};
  const std::size_t n = std::min(rows.size(), most_rows);
  const double step = 0.8 / static_cast<double>(std::max<std::size_t>(series.size(), 1));
  add_rows(figure, std::vector(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(n)),
           std::max(0.42, 0.2 * static_cast<double>(series.size())));
  figure.settings += fmt::format("set xrange [0:100]\nset xtics 20\nset xlabel {}\n",
                                 gnuplot_string(fmt::format("{} [%]", words.quantity)));
  figure.data = "# a block a series: row, share, low, high [%]\n";
  std::vector<std::string> clauses, labels;
  for (std::size_t k = 0; k < series.size(); ++k) {
    const RateSeries& one = series[k];
    figure.data += fmt::format("{}# {}\n", k == 0 ? "" : "\n\n", one_line(one.name));
    for (std::size_t row = 0; row < n; ++row) {
      const statistics::Estimate& share = one.shares[row];
      const double place = static_cast<double>(row + 1) + step * (static_cast<double>(k) + 0.5) - 0.4;
      figure.data += fmt::format("{} {} {} {}\n", text_of(place), data_number(100 * share.value),
                                 data_number(100 * share.low), data_number(100 * share.high));
    }
    const std::string block = fmt::format("'{}.dat' index {}", words.name, k);
    const std::string label = shortened(one.name, longest_label);
    labels.push_back(label);
    clauses.push_back(
        fmt::format("{} using 3:1:($4-$3):(0) with vectors nohead ls {} pt 7 notitle", block, one.colour));
    clauses.push_back(fmt::format("{} using 2:1 with points ls {} pt {} ps {} title {}", block, one.colour,
                                  one.is_ring ? 6 : 7, one.is_ring ? "0.8" : "0.55", gnuplot_string(label)));
  }
  add_legend(figure, labels);
  figure.plot = n > 0 && !clauses.empty() ? plot_command(clauses) : "plot NaN notitle";
  if (n < rows.size()) figure.caption += fmt::format(" Only the first {} of {} rows are shown.", n, rows.size());
  return figure;
}

}  // namespace ikbench::figures
