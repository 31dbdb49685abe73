// Which rows of a user's CSV are replicates: its runs, and rows that share one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "analysis/inference/csv_contents.hpp"

namespace ikbench::inference {

// Whether the column numbers repetitions, and was not given as anything else.
bool numbers_runs(const std::string& title, const CsvRequest& request);

using GroupRun = std::pair<std::size_t, std::size_t>;

// The group and the run of each observation, sorted.
template <typename RunOf>
std::vector<GroupRun> group_runs(const Contents& contents, const RunOf& run_of) {
  std::vector<GroupRun> keys;
  keys.reserve(contents.observations.size());
  for (const Observation& o : contents.observations) keys.emplace_back(o.group, run_of(o));
  std::ranges::sort(keys);
  return keys;
}

// How often a sorted key is there.
std::size_t rows_of(const std::vector<GroupRun>& keys, const GroupRun& key);

// Refuses rows that are no replicates, or says why they are none.
std::string rows_share_a_run(const CsvFile& file, const Contents& contents, const CsvRequest& request);

}  // namespace ikbench::inference
