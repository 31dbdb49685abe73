#include "analysis/claims/search_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/claims/printed.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"

namespace ikbench::claims {

using namespace statistics;

namespace {

double mean_of_found(std::span<const Search> all, double Search::*value) {
  double sum = 0, count = 0;
  for (const Search& search : all) {
    sum += search.is_found ? search.*value : 0;
    count += search.is_found ? 1 : 0;
  }
  return count > 0 ? sum / count : not_defined;
}

// The middle one of the sorted iterations, the upper of two.
double median_of_found(std::span<const Search> all) {
  std::vector<double> found;
  for (const Search& search : all) {
    if (search.is_found) found.push_back(search.iterations);
  }
  if (found.empty()) return not_defined;
  const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
  std::ranges::nth_element(found, middle);
  return *middle;
}

double most_searches(std::span<const Search> all) {
  double most = 0;
  for (const Search& search : all) most = search.is_found ? std::max(most, search.searches) : most;
  return most;
}

constexpr std::array<SearchStatistic, 6> search_statistics{
    {{"iterations_mean", "mean iterations",
      [](std::span<const Search> all) { return mean_of_found(all, &Search::iterations); }},
     {"iterations_median", "median iterations", median_of_found, true},
     {"infeasible", "no solution",
      [](std::span<const Search> all) {
        return static_cast<double>(std::ranges::count(all, false, &Search::is_found));
      },
      true},
     {"searches_mean", "mean searches",
      [](std::span<const Search> all) { return mean_of_found(all, &Search::searches); }},
     {"searches_most", "most searches", most_searches, true, false},
     {"violations", "outside the limits",
      [](std::span<const Search> all) {
        return static_cast<double>(std::ranges::count(all, true, &Search::is_outside));
      },
      true}}};

}  // namespace

Search search_of(std::int64_t iterations, int restarts, results::StopReason reason, bool is_outside) {
  const bool is_found = reason == results::StopReason::finished || reason == results::StopReason::tolerance;
  return {static_cast<double>(iterations), restarts + 1.0, is_found, is_found && is_outside};
}

std::vector<const SearchStatistic*> statistics_in(const results::CsvTable& printed) {
  std::vector<const SearchStatistic*> found;
  for (const SearchStatistic& statistic : search_statistics) {
    if (std::ranges::find(printed.header, statistic.column) != printed.header.end()) found.push_back(&statistic);
  }
  return found;
}

bool agrees(double ours, const std::string& printed) {
  constexpr double room = 1 + 1e-9;  // 2.5 printed as 2 is half a unit off, and doubles are not exact
  return std::abs(ours - numerics::number_from(printed).value()) <= half_unit(printed) * room;
}

}  // namespace ikbench::claims
