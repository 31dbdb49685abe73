#include "cli/comparing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "analysis/inference/analysis_plan.hpp"
#include "analysis/inference/margin.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/words.hpp"
#include "cli/console.hpp"
#include "numerics/names.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace results;
using namespace inference;

namespace {

AnalysisPlan plan_for(const CompareArguments& arguments, const StudyEntry& study) {
  AnalysisPlan plan = plan_of(study);
  plan.margin = arguments.margin.value_or(plan.margin);
  plan.margin_cm = arguments.margin_cm.value_or(plan.margin_cm);
  plan.significance = arguments.significance.value_or(plan.significance);
  if (arguments.estimand) plan.estimands = {*arguments.estimand};
  return plan;
}

std::vector<std::string> labels_of(const std::vector<Variant>& variants) {
  std::vector<std::string> labels;
  for (const Variant& variant : variants) labels.push_back(variant.series.label);
  return labels;
}

bool has_label(const std::vector<Variant>& variants, const std::string& label) {
  return std::ranges::any_of(variants, [&](const Variant& variant) { return variant.series.label == label; });
}

Variant the(const std::vector<Variant>& variants, const std::string& label, const std::string& where) {
  const auto found = std::ranges::find(variants, label, [](const Variant& variant) { return variant.series.label; });
  if (found != variants.end()) return *found;
  throw std::invalid_argument(where + unknown_name("label", label, labels_of(variants)));
}

Store opened(const std::string& file) {
  if (std::filesystem::exists(file)) return checked_store(file);
  throw std::invalid_argument(
      fmt::format("store '{}' does not exist; to compare two labels of one store, add --store FILE", file));
}

// B's study: the one that is asked for, or the one with the name of A's study, if the store has it.
StudyEntry partner(const Store& store, const CompareArguments& arguments, const StudyEntry& of_a) {
  if (!arguments.other_study.empty()) return store.study(arguments.other_study);
  if (!arguments.study.empty()) return store.study(arguments.study);
  for (StudyEntry& study : store.studies()) {
    if (study.name == of_a.name) return std::move(study);
  }
  return chosen_study(store, "");
}

std::vector<std::string> common_labels(const std::vector<Variant>& a, const std::vector<Variant>& b, Request& asked) {
  std::vector<std::string> common, alone;
  for (const std::string& label : labels_of(a)) (has_label(b, label) ? common : alone).push_back(label);
  for (const std::string& label : labels_of(b)) {
    if (!has_label(a, label)) alone.push_back(label);
  }
  if (common.empty()) {
    throw std::invalid_argument(fmt::format("A and B have no label in common (A: {}; B: {})",
                                            fmt::join(labels_of(a), ", "), fmt::join(labels_of(b), ", ")));
  }
  if (!alone.empty())
    asked.notes.push_back(fmt::format("Not compared, because only one store has them: {}.", fmt::join(alone, ", ")));
  return common;
}

// The rules of the decision, in words.
std::string rules(const AnalysisPlan& plan) {
  return fmt::format("margin {}; if A and B are alike, some difference is found with a probability of at most {}",
                     margin_words(plan.margin, plan.margin_cm), percent(plan.significance));
}

}  // namespace

Request labels_of_store(const CompareArguments& arguments, const std::filesystem::path& file, const std::string& name) {
  const Store store = checked_store(file);
  const StudyEntry study = chosen_study(store, name);
  const std::vector<Variant> all = variants(store, study);
  const Variant a = the(all, arguments.a, "A: "), b = the(all, arguments.b, "B: ");
  Request asked{.headline = fmt::format("B: {}, against A: {}, in study {}", arguments.b, arguments.a, study.name),
                .plan = plan_for(arguments, study)};
  asked.studies.push_back(study_of_both(a, b, asked.plan));
  if (all.size() > 2) {
    const std::string& control = plan_of(study).control;
    asked.notes.push_back(fmt::format(
        report::words::families,
        fmt::arg("solvers", control.empty() ? fmt::format("all {} solvers", all.size()) : "the control " + control)));
  }
  return asked;
}

Request labels_of_stores(const CompareArguments& arguments) {
  const Store of_a = opened(arguments.a), of_b = opened(arguments.b);
  const StudyEntry first = chosen_study(of_a, arguments.study), second = partner(of_b, arguments, first);
  const std::vector<Variant> a = variants(of_a, first), b = variants(of_b, second);
  Request asked{
      .headline = fmt::format("B: {} in {}, against A: {} in {}", second.name, arguments.b, first.name, arguments.a),
      .plan = plan_for(arguments, first)};
  for (const std::string& label : arguments.labels.empty() ? common_labels(a, b, asked) : arguments.labels) {
    const Variant one = the(a, label, "A: "), other = the(b, label, "B: ");
    asked.studies.push_back(study_of_both(one, other, asked.plan));
  }
  return asked;
}

ComparedLabels judged(const Request& asked, const CompareArguments& arguments) {
  const WorkingLine comparing("Comparing ...");
  ComparedLabels compared{compare_variants(asked.studies, arguments.metrics),
                          fmt::format("{}; {}.", asked.headline, rules(asked.plan)), asked.plan, asked.notes};
  for (const VariantStudy& study : asked.studies) compared.differences.push_back(study.differences);
  return compared;
}

}  // namespace ikbench::cli
