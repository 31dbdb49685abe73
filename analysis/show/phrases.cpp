#include "analysis/show/phrases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "analysis/show/text.hpp"
#include "base/names.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

// Returns "5 mm"; empty for 0, which is no limit.
std::string limit_text(double value, std::string_view unit) {
  return value > 0 ? fmt::format("{}{}", number_text(value), unit) : "";
}

// Returns "1 iteration" or "200 iterations"; empty for 0, which is no limit.
std::string count_limit_text(std::int64_t count, std::string_view nouns) {
  return count > 0 ? base::counted(count, nouns) : "";
}

// Returns why a solve that is not solved ended.
std::string failure_reason(const SolveSummary& solve) {
  if (!results::is_sound(solve.status)) return with_spaces(results::name_of(solve.status));
  switch (solve.stop_reason) {
    case results::StopReason::iterations:
      return "iteration limit";
    case results::StopReason::evaluations:
      return "evaluation limit";
    case results::StopReason::time:
      return "time limit";
    case results::StopReason::tolerance:
      return "stopped outside the tolerance";
    case results::StopReason::not_finite:
      return "values that are not finite";
    case results::StopReason::finished:
    case results::StopReason::gave_up:
      return "gave up";
  }
  return "";
}

}  // namespace

std::string with_unit(const std::string& text, const std::string& unit) {
  if (unit.empty()) return text;
  return fmt::format("{} {}", text, text == "1" && unit == "points" ? "point" : unit);
}

void NamesByPhrase::add(const std::string& word, const std::string& name) {
  auto entry = std::ranges::find(entries, word, [](const auto& pair) { return pair.first; });
  if (entry == entries.end()) entry = entries.insert(entry, {word, {}});
  if (std::ranges::count(entry->second, name) == 0) entry->second.push_back(name);
}

std::vector<std::string> NamesByPhrase::formatted(const char* form) const {
  std::vector<std::string> texts;
  for (const auto& [word, names] : entries) texts.push_back(fmt::format(fmt::runtime(form), word, names_of(names)));
  return texts;
}

std::string margin_text(const JudgedMetric& judged) {
  const auto [relative, absolute] = std::pair(judged.plan.margin, judged.samples.absolute_margin);
  const std::string words = with_unit(number_text(100 * relative), is_success_rate(judged) ? "points" : "%");
  if (absolute == 0 || is_success_rate(judged)) return words;
  return (relative == 0 ? "" : words + " or ") + with_unit(number_text(absolute), judged.samples.unit);
}

std::string comparison_text(const Comparison& comparison, const JudgedMetric& judged) {
  const std::string margin = margin_text(judged), verdict(judge::name_of(verdict_of(comparison)));
  if (const auto* const tested = std::get_if<TestResult>(&comparison.result)) {
    if (tested->verdict == Verdict::equivalent) return "same within " + margin;
    if (all_values_equal(comparison)) return fmt::format("{}: all {} equal", verdict, tested->n);
    return verdict + (tested->is_below_margin ? " by less than " + margin : "");
  }
  if (std::holds_alternative<DeterministicResult>(comparison.result))
    return verdict +
           (all_values_equal(comparison) || is_difference(verdict_of(comparison)) ? "" : " within " + margin) +
           " (deterministic)";
  return fmt::format("{}: {}", verdict, reason_text(std::get<NotTested>(comparison.result), "values"));
}

const VerdictStyle& verdict_words(Verdict verdict) {
  static constexpr std::array<VerdictStyle, 5> all{
      {{"better", Tone::good}, {"worse", Tone::bad}, {"same"}, {"inconclusive"}, {"not_tested"}}};
  return all[static_cast<std::size_t>(verdict)];
}

ReasonTexts reason_words(NotTestedReason why) {
  constexpr std::array<ReasonTexts, 9> all{
      {{"missing_values", "values are missing", "values are missing"},
       {"infinite_values", "a mean needs finite values", "a mean needs finite values"},
       {"not_comparable", "not comparable", "not comparable (!)"},
       {"zero_spread", "a group has zero spread", "not comparable (!)"},
       {"nothing_solved", "one or both solved no target", "no target was solved"},
       {"no_answer", "neither gave an answer", "no answer"},
       {"copies", "each has a single number, which may have been copied; add --run row if each row is a measurement",
        "one number (!)"},
       {"sample_too_small", "no values to compare", "too few to compare"},
       {"dominated", "a few values dominate", "too few to compare"}}};
  return all[static_cast<std::size_t>(why)];
}

std::string reason_text(const NotTested& open, std::string_view noun) {
  if (open.reason != NotTestedReason::sample_too_small || open.n == 0)
    return std::string(reason_words(open.reason).of_pair);
  return fmt::format("{}, at least {} needed", base::counted(open.n, noun), open.required_n);
}

