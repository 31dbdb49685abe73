#include "analysis/slim2023/paper_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/deciding.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/ranking.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/leaders.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/slim2023/agreement.hpp"
#include "analysis/slim2023/circle.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/slim2023/time_assessment.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

// The printed ranking of the solvers that we have.
std::vector<Standing> printed_ranking(const StudyResults& study, Metric metric, const std::vector<Standing>& ours) {
  std::vector<Standing> standings;
  for (const PrintedRow& row : printed_table_3(study, metric)) {
    if (std::ranges::find(ours, row.algorithm, &Standing::solver) == ours.end()) continue;
    standings.push_back({row.algorithm, row.printed.mean});
  }
  return ranked(std::move(standings));
}

// Our ranking, compared with the printed one.
std::string rankings(const StudyResults& study, Metric metric) {
  const std::string text = ranking_sentence(study, metric);
  const auto ours = standings(study, metric);
  const auto printed = printed_ranking(study, metric, ours);
  if (printed.size() < 2) return text;
  const bool same_first = first_of(printed) == first_of(ours);
  return text + fmt::format(" The paper: {}. {} is first in the paper, and {}; {}.", order_words(printed),
                            first_words(printed),
                            same_first ? std::string("here too") : fmt::format("here it is {}", first_words(ours)),
                            printed_order_words(compare_pairs(printed, ours)));
}

// The paper's second claim: its solver moves the joints less than every other. The plan's test says where the
// difference may be chance; points of one run depend on each other, so it uses run means only.
std::string variation_sentence(const JudgedStudy& study, const std::vector<Comparison>& rows) {
  if (study.plan.unit == Unit::point) return "";
  const auto printed = printed_ranking(study, Metric::variation_deg, standings(study, Metric::variation_deg));
  const auto description = [&](std::string_view solver) {
    return std::ranges::find_if(
               rows, [&](const Comparison& row) { return row.solver == solver && row.metric == Metric::variation_deg; })
        ->ours;
  };
  const auto printed_reference = std::ranges::find(printed, time_reference, &Standing::solver);
  if (printed_reference == printed.end()) return "";
  const Description reference = description(time_reference);
  const Evidence& found = study.evidence(Metric::variation_deg);
  std::string less, alike, more;
  for (const Standing& standing : printed) {
    if (standing.mean <= printed_reference->mean) continue;
    const Description other = description(standing.solver);
    const Relation answer = judge(found, time_reference, standing.solver).relation;
    std::string& list = answer == Relation::better ? less : answer == Relation::worse ? more : alike;
    list +=
        fmt::format("{}{} ({:.0f} %)", list.empty() ? "" : ", ", standing.solver, 100 * reference.mean / other.mean);
  }
  std::string text;
  if (!less.empty()) text += " Here it is smaller than that of " + less + ".";
  if (!alike.empty()) {
    text += fmt::format(" Against {} it is undecided ({}, p >= {}).", alike, pair_test_words(found),
                        rounded_number(study.plan.significance, 3));
  }
  if (!more.empty()) text += " Here it is not smaller than that of " + more + ".";
  if (text.empty()) return "";
  return fmt::format(
      "The paper prints a smaller angles variation for {} than for the others.{} (In brackets: the variation of {} in "
      "percent of the other's.)",
      time_reference, text, time_reference);
}

std::string anova_sentence(const StudyResults& study, Metric metric) {
  const StudyAnova ours = anova(study, metric);
  const auto printed = comparable_printed_anova(study, metric);
  std::string text = fmt::format("ANOVA of {}: ", name_of(metric));
  if (!ours.table.undefined.empty()) {
    text += "not defined (" + ours.table.undefined + ")";
  } else {
    const bool differ = is_significant(ours.table.p, study.plan);
    text += fmt::format("F({}, {}) = {}, p {}: the solvers {}", ours.table.df_between, ours.table.df_within,
                        rounded_number(ours.table.F, 4),
                        ours.table.p < 1e-300 ? "< 1e-300" : "= " + rounded_number(ours.table.p, 3),
                        differ ? "differ" : "are not shown to differ");
    if (printed) {
      text += is_significant(printed->p, study.plan) == differ ? ", as in the paper" : ", unlike in the paper";
    }
  }
  if (study.plan.unit == Unit::point)
    text += "; but this p is no evidence, because the points of one run depend on each other";
  for (const std::string& sentence : ours.left_out) text += ". " + sentence.substr(0, sentence.size() - 1);
  return text + ".";
}

// The ratios of our means to the printed ones.
std::string ratios_sentence(const std::vector<Comparison>& rows) {
  std::string list;
  for (const Comparison& row : rows) {
    const bool is_time = row.metric == Metric::seconds;
    if (!std::isfinite(row.ratio) || (is_time && row.solver == time_reference)) continue;
    list += fmt::format("{}{} {}{} ({} x)", list.empty() ? "" : ", ", row.solver, is_time ? "relative " : "",
                        info_of(row.metric).slug, rounded_number(row.ratio, 3));
  }
  return list.empty() ? "" : fmt::format("Our mean divided by the printed mean: {}.", list);
}

// The paper's metrics, without the times if those cannot be compared.
std::span<const Metric> judged_metrics(const StudyResults& study) {
  static_assert(paper_metrics.back() == Metric::seconds);
  const std::span<const Metric> all = paper_metrics;
  return times_are_comparable(study) ? all : all.first(all.size() - 1);
}

}  // namespace

std::vector<std::string> paper_summary(const Reported& reported) {
  const JudgedStudy& study = reported.study;
  const auto rows = compare(study);
  std::vector<std::string> sentences;
  const std::span<const Metric> judged = judged_metrics(study);
  for (const Metric metric : judged) {
    sentences.push_back(rankings(study, metric));
    if (metric == Metric::position_error_cm) sentences.push_back(limits_sentence(study));
    if (metric == Metric::seconds)
      std::ranges::move(words_of(leader_sentences(study, metric)), std::back_inserter(sentences));
    if (metric == Metric::variation_deg) sentences.push_back(variation_sentence(study, rows));
  }
  sentences.push_back(times_sentence(study));
  sentences.push_back(real_time_verdict(study));
  sentences.push_back(printed_angles_verdict(study));
  for (const Metric metric : judged) sentences.push_back(anova_sentence(study, metric));
  sentences.push_back(agreement_sentence(agreements(study, reported.repetitions)));
  sentences.push_back(ratios_sentence(rows));
  return sentences;
}

}  // namespace ikbench::slim2023
