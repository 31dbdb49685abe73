// The rules that judge claims: each finds a verdict, a number and why.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/judge.hpp"
#include "analysis/papers/paper.hpp"

namespace ikbench::papers {

struct Repeated;  // repeated.hpp

// in_part: for some of those that it is about, and not for others. undecided: more data could show either. not_tested:
// nothing here can decide it. Tables have them in this order.
enum class Holds { holds, in_part, fails, undecided, not_tested };
std::string_view name_of(Holds holds);

// In how many readings of what a paper leaves open.
struct InReadings {
  std::int64_t hold = 0, fail = 0, open = 0;
  std::string most_fail = {};  // those of one answer, other than a default: "118 with a=1 (its reason)"

  std::int64_t all() const { return hold + fail + open; }
};

struct JudgedClaim : Claim {
  Holds holds = Holds::not_tested;
  std::string number = {};      // the most telling one: "0.0017 cm, K-ABC 0.21"
  std::string rival = {};       // its part of the best rival: "K-ABC 0.21"
  std::string evidence = {};    // what tables do not say, in at most two sentences
  InReadings in_readings = {};  // none: readings do not judge it
};

// The results of a rule. Empty: the report has nothing to judge. Several: the sentence is about each "{solver}".
using JudgedClaims = std::vector<JudgedClaim>;

struct Rule {
  std::string_view name;
  JudgedClaims (*verdict)(const Claim& claim, const Repeated& repeated);
  bool is_of_metrics = true;
};
// better: its solvers are better than the others in each metric. ahead: its solver is better than each other in some
// metric, and worse in none. differ: all differ, by one-way ANOVA. at_rounding: all of its solver's errors are.
// as_printed: each printed share of solved targets is ours. solves_most: the share of its solver is the largest on each
// arm.
std::span<const Rule> rules();

// How solvers do against others.
struct Tally {
  int better = 0, worse = 0, open = 0, untested = 0;

  void add(judge::Verdict verdict);
  int all() const { return better + worse + open + untested; }
};
// All better: holds; one worse: fails; else more data decide.
Holds holds_of(const Tally& tally);
// Returns whether all parts hold, some or none; undecided if open parts decide that. `parts` must not be empty.
Holds holds_of(const std::vector<Holds>& parts);

// Each value as its distance from its group's median (Brown and Forsythe, JASA 69 (1974) 364), whose means are compared
// in place of spreads.
judge::MetricSamples deviations(judge::MetricSamples samples);

// Returns the verdict of the first solver against the second; not_tested if they are no pair.
judge::Verdict verdict_between(const judge::JudgedMetric& judged, std::string_view first, std::string_view second);

}  // namespace ikbench::papers
