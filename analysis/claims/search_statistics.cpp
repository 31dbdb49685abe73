#include "analysis/claims/search_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/claims/printed.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/draw.hpp"
#include "analysis/statistics/proportion.hpp"
#include "numerics/number.hpp"

namespace ikbench::claims {

using namespace report;
using namespace results;
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

double unsolved(std::span<const Search> all) {
  return static_cast<double>(std::ranges::count(all, false, &Search::is_solved));
}

constexpr std::array<SearchStatistic, 7> search_statistics{
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
      true},
     {.column = "error_rate_percent",
      .heading = "not solved [%]",
      .of = [](std::span<const Search> all) { return 100 * unsolved(all) / static_cast<double>(all.size()); },
      .is_percentage = true}}};

}  // namespace

Search search_of(std::int64_t iterations, int restarts, StopReason reason, Status status, bool is_outside) {
  const bool is_found = reason == StopReason::finished || reason == StopReason::tolerance;
  return {static_cast<double>(iterations), restarts + 1.0, is_found, is_found && is_outside, status == Status::ok};
}

std::vector<const SearchStatistic*> statistics_in(const results::CsvTable& printed) {
  std::vector<const SearchStatistic*> found;
  for (const SearchStatistic& statistic : search_statistics) {
    if (std::ranges::find(printed.header, statistic.column) != printed.header.end()) found.push_back(&statistic);
  }
  return found;
}

Range range_of_chance(std::span<const Search> all, const SearchStatistic& statistic) {
  constexpr int resamples = 400;
  constexpr double level = 0.95;
  const double ours = statistic.of(all);
  if (statistic.is_percentage) {
    const auto [share, low, high] = wilson_of_mean(ours / 100, static_cast<int>(all.size()), level);
    return {100 * low, 100 * high};
  }
  Draws draws(1);
  std::vector<Search> drawn(all.size());
  const auto of_resample = [&] {
    for (Search& search : drawn) search = all[draws.below(all.size())];
    return statistic.of(drawn);
  };
  std::vector<double> differences;
  for (int i = 0; i < resamples; ++i) {
    const double one = of_resample();
    differences.push_back(one - of_resample());
  }
  std::ranges::sort(differences);
  const auto outside = static_cast<std::size_t>(resamples * (1 - level) / 2);
  return {ours + differences[outside], ours + differences[differences.size() - 1 - outside]};
}

bool can_be(Range range, const std::string& printed) {
  const double number = numerics::number_from(printed).value(), half = half_unit(printed);
  return range.low - half <= number && number <= range.high + half;
}

bool agrees(double ours, const std::string& printed) {
  constexpr double room = 1 + 1e-9;  // 2.5 printed as 2 is half a unit off, and doubles are not exact
  return std::abs(ours - numerics::number_from(printed).value()) <= half_unit(printed) * room;
}

}  // namespace ikbench::claims