std::string reason_in_metric(const NotTested& not_tested, const JudgedMetric& judged, std::string_view noun) {
  if (not_tested.reason != NotTestedReason::not_comparable) return reason_text(not_tested, noun);
  std::string reason = reason_text(not_tested, noun);
  for (const Warning& warning : judged.samples.warnings)
    if (std::string stated = reason_not_compared(warning); !stated.empty()) reason = std::move(stated);
  return reason;
}

std::string warning_sentence(const Warning& warning) {
  const std::string text = warning_text(warning) + '.';
  return warning.solvers.empty() || !text.starts_with(warning.solvers[0]) ? as_sentence(text) : text;
}

std::string estimate_unit(const Comparison& comparison, const JudgedMetric& judged) {
  if (!comparison.estimate) return "";
  switch (comparison.scale) {
    case EffectScale::ratio:
      return "ratio";
    case EffectScale::share:
      return "points";
    case EffectScale::difference:
      return judged.samples.unit;
  }
  return "";
}

std::string dominance_text(const Comparison& comparison) {
  const auto* const tested = std::get_if<TestResult>(&comparison.result);
  if (!tested || !tested->dominance || !is_difference(tested->verdict)) return "";
  return fmt::format("better in {} % and worse in {} % of value pairs", number_text(100 * tested->dominance->better),
                     number_text(100 * tested->dominance->worse));
}

bool shows_a12(const TestResult& tested, const JudgedMetric& judged) {
  return tested.dominance && !tested.hedges_g && !is_success_rate(judged);
}

std::set<double> null_and_margin(const Comparison& comparison, const JudgedMetric& judged) {
  const double margin = judged.plan.margin;
  if (comparison.scale == EffectScale::ratio) return {1, 1 + margin, 1 / (1 + margin)};
  const double end = is_success_rate(judged) ? 100 * margin : judged.samples.absolute_margin;
  return {0, end, -end};
}

std::string tolerance_text(const StudyResults& study) {
  const numerics::StopRule& stop = study.definition.stop;
  std::vector<std::string> tolerances{limit_text(10 * stop.tolerance_cm(), " mm"),
                                      limit_text(stop.tolerance_deg(), " deg")};
  std::erase(tolerances, "");
  return listed(tolerances) + (stop.adds_squares ? " (squares added)" : "");
}

std::string effort_limits_text(const StudyResults& study) {
  const numerics::StopRule& stop = study.definition.stop;
  std::vector<std::string> limits{count_limit_text(stop.iterations, "iterations"),
                                  count_limit_text(stop.evaluations, "evaluations"),
                                  limit_text(1000 * stop.seconds, " ms")};
  std::erase(limits, "");
  return limits.empty() ? "" : "after " + listed(limits, " or ");
}

std::string budget_text(const StudyResults& study) {
  std::vector<std::string> stops;
  if (study.definition.has_tolerance()) stops.push_back("at " + tolerance_text(study));
  stops.push_back(effort_limits_text(study));
  std::erase(stops, "");
  return fmt::format("{}", fmt::join(stops, ", or "));
}

std::string failure_reasons_text(const StudyResults& study) {
  if (!study.definition.has_tolerance()) return "";  // no solve counts as solved or unsolved
  NamesByPhrase reasons;
  for (const std::string& label : study.labels) {
    std::set<std::string> of_label;
    for (const SolveSummary& solve : study.of(label)) {
      if (solve.status != results::Status::ok) of_label.insert(failure_reason(solve));
    }
    if (!of_label.empty()) reasons.add(listed({of_label.begin(), of_label.end()}, " or "), label);
  }
  return reasons.entries.empty() ? "" : fmt::format("Why unsolved: {}.", fmt::join(reasons.formatted("{} ({})"), "; "));
}

std::string rejections_text(const StudyResults& study) {
  NamesByPhrase faults;
  for (const auto& [label, all] : study.rejections)
    for (const auto& [fault, count] : all) faults.add(fault, fmt::format("{} {}", label, count));
  if (faults.entries.size() > 10)
    faults.entries = {{base::counted(std::ssize(faults.entries), "faults"), {"listed in solves.csv"}}};
  return faults.entries.empty()
             ? ""
             : fmt::format("Rejected by the check: {}.", fmt::join(faults.formatted("{} ({})"), "; "));
}

const std::string& title_of(const StudyResults& study) {
  return study.definition.title.empty() ? study.name : study.definition.title;
}

std::string study_text(const StudyResults& study) {
  const results::StudyDefinition& definition = study.definition;
  const bool is_one_each = definition.draws_targets && definition.points == 1;
  return fmt::format("{}, {}{} ({})", std::filesystem::path(definition.robot).stem().string(),
                     is_one_each ? "" : base::counted(definition.runs, "runs") + " of ",
                     base::counted(is_one_each ? definition.runs : definition.points, "targets"),
                     with_spaces(definition.path));
}

}  // namespace ikbench::show
