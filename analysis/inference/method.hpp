// The table of methods that decide which of two groups is better: one row per method (methods/), with what it compares,
// how, and its source. The plan and the design choose the row, never the data.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/multiple_comparisons.hpp"

namespace ikbench::inference {

// The compared groups. `values` and `ranked` are empty if only summaries are known.
struct Groups {
  std::span<const statistics::GroupSummary> summaries;
  std::span<const std::vector<double>> values;  // NaN ranks last; with blocks, in their order
  std::span<const std::vector<double>> ranked;  // values turned so that smaller is better
};

enum class Compares { means, ranks, shares };

struct Method {
  std::string_view name;                // name in a plan; a plan cannot name the two methods of shares
  std::string_view title;               // names the test of all groups and that of its pairs
  std::string_view of_pair = title;     // "Tamhane's test"
  std::string_view of_two = of_pair;    // name if there are only two groups: "Welch's test"
  std::string_view interval = of_pair;  // method of a difference's interval
  Compares compares = Compares::means;
  bool within_blocks = false;       // compares differences within blocks
  bool corrects_all_pairs = false;  // p is corrected for the pairs of all groups, even with a control
  // Draws resamples. With few or equal values an exact test of order replaces it.
  bool resamples = false;
  // Returns one result per Evidence::contrasts, in that order: p, p_alone, ahead, estimate, why.
  std::vector<Finding> (*pairs)(const Evidence& evidence, const Groups& groups) = nullptr;
  // The test of all groups; null if the method has none.
  std::optional<TestResult> (*all)(const Evidence& evidence, const Groups& groups) = nullptr;
};

#define IKBENCH_DECIDING_TEST(name, needs) extern const Method name##_method;
#include "results/deciding_tests.inc"
#undef IKBENCH_DECIDING_TEST
extern const Method bootstrap_within_blocks_method, paired_t_method, fisher_method, mcnemar_method;

// All rows: first those that a plan can name, in the order of results/deciding_tests.inc, then the bootstrap within
// blocks, then those of shares.
std::span<const Method* const> methods();

// Chooses the row that decides, by the plan's test and the kind of groups: outcomes, blocks, too many values for a
// bootstrap within a second, or summaries only. Throws std::invalid_argument if the plan's test needs what the groups
// lack.
const Method& method_for(const Evidence& evidence);
// Returns whether a plan's test compares means, ranks or shares. by_design compares means.
Compares compares(std::string_view test);

// Adjusts p-values for several tests, in the given order, as R's p.adjust does, by Holm (Scandinavian J. Statistics 6
// (1979) 65). A p that is NaN (a test that could not be made) stays NaN and does not count. The others must be 0 to 1;
// anything else throws std::invalid_argument.
std::vector<double> adjusted(std::span<const double> p);

// Corrects p-values. A pair of the family that is not among these, or has no p, counts as one that does not
// differ.
void correct(const Evidence& evidence, std::vector<double>& p);
// Fills p of each result with the corrected p_alone.
void correct(const Evidence& evidence, std::vector<Finding>& pairs);

// Shared by several rows.
std::vector<Finding> of_means(const Evidence& evidence, const std::vector<statistics::MeanDifference>& differences);
// Number of bootstrap resamples that so many values allow; 0 if there are too many values.
int resamples_of(const Evidence& evidence);

}  // namespace ikbench::inference
