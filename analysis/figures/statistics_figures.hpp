// Figures of a statistical analysis: what was observed, which groups differ, by how much, and in which order they come.
// Each names in its caption what its picture does not show.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/observations.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::figures {

// Half violin, box plot and the values themselves, a row a group: Allen et al., Raincloud plots, Wellcome Open Research
// 4:63 (2019). The values span an axis of logarithms where they differ by more than 30 times; so does the density then.
Figure raincloud_figure(const inference::Observations& observations, statistics::QuantileType quartiles,
                        const std::string& name);

struct DifferenceRow {
  std::string label;                            // "BA - IK-BA"
  double difference = statistics::not_defined;  // all of the unit of the quantity
  double low = statistics::not_defined;
  double high = statistics::not_defined;
};

struct DifferencesWords {
  std::string name;
  std::string quantity;  // "difference of means: position error [cm]"
  double level = 0.95;   // of all intervals together
  std::string method;    // "Games-Howell"
};

// A forest plot: intervals of differences, those that exclude zero coloured.
Figure differences_figure(const std::vector<DifferenceRow>& rows, const DifferencesWords& words);

struct CriticalDifference {
  std::string name;
  std::vector<std::string> labels;
  std::vector<double> average_ranks;  // as long as the labels; 1 is best
  double critical_difference = statistics::not_defined;
  double significance = 0.05;
  std::string method;  // "Nemenyi, 14 problems"
};

// Demsar, Journal of Machine Learning Research 7 (2006) 1, Figure 1: bars join what does not differ.
Figure critical_difference_figure(const CriticalDifference& ranks);

struct EffectMatrix {
  std::string name;
  std::string quantity;
  std::vector<std::string> labels;
  std::string meaning;  // of an effect: "the chance that a value of the row is better than one of the column"
  // effects[row][column], 0 to 1: of the row against the column.
  std::vector<std::vector<double>> effects;
};

constexpr std::size_t most_effect_labels = 20;

Figure effect_matrix_figure(const EffectMatrix& matrix);

}  // namespace ikbench::figures
