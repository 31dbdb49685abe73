#include "analysis/csv/google_benchmark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string_view>

namespace ikbench::csv {
namespace {

enum : std::size_t { name, iterations, real_time, cpu_time, time_unit };

bool is_of_google_benchmark(const Sheet& sheet) {
  constexpr std::array<std::string_view, 5> header{"name", "iterations", "real_time", "cpu_time", "time_unit"};
  return sheet.titles().size() >= header.size() && std::equal(header.begin(), header.end(), sheet.titles().begin());
}

}  // namespace

std::vector<std::string> leave_out_aggregates(Sheet& sheet, const Request& request) {
  std::vector<std::string> names;
  const auto is_of_name = [](const std::string& condition) { return condition.starts_with("name="); };
  if (!is_of_google_benchmark(sheet) || std::ranges::any_of(request.where, is_of_name)) return names;
  std::map<std::string_view, int> counts;
  for (const std::uint32_t row : sheet.rows()) ++counts[sheet.cell(row, name)];
  std::vector<std::uint32_t> aggregates;
  for (const std::uint32_t row : sheet.rows()) {
    const std::string_view title = sheet.cell(row, name);
    const auto repeated = counts.find(title.substr(0, title.rfind('_')));  // "BM_x" of "BM_x_mean"
    const bool is_of_others = counts[title] == 1 && repeated != counts.end() && repeated->second > 1;
    const bool is_of_fit = sheet.cell(row, iterations).empty() && !sheet.cell(row, real_time).empty();  // "BM_x_BigO"
    if (!is_of_others && !is_of_fit) continue;
    aggregates.push_back(row);
    names.emplace_back(title);
  }
  if (!aggregates.empty()) sheet.leave_out(aggregates);
  return names;
}

void expect_one_time_unit(const Sheet& sheet, const Columns& values) {
  const auto is_time = [](std::size_t value) { return value == real_time || value == cpu_time; };
  if (!is_of_google_benchmark(sheet) || std::ranges::none_of(values, is_time)) return;
  const std::string_view first = sheet.cell(sheet.rows().front(), time_unit);
  for (const std::uint32_t row : sheet.rows())
    if (!sheet.cell(row, real_time).empty() && sheet.cell(row, time_unit) != first)
      sheet.refuse(row, time_unit,
                   fmt::format("is not {} as above; write all times in one unit with --benchmark_time_unit=ns",
                               in_quotes(first)));
}

}  // namespace ikbench::csv
