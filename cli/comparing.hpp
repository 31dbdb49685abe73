// Compares for `ikbench compare`: labels of one store, or of two.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/inference/variant_comparison.hpp"
#include "cli/reporting.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::cli {

struct CompareArguments {
  std::string a, b, store, study, other_study;
  std::vector<std::string> outputs;  // files
  std::vector<std::string> labels, metrics;
  results::AnalysisPlan plan = {};    // values of the given options
  std::optional<double> margin = {};  // if given; else the study of A has it
  std::optional<double> margin_cm = {};
  std::optional<double> significance = {};
  std::optional<results::Estimand> estimand = {};
  bool strict = false;
  OutputArguments output_as;
};

// The studies to compare, with A's plan as the options change it.
struct Request {
  std::string headline;
  results::AnalysisPlan plan;
  std::vector<inference::VariantStudy> studies = {};  // one per label
  std::vector<std::string> notes = {};
};

struct ComparedLabels {
  std::vector<inference::VariantComparison> comparisons;
  std::string headline = {};
  results::AnalysisPlan plan = {};
  std::vector<std::string> notes = {};
  std::vector<std::string> differences = {};  // of the settings, a sentence for each comparison
};

// Throw std::invalid_argument if a store, a study or a label does not exist.
Request labels_of_store(const CompareArguments& arguments, const std::filesystem::path& file, const std::string& study);
Request labels_of_stores(const CompareArguments& arguments);

ComparedLabels judged(const Request& asked, const CompareArguments& arguments);

}  // namespace ikbench::cli
