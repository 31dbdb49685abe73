#include "analysis/slim2023/paper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "analysis/claims/audit.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/leaders.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/slim2023/agreement.hpp"
#include "analysis/slim2023/claims.hpp"
#include "analysis/slim2023/multiverse.hpp"
#include "analysis/slim2023/one_at_a_time.hpp"
#include "analysis/slim2023/paper_figures.hpp"
#include "analysis/slim2023/paper_summary.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/slim2023/time_assessment.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/embedded_file.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

constexpr const char* this_paper = "slim2023";
constexpr numerics::EmbeddedFile files[]{
#include "claims.inc"
};

std::vector<AuditItem> audit() {
  const numerics::EmbeddedFile& file = *numerics::find_embedded(files, "audit");
  return claims::audited(this_paper, file.text, file.name);
}

// What only a companion has.
bool is_of_companions(const std::string& piece) {
  constexpr std::array<std::string_view, 8> names{"table-7",   "table-7-cost", "table-8",   "figure-14",
                                                  "figure-15", "figure-16",    "figure-17", "figure-18"};
  return std::ranges::find(names, piece) != names.end();
}

// The error of the paper's solver, and how many printed numbers agree: short, for the first lines.
std::string verdict_sentence(const JudgedStudy& study, const std::vector<Agreement>& agreed) {
  const Metric metric = Metric::position_error_cm;
  const std::vector<Sample> all = samples(study, metric);
  const auto own = std::ranges::find(all, time_reference, &Sample::solver);
  const std::optional<PrintedRow> printed = printed_row(study, time_reference, metric);
  std::string text;
  if (own != all.end() && printed) {
    text = fmt::format("{}'s mean error: {} cm (printed {}).", time_reference, short_number(describe(own->values).mean),
                       short_number(printed->summary.mean));
  }
  if (!agreed.empty()) {
    text += fmt::format(" {} of {} printed numbers repeat.", std::ranges::count(agreed, true, &Agreement::is_expected),
                        agreed.size());
  }
  return text;
}

std::map<std::string, std::string> seen(const Reported& reported) {
  const JudgedStudy& study = reported.study;
  const std::vector<Agreement> agreed = agreements(study, reported.repetitions);
  std::map<std::string, std::string> sentences{{"Verdict", verdict_sentence(study, agreed)},
                                               {"figure-6", closest_point_by_point(study)},
                                               {"figure-9", limits_sentence(study)}};
  for (const Metric metric : paper_metrics) {
    const bool is_judged = is_comparable(study, metric);
    const PaperNumbers& numbers = paper_numbers(metric);
    sentences[fmt::format("figure-{}", numbers.box_figure)] =
        is_judged ? leader_sentence(study, metric, results::Estimand::mean) : times_sentence(study);
    if (metric != Metric::position_error_cm && is_judged) {
      sentences[fmt::format("figure-{}", numbers.curves_figure)] = ranking_sentence(study, metric);
    }
  }
  return sentences;
}

StudyPieces pieces(const Reported& reported) {
  StudyPieces all{.tables = paper_tables(reported.study, reported.repetitions),
                  .figures = paper_figures(reported.study),
                  .results = "table-3",
                  .path = "figure-5"};
  if (!reported.study.solves.empty()) all.seen = seen(reported);
  for (const StudyResults& companion : reported.companions) {
    for (Table& table : paper_tables(companion)) {
      if (is_of_companions(table.name)) all.tables.push_back(std::move(table));
    }
    for (figures::Figure& figure : paper_figures(companion)) {
      if (is_of_companions(figure.name)) all.figures.push_back(std::move(figure));
    }
  }
  return all;
}

// "computing time, as printed [s]"
std::string as_printed(std::string_view quantity) {
  const std::size_t unit = std::min(quantity.find(" ["), quantity.size());
  return fmt::format("{}, as printed{}", quantity.substr(0, unit), quantity.substr(unit));
}

std::vector<Summaries> printed_summaries(const StudyResults& study) {
  std::vector<Summaries> result;
  for (const Metric metric : paper_metrics) {
    Summaries printed{.name = fmt::format("printed-{}", info_of(metric).slug),
                      .quantity = as_printed(quantity(metric))};
    for (const PrintedRow& row : printed_table_3(study, metric)) printed.groups.push_back({row.algorithm, row.summary});
    if (printed.groups.size() >= 2) result.push_back(std::move(printed));
  }
  return result;
}

ReportPlan sections() {
  return {
      .results = {{"Table 3", "", {"overview", "agreement|table-3"}, {"table-3", "table-3-as-printed"}},
                  {"Figures 5 to 12",
                   "",
                   {"figure-5", "figure-6", "figure-7", "figure-8", "figure-9", "figure-10", "figure-11", "figure-12"}},
                  {"Tables 4 to 6",
                   "One-way analysis of variance of error, variation and time.",
                   {},
                   {"table-4", "table-5", "table-6", "anova-from-printed-table-3"}}},
      .further = {{"Table 7: real time",
                   "How long a swarm of a given size takes to come within 0.1 cm of the target.",
                   {"table-7"},
                   {"table-7-cost"}},
                  {"Dobot Magician: Table 8, Figures 14 to 18",
                   "The paper's second arm on a circle, computed; no real arm moved.",
                   {"figure-14", "figure-15", "figure-16", "figure-17", "figure-18"},
                   {"table-8"}}}};
}

}  // namespace

Paper paper() {
  return {.name = this_paper,
          .in_short = "six solvers on a helix",
          .citation =
              "Slim, Rokbani, Neji, Terres and Beyrouthy: Inverse Kinematic Solver Based on Bat Algorithm for "
              "Robotic Arm Path Planning. Robotics 2023, 12(2), 38, doi:10.3390/robotics12020038.",
          .not_reproduced = "No real Dobot.",
          .studies = {{this_paper, {"seed", "runs"}},            // Sec. 5.2
                      {"slim2023-context", {"seed", "runs"}},    // beside it: a classical solver
                      {"slim2023-limits", {"seed", "runs"}},     // the same with the limits enforced
                      {"slim2023-bounds", {"seed", "runs"}},     // with the other solvers clamped
                      {"slim2023-frequency", {"seed", "runs"}},  // without Eq. 13
                      {"slim2023-time", {"seed"}},               // Sec. 5.3.3
                      {"slim2023-dobot", {"seed"}}},             // Sec. 6
          .repetitions = 50,
          .claims = claims,
          .pieces = pieces,
          .sections = sections(),
          .summary = [](const Reported& of) { return paper_summary(of); },
          .printed = printed_summaries,
          .audit = audit,
          .multiverse = [](const Multiverse& multiverse,
                           const AnalysisPlan& plan) { return multiverse_report(this_paper, multiverse, plan); },
          .one_at_a_time = [](const Multiverse& multiverse,
                              const AnalysisPlan& plan) { return one_at_a_time(this_paper, multiverse, plan); }};
}

}  // namespace ikbench::slim2023
