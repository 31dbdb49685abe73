#include "analysis/slim2023/audit_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/inference/text.hpp"
#include "analysis/slim2023/audit_items.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/multiple_comparisons.hpp"
#include "analysis/statistics/welch.hpp"
#include "results/published.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

struct Measured {
  Metric metric;
  std::string_view words;
  std::string anova;  // the table of its ANOVA
};
const std::array<Measured, 3> measured_metrics{Measured{Metric::position_error_cm, "error", "table-4"},
                                               Measured{Metric::variation_deg, "variation", "table-5"},
                                               Measured{Metric::seconds, "time", "table-6"}};

// "3.1d" is the fourth of "3.1".
std::string lettered(std::string_view item, std::size_t index) {
  return fmt::format("{}{}", item, static_cast<char>('a' + index));
}

std::string_view words_for(Metric metric) {
  return std::ranges::find(measured_metrics, metric, &Measured::metric)->words;
}

std::string table_words(const std::string& name) { return "Table " + name.substr(name.size() - 1); }

std::vector<GroupSummary> summaries(std::string_view paper, Metric metric) {
  std::vector<GroupSummary> groups;
  for (const PrintedRow& row : printed_table_3(paper, metric)) groups.push_back(row.summary);
  return groups;
}

// What half a unit of every printed mean and standard deviation may change F by, all in the same direction.
double slack_of_f(std::string_view paper, Metric metric) {
  const CsvTable table = published::table(paper, "table-3");
  const std::vector<GroupSummary> groups = summaries(paper, metric);
  const double F = anova_from_summaries(groups).F;
  double slack = 0;
  std::size_t group = 0;
  for (const auto& row : table.rows) {
    if (row[table.column("metric")] != name_of(metric)) continue;
    for (const auto& [column, field] : {std::pair("mean", &GroupSummary::mean), std::pair("std", &GroupSummary::std)}) {
      std::vector<GroupSummary> moved = groups;
      moved[group].*field += half_unit(row[table.column(column)]);
      slack += std::abs(anova_from_summaries(moved).F - F);
    }
    ++group;
  }
  return slack;
}

// A pair of the printed Table 3 among all of them: with one variance for all, as ANOVA has it, and with each its own.
struct PairTest {
  double pooled = not_defined;
  double unpooled = not_defined;
};

PairTest test_of(std::string_view paper, std::string_view a, std::string_view b, Metric metric) {
  const std::vector<PrintedRow> rows = printed_table_3(paper, metric);
  const auto place = [&](std::string_view algorithm) {
    return static_cast<std::size_t>(std::ranges::find(rows, algorithm, &PrintedRow::algorithm) - rows.begin());
  };
  const auto p_of = [&](const std::vector<MeanDifference>& pairs) {
    for (const MeanDifference& pair : pairs) {
      if (std::minmax(pair.first, pair.second) == std::minmax(place(a), place(b))) return pair.p;
    }
    return not_defined;
  };
  const std::vector<GroupSummary> groups = summaries(paper, metric);
  return {.pooled = p_of(tukey(groups, 0.95)), .unpooled = p_of(games_howell(groups, 0.95))};
}

// A row of five statistics that no sample could have: the reason, or empty.
std::string impossible(double mean, double median, double std, double max, double min, double n) {
  if (mean > max) return "the mean exceeds the maximum";
  if (mean < min) return "the mean is below the minimum";
  if (median > max || median < min) return "the median is outside the extremes";
  // Popoviciu's inequality for the sample standard deviation.
  if (std > (max - min) / 2 * std::sqrt(n / (n - 1))) return "the standard deviation exceeds what the extremes allow";
  // The mean and the median are at most one standard deviation (divided by n) apart.
  if (std::abs(mean - median) > std * std::sqrt((n - 1) / n)) return "mean and median are too far apart";
  return "";
}

}  // namespace

