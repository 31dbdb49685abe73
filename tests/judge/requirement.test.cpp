// Requirements on shares: how they are read, how they are checked, and how often the check is wrong.
#include "analysis/judge/requirement.hpp"

#include <cmath>
#include <map>
#include <random>

#include "analysis/judge/judge.hpp"
#include "tests/common.hpp"

using namespace ikbench;
using namespace ikbench::judge;
using results::parse_requirement;
using results::Requirement;

namespace {

// The share of successes of one solver, whose values are not needed.
JudgedMetric metric_with(double share, int n) {
  JudgedMetric judged{.samples = {.metric = "solved", .quantity = "targets solved", .kind = Proportions{}}, .plan = {}};
  judged.samples.groups = {{.name = "mine", .sample = Sample{}}};
  judged.descriptives = {{.n = n, .mean = share}};
  return judged;
}

RequirementCheck check_of(double share, int n, double required) {
  return check_requirement(metric_with(share, n), "mine", required);
}

double binomial(int n, int k, double p) {
  return std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) + k * std::log(p) +
                  (n - k) * std::log1p(-p));
}

// The chances of the verdicts on a solver whose true share is the required one.
std::map<RequirementVerdict, double> chances(int n, double share) {
  std::map<RequirementVerdict, double> all;
  for (int k = 0; k <= n; ++k) all[check_of(double(k) / n, n, share).verdict] += binomial(n, k, share);
  return all;
}

}  // namespace

TEST_CASE("a requirement is read with and without a label", "[judge]") {
  CHECK(parse_requirement("solved=95%") == Requirement{.metric = "solved", .share = 0.95});
  CHECK(parse_requirement("LM 0.1.solved=99.5%") ==
        Requirement{.solver = "LM 0.1", .metric = "solved", .share = 0.995});
  CHECK(parse_requirement("a=b.in-time=50%") == Requirement{.solver = "a=b", .metric = "in-time", .share = 0.5});
  for (const char* const text : {"solved=95%", "mine.solved=99.5%"}) CHECK(parse_requirement(text).text() == text);
  for (const char* const text : {"", "solved", "solved=95", "solved=0%", "solved=100%", "solved=nan%", "time=95%",
                                 ".solved=95%", "error=1%", "solved=-5%", "solved=95%%"})
    CHECK_THROWS_AS(parse_requirement(text), std::invalid_argument);
}

TEST_CASE("the interval of a share decides a requirement", "[judge]") {
  CHECK(check_of(1, 100, 0.95).verdict == RequirementVerdict::met);
  CHECK(check_of(0.43, 100, 0.95).verdict == RequirementVerdict::failed);
  const RequirementCheck open = check_of(0.97, 100, 0.95);
  CHECK(open.verdict == RequirementVerdict::inconclusive);
  // So many more of the same share do meet it, and one in a hundred fewer do not.
  const auto more = static_cast<int>(open.more_values);
  CHECK(check_of(0.97, 100 + more, 0.95).verdict == RequirementVerdict::met);
  CHECK(check_of(0.97, 100 + more * 99 / 100, 0.95).verdict == RequirementVerdict::inconclusive);
  CHECK(check_of(0.95, 100, 0.95).more_values == 0);  // no number would show it
  CHECK(check_of(0.93, 100, 0.95).more_values == 0);
  CHECK(check_of(1, 20, 0.95).more_values > 0);

  const RequirementCheck met = check_of(1, 100, 0.95), failed = check_of(0, 100, 0.95);
  RequirementCheck strict = open;
  strict.is_strict = true;
  CHECK(exit_code({}) == 0);
  CHECK(exit_code({met, open}) == 0);
  CHECK(exit_code({met, strict}) == 4);
  CHECK(exit_code({strict, failed}) == 3);
}

TEST_CASE("what is missing, excluded or without chance decides no requirement by an interval", "[judge]") {
  JudgedMetric judged = metric_with(1, 3);
  judged.samples.groups[0].sample = Sample{.values = {1}, .is_deterministic = true};
  CHECK(check_requirement(judged, "mine", 0.99).verdict == RequirementVerdict::met);
  judged.samples.groups[0].sample = ExcludedSample{.missing = 2};
  CHECK(check_requirement(judged, "mine", 0.1).verdict == RequirementVerdict::inconclusive);
  judged.samples.groups[0].sample = ExcludedSample{.reason = ExclusionReason::not_comparable};
  judged.samples.warnings = {
      {.kind = WarningKind::time_limit_decides, .solvers = {"mine"}, .detail = "the machine was busy"}};
  const RequirementCheck limited = check_requirement(judged, "mine", 0.1);
  CHECK(limited.verdict == RequirementVerdict::inconclusive);
  CHECK(limited.reason.ends_with("the machine was busy"));
}

TEST_CASE("a requirement is met or failed wrongly as rarely as methods.md says", "[judge]") {
  for (const double share : {0.5, 0.9, 0.95, 0.99}) {
    for (int n = 20; n <= 1000; n += n < 200 ? 1 : 7) {
      const std::map<RequirementVerdict, double> all = chances(n, share);
      const auto chance = [&](RequirementVerdict verdict) { return all.contains(verdict) ? all.at(verdict) : 0; };
      INFO(share << " of " << n);
      CHECK(chance(RequirementVerdict::met) < 0.04);
      if (share == 0.99)
        CHECK(chance(RequirementVerdict::failed) < 0.11);
      else
        CHECK(chance(RequirementVerdict::failed) < (n < 100 ? 0.08 : 0.05));
    }
  }
}

TEST_CASE("runs that share targets meet a requirement wrongly no more often", "[judge]") {
  // Each target has a difficulty of its own: a share of successes drawn around the required mean.
  std::mt19937_64 engine(11);
  constexpr double required = 0.9;
  constexpr int targets = 50, runs = 10, sets = 2000;
  for (const double easy : {0.92, 1.0}) {  // of an easy target; one in five is harder
    const double hard = required * 5 - easy * 4;
    int met = 0;
    for (int set = 0; set < sets; ++set) {
      double sum = 0;
      for (int target = 0; target < targets; ++target) {
        const bool is_hard = std::uniform_int_distribution<int>(0, 4)(engine) == 0;
        sum += std::binomial_distribution<int>(runs, is_hard ? hard : easy)(engine) / double(runs);
      }
      met += check_of(sum / targets, targets, required).verdict == RequirementVerdict::met;
    }
    CHECK(met < sets / 25);
  }
}
