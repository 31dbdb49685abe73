// The claims of a paper, each with a verdict, a number and why.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/papers/paper.hpp"

namespace ikbench::papers {

// in_part: for some of those that it is about. not_compared: about another program or machine. not_tested: nothing here
// can decide it. Tables have them in this order.
enum class Holds { holds, in_part, fails, undecided, not_compared, not_tested };
std::string_view name_of(Holds holds);
constexpr bool is_judged(Holds holds) { return holds != Holds::not_compared && holds != Holds::not_tested; }

// Shares of all readings of what a paper leaves open.
struct Shares {
  double holds = 0, fails = 0, undecided = 0;

  double all() const { return holds + fails + undecided; }
  double part(double share) const { return all() > 0 ? share / all() : compare::unknown; }
  void add(const Shares& more, double weight = 1);
};
struct SharesOfClaim {
  std::string id;
  Shares all, near = {};  // near: of the readings that are near the print
};

struct JudgedClaim {
  std::string id, sentence, section;
  bool is_ours = false;
  Holds holds = Holds::not_tested;
  std::optional<Holds> printed = {};    // by the printed numbers alone, if they can tell
  std::string number = {};              // the most telling one: "0.0017 cm, K-ABC 0.21"
  std::string rival = {};               // its part of the best rival: "K-ABC 0.21"
  std::string evidence = {};            // what tables do not say, in at most two sentences
  SharesOfClaim shares = {};            // of no reading if they are not known
  std::optional<Holds> otherwise = {};  // by the paper's other reading
  std::string number_otherwise = {};
};

// In the order of the paper's file. A claim that the report cannot judge is not tested; our own questions, and claims
// that are made of each solver, are left out instead.
std::vector<JudgedClaim> judged_claims(const Repeated& of, const std::vector<SharesOfClaim>& shares = {});

const JudgedClaim* claim_named(const std::vector<JudgedClaim>& claims, std::string_view id);  // null if it is not there
std::string percent(double share);                   // "61 %"; "< 1 %" and "> 99 %" if it is not quite 0 or 1
std::string shares_words(const JudgedClaim& claim);  // "holds in 20 %, fails in 36 %"; empty if not known
std::string tally_words(const std::vector<JudgedClaim>& claims);  // "3 claims: holds 2, fails 1."

// The sentences, which paper it is, and the table.
show::Blocks beginning(const Paper& paper, const std::vector<std::string>& sentences, const show::Table& table);
// Grouped by verdict: the claims, then our own questions.
show::Blocks claims_section(const std::vector<JudgedClaim>& claims);
// What `reproduce` ends with: some sentences, a line a claim.
std::string screen(const std::vector<std::string>& sentences, const std::vector<JudgedClaim>& claims);

}  // namespace ikbench::papers
