// A paper's claims one by one: whether each holds here, and by which numbers.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/table.hpp"

namespace ikbench::report {

// depends: the answer depends on what the paper leaves open. untested: nothing here could decide it. incomparable: it
// is about another program or machine.
enum class Verdict { holds, in_part, undecided, fails, depends, untested, incomparable };
std::string_view name_of(Verdict verdict);

enum class Claimant { paper, us };  // who made the claim: the paper, or we added it

struct Claim {
  std::string statement;
  Verdict verdict;
  std::vector<std::string>
      evidence;       // sentences with numbers from the store, unless said to be printed; the most telling first
  std::string table;  // the name of the table that has the numbers
  std::optional<Verdict> printed = {};  // verdict by the printed numbers only; nullopt if they cannot tell
  std::string id = {};                  // "most_accurate"; joins other results to the claim
  std::string section = {};             // section of the paper
  Claimant by = Claimant::paper;
  std::string decides = {};                  // a sentence on what would decide it
  std::string number = {};                   // the most telling number, short: "0.0017 against 0.21 cm"
  std::vector<std::string> depends_on = {};  // what the verdict depends on, most important first: "who obeys limits"
};

// "depends on who obeys limits (+2)"
std::string verdict_words(const Claim& claim);

std::string evidence_text(const Claim& claim);  // all of it

// One row per claim; leaves out a column that no claim fills.
Table claims_table(const std::vector<Claim>& claims, std::string name, std::string caption);

// One row per claim for a screen and for JSON: here, printed, number, claim, id, by, section, depends_on. The verdicts
// are single words: "holds", "in part", "undecided", "fails", "depends", "untested",
// "incomparable".
Table verdict_table(const std::vector<Claim>& claims);

std::vector<Claim> claims_by(Claimant by, const std::vector<Claim>& claims);

// A sentence that counts how many of the paper's claims hold here; our own questions do not count.
std::string tally(const std::vector<Claim>& claims);

// Shares of all interpretations of what a paper leaves open in which a claim holds, fails and is undecided.
struct ClaimShares {
  std::string id;
  double holds = 0, fails = 0, undecided = 0;
  std::vector<std::string> decided_by = {};  // dimensions that change the answer most: "who obeys limits"
  std::string sentence = {};                 // how
  // Of the interpretations that fit the printed numbers; not defined if none does.
  double fitting_holds = statistics::not_defined, fitting_fails = statistics::not_defined;
};

// Smallest share of interpretations at which a claim keeps its verdict; below, it depends.
constexpr double clear_share = 0.95;

// "61 %"; "under 1 %" and "over 99 %" if the share is not exactly 0 or 1.
std::string share_words(double share);

// Joins shares to claims by id. A claim keeps its verdict if that has a clear share; else it depends. Each states its
// shares.
void join(std::vector<Claim>& claims, std::span<const ClaimShares> shares);

}  // namespace ikbench::report
