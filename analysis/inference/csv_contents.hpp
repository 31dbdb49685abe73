// Reads a user's CSV of either layout into observations, before any are averaged or refused, and finds the runs
// in it: rows that share a run are no replicates.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "analysis/inference/csv_cells.hpp"
#include "analysis/inference/observations_csv.hpp"

namespace ikbench::inference {

// Number of a row, name or value. 32 bits are enough, since a text has at most max_csv_bytes.
using Index = std::uint32_t;
static_assert(results::max_csv_bytes < std::numeric_limits<Index>::max());

constexpr Index no_label = std::numeric_limits<Index>::max();

// Texts numbered in the order of their first appearance.
class Names {
 public:
  Index index_of(const std::string& name) {
    const auto [found, is_new] = indices_.try_emplace(name, static_cast<Index>(all_.size()));
    if (is_new) all_.push_back(name);
    return found->second;
  }
  const std::vector<std::string>& all() const { return all_; }

 private:
  std::unordered_map<std::string, Index> indices_;
  std::vector<std::string> all_;
};

// A column's texts as numbers, one per row; `no_label` if the cell is missing.
struct Labels {
  Names names;
  std::vector<Index> of_row;
};

Labels labels_of(const CsvFile& file, std::size_t column);
// nullopt if there are more than `most` different labels.
std::optional<Labels> labels_of(const CsvFile& file, std::size_t column, std::size_t most);
// Refuses a missing label.
Labels expect_labels(const CsvFile& file, std::size_t column);

struct Observation {
  Index group = 0;
  Index row = 0;    // first row of it, counted below the header
  Index block = 0;  // 0 if there are no blocks; likewise `run`
  Index run = 0;
  Index count = 1;                   // number of averaged values
  Index whole = 1;                   // number of values that a whole one has
  std::optional<double> value = {};  // nullopt if missing
};

struct Contents {
  Names groups;
  std::vector<Observation> observations;
  std::vector<std::string> notes;
};

Contents read_long(const CsvFile& file, const CsvRequest& request);
Contents read_wide(const CsvFile& file, const CsvRequest& request);
// Replaces values by their logarithms to base 10; refuses values that are not positive.
void take_logarithms(const CsvFile& file, Contents& contents);

// Returns whether a column's name says that it numbers repetitions. "fold" does not count: folds of two data sets share
// nothing but their number.
bool names_replicates(std::string_view title);

// Returns whether the column numbers repetitions and the request gives it no other role.
bool numbers_runs(const std::string& title, const CsvRequest& request);

using GroupRun = std::pair<Index, Index>;

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
