// Finds the runs in a user's CSV, and rows that share a run and so are no replicates.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "analysis/inference/csv_contents.hpp"

namespace ikbench::inference {

// Returns whether the column numbers repetitions and the request gives it no other role.
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

// Number of rows with this key; `keys` are sorted.
std::size_t rows_of(const std::vector<GroupRun>& keys, const GroupRun& key);

// Refuses rows that are no replicates. If they are taken as given, says why they are none; empty if all are replicates.
std::string rows_share_a_run(const CsvFile& file, const Contents& contents, const CsvRequest& request);

}  // namespace ikbench::inference
