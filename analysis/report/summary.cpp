#include "analysis/report/summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/metrics.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;
using namespace figures;
using namespace fmt::literals;

namespace {

// "Smallest typical error"
std::string first_by_words(const StudyResults& study, Metric metric, Estimand estimand) {
  if (estimand == Estimand::reliability) return fmt::format("Most often {}", within_words(study, metric));
  const MetricInfo& info = info_of(metric);
  std::vector<std::string> remarks;
  if (estimand == Estimand::typical) remarks.emplace_back("geometric mean");
  if (is_penalised(study, metric)) remarks.push_back(penalty_words(study, metric));
  if (const double least = tolerance_of(study, metric); std::isfinite(least))
    remarks.push_back(fmt::format(words::counts_as, "least"_a = figures::value_words(metric, least)));
  if (metric == Metric::position_error_cm && estimand == Estimand::mean) remarks.emplace_back("large errors dominate");
  const std::string remark = remarks.empty() ? "" : fmt::format(" ({})", fmt::join(remarks, "; "));
  if (info.kind == Kind::count) return fmt::format("Fewest {}{}", info.slug, remark);
  return fmt::format("{} {} {}{}", info.kind == Kind::time ? "Shortest" : "Smallest", name_of(estimand), info.slug,
                     remark);
}

// The mean error that a cost bought, by solver. Empty if the metric is no cost, or if it counts unsolved solves
// already.
std::vector<Sample> achieved(const StudyResults& study, Metric metric) {
  if (!is_cost(metric) || std::isfinite(tolerance_cm(study))) return {};
  return samples(study, Metric::position_error_cm);
}

// " with error 87 cm"
std::string achieved_words(const std::vector<Sample>& achieved, const std::string& solver) {
  const auto own = std::ranges::find(achieved, solver, &Sample::solver);
  if (own == achieved.end()) return "";
  return " with error " + figures::value_words(Metric::position_error_cm, statistics::mean(own->values));
}

// "0.0017 cm"; with the tolerance's error "at most 0.01 cm".
std::string value_words(const JudgedStudy& study, Metric metric, Estimand estimand, double mean) {
  const double least = estimand == Estimand::reliability ? statistics::not_defined : tolerance_of(study, metric);
  if (statistics::without_rounding(mean - least, least) <= 0) return "at most " + figures::value_words(metric, least);
  return estimand == Estimand::reliability ? percent(mean) : figures::value_words(metric, mean);
}

}  // namespace

Sentence leader_sentence(const JudgedStudy& study, Metric metric, Estimand estimand) {
  const Evidence& evidence = study.evidence(metric, estimand);
  const std::vector<Sample> by_cost = achieved(study, metric);
  const auto label = [&](std::size_t group) {
    const GroupEvidence& of = evidence.groups[group];
    const std::string name = (of.name == evidence.plan.control ? "control " : "") + name_words(evidence, group);
    if (!std::isfinite(of.described.mean)) return name;
    return fmt::format("{} ({}{})", name, value_words(study, metric, estimand, of.described.mean),
                       achieved_words(by_cost, of.name));
  };
  std::vector<std::size_t> order;  // of the groups with a mean, the best first
  for (std::size_t i = 0; i < evidence.groups.size(); ++i) {
    if (std::isfinite(evidence.groups[i].described.mean)) order.push_back(i);
  }
  if (order.empty()) return {};
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return group_score(evidence, evidence.groups[i]); });
  std::vector<std::string> labels;
  for (const std::size_t group : order) labels.push_back(label(group));
  const Doubts without = is_comparable(study, metric) ? left_out(study, metric) : Doubts();
  const std::string words =
      evidence.flaws.empty() && has_judged(evidence) ? fmt::format("{}", fmt::join(short_answer(evidence, label), ". "))
      : order.size() == 1 && without.empty()         ? labels.front()
                                                     : fmt::format(words::none_tested, "values"_a = listed(labels));
  return {first_by_words(study, metric, estimand),
          words + '.' + (without.empty() ? "" : ' ' + fmt::format(words::left_out, "who"_a = left_out_words(without)))};
}

std::vector<std::string> no_answer_sentences(const StudyResults& study) {
  std::vector<std::string> sentences;
  for (const SolverCounts& of : counts(study)) {
    int count = 0;
    std::vector<std::string> how;
    for (const Status status : of.without_answer()) {
      count += of.of(status);
      how.push_back(in_words(name_of(status)));
    }
    if (count == 0) continue;
    sentences.push_back(fmt::format(words::no_answer, "solver"_a = one_line(of.solver), "count"_a = count,
                                    "solves"_a = of.solves, "how"_a = listed(how)));
  }
  return sentences;
}

namespace {

// Reports the evaluations that solvers used, if the study sets no common budget.
std::string budgets_sentence(const StudyResults& study) {
  if (study.facts.stop.evaluations > 0) return "";
  std::vector<std::pair<double, std::string>> all;  // median, solver
  for (const std::string& solver : study.solvers) {
    std::vector<double> spent;
    for (const Solve& solve : solves_of(study, solver)) spent.push_back(value_of(study, solve, Metric::evaluations));
    const double median = statistics::median(spent);
    if (std::isfinite(median)) all.emplace_back(median, one_line(solver));
  }
  if (all.empty()) return "";
  const auto [least, most] = std::ranges::minmax(all, {}, &std::pair<double, std::string>::first);
  if (!(least.first < most.first)) return "";
  return fmt::format(words::no_budget, "least"_a = least.second, "smallest"_a = rounded_number(least.first, 6),
                     "most"_a = most.second, "largest"_a = rounded_number(most.first, 6));
}

// Leaders by every quantity except the primary one.
std::vector<Sentence> exploratory_sentences(const JudgedStudy& study) {
  std::vector<Sentence> sentences;
  for (const Metric metric : reported_metrics()) {
    if (!is_comparable(study, metric)) continue;
    for (const Estimand estimand : estimands_of(study, metric)) {
      if (metric == Metric::position_error_cm && estimand == primary_estimand(study)) continue;
      add(sentences, leader_sentence(study, metric, estimand));
    }
  }
  return sentences;
}

}  // namespace

