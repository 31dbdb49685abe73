#include "analysis/report/article_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;
using namespace statistics;
using namespace fmt::literals;

namespace {

struct ArticleColumn {
  Metric metric;
  Estimand estimand;
  const Evidence* evidence;

  bool is_share() const { return estimand == Estimand::reliability; }
  bool is_compared() const { return !evidence->contrasts.empty() && evidence->flaws.empty(); }
};

// The quantities that the study is judged by, the most important first. An error has the plan's first average. How far
// the arm moves counts much where each solve begins with the previous answer, and the share where it says what is
// solved or decides.
std::vector<ArticleColumn> article_columns(const JudgedStudy& study, const EvidenceOf& evidence_of) {
  std::vector<Metric> metrics{Metric::position_error_cm, Metric::orientation_error_deg};
  if (study.facts.start == "previous") metrics.push_back(Metric::variation_deg);
  metrics.insert(metrics.end(), {Metric::seconds, Metric::evaluations});
  const std::vector<Metric> judged = shown_metrics(study);
  std::erase_if(metrics, [&](Metric metric) { return std::ranges::count(judged, metric) == 0; });
  std::ranges::copy_if(judged, std::back_inserter(metrics),
                       [&](Metric metric) { return std::ranges::count(metrics, metric) == 0; });
  std::vector<ArticleColumn> columns, last;
  const auto add = [&](std::vector<ArticleColumn>& to, Metric metric, Estimand estimand) {
    if (const Evidence* const evidence = evidence_of(metric, estimand)) to.push_back({metric, estimand, evidence});
  };
  const bool is_share_first = std::isfinite(tolerance_cm(study)) || primary_estimand(study) == Estimand::reliability;
  for (const Metric metric : metrics) {
    const std::vector<Estimand> estimands = estimands_of(study, metric);
    const bool has_share =
        metric == Metric::position_error_cm && std::ranges::count(estimands, Estimand::reliability) > 0;
    if (has_share) add(is_share_first ? columns : last, metric, Estimand::reliability);
    const auto average = std::ranges::find_if(estimands, [](Estimand of) { return of != Estimand::reliability; });
    add(columns, metric, average == estimands.end() ? average_estimand(metric) : *average);
  }
  std::ranges::move(last, std::back_inserter(columns));
  return columns;
}

std::string head_of_article(const StudyResults& study, const ArticleColumn& column) {
  if (!column.is_share()) return std::string(name_of(column.metric));
  return std::isfinite(tolerance_cm(study)) ? "solved [%]" : within_words(study, column.metric) + " [%]";
}

AverageCell average_of(const GroupEvidence& group, const ArticleColumn& column) {
  constexpr double whole = 100;
  if (column.is_share()) return {.value = whole * group.described.mean};
  if (column.estimand == Estimand::typical) return {.value = group.described.mean, .spread = {group.q1, group.q3}};
  return {.value = group.described.mean, .spread = {group.described.std}};
}

// Marks the best of a column, and what was found to differ from it or from the control.
void mark(std::vector<AverageCell>& averages, const Evidence& evidence) {
  const double sign = evidence.better == Better::smaller ? 1 : -1;
  const auto score = [&](const AverageCell& of) { return std::isfinite(of.value) ? sign * of.value : HUGE_VAL; };
  const auto best = std::ranges::min_element(averages, {}, score);
  const auto control = std::ranges::find(evidence.groups, evidence.plan.control, &GroupEvidence::name);
  const auto reference = static_cast<std::size_t>(control != evidence.groups.end() ? control - evidence.groups.begin()
                                                                                   : best - averages.begin());
  for (std::size_t i = 0; i < averages.size(); ++i) {
    averages[i].is_best = std::isfinite(averages[i].value) && value_words(averages[i]) == value_words(*best);
    const std::optional<Finding> finding = finding_of(evidence.contrasts, reference, i);
    averages[i].differs = finding && is_decided(*finding);
  }
}

void add_column(Table& table, const JudgedStudy& study, const ArticleColumn& column) {
  const std::vector<GroupEvidence>& groups = column.evidence->groups;
  std::vector<AverageCell> averages;
  for (const GroupEvidence& group : groups) averages.push_back(average_of(group, column));
  if (column.is_compared()) mark(averages, *column.evidence);
  table.columns.push_back(head_of_article(study, column));
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto group = std::ranges::find(groups, std::get<std::string>(table.rows[row].front()), &GroupEvidence::name);
    table.rows[row].emplace_back(group == groups.end() ? average_of({}, column)  // a solver without observations
                                                       : averages[static_cast<std::size_t>(group - groups.begin())]);
  }
}

