// The statistics of searches that tables print: iterations and searches of the solves that found a solution.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/csv.hpp"
#include "results/record.hpp"

namespace ikbench::claims {

// What a statistic of searches needs of a solve.
struct Search {
  double iterations, searches;
  bool is_found, is_outside;  // found: the solver did not give up; outside the joint limits
};

Search search_of(std::int64_t iterations, int restarts, results::StopReason reason, bool is_outside);

struct SearchStatistic {
  std::string_view column, heading;  // in results/published; of our table
  double (*of)(std::span<const Search>);
  bool is_whole = false;  // printed as an integer
  bool has_range = true;  // false: resamples say nothing of it
};

// Those that the printed table has.
std::vector<const SearchStatistic*> statistics_in(const results::CsvTable& printed);

// Whether our number rounds to the printed digits.
bool agrees(double ours, const std::string& printed);

}  // namespace ikbench::claims