std::vector<Sentence> own_verdict(const JudgedStudy& study, bool has_claims) {
  const Evidence& judged = study.evidence(Metric::position_error_cm, primary_estimand(study));
  const bool has_several = study.solvers.size() > 1;
  std::vector<Sentence> sentences;
  if (has_several) add(sentences, too_few(judged));
  add(sentences, leader_sentence(study, Metric::position_error_cm, primary_estimand(study)));
  for (const std::string& sentence : no_answer_sentences(study)) add(sentences, {"", sentence});
  add(sentences, change_words(judged, false));
  const std::vector<Sentence> others = exploratory_sentences(study);
  if (has_several && !others.empty()) {
    add(sentences, {"Exploratory",
                    fmt::format(words::exploratory, "judged_by"_a = has_claims ? words::by_claims : words::by_quantity,
                                "count"_a = others.size(), "ies"_a = others.size() == 1 ? "y" : "ies")});
  }
  std::ranges::copy(others, std::back_inserter(sentences));
  if (const std::string failures = rare_failures_words(judged); !failures.empty()) add(sentences, {"", failures + '.'});
  if (has_several) add(sentences, {"", budgets_sentence(study)});
  return sentences;
}

namespace {

std::string departures_sentence(const StudyResults& study) {
  std::vector<std::string> departures = study.facts.departures;
  for (const std::string& solver : study.facts.missing_solvers) departures.push_back("no " + solver);
  if (departures.empty()) return "";
  if (!study.departed_from.empty()) {
    return fmt::format(words::another_task, "paper"_a = study.departed_from, "list"_a = fmt::join(departures, ", "));
  }
  return fmt::format(words::departs, "list"_a = fmt::join(departures, ", "),
                     "judged"_a = departs_from_paper(study) ? words::departs_judged : "");
}

std::string no_tolerance_sentence(const StudyResults& study) {
  if (!study.facts.published.empty() || study.solves.empty() || std::isfinite(tolerance_cm(study))) return "";
  return words_of(Doubt{.kind = DoubtKind::no_tolerance});
}

// Sentences of a paper that hold for the study: its citation, the kind of reproduction, and what is not reproduced.
std::vector<std::string> of_paper(const StudyResults& study, const Paper& paper) {
  std::vector<std::string> sentences{paper.citation};
  if (!departs_from_paper(study)) sentences.insert(sentences.end(), {paper.kind, paper.not_reproduced});
  std::erase(sentences, "");
  return sentences;
}

}  // namespace

Doubts wrong_claims(const StudyResults& study) {
  Doubts doubts;
  for (const SolverCounts& count : counts(study)) {
    if (const int wrong = count.of(Status::claimed_but_wrong); wrong > 0) {
      doubts.push_back({.kind = DoubtKind::wrong_claims,
                        .who = {count.solver},
                        .count = static_cast<double>(wrong),
                        .of = static_cast<double>(count.solves)});
    }
  }
  return doubts;
}

std::string limits_sentence(const StudyResults& study) {
  int outside = 0;
  double worst = 0;
  std::string list;
  for (const SolverCounts& count : counts(study)) {
    outside += count.outside_limits;
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count.solver, count.outside_limits);
    worst = std::max(worst, count.worst_outside_deg);
  }
  if (outside == 0) return std::string(words::inside_limits);
  return fmt::format(words::outside_limits, "outside"_a = outside, "answers"_a = study.solves.size(), "list"_a = list,
                     "worst"_a = degrees_words(worst));
}

std::string times_sentence(const StudyResults& study) {
  if (times_are_comparable(study)) return "";
  return fmt::format(words::times_not_ranked, "why"_a = times_not_judged);
}

std::vector<std::string> summary(const StudyResults& study) {
  if (study.solves.empty()) return {std::string(words::no_solves)};
  std::vector<std::string> sentences{departures_sentence(study), limits_sentence(study), times_sentence(study)};
  sentences.push_back(no_tolerance_sentence(study));
  std::ranges::move(status_notes(study), std::back_inserter(sentences));
  std::erase(sentences, "");
  return sentences;
}

std::vector<std::string> studied(const StudyResults& study, const Paper& paper) {
  const auto several = [](std::size_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  std::string run = fmt::format("{}, {}, {}", several(study.solvers.size(), "solver"),
                                several(static_cast<std::size_t>(study.runs), "run"),
                                several(static_cast<std::size_t>(study.points), "point"));
  if (!study.facts.path.empty()) run += fmt::format(" ({})", study.facts.path);
  if (!study.facts.robot.empty()) run += fmt::format(", {}", study.facts.robot);
  if (std::isfinite(study.facts.seed)) run += fmt::format(", seed {}", study.facts.seed);
  std::vector<std::string> sentences = of_paper(study, paper);
  sentences.push_back(run + '.');
  return sentences;
}

}  // namespace ikbench::report
