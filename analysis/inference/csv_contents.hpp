// Reads a user's CSV of either layout into observations, before any are averaged or refused.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "analysis/inference/csv_cells.hpp"
#include "analysis/inference/observations_csv.hpp"

namespace ikbench::inference {

constexpr std::size_t no_label = static_cast<std::size_t>(-1);

// Texts numbered in the order of their first appearance.
class Names {
 public:
  std::size_t index_of(const std::string& name) {
    const auto [found, is_new] = indices_.try_emplace(name, all_.size());
    if (is_new) all_.push_back(name);
    return found->second;
  }
  const std::vector<std::string>& all() const { return all_; }

 private:
  std::unordered_map<std::string, std::size_t> indices_;
  std::vector<std::string> all_;
};

// A column's texts as numbers, one per row; `no_label` if the cell is missing.
struct Labels {
  Names names;
  std::vector<std::size_t> of_row;
};

Labels labels_of(const CsvFile& file, std::size_t column);
// nullopt if there are more than `most` different labels.
std::optional<Labels> labels_of(const CsvFile& file, std::size_t column, std::size_t most);
// Refuses a missing label.
Labels expect_labels(const CsvFile& file, std::size_t column);

struct Observation {
  std::size_t group = 0;
  std::size_t row = 0;    // first row of it, counted below the header
  std::size_t block = 0;  // 0 if there are no blocks; likewise `run`
  std::size_t run = 0;
  std::size_t count = 1;             // number of averaged values
  std::size_t whole = 1;             // number of values that a whole one has
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

}  // namespace ikbench::inference