AuditItems anova_items(std::string_view paper) {
  AuditItems items;
  for (std::size_t i = 0; i < measured_metrics.size(); ++i) {
    const auto& [metric, words, name] = measured_metrics[i];
    const CsvTable table = published::table(paper, name);
    const std::string& printed = table.rows[0][table.column("f")];
    const double F = anova_from_summaries(summaries(paper, metric)).F;
    items.push_back({lettered("3.1", i), fmt::format("{}: F of the {}", table_words(name), words), printed,
                     fmt::format("{:.4f}", F), judged(printed, F, slack_of_f(paper, metric)),
                     "F follows from the means and standard deviations of Table 3 with 20 values per group."});
  }
  for (std::size_t i = 0; i < measured_metrics.size(); ++i) {
    const std::string& name = measured_metrics[i].anova;
    const CsvTable table = published::table(paper, name);
    const std::string& printed = table.rows[0][table.column("p")];
    const double F = table.number(0, "f");
    const auto p_of = [&](double value) { return f_upper_tail(value, table.number(0, "df"), table.number(1, "df")); };
    const double slack = p_of(F - half_unit(table.rows[0][table.column("f")])) - p_of(F);
    items.push_back({lettered("3.1", 3 + i), fmt::format("{}: p of its F", table_words(name)), printed,
                     rounded_number(p_of(F), 5), judged(printed, p_of(F), slack),
                     "The printed p is the upper tail of the F distribution at the printed F."});
  }
  const Statements statements(paper);
  const auto algorithms = static_cast<double>(summaries(paper, Metric::seconds).size());
  const CsvTable table = published::table(paper, "table-4");
  const std::string& df = table.rows[1][table.column("df")];
  const double follows = algorithms * statements.number("runs") - algorithms;
  items.push_back(
      {"3.1g", "Tables 4-6: degrees of freedom", df, fmt::format("{}", follows), judged(df, follows, 0),
       "One observation is the mean of a run over its points; there are six algorithms with 20 runs each."});
  return items;
}

AuditItems variance_items(std::string_view paper) {
  AuditItems items;
  for (std::size_t i = 0; i < measured_metrics.size(); ++i) {
    const auto& [metric, words, name] = measured_metrics[i];
    const std::vector<GroupSummary> groups = summaries(paper, metric);
    const auto [least, most] = std::ranges::minmax(groups, {}, &GroupSummary::std);
    const double ratio = (most.std / least.std) * (most.std / least.std);
    const auto pairs = static_cast<double>(groups.size() * (groups.size() - 1));
    const bool unequal = f_upper_tail(ratio, most.n - 1, least.n - 1) * pairs < 0.05;
    items.push_back(
        {lettered("3.2", i), fmt::format("{}: variances of the {}", table_words(name), words),
         "one-way ANOVA, which assumes equal variances",
         fmt::format("largest / smallest = {}; level {} instead of 0.05", rounded_number(ratio, 3),
                     rounded_number(level_of_anova(groups, 0.05), 2)),
         unequal ? AuditVerdict::unsupported : AuditVerdict::consistent,
         "The variances differ if p of their F test, times the number of pairs, is below 0.05. The level is "
         "about how often ANOVA then finds a difference that is not there (Box 1954). Welch's test below does without "
         "the assumption."});
  }
  for (std::size_t i = 0; i < measured_metrics.size(); ++i) {
    const auto& [metric, words, name] = measured_metrics[i];
    const WelchAnova test = welch_anova(summaries(paper, metric));
    const CsvTable table = published::table(paper, name);
    items.push_back({lettered("3.2", 3 + i), fmt::format("{}: {} without equal variances", table_words(name), words),
                     fmt::format("F {}, p {}", table.rows[0][table.column("f")], table.rows[0][table.column("p")]),
                     fmt::format("Welch F {:.2f}, p {}", test.F, rounded_number(test.p, 3)),
                     test.p < 0.05 ? AuditVerdict::consistent : AuditVerdict::unsupported,
                     "Without this assumption, the means still differ."});
  }

  struct Pair {
    std::string id, a, b;
    Metric metric;
  };
  for (const Pair& pair :
       {Pair{"3.2g", "IK-BA", "DE", Metric::position_error_cm},
        Pair{"3.2h", "IK-BA", "K-ABC", Metric::position_error_cm},
        Pair{"3.2i", "IK-BA", "MO-PSO", Metric::variation_deg}, Pair{"3.2j", "PSO", "IK-BA", Metric::seconds}}) {
    const double a = printed_row(paper, pair.a, pair.metric).value().summary.mean;
    const double b = printed_row(paper, pair.b, pair.metric).value().summary.mean;
    const auto [pooled, unpooled] = test_of(paper, pair.a, pair.b, pair.metric);
    const bool below = unpooled < 0.05;
    std::string sentence =
        below ? fmt::format("Without equal variances {} is below {}", pair.a, pair.b)
              : fmt::format("The numbers do not show that {} is below {}, nor that it is not", pair.a, pair.b);
    if (below && pooled >= 0.05) sentence += "; the pooled variance of the ANOVA would not show it";
    items.push_back({pair.id, fmt::format("Table 3: mean {} of {} and {}", words_for(pair.metric), pair.a, pair.b),
                     fmt::format("{} below {}", a, b),
                     fmt::format("p of all pairs: {} by Games-Howell, {} by Tukey", rounded_number(unpooled, 3),
                                 rounded_number(pooled, 3)),
                     below ? AuditVerdict::consistent : AuditVerdict::unsupported, sentence + "."});
  }
  return items;
}

