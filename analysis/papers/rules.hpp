// The rules that judge claims. A rule gives a claim a verdict, a number and the evidence. claims.cpp calls the rule of
// each claim once; multiverse.cpp counts how the claims do in all interpretations.
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

// The verdict of a claim, in the order of the tables.
// holds: the claim holds for all of its parts.
// in_part: the claim holds for some of its parts, and fails for others.
// fails: the claim fails.
// inconclusive: more data could show either.
// not_tested: the data here cannot decide the claim.
enum class Holds { holds, in_part, fails, inconclusive, not_tested };
// Returns the word for a verdict.
std::string_view name_of(Holds holds);

// The number of interpretations of a paper in which a claim holds, fails, or stays open. Each seed of an interpretation
// counts by itself.
struct InReadings {
  std::int64_t hold = 0, fail = 0, open = 0;
  std::int64_t seeds = 1;      // of each interpretation
  std::string most_fail = {};  // the answer, other than a default, with most failures: "118 with a=1 (its reason)"

  // Returns the number of all interpretations.
  std::int64_t all() const { return hold + fail + open; }
};
// Returns "288 interpretations with 3 seeds each (864)", or only "288 interpretations" if there is one seed.
std::string interpretations_text(std::int64_t interpretations, std::int64_t seeds);

// A claim with its verdict.
struct JudgedClaim : Claim {
  Holds holds = Holds::not_tested;
  std::string number = {};      // the most telling one: "0.0017 cm, K-ABC 0.21"
  std::string rival = {};       // the part of `number` about the best rival: "K-ABC 0.21"
  std::string evidence = {};    // what tables do not say, in at most two sentences
  InReadings in_readings = {};  // no counts: the interpretations do not judge the claim
};

// The results of a rule for one claim. Empty if the report has nothing to judge. There are several results if the
// sentence of the claim is about each "{solver}".
using JudgedClaims = std::vector<JudgedClaim>;

// A rule with the name that the file of a paper uses.
struct Rule {
  std::string_view name;
  JudgedClaims (*verdict)(const Claim& claim, const Repeated& repeated);
  bool is_of_metrics = true;
};
// Returns all rules:
// better: the claim's solvers are better than the others in each metric.
// ahead: the claim's solver is better than each other one in some metric, and worse in none.
// differ: all solvers differ, by one-way ANOVA.
// at_rounding: all errors of the claim's solver are at rounding.
// as_printed: our share of solved targets agrees with each printed one.
// solves_most: the share solved of the claim's solver is the largest on each arm.
// as_counted: the least and the largest number of answers of the claim's program are the printed ones on each arm.
std::span<const Rule> rules();

// The number of pairs of solvers with each verdict.
struct Tally {
  int better = 0, worse = 0, open = 0, untested = 0;

  // Adds a pair.
  void add(judge::Verdict verdict);
  // Returns the number of all pairs.
  int all() const { return better + worse + open + untested; }
};
// Returns fails if a pair is worse, holds if all pairs are better, not_tested if no pair was tested, and inconclusive
// otherwise.
Holds holds_of(const Tally& tally);
// Returns in_part if a part does or if some parts hold and others fail, the verdict of the parts if all are alike, and
// inconclusive otherwise. `parts` must not be empty.
Holds holds_of(const std::vector<Holds>& parts);

// Returns the samples with each value replaced by its distance from the median of the value's group. The means of these
// distances are compared in place of spreads (Brown and Forsythe, JASA 69 (1974) 364).
judge::MetricSamples deviations(judge::MetricSamples samples);

// Returns the verdict of the first solver against the second; not_tested if they are no pair.
judge::Verdict verdict_between(const judge::JudgedMetric& judged, std::string_view first, std::string_view second);

}  // namespace ikbench::papers
