#include "analysis/slim2023/paper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "analysis/slim2023/audit.hpp"
#include "analysis/slim2023/claims.hpp"
#include "analysis/slim2023/multiverse.hpp"
#include "analysis/slim2023/paper_figures.hpp"
#include "analysis/slim2023/paper_summary.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/slim2023/readings.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace inference;
using namespace report;

namespace {

constexpr const char* this_paper = "slim2023";

// What only a companion has.
bool is_of_companions(const std::string& piece) {
  constexpr std::array<std::string_view, 8> names{"table-7",   "table-7-cost", "table-8",   "figure-14",
                                                  "figure-15", "figure-16",    "figure-17", "figure-18"};
  return std::ranges::find(names, piece) != names.end();
}

StudyPieces pieces(const Reported& reported) {
  StudyPieces all{.tables = paper_tables(reported.study, reported.repetitions),
                  .figures = paper_figures(reported.study),
                  .results = "table-3",
                  .path = "figure-5"};
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
  return {.results = {{"Results",
                       "",
                       {"figure-5", "table-3", "agreement", "table-3-as-printed", "figure-6", "figure-7", "figure-8",
                        "figure-9"}},
                      {"Analysis of variance",
                       "",
                       {"figure-10", "figure-11", "figure-12", "table-4", "table-5", "table-6",
                        "anova-from-printed-table-3"}}},
          .further = {{"Computing time",
                       "The paper's real-time test: how long a swarm of a given size takes to reach 0.1 cm.",
                       {"table-7", "table-7-cost"}},
                      {"Circle",
                       "The paper's second arm, a Dobot Magician, on a circle.",
                       {"table-8", "figure-14", "figure-15", "figure-16", "figure-17", "figure-18"}}}};
}

}  // namespace

Paper paper() {
  return {.name = this_paper,
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
          .audit = [] { return audit(this_paper); },
          .readings = [](std::span<const ReadingResults> results) { return readings_report(this_paper, results); },
          .multiverse = [](const Multiverse& multiverse,
                           const AnalysisPlan& plan) { return multiverse_report(this_paper, multiverse, plan); }};
}

}  // namespace ikbench::slim2023
