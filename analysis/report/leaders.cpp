#include "analysis/report/leaders.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/answer.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;
using namespace fmt::literals;

namespace {

// "Smallest typical error"
std::string first_by_words(const StudyResults& study, Metric metric, Estimand estimand) {
  if (estimand == Estimand::reliability) return fmt::format("Most often {}", within_words(study, metric));
  const MetricInfo& info = info_of(metric);
  const bool is_penalised = is_cost(metric) && !is_of_run(metric) && std::isfinite(tolerance_cm(study));
  const std::string penalised = is_penalised ? fmt::format(" ({})", penalty_words(study, metric)) : "";
  if (info.kind == Kind::count) return fmt::format("Fewest {}{}", is_of_run(metric) ? info.name : info.slug, penalised);
  if (info.kind == Kind::time) return fmt::format("Shortest {} {}{}", name_of(estimand), info.slug, penalised);
  if (is_of_run(metric)) return fmt::format("Smallest {}", info.name);
  const std::string words = fmt::format("Smallest {} {}{}", name_of(estimand), info.slug, penalised);
  if (metric != Metric::position_error_cm || estimand != Estimand::mean) return words;
  return words + " (large errors dominate)";
}

// Adds to a cost what it achieved: the answers' error or, with a tolerance, the share of solves with status ok.
class Achieved {
 public:
  Achieved(const StudyResults& study, Metric metric) {
    if (!is_cost(metric)) return;
    const bool has_tolerance = std::isfinite(tolerance_cm(study));
    if (has_tolerance && !is_of_run(metric)) return;  // unsolved ones are penalised already
    for (const Metric other : {Metric::position_error_cm, Metric::orientation_error_deg}) {
      if (other == Metric::orientation_error_deg && (has_tolerance || !study.facts.pose)) continue;
      for (const Sample& sample : samples(study, has_tolerance ? Metric::solved : other)) {
        const double mean = statistics::mean(sample.values);
        std::string& text = words_[sample.solver];
        text += (text.empty() ? "" : " and ") +
                (has_tolerance ? percent(mean) + " solved" : "error " + figures::value_words(other, mean));
      }
    }
  }
  // " with error 87 cm", " with 30 % solved"; empty if the metric is no cost.
  std::string of(const std::string& solver) const {
    const auto found = words_.find(solver);
    return found == words_.end() ? "" : " with " + found->second;
  }

 private:
  std::map<std::string, std::string> words_ = {};
};

// "0.0017 cm"; with the tolerance's error "at most 0.01 cm".
std::string value_words(const JudgedStudy& study, Metric metric, Estimand estimand, double mean) {
  const double least = estimand == Estimand::reliability ? statistics::not_defined : tolerance_of(study, metric);
  if (statistics::without_rounding(mean - least, least) <= 0) return "at most " + figures::value_words(metric, least);
  return estimand == Estimand::reliability ? percent(mean) : figures::value_words(metric, mean);
}

}  // namespace

Sentence leader_sentence(const JudgedStudy& study, Metric metric, Estimand estimand) {
  const Evidence& evidence = study.evidence(metric, estimand);
  const Achieved achieved(study, metric);
  const auto label = [&](std::size_t group) {
    const GroupEvidence& of = evidence.groups[group];
    const std::string name = (of.name == evidence.plan.control ? "control " : "") + name_words(evidence, group);
    if (!std::isfinite(of.described.mean)) return name;
    return fmt::format("{} ({}{})", name, value_words(study, metric, estimand, of.described.mean),
                       achieved.of(of.name));
  };
  std::vector<std::size_t> order;  // of the groups with a mean, the best first
  for (std::size_t i = 0; i < evidence.groups.size(); ++i) {
    if (std::isfinite(evidence.groups[i].described.mean)) order.push_back(i);
  }
  if (order.empty()) return {};
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return group_score(evidence, evidence.groups[i]); });
  std::vector<std::string> labels;
  for (const std::size_t group : order) labels.push_back(label(group));
  const std::string words = evidence.flaws.empty() && has_judged(evidence)
                                ? fmt::format("{}", fmt::join(short_answer(evidence, label), ". "))
                            : order.size() == 1 ? labels.front()
                                                : fmt::format(words::none_tested, "values"_a = listed(labels));
  return {first_by_words(study, metric, estimand), words + '.'};
}

