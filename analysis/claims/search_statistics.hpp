// The statistics of searches that tables print: iterations and searches of the solves that found a solution, and
// shares.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/table.hpp"
#include "results/csv.hpp"
#include "results/record.hpp"

namespace ikbench::claims {

// What a statistic of searches needs of a solve.
struct Search {
  double iterations, searches;
  bool is_found, is_outside, is_solved;  // the solver did not give up; outside the joint limits; the status is ok
};

Search search_of(std::int64_t iterations, int restarts, results::StopReason reason, results::Status status,
                 bool is_outside);

struct SearchStatistic {
  std::string_view column, heading;  // in results/published; of our table
  double (*of)(std::span<const Search>);
  bool is_whole = false;  // printed as an integer
  bool has_range = true;  // false: resamples say nothing of it
  bool is_percentage = false;
};

// Those that the printed table has.
std::vector<const SearchStatistic*> statistics_in(const results::CsvTable& printed);

// The central 95 % of what the statistic would be with other targets: ours plus the difference of two resamples. For a
// percentage it is Wilson's interval, since resamples of no failure have none.
report::Range range_of_chance(std::span<const Search> all, const SearchStatistic& statistic);

// Whether a number in the range rounds to the printed digits.
bool can_be(report::Range range, const std::string& printed);

// Whether our number rounds to the printed digits.
bool agrees(double ours, const std::string& printed);

}  // namespace ikbench::claims
