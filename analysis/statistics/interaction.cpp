#include "analysis/statistics/interaction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/tails.hpp"
#include "analysis/statistics/welch.hpp"

namespace ikbench::statistics {
namespace {

using Row = std::vector<double>;

// The means of rows and columns taken out: what is left is interaction. `cells` is by rows of `columns`.
Row without_main_effects(const Row& cells, std::size_t columns) {
  const std::size_t rows = cells.size() / columns;
  Row of_row(rows), of_column(columns);
  double all = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    of_row[c / columns] += cells[c] / static_cast<double>(columns);
    of_column[c % columns] += cells[c] / static_cast<double>(rows);
    all += cells[c] / static_cast<double>(cells.size());
  }
  Row left;
  for (std::size_t c = 0; c < cells.size(); ++c)
    left.push_back(cells[c] - of_row[c / columns] - of_column[c % columns] + all);
  return left;
}

double product(const Row& first, const Row& second) {
  double sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i) sum += first[i] * second[i];
  return sum;
}

// Describes the covariance matrix of the cells' means, projected on interactions.
struct Spread {
  double trace = 0, trace_of_square = 0, df_within = 0;
};

Spread of_independent(std::span<const std::vector<double>> cells, std::size_t columns) {
  Row variances;
  for (const std::vector<double>& cell : cells) variances.push_back(std::pow(standard_error(cell), 2));
  const auto rows = static_cast<double>(cells.size() / columns), width = static_cast<double>(columns);
  Spread spread;
  double fourth = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    spread.trace += (1 - 1 / rows) * (1 - 1 / width) * variances[c];
    fourth += std::pow((1 - 1 / rows) * (1 - 1 / width) * variances[c], 2) / static_cast<double>(cells[c].size() - 1);
    for (std::size_t d = 0; d < cells.size(); ++d) {
      const double weight = ((c / columns == d / columns) - 1 / rows) * ((c % columns == d % columns) - 1 / width);
      spread.trace_of_square += weight * weight * variances[c] * variances[d];
    }
  }
  spread.df_within = spread.trace * spread.trace / fourth;
  return spread;
}

Spread of_blocks(std::span<const std::vector<double>> cells, const Row& means, std::size_t columns) {
  const std::size_t blocks = cells.front().size();
  std::vector<Row> left;
  for (std::size_t block = 0; block < blocks; ++block) {
    Row of_block;
    for (std::size_t c = 0; c < cells.size(); ++c) of_block.push_back(cells[c][block] - means[c]);
    left.push_back(without_main_effects(of_block, columns));
  }
  const double scale = 1 / (static_cast<double>(blocks) * static_cast<double>(blocks - 1));
  Spread spread;
  for (const Row& one : left) {
    spread.trace += scale * product(one, one);
    for (const Row& other : left) spread.trace_of_square += std::pow(scale * product(one, other), 2);
  }
  spread.df_within = spread.trace * spread.trace / spread.trace_of_square * static_cast<double>(blocks - 1);
  return spread;
}

Estimate corners_of(std::span<const std::vector<double>> cells, std::size_t columns, Cells are, double level) {
  const std::size_t last = cells.size() - 1;
  const std::array<std::pair<std::size_t, int>, 4> corners{
      {{last, 1}, {columns - 1, -1}, {last + 1 - columns, -1}, {0, 1}}};
  if (are == Cells::in_blocks) {
    std::vector<double> contrasts(cells.front().size());
    for (const auto& [cell, sign] : corners)
      for (std::size_t block = 0; block < contrasts.size(); ++block) contrasts[block] += sign * cells[cell][block];
    return mean_interval(summarise(contrasts), level);
  }
  double value = 0, variance = 0, fourth = 0;
  for (const auto& [cell, sign] : corners) {
    const double of_mean = std::pow(standard_error(cells[cell]), 2);
    value += sign * mean(cells[cell]);
    variance += of_mean;
    fourth += of_mean * of_mean / static_cast<double>(cells[cell].size() - 1);
  }
  const double reach = -t_quantile((1 - level) / 2, variance * variance / fourth) * std::sqrt(variance);
  if (!std::isfinite(reach)) return {.value = value};
  return {.value = value, .low = value - reach, .high = value + reach};
}

Reason why_no_table(std::span<const std::vector<double>> cells, std::size_t columns) {
  if (columns < 2 || cells.size() < 2 * columns) return "a factor has fewer than two levels";
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].size() < 2) return {c, "{} has fewer than two values, so no spread"};
    if (!all_finite(cells[c])) return {c, "{} has values that are not finite"};
  }
  return {};
}

}  // namespace

Interaction interaction(std::span<const std::vector<double>> cells, std::size_t columns, Cells are, double level) {
  check_level(level);
  if (columns == 0 || cells.size() % columns != 0) throw std::invalid_argument("a table needs rows of one length");
  if (are == Cells::in_blocks && !std::ranges::all_of(cells, [&](const std::vector<double>& cell) {
        return cell.size() == cells.front().size();
      })) {
    throw std::invalid_argument("cells in blocks need one value per block");
  }
  Interaction result;
  result.undefined = why_no_table(cells, columns);
  if (!result.undefined.empty()) return result;
  Row all;
  for (const std::vector<double>& cell : cells) all.insert(all.end(), cell.begin(), cell.end());
  const double unit = power_of_two_below(all);
  std::vector<std::vector<double>> scaled(cells.begin(), cells.end());
  for (std::vector<double>& cell : scaled)
    for (double& value : cell) value /= unit;
  Row means;
  for (const std::vector<double>& cell : scaled) means.push_back(mean(cell));
  const Row left = without_main_effects(means, columns);
  const Spread spread = are == Cells::independent ? of_independent(scaled, columns) : of_blocks(scaled, means, columns);
  result.corners = corners_of(scaled, columns, are, level);
  for (double* end : {&result.corners.value, &result.corners.low, &result.corners.high}) *end *= unit;
  constexpr double rounding = 1e-28;  // the square of what decimals lose
  if (!(spread.trace > rounding)) {
    result.undefined = "there is no spread to compare with";
    result.corners = {.value = result.corners.value};
    return result;
  }
  result.statistic = product(left, left) / spread.trace;
  result.df = spread.trace * spread.trace / spread.trace_of_square;
  result.df_within = spread.df_within;
  result.p = f_upper_tail(result.statistic, std::max(1.0, result.df), result.df_within);
  if (std::isnan(result.p)) result.undefined = "there is too little spread to compare with";
  return result;
}

}  // namespace ikbench::statistics
