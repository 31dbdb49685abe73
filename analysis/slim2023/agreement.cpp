#include "analysis/slim2023/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/claims/printed.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/predictive_study.hpp"

namespace ikbench::slim2023 {

using namespace claims;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

constexpr double predictive_level = 0.95;
constexpr std::array<Metric, 2> repeated_metrics{Metric::position_error_cm, Metric::variation_deg};

std::vector<Description> descriptions(const RepeatedSolver& solver, Metric metric) {
  std::vector<Description> seeds;
  for (const std::vector<double>& runs : metric == Metric::variation_deg ? solver.variation_deg : solver.error_cm) {
    seeds.push_back(describe(runs));
  }
  return seeds;
}

const Sample* sample_of(const std::vector<Sample>& all, const std::string& solver) {
  const auto found = std::ranges::find(all, solver, &Sample::solver);
  return found == all.end() || found->values.empty() ? nullptr : &*found;
}

Cell cell_of(const Agreement& agreement) {
  return OursAndPrinted{.ours = agreement.ours,
                        .printed = agreement.printed,
                        .nearness = nearness_of(agreement),
                        .words = agreement.is_expected ? "" : words_of(agreement)};
}

// Formats a value with as many digits after the point as a printed number.
std::string like(std::string_view printed, double value) {
  const std::size_t e = std::min(printed.find_first_of("eE"), printed.size()), point = printed.find('.');
  const std::size_t decimals = point < e ? e - point - 1 : 0;
  return e < printed.size() ? fmt::format("{:.{}e}", value, decimals) : fmt::format("{:.{}f}", value, decimals);
}

// Only the ratio of a time to IK-BA's can be compared.
void add_times(Table& table, const StudyResults& study) {
  const std::vector<Sample> all = samples(study, Metric::seconds);
  const Sample* const reference = sample_of(all, std::string(time_reference));
  const std::optional<PrintedRow> printed_reference = printed_row(study, time_reference, Metric::seconds);
  if (!times_are_comparable(study) || reference == nullptr || !printed_reference) return;
  const Description own = describe(reference->values);
  for (const PrintedRow& printed : printed_table_3(study, Metric::seconds)) {
    const Sample* const sample = sample_of(all, printed.algorithm);
    if (sample == nullptr || printed.algorithm == time_reference) continue;
    const Description ours = describe(sample->values);
    const auto times = [](double our_ratio, double printed_ratio) -> Cell {
      return OursAndPrinted{.ours = our_ratio, .printed = short_number(printed_ratio)};
    };
    table.rows.push_back({printed.algorithm, fmt::format("time / {}'s time", time_reference),
                          times(ours.mean / own.mean, printed.printed.mean / printed_reference->printed.mean),
                          times(ours.median / own.median, printed.printed.median / printed_reference->printed.median),
                          Cell(), Cell(), Cell()});
  }
}

}  // namespace

Nearness nearness_of(double ratio) {
  if (!std::isfinite(ratio)) return Nearness::unknown;
  return ratio < near_ratio && ratio > 1 / near_ratio ? Nearness::near : Nearness::far;
}

Nearness nearness_of(const Agreement& agreement) {
  if (agreement.is_expected) return Nearness::within;
  return nearness_of(agreement.ratio) == Nearness::near ? Nearness::near : Nearness::far;
}

std::string words_of(const Agreement& agreement) {
  if (agreement.is_expected) return "in our range";
  return fmt::format("{}outside our range {} to {}",
                     std::isfinite(agreement.ratio) ? rounded_number(agreement.ratio, 2) + " times, " : "",
                     like(agreement.printed, agreement.expected.low), like(agreement.printed, agreement.expected.high));
}

std::vector<Agreement> agreements(const StudyResults& study, std::span<const RepeatedSolver> repetitions) {
  std::vector<Agreement> result;
  if (printed_table_3(study, Metric::position_error_cm).empty()) return result;
  for (const Metric metric : repeated_metrics) {
    const std::vector<Sample> all = samples(study, metric);
    for (const PrintedRow& row : printed_table_3(study, metric)) {
      const auto repeated = std::ranges::find(repetitions, row.algorithm, &RepeatedSolver::label);
      const Sample* const sample = sample_of(all, row.algorithm);
      if (repeated == repetitions.end() || sample == nullptr) continue;
      const std::vector<Description> seeds = descriptions(*repeated, metric);
      const Description ours = describe(sample->values);
      for (std::size_t s = 0; s < printed_statistics.size(); ++s) {
        const auto& [name, field] = printed_statistics[s];
        std::vector<double> values;
        for (const Description& seed : seeds) values.push_back(seed.*field);
        const Estimate expected = predictive_interval(values, predictive_level);
        const double printed = row.printed.*field, rounding = half_unit(row.digits[s]);
        result.push_back({.solver = row.algorithm,
                          .metric = metric,
                          .statistic = std::string(name),
                          .printed = row.digits[s],
                          .ours = ours.*field,
                          .ratio = printed == 0 ? not_defined : ours.*field / printed,
                          .expected = expected,
                          .is_expected = printed + rounding >= expected.low && printed - rounding <= expected.high});
      }
    }
  }
  return result;
}

std::optional<Table> agreement_table(const StudyResults& study, std::span<const RepeatedSolver> repetitions) {
  const std::vector<Agreement> all = agreements(study, repetitions);
  if (all.empty()) return std::nullopt;
  Table table{.name = "agreement",
              .caption = "Table 3, every number rounded and beside the printed one",
              .columns = {"algorithm", "metric"}};
  for (const auto& [name, field] : printed_statistics) table.columns.emplace_back(name);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % printed_statistics.size() == 0) {
      const MetricInfo& metric = info_of(all[i].metric);
      table.rows.push_back({all[i].solver, fmt::format("{} [{}]", metric.slug, metric.unit)});
    }
    table.rows.back().push_back(cell_of(all[i]));
  }
  add_times(table, study);
  table.notes.push_back(agreement_sentence(all));
  table.notes.push_back(own_sentence(all));
  table.notes.push_back(fmt::format(
      "The printed digits are the paper's. Our range holds that statistic in 95 % of studies like ours: it is the "
      "predictive range of one more of them, by order statistics of {} seeds. Where the printed number lies outside, "
      "there is our number divided by the printed one, and the range; near is less than {} times as much or as little. "
      "Computing times are ratios to those of {}.",
      repetitions.front().error_cm.size(), near_ratio, time_reference));
  return table;
}

std::string agreement_sentence(const std::vector<Agreement>& agreements) {
  if (agreements.empty()) return "";
  std::string means;
  for (const Agreement& each : agreements) {
    if (each.is_expected || each.statistic != "mean") continue;
    means +=
        fmt::format("{}{} {} ({})", means.empty() ? "" : "; ", each.solver, info_of(each.metric).slug, words_of(each));
  }
  return fmt::format(
      "{} of {} printed errors and variations lie where 95 % of our repetitions do. Means that do not: {}.",
      std::ranges::count(agreements, true, &Agreement::is_expected), agreements.size(), means.empty() ? "none" : means);
}

std::string own_sentence(const std::vector<Agreement>& agreements) {
  const auto outside = std::ranges::count_if(
      agreements, [](const Agreement& of) { return of.ours < of.expected.low || of.ours > of.expected.high; });
  return fmt::format(
      "Of our own {0} numbers, which are those of one seed, {1} {2} outside our range; by chance {3:.0f} of {0} would.",
      agreements.size(), outside, outside == 1 ? "lies" : "lie",
      (1 - predictive_level) * static_cast<double>(agreements.size()));
}

}  // namespace ikbench::slim2023
