// A user's CSV as observations before anything is averaged or refused, from either layout.
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

// What a column says of each row, as numbers; `no_label` where the cell is missing.
struct Labels {
  Names names;
  std::vector<std::size_t> of_row;
};

Labels labels_of(const CsvFile& file, std::size_t column);
// Nothing where there are more different ones.
std::optional<Labels> labels_of(const CsvFile& file, std::size_t column, std::size_t most);
// No label may be missing.
Labels expect_labels(const CsvFile& file, std::size_t column);

struct Observation {
  std::size_t group = 0;
  std::size_t row = 0;    // the first, below the header
  std::size_t block = 0;  // 0 for all where there are none; so the run
  std::size_t run = 0;
  std::size_t count = 1;             // of how many values it is the mean
  std::size_t whole = 1;             // of how many it should be
  std::optional<double> value = {};  // nothing where missing
};

struct Contents {
  Names groups;
  std::vector<Observation> observations;
  std::vector<std::string> notes;
};

Contents read_long(const CsvFile& file, const CsvRequest& request);
Contents read_wide(const CsvFile& file, const CsvRequest& request);
// Of values, which have to be positive.
void take_logarithms(const CsvFile& file, Contents& contents);

// Whether a column's name says that it numbers repetitions. Folds are not among them: folds of two data sets have
// nothing but their number in common.
bool names_replicates(std::string_view title);

}  // namespace ikbench::inference
