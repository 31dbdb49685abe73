// What `ikbench compare` holds against what: labels of one store, or of two, once or look by look.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/inference/variant_looks.hpp"
#include "cli/reporting.hpp"
#include "experiments/study_reader.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::cli {

struct CompareArguments {
  std::string a, b, store, study, output;
  std::vector<std::string> labels, metrics;
  results::AnalysisPlan plan = {};    // where the options say it
  std::optional<double> margin = {};  // given; else the study of A says it
  std::optional<double> margin_cm = {};
  std::optional<double> significance = {};
  bool strict = false;
  bool sequential = false;
  inference::Looks looks = {};
  std::string run;  // the study that is solved look by look
  experiments::Overrides overrides;
  RunArguments solving;
};

// What is held against what, by A's plan but for what the options say.
struct Asked {
  std::string headline;
  results::AnalysisPlan plan;
  std::vector<inference::VariantStudy> studies = {};  // one for each label
  std::vector<std::string> notes = {};
};

struct Compared {
  std::string headline;
  results::AnalysisPlan plan;
  std::vector<inference::VariantComparison> comparisons = {};
  std::vector<std::string> notes = {};
  inference::LookState state = inference::LookState::settled;
};

// std::invalid_argument where a store, a study or a label is not there.
Asked labels_of_store(const CompareArguments& arguments, const std::filesystem::path& file, const std::string& study);
Asked labels_of_stores(const CompareArguments& arguments);

Compared judged(const Asked& asked, const CompareArguments& arguments);

}  // namespace ikbench::cli
