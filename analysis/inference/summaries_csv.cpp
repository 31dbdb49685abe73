#include "analysis/inference/summaries_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/inference/csv_cells.hpp"
#include "analysis/inference/observations_csv.hpp"
#include "analysis/inference/text.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr std::array<std::string_view, 4> name_titles{"name", "group", "solver", "algorithm"};
constexpr std::array<std::string_view, 1> mean_titles{"mean"};
constexpr std::array<std::string_view, 3> std_titles{"sd", "std", "stddev"};
constexpr std::array<std::string_view, 2> n_titles{"n", "count"};
constexpr std::array<std::string_view, 3> quantity_titles{"metric", "quantity", "variable"};

std::size_t expect_column(const CsvFile& file, std::span<const std::string_view> titles) {
  if (const auto column = file.column_like(titles)) return *column;
  file.refuse(fmt::format("no column {}; found only: {}", fmt::join(titles, " or "), file.columns()));
}

}  // namespace

std::vector<Summaries> read_summaries(std::string_view text, std::string_view source) {
  const CsvFile file = open_csv(text, source);
  const std::size_t name = expect_column(file, name_titles);
  const std::size_t mean = expect_column(file, mean_titles);
  const std::size_t std = expect_column(file, std_titles);
  const std::size_t n = expect_column(file, n_titles);

  const auto quantity = file.column_like(quantity_titles);

  std::vector<Summaries> result;
  std::set<std::pair<std::string, std::string>> seen;  // quantity and group
  for (std::size_t row = 0; row < file.table.rows(); ++row) {
    if (file.is_blank(row)) continue;
    SummaryGroup group{.name = file.group_name(row, name), .summary = {}};
    const std::string of = quantity ? file.group_name(row, *quantity) : "value";
    if (!seen.insert({of, group.name}).second) {
      file.refuse_cell(
          row, name,
          quantity ? "given twice; expected each group once per metric" : "given twice; expected each group once");
    }
    if (seen.size() > max_groups) file.refuse(fmt::format("expected at most {} groups", max_groups));

    const double count = file.number(row, n).value_or(not_defined);
    if (!(count >= 1 && count <= std::numeric_limits<int>::max() && count == std::floor(count))) {
      file.refuse_cell(row, n, "expected the number of observations, a whole number from 1");
    }
    group.summary.n = static_cast<int>(count);
    group.summary.mean = file.number(row, mean).value_or(not_defined);
    if (!std::isfinite(group.summary.mean)) file.refuse_cell(row, mean, "expected a finite number");
    group.summary.std = file.number(row, std).value_or(not_defined);
    const bool single = group.summary.n == 1 && std::isnan(group.summary.std);  // one value has no spread
    if (!single && !(group.summary.std >= 0 && std::isfinite(group.summary.std))) {
      file.refuse_cell(row, std, "expected a standard deviation, a finite number from 0");
    }
    auto summaries = std::ranges::find(result, of, &Summaries::quantity);
    if (summaries == result.end()) {
      result.push_back({.name = slug(of), .quantity = of, .unit = split_unit(of).unit});
      summaries = result.end() - 1;
    }
    std::int64_t all = group.summary.n;
    for (const SummaryGroup& other : summaries->groups) all += other.summary.n;
    if (all > std::numeric_limits<int>::max()) file.refuse_cell(row, n, "expected at most 2147483647 in all groups");
    summaries->groups.push_back(std::move(group));
  }
  if (result.empty()) file.refuse("no rows below the header; expected at least one");
  return result;
}

}  // namespace ikbench::inference
