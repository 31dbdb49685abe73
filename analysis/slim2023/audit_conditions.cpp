#include "analysis/slim2023/audit_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/inference/text.hpp"
#include "analysis/slim2023/audit_items.hpp"
#include "analysis/slim2023/published_numbers.hpp"

namespace ikbench::slim2023 {

using namespace statistics;
using namespace inference;
using namespace report;

namespace {

// Whether a particle's mean position converges (Trelea, Information Processing Letters 85 (2003) 317).
bool is_stable(double w, double c1, double c2) { return w < 1 && c1 + c2 > 0 && (c1 + c2) / 2 < 2 * (1 + w); }

AuditItem stability(const std::string& id, const std::string& where, double w, double c1, double c2) {
  const bool stable = is_stable(w, c1, c2);
  return {id,
          where,
          fmt::format("w {}, c1 {}, c2 {}", w, c1, c2),
          stable ? "converges" : fmt::format("diverges: w = {} is not below 1", w),
          unless(stable, AuditVerdict::misprint),
          "Velocities grow without bound unless w < 1 and (c1 + c2) / 2 < 2 (1 + w)."};
}

}  // namespace

AuditItems parameter_items(std::string_view paper) {
  const Statements statements(paper);
  const double alpha = statements.number("ik_ba_alpha"), gamma = statements.number("ik_ba_gamma");
  const double iterations = statements.number("iterations");
  AuditItems items;
  items.push_back(
      {"3.6a", "Table 1 against Eq. 9: alpha", statements.text("alpha_words"),
       fmt::format("{}^{:.0f} = {}: A decreases", alpha, iterations, rounded_number(std::pow(alpha, iterations), 2)),
       unless(alpha > 1, AuditVerdict::misprint), "A <- alpha A with alpha below 1 reduces the loudness."});
  items.push_back(
      {"3.6b", "Table 1 against Eq. 10: gamma", statements.text("gamma_words"),
       fmt::format("1 - exp(-{} t) = {} at t = 10: r increases", gamma, rounded_number(1 - std::exp(-10 * gamma), 2)),
       unless(gamma < 0, AuditVerdict::misprint), "r = r0 (1 - exp(-gamma t)) grows towards r0."});
  const double w = statements.number("pso_w"), c1 = statements.number("pso_c1"), c2 = statements.number("pso_c2");
  items.push_back(stability("3.6c", "Table 1: PSO as printed", w, c1, c2));
  items.push_back(stability("3.6d", "Table 1: PSO, labels permuted", c2, w, c1));
  return items;
}

AuditItems condition_items(std::string_view paper) {
  const Statements statements(paper);
  AuditItems items;
  items.push_back(
      {"3.7a", fmt::format("{} against {}", statements.source("population"), statements.source("population_of_test")),
       fmt::format("{} agents", statements.text("population")),
       fmt::format("{} agents", statements.text("population_of_test")),
       unless(statements.number("population") == statements.number("population_of_test"), AuditVerdict::contradiction),
       "The paper gives two swarm sizes for the test of Table 3."});
  const std::vector<PrintedTime> times = printed_table_7(paper);
  const PrintedTime& fewest = times.front();
  items.push_back(
      {"3.7b", fmt::format("{}: real time with {} bats", statements.source("real_time_words"), fewest.bats),
       fmt::format("\"{}\" and \"{}\"", statements.text("real_time_words"), statements.text("real_time_words_too")),
       fmt::format("Table 7: mean {} ms, maximum {} ms", fewest.mean_ms, fewest.max_ms),
       unless(statements.text("real_time_words") == statements.text("real_time_words_too"),
              AuditVerdict::contradiction),
       "Real time is said not to be met, and to be met; the mean meets it, the slowest solve does not."});
  std::string bats;
  for (const PrintedTime& row : times) bats += fmt::format("{}{}", bats.empty() ? "" : " ", row.bats);
  items.push_back({"3.7c", fmt::format("{} against Table 7: numbers of bats", statements.source("bats_in_text")),
                   statements.text("bats_in_text"), bats,
                   unless(statements.text("bats_in_text") == bats, AuditVerdict::misprint),
                   "The text does not name every swarm that Table 7 has."});

  const double solve = statements.number("population") * statements.number("iterations");
  const double factor = statements.number("k_abc_evaluations_a_source");
  const auto seconds = [&](std::string_view algorithm) {
    return printed_row(paper, algorithm, Metric::seconds).value().summary.mean;
  };
  items.push_back({"3.8a", "Sec. 5.2: equal iterations",
                   fmt::format("{} iterations for all", statements.text("iterations")),
                   fmt::format("evaluations: K-ABC {:.0f}, PSO {:.0f}", factor * solve, solve),
                   unless(factor == 1, AuditVerdict::unsupported),
                   fmt::format("Equal iterations do not mean equal effort: K-ABC evaluates sources and onlookers, and "
                               "its printed time is {:.1f} times PSO's.",
                               seconds("K-ABC") / seconds("PSO"))});
  const auto variation = [&](std::string_view algorithm) {
    return printed_row(paper, algorithm, Metric::variation_deg).value().summary.mean;
  };
  double least = variation("BA");
  for (const std::string_view algorithm : {"DE", "PSO", "K-ABC"}) least = std::min(least, variation(algorithm));
  items.push_back(
      {"3.8b", fmt::format("{}: equal starts", statements.source("start_of_ik_ba")), statements.text("start_of_ik_ba"),
       fmt::format("variation of BA, DE, PSO, K-ABC at least {:.1f} times IK-BA's", least / variation("IK-BA")),
       AuditVerdict::unsupported,
       "Solvers that start at random and do not know Theta_s cannot stay near it, so the starts are not equal."});
  items.push_back({"3.9a", "Tables 3 and 6: computing time",
                   fmt::format("taken on {} machines", statements.text("machines")),
                   "only ratios on one machine can be compared",
                   unless(statements.number("machines") == 1, AuditVerdict::unsupported),
                   "Table 6 tests the times as if they came from one machine."});
  std::string faster;
  for (const PrintedRow& row : printed_table_3(paper, Metric::seconds)) {
    if (row.summary.mean < seconds("IK-BA")) faster += fmt::format(" {} {} s", row.algorithm, row.summary.mean);
  }
  items.push_back(
      {"3.9b", fmt::format("{} against Table 3", statements.source("time_words")), statements.text("time_words"),
       faster.empty() ? "IK-BA is the fastest" : fmt::format("IK-BA {} s, faster:{}", seconds("IK-BA"), faster),
       unless(faster.empty(), AuditVerdict::contradiction),
       "Of the challengers in Table 3, one takes less time than IK-BA."});
  return items;
}

}  // namespace ikbench::slim2023