std::vector<Sentence> leader_sentences(const JudgedStudy& study, Metric metric) {
  std::vector<Sentence> sentences;
  for (const Estimand estimand : estimands_of(study, metric)) add(sentences, leader_sentence(study, metric, estimand));
  return sentences;
}

namespace {

// Warns of imports that lack solves.
Sentence partial_imports_sentence(const JudgedStudy& study) {
  std::string list;
  for (const SolverCounts& count : counts(study)) {
    if (count.solves == count.expected || !is_imported(study, count.solver)) continue;
    list += (list.empty() ? "" : ", ") + fmt::format(words::partial_import, "solver"_a = count.solver,
                                                     "has"_a = count.solves, "expected"_a = count.expected);
  }
  if (list.empty()) return {};
  return {"Not comparable", fmt::format(words::partial_imports, "list"_a = list)};
}

// Warns that too few observations exist for any pair to differ.
std::string too_few_sentence(const JudgedStudy& study) {
  const Evidence& evidence = study.evidence(Metric::position_error_cm, primary_estimand(study));
  if (!has_too_few(evidence)) return "";
  return fmt::format(words::none_can_differ, "of"_a = replicates_words(evidence), "solvers"_a = evidence.groups.size(),
                     "fewest"_a = evidence.fewest);
}

// Reports the evaluations that solvers used, if the study sets no common budget.
std::string budgets_sentence(const StudyResults& study) {
  if (study.facts.stop.evaluations > 0) return "";
  std::string least, most;
  double smallest = statistics::not_defined, largest = statistics::not_defined;
  for (const std::string& solver : study.solvers) {
    std::vector<double> spent;
    for (const Solve& solve : solves_of(study, solver)) spent.push_back(value_of(study, solve, Metric::evaluations));
    const double own = statistics::median(spent);
    if (!std::isfinite(own)) continue;
    if (!(own >= smallest)) {
      smallest = own;
      least = solver;
    }
    if (!(own <= largest)) {
      largest = own;
      most = solver;
    }
  }
  if (!(smallest < largest)) return "";
  return fmt::format(words::no_budget, "least"_a = one_line(least), "smallest"_a = rounded_number(smallest, 6),
                     "most"_a = one_line(most), "largest"_a = rounded_number(largest, 6));
}

// Leaders by every quantity except the primary one.
std::vector<Sentence> exploratory_sentences(const JudgedStudy& study) {
  std::vector<Sentence> sentences;
  for (const Metric metric : shown_metrics(study).judged) {
    const bool is_reported = info_of(metric).shown == ShownIn::everywhere;
    if (!is_comparable(study, metric) || !(is_reported || is_of_run(metric))) continue;
    for (const Estimand estimand : estimands_of(study, metric)) {
      if (metric == Metric::position_error_cm && estimand == primary_estimand(study)) continue;
      add(sentences, leader_sentence(study, metric, estimand));
    }
  }
  return sentences;
}

}  // namespace

std::vector<Sentence> own_verdict(const JudgedStudy& study) {
  const Evidence& judged = study.evidence(Metric::position_error_cm, primary_estimand(study));
  const bool has_several = study.solvers.size() > 1;
  std::vector<Sentence> sentences;
  add(sentences, partial_imports_sentence(study));
  if (has_several) add(sentences, {"", too_few_sentence(study)});
  add(sentences, leader_sentence(study, Metric::position_error_cm, primary_estimand(study)));
  add(sentences, change_words(judged, false));
  const std::vector<Sentence> others = exploratory_sentences(study);
  if (has_several && !others.empty()) {
    add(sentences, {"Exploratory", fmt::format(words::exploratory, "count"_a = others.size())});
  }
  std::ranges::copy(others, std::back_inserter(sentences));
  if (const std::string failures = rare_failures_words(judged); !failures.empty()) add(sentences, {"", failures + '.'});
  if (has_several) add(sentences, {"", budgets_sentence(study)});
  return sentences;
}

}  // namespace ikbench::report