// Says what the numbers and the marks are.
std::string article_caption(const JudgedStudy& study, const std::vector<std::string>& solvers,
                            std::span<const ArticleColumn> columns, std::span<const ArticleColumn> without_room) {
  const auto any = [&](const auto& is_so) { return std::ranges::any_of(columns, is_so); };
  const auto is_of = [](Estimand estimand) {
    return [estimand](const ArticleColumn& column) { return column.estimand == estimand; };
  };
  const Evidence& first = *columns.front().evidence;
  int most = 0;
  for (const GroupEvidence& group : first.groups) most = std::max(most, group.described.n);
  std::vector<std::string> averages;
  if (any(is_of(Estimand::mean))) averages.emplace_back(words::article_means);
  if (any(is_of(Estimand::typical))) averages.emplace_back(words::article_typical);
  const std::string_view observations = first.blocks > 0                 ? std::string_view(first.block_noun)
                                        : study.plan.unit == Unit::point ? "points"
                                                                         : "runs";
  std::vector<std::string> sentences{
      capitalised(fmt::format(words::article_averages, "averages"_a = fmt::join(averages, " or "),
                              "observations"_a = observations, "n"_a = most))};
  const auto is_average_error = [](const ArticleColumn& column) {
    return column.metric == Metric::position_error_cm && !column.is_share();
  };
  if (any(is_average_error) && std::isfinite(tolerance_cm(study))) sentences.emplace_back(words::article_tolerance);
  const auto penalised =
      std::ranges::find_if(columns, [&](const ArticleColumn& column) { return is_penalised(study, column.metric); });
  if (penalised != columns.end()) sentences.push_back(capitalised(penalty_words(study, penalised->metric)) + '.');
  std::vector<std::string> not_compared;
  for (const ArticleColumn& column : columns) {
    if (!column.is_compared()) not_compared.emplace_back(info_of(column.metric).name);
  }
  std::vector<std::string> no_room;  // errors, without which a solver may look better than it is
  for (const ArticleColumn& column : without_room) {
    if (is_error(column.metric) && !column.is_share()) no_room.emplace_back(info_of(column.metric).name);
  }
  if (!no_room.empty()) sentences.push_back(fmt::format(words::article_no_room, "names"_a = listed(no_room)));
  for (const ArticleColumn& column : columns) {
    Doubts without = is_comparable(study, column.metric) ? left_out(study, column.metric) : Doubts();
    for (Doubt& doubt : without)
      std::erase_if(doubt.who, [&](const std::string& who) { return std::ranges::count(solvers, who) == 0; });
    std::erase_if(without, [](const Doubt& doubt) { return doubt.who.empty(); });
    if (!without.empty())
      sentences.push_back(fmt::format(words::article_left_out, "name"_a = info_of(column.metric).name,
                                      "who"_a = left_out_words(without)));
  }
  if (solvers.size() < 2) return fmt::format("{}", fmt::join(sentences, " "));
  if (not_compared.size() < columns.size()) {
    const std::string& control = first.plan.control;
    sentences.push_back(fmt::format(words::article_marks, "from"_a = control.empty() ? "the best" : control,
                                    "level"_a = rounded_number(first.plan.significance, 3)));
  }
  if (!not_compared.empty())
    sentences.push_back(fmt::format(words::article_not_compared, "names"_a = listed(not_compared)));
  return fmt::format("{}", fmt::join(sentences, " "));
}

// `judged` is the study, or stands for those that are judged together.
Table article_of(const JudgedStudy& judged, const std::vector<std::string>& solvers,
                 const std::vector<ArticleColumn>& columns) {
  Table table{.name = "paper", .caption = "", .columns = {"solver"}, .is_narrow = true};
  for (const std::string& solver : solvers) table.rows.push_back({solver});
  for (const ArticleColumn& column : columns) add_column(table, judged, column);
  // A pose has two errors, so names make room for the second.
  const auto turned = std::ranges::find(columns, Metric::orientation_error_deg, &ArticleColumn::metric);
  const auto needed = turned == columns.end() ? 0 : turned - columns.begin() + 2;
  table = fitted(std::move(table), static_cast<std::size_t>(needed));
  const std::span all(columns);
  const std::size_t shown = table.columns.size() - 1;
  table.caption = article_caption(judged, solvers, all.first(shown), all.subspan(shown));
  return table;
}

}  // namespace

Table article_table(const JudgedStudy& study) {
  const auto evidence_of = [&](Metric metric, Estimand estimand) { return &study.evidence(metric, estimand); };
  return article_of(study, study.solvers, article_columns(study, evidence_of));
}

Table article_table(const JudgedStudies& studies, const EvidenceOf& evidence_of) {
  const JudgedStudy& first = studies.front();
  const std::vector<ArticleColumn> columns = article_columns(first, evidence_of);
  std::vector<std::string> solvers;
  for (const GroupEvidence& group : columns.front().evidence->groups) solvers.push_back(group.name);
  return article_of(first, solvers, columns);
}

}  // namespace ikbench::report
