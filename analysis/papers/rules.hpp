// The rules that judge claims.
#pragma once

#include <string_view>
#include <vector>

#include "analysis/papers/claims.hpp"
#include "numerics/names.hpp"

namespace ikbench::papers {

// What a rule finds; none if the report has nothing to judge; several if the sentence is about each solver and arm:
// "{solver} on the {arm}".
using Found = std::vector<JudgedClaim>;

struct Rule {
  std::string_view name;
  Found (*judge)(const Claim& claim, const Repeated& of);
  bool is_of_metrics = true;
};
// better: its solvers are better than the others in each metric. ahead: its solver is better than each other in some
// metric, and worse in none. differ: all differ, by one-way ANOVA. ratios: of times, which are not compared.
// at_rounding: all of its solver's errors are. as_printed: each printed share of solved targets is ours.
numerics::Choices<const Rule*> rules();

JudgedClaim begun(const Claim& claim);  // without a verdict

// How solvers do against others.
struct Tally {
  int better = 0, worse = 0, open = 0, untested = 0;

  void add(compare::Verdict verdict);
  int all() const { return better + worse + open + untested; }
};
// All better: holds; one worse: fails; some better: in part; one open: not decided.
Holds holds_of(const Tally& tally);
Holds holds_of(const std::vector<Holds>& parts);  // all hold, some, or none

// Each value as its distance from its group's median (Brown and Forsythe, JASA 69 (1974) 364), whose means are compared
// in place of spreads.
compare::Observations deviations(compare::Observations of);

// Of the first, in the findings of either order.
compare::Verdict verdict_between(const compare::Judged& judged, std::string_view first, std::string_view second);

}  // namespace ikbench::papers
