// The claims of a paper, each with a verdict, a number and why.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/papers/paper.hpp"

namespace ikbench::papers {

// in_part: for some of those that it is about. not_comparable: about another program or machine. not_tested: nothing
// here can decide it.
enum class Holds { holds, in_part, fails, undecided, not_comparable, not_tested };
std::string_view name_of(Holds holds);

// Shares of all readings of what a paper leaves open.
struct Shares {
  double holds = 0, fails = 0, undecided = 0;

  double all() const { return holds + fails + undecided; }
  void operator+=(const Shares& more);
};
struct SharesOfClaim {
  std::string id;
  Shares all, near = {};  // near: of the readings that are near the print
};

struct JudgedClaim {
  std::string id, sentence, section;
  bool is_ours = false;
  Holds holds = Holds::not_tested;
  std::optional<Holds> printed = {};  // by the printed numbers alone, if they can tell
  std::string number = {};            // the most telling one: "mean 0.0017 cm, K-ABC 0.21"
  std::string evidence = {};          // at most two sentences
  std::optional<SharesOfClaim> shares = {};
};

// In the order of the paper's file. A claim that the report cannot judge is not tested; our own questions, claims that
// are made of each solver, and all such claims where the study departs from the paper are left out instead.
std::vector<JudgedClaim> judged_claims(const Repeated& of, const std::vector<SharesOfClaim>& shares = {});

const JudgedClaim* claim_named(const std::vector<JudgedClaim>& claims, std::string_view id);  // null if it is not there
std::string percent(double share);                   // "61 %"; "< 1 %" and "> 99 %" if it is not quite 0 or 1
std::string shares_words(const JudgedClaim& claim);  // "holds in 20 %, fails in 36 %"; empty if not known

// Grouped by verdict: the claims, then our own questions.
show::Blocks claims_section(const std::vector<JudgedClaim>& claims);
// What `reproduce` ends with: some sentences, the means beside the printed ones, a line a claim, and further lines.
std::string screen(const std::vector<std::string>& sentences, const show::Table& table,
                   const std::vector<JudgedClaim>& claims, const std::vector<std::string>& rest);

}  // namespace ikbench::papers
