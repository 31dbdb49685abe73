#include "analysis/slim2023/paper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/leaders.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/slim2023/agreement.hpp"
#include "analysis/slim2023/circle.hpp"
#include "analysis/slim2023/paper_figures.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/slim2023/time_assessment.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

// True for pieces that only a companion study has.
bool is_of_companions(const std::string& piece) {
  constexpr std::array<std::string_view, 7> names{"table-7",   "table-8",   "figure-14", "figure-15",
                                                  "figure-16", "figure-17", "figure-18"};
  return std::ranges::find(names, piece) != names.end();
}

// Says for the first lines how many printed numbers agree or, if that is not known, the error of the paper's solver.
std::string verdict_sentence(const JudgedStudy& study, const std::vector<Agreement>& agreed) {
  if (!agreed.empty()) {
    return fmt::format("{} of {} printed numbers repeat.", std::ranges::count(agreed, true, &Agreement::is_expected),
                       agreed.size());
  }
  const Metric metric = Metric::position_error_cm;
  const std::vector<Sample> all = samples(study, metric);
  const auto own = std::ranges::find(all, time_reference, &Sample::solver);
  const std::optional<PrintedRow> printed = printed_row(study, time_reference, metric);
  if (own == all.end() || !printed) return "";
  return fmt::format(
      "{}'s mean error: {} cm (printed {}). ikbench reproduce, without --quick, shows what depends on chance and on the "
      "interpretation.",
      time_reference, short_number(describe(own->values).mean), short_number(printed->printed.mean));
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
        is_judged ? words_of(leader_sentence(study, metric, average_estimand(metric))) : times_sentence(study);
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

std::vector<std::string> summary(const Reported& reported) {
  return {real_time_verdict(reported.study), printed_angles_verdict(reported.study),
          agreement_sentence(agreements(reported.study, reported.repetitions))};
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
                   {}},
                  {"Dobot Magician: Table 8, Figures 14 to 18",
                   "The paper's second arm on a circle, computed; no real arm moved.",
                   {"figure-14", "figure-15", "figure-16", "figure-17", "figure-18"},
                   {"table-8"}}}};
}

}  // namespace

void complete(Paper& paper) {
  paper.pieces = pieces;
  paper.sections = sections();
  paper.summary = summary;
}

}  // namespace ikbench::slim2023
