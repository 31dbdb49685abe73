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
#include "analysis/inference/ranking.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;
using namespace fmt::literals;

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

// The solvers that have a mean of the metric.
std::vector<RankedSolver> standings(const StudyResults& study, Metric metric) {
  std::vector<RankedSolver> result;
  for (const Sample& sample : samples(study, quantity_of(study, metric, Estimand::mean).value)) {
    const double average = average_in(statistics::describe(sample.values), metric);
    if (std::isfinite(average)) result.push_back({sample.solver, average});
  }
  return ranked(std::move(result));
}

}  // namespace

std::string ranking_sentence(const StudyResults& study, Metric metric) {
  const std::string_view name = info_of(metric).name;
  const StudyResults compared = compared_in(study, metric);
  const auto ours = standings(compared, metric);
  if (ours.empty()) return "";
  const std::string failures =
      is_penalised(study, metric) && !is_of_run(metric) ? ", " + penalty_words(study, metric) : "";
  std::string text =
      fmt::format("{}{}, smallest first): {}",
                  metric == Metric::position_error_cm ? fmt::format("Accuracy (mean {}", name)
                                                      : fmt::format("{} ({}", capitalised(name), average_name(metric)),
                  failures, order_words(ours));
  if (ours.size() < compared.solvers.size()) {
    text += fmt::format("; {} without a {}", compared.solvers.size() - ours.size(), average_name(metric));
  }
  if (const auto without = solvers_left_out(study, metric); !without.empty()) {
    text += fmt::format("; not compared: {}", fmt::join(without, ", "));
  }
  return text + ".";
}

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

std::vector<std::string> summary(const Reported& reported, const Paper& paper) {
  const StudyResults& study = reported.study;
  if (study.solves.empty()) return {std::string(words::no_solves)};
  std::vector<std::string> sentences{departures_sentence(study)};
  for (const Metric metric : reported_metrics()) {
    const bool is_ranked = metric != Metric::seconds || times_are_comparable(study);
    sentences.push_back(is_ranked ? ranking_sentence(study, metric) : times_sentence(study));
    if (metric == Metric::position_error_cm) sentences.push_back(limits_sentence(study));
  }
  if (paper.summary) std::ranges::move(paper.summary(reported), std::back_inserter(sentences));
  sentences.push_back(last_bits_sentence(study, copies_of(study, reported)));
  sentences.push_back(no_tolerance_sentence(study));
  for (std::string& note : status_notes(study)) sentences.push_back(std::move(note));
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
  std::vector<std::string> sentences{paper.citation, departs_from_paper(study) ? "" : paper.kind, run + '.',
                                     departs_from_paper(study) ? "" : paper.not_reproduced};
  std::erase(sentences, "");
  return sentences;
}

}  // namespace ikbench::report
