#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/inference/csv_cells.hpp"
#include "analysis/inference/observations_csv.hpp"
#include "analysis/inference/text.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

std::size_t expect_column(const CsvFile& file, std::initializer_list<std::string_view> titles) {
  if (const auto column = file.column_like(titles)) return *column;
  file.refuse(fmt::format("no column {}; found only: {}", fmt::join(titles, " or "), file.columns()));
}

}  // namespace

std::vector<Summaries> read_summaries(std::string_view text, std::string_view source) {
  const CsvFile file(text, source);
  const std::size_t name = expect_column(file, {"name", "group", "solver", "algorithm"});
  const std::size_t mean = expect_column(file, {"mean"}), std = expect_column(file, {"sd", "std", "stddev"});
  const std::size_t n = expect_column(file, {"n", "count"});
  const auto quantity = file.column_like({"metric", "quantity", "variable"});

  std::vector<Summaries> result;
  std::size_t groups = 0;
  for (const Index row : file.rows()) {
    const double count = file.number(row, n);
    GroupSummary summary{.mean = file.number(row, mean), .std = file.number(row, std)};
    if (!(count >= 1 && count <= std::numeric_limits<int>::max() && count == std::floor(count))) {
      file.refuse_cell(row, n, "expected the number of observations, a whole number from 1");
    }
    summary.n = static_cast<int>(count);
    if (!std::isfinite(summary.mean)) file.refuse_cell(row, mean, "expected a finite number");
    const bool is_single = summary.n == 1 && std::isnan(summary.std);  // one value has no spread
    if (!is_single && !(summary.std >= 0 && std::isfinite(summary.std))) {
      file.refuse_cell(row, std, "expected a standard deviation, a finite number from 0");
    }

    const std::string of = quantity ? file.name_in(file.cell(row, *quantity)) : "value";
    auto summaries = std::ranges::find(result, of, &Summaries::quantity);
    if (summaries == result.end()) {
      result.push_back({.name = slug(of), .quantity = of, .unit = split_unit(of).unit});
      summaries = result.end() - 1;
    }
    double all = count;
    std::string group = file.name_in(file.cell(row, name));
    for (const SummaryGroup& other : summaries->groups) {
      if (other.name == group) file.refuse_cell(row, name, "given twice; expected each group once per metric");
      all += other.summary.n;
    }
    if (all > std::numeric_limits<int>::max()) file.refuse_cell(row, n, "expected at most 2147483647 in all groups");
    if (++groups > max_groups) file.refuse(fmt::format("expected at most {} groups", max_groups));
    summaries->groups.push_back({std::move(group), summary});
  }
  return result;
}

}  // namespace ikbench::inference
