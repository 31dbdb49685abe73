#include "analysis/claims/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/study_tables.hpp"

namespace ikbench::claims {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

// Takes the solver's numbers from the one, the others' from the other: they share no block.
Observations mixed(Observations of_solver, Observations of_others, const std::string& solver) {
  std::erase_if(of_others.groups, [&](const Group& group) { return group.name == solver; });
  for (Group& group : of_solver.groups) {
    if (group.name == solver) of_others.groups.insert(of_others.groups.begin(), std::move(group));
  }
  of_others.blocks.clear();
  of_others.block.clear();
  if (of_others.flaws.empty()) of_others.flaws = of_solver.flaws;
  return of_others;
}

}  // namespace

std::vector<PrintedRow> printed_rows(const ClaimsFile& file, const StudyResults& study, Metric metric) {
  const bool is_elsewhere = std::ranges::count(file.not_on, study.facts.path) > 0;
  return is_elsewhere ? std::vector<PrintedRow>() : printed_rows(study.facts.published, file.means, metric);
}

std::vector<Observations> printed_summaries(const ClaimsFile& file, const StudyResults& study) {
  std::vector<Observations> result;
  for (const Metric metric : all_metrics()) {
    const MetricInfo& info = info_of(metric);
    Observations printed{.name = fmt::format("printed-{}", info.slug),
                         .quantity = text_of({fmt::format("{}, as printed", info.name), std::string(info.unit)}),
                         .unit = std::string(info.unit),
                         .better = info.better};
    for (const PrintedRow& row : printed_rows(file, study, metric))
      printed.groups.push_back({.name = row.algorithm, .summary = row.summary()});
    if (printed.groups.size() >= 2) result.push_back(std::move(printed));
  }
  return result;
}

Claim Case::begun() const {
  return {.statement = entry.sentence,
          .verdict = Verdict::undecided,
          .evidence = {},
          .table = entry.table.empty() ? file.means : entry.table,
          .id = entry.id,
          .section = entry.section,
          .by = entry.by,
          .decides = entry.decides};
}

bool Case::is_of_means() const {
  return file.means.empty() || std::ranges::any_of(all_metrics(), [&](Metric metric) {
           return !printed_rows(file, study(), metric).empty();
         });
}

std::vector<Pair> Case::pairs(Metric metric) const {
  const std::vector<PrintedRow> printed = printed_rows(file, study(), metric);
  std::vector<Pair> result;
  for (const Sample& sample : samples(study(), metric)) {
    const auto row = std::ranges::find(printed, sample.solver, &PrintedRow::algorithm);
    const bool is_asked = entry.against.empty() || sample.solver == entry.solver || sample.solver == entry.against;
    if (row == printed.end() || sample.values.empty() || !is_asked) continue;
    result.push_back({sample.solver, describe(sample.values), row->summary()});
  }
  std::ranges::stable_sort(result, {}, [](const Pair& pair) { return pair.printed.mean; });
  return result;
}

bool Case::is_printed() const {
  const std::vector<Pair> all = pairs(Metric::position_error_cm);
  return all.size() >= 2 && std::ranges::count(all, entry.solver, &Pair::solver) > 0;
}

bool Case::has_solver() const {
  const auto has_solves = [&](const std::string& solver) { return !solves_of(study(), solver).empty(); };
  return file.means.empty() ? has_solves(entry.solver) && std::ranges::count_if(study().solvers, has_solves) >= 2
                            : is_printed();
}

Evidence Case::printed_evidence(const std::vector<Pair>& pairs) const {
  Observations printed;
  for (const Pair& pair : pairs) printed.groups.push_back({.name = pair.solver, .summary = pair.printed});
  return inference::evidence(printed, feasible(study().plan, printed));
}

const JudgedStudy* Case::companion() const {
  for (const JudgedStudy& companion : reported.companions) {
    if (companion.name == study().name + '-' + entry.study && same_targets(study(), companion)) return &companion;
  }
  return nullptr;
}

std::optional<Evidence> Case::evidence(Metric metric) const {
  const JudgedStudy* const other = companion();
  if (!entry.study.empty() && other == nullptr) return std::nullopt;
  const JudgedStudy& of_solver = other != nullptr && entry.take != FromCompanion::others ? *other : study();
  const JudgedStudy& of_others = other != nullptr && entry.take != FromCompanion::solver ? *other : study();
  std::optional<Evidence> found;
  if (&of_solver == &of_others && entry.against.empty()) {
    found = of_solver.evidence(metric);
  } else {
    Observations observed = &of_solver == &of_others
                                ? observations(of_solver, metric)
                                : mixed(observations(of_solver, metric), observations(of_others, metric), entry.solver);
    std::erase_if(observed.groups, [&](const Group& group) {
      return !entry.against.empty() && group.name != entry.solver && group.name != entry.against;
    });
    const AnalysisPlan plan = feasible(study().plan, observed);
    const bool comparable = is_comparable(of_solver, metric) && is_comparable(of_others, metric);
    found = comparable ? inference::evidence(observed, plan) : described(observed, plan);
  }
  const std::vector<std::string> own = entry.own();
  const bool has_own =
      std::ranges::all_of(own, [&](const auto& solver) { return group_named(found->groups, solver) != nullptr; });
  const bool is_complete =
      std::ranges::none_of(found->groups, [](const GroupEvidence& group) { return group.described.n == 0; });
  return found->groups.size() > own.size() && has_own && is_complete ? found : std::nullopt;
}

void PairCounts::add(Relation relation) {
  better += relation == Relation::better ? 1 : 0;
  worse += relation == Relation::worse ? 1 : 0;
  open += is_difference(relation) ? 0 : 1;
}

Verdict verdict_on(const PairCounts& found) {
  if (found.worse > 0) return Verdict::fails;
  if (found.open == 0) return Verdict::holds;
  return found.better > 0 ? Verdict::in_part : Verdict::undecided;
}

Verdict verdict_on(const std::vector<Verdict>& verdicts) {
  const auto count = [&](Verdict verdict) { return static_cast<std::size_t>(std::ranges::count(verdicts, verdict)); };
  if (count(Verdict::holds) == verdicts.size()) return Verdict::holds;
  if (count(Verdict::holds) + count(Verdict::in_part) > 0) return Verdict::in_part;
  return count(Verdict::fails) > 0 ? Verdict::fails : Verdict::undecided;
}

Verdict verdict_of(bool always, bool on_average) {
  return always ? Verdict::holds : on_average ? Verdict::in_part : Verdict::fails;
}

std::string in_brackets(double p) { return std::isfinite(p) ? fmt::format(" ({})", p_words(p)) : ""; }

std::string title(Metric metric) { return inference::capitalised(info_of(metric).name); }

std::string number_of(double value, Metric metric) {
  return short_number(info_of(metric).kind == Kind::time ? 1000 * value : value);
}

std::string with_unit(double value, Metric metric) {
  const std::string_view unit = info_of(metric).kind == Kind::time ? "ms" : info_of(metric).unit;
  return fmt::format("{}{}{}", number_of(value, metric), unit.empty() ? "" : " ", unit);
}

}  // namespace ikbench::claims
