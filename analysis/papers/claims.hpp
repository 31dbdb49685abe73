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

// With which answers to what a paper leaves open a claim fails.
struct Condition {
  std::string id;          // of the claim
  std::string fails;       // "only where bounds=initial", "nowhere"
  std::string words = {};  // the same as a clause; empty where no pair of answers tells it
};

struct JudgedClaim {
  std::string id, sentence, section;
  bool is_ours = false;
  Holds holds = Holds::not_tested;
  std::optional<Holds> printed = {};    // by the printed numbers alone, if they can tell
  std::string number = {};              // the most telling one: "0.0017 cm, K-ABC 0.21"
  std::string rival = {};               // its part of the best rival: "K-ABC 0.21"
  std::string evidence = {};            // what tables do not say, in at most two sentences
  Condition condition = {};             // empty if readings were not tried
  std::optional<Holds> otherwise = {};  // by the paper's other reading
  std::string number_otherwise = {};
};

// In the order of the paper's file. A claim that the report cannot judge is not tested; our own questions, and claims
// that are made of each solver, are left out instead.
std::vector<JudgedClaim> judged_claims(const Repeated& of, const std::vector<Condition>& conditions = {});

const JudgedClaim* claim_named(const std::vector<JudgedClaim>& claims, std::string_view id);  // null if it is not there
std::string tally_words(const std::vector<JudgedClaim>& claims);  // "3 claims: holds 2, fails 1."

// The sentences, which paper it is, and the table.
show::Blocks beginning(const Paper& paper, const std::vector<std::string>& sentences, const show::Table& table);
// Grouped by verdict: the claims, then our own questions.
show::Blocks claims_section(const std::vector<JudgedClaim>& claims);
// What `reproduce` ends with: some sentences, a line a claim.
std::string screen(const std::vector<std::string>& sentences, const std::vector<JudgedClaim>& claims);

}  // namespace ikbench::papers