AuditItems summary_items(std::string_view paper) {
  AuditItems items;
  const CsvTable table = published::table(paper, "table-7");
  std::vector<GroupSummary> per_bat;
  std::vector<std::string> shown;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto number = [&](std::string_view column) { return table.number(row, column); };
    const double bats = number("bats"), n = number("n");
    const std::string reason =
        impossible(number("mean_ms"), number("median_ms"), number("std_ms"), number("max_ms"), number("min_ms"), n);
    items.push_back({lettered("3.3", row), fmt::format("Table 7, {} bats", bats),
                     fmt::format("mean {}, std {}, max {}", number("mean_ms"), number("std_ms"), number("max_ms")),
                     reason.empty() ? "possible" : reason,
                     reason.empty() ? AuditVerdict::consistent : AuditVerdict::misprint,
                     "The mean, median and spread of a sample must fit its extremes."});
    if (reason.empty()) {
      per_bat.push_back({number("mean_ms") / bats, number("std_ms") / bats, static_cast<int>(n)});
      shown.push_back(fmt::format("{} bats {:.2f}", bats, number("mean_ms") / bats));
      continue;
    }
    const double most = (number("max_ms") - number("min_ms")) / 2 * std::sqrt(n / (n - 1));
    items.back().sentence = number("std_ms") > most
                                ? fmt::format(
                                      "No sample has these numbers. The std {} also exceeds the {:.1f} that the "
                                      "extremes allow, so the maximum is wrong.",
                                      number("std_ms"), most)
                                : "No sample has these numbers. It is unknown which of the five is wrong.";
  }
  const double p = welch_anova(per_bat).p;
  items.push_back({lettered("3.3", items.size()), "Table 7: time by bats, possible rows",
                   fmt::format("{} ms per bat", fmt::join(shown, ", ")),
                   fmt::format("{}: Welch p {}", p < 0.05 ? "they differ" : "undecided", rounded_number(p, 2)),
                   p < 0.05 ? AuditVerdict::unsupported : AuditVerdict::consistent,
                   "Welch's test of the mean time per bat. Undecided does not mean equal: the times vary widely."});

  const CsvTable results = published::table(paper, "table-3");
  std::vector<std::string> wrong;
  for (std::size_t row = 0; row < results.rows.size(); ++row) {
    const auto number = [&](std::string_view column) { return results.number(row, column); };
    const std::string reason =
        impossible(number("mean"), number("median"), number("std"), number("max"), number("min"), number("n"));
    if (!reason.empty()) wrong.push_back(fmt::format("row {}: {}", row + 1, reason));
  }
  items.push_back({lettered("3.3", items.size()), "Table 3, row by row",
                   fmt::format("{} rows of five statistics", results.rows.size()),
                   wrong.empty() ? "all possible" : fmt::format("{}", fmt::join(wrong, "; ")),
                   wrong.empty() ? AuditVerdict::consistent : AuditVerdict::misprint,
                   "The mean, median and spread of a sample must fit its extremes."});
  return items;
}

}  // namespace ikbench::slim2023
