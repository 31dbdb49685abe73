// The verdict: a paper's claims one by one, whether each holds here, and by which numbers.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ikbench::report {

// depends: on what the paper leaves open. untested: nothing here could decide it.
enum class Verdict { holds, in_part, undecided, fails, depends, untested };
std::string_view name_of(Verdict verdict);

enum class By { paper, us };  // who claims it: the paper, or we asked

struct Claim {
  std::string statement;
  Verdict verdict;
  std::vector<std::string>
      evidence;  // sentences with numbers, all of the store but those said to be printed; first the one that says most
  std::string table;                    // the name of the table that has the numbers
  std::optional<Verdict> printed = {};  // on the printed numbers alone; none where they cannot say
  std::string id = {};                  // "most_accurate"; by it other results are joined
  std::string section = {};             // of the paper
  By by = By::paper;
  std::string decides = {};                  // what would decide it, a sentence
  std::string number = {};                   // the one that says most, short: "0.0017 against 0.21 cm"
  std::vector<std::string> depends_on = {};  // where it depends: "who obeys limits", the first the most
};

// "depends on who obeys limits (+2)"
std::string verdict_words(const Claim& claim);

std::string evidence_text(const Claim& claim);  // all of it

std::vector<Claim> claims_by(By by, const std::vector<Claim>& claims);

// How many of the paper's claims hold here, in a sentence; what we asked besides is not counted.
std::string tally(const std::vector<Claim>& claims);

// Of all interpretations of what a paper leaves open, the shares in which a claim holds, fails and is undecided.
struct ClaimShares {
  std::string id;
  double holds = 0, fails = 0, undecided = 0;
  std::vector<std::string> decided_by = {};  // what its answer depends on most: "who obeys limits"
  std::string sentence = {};                 // how
  std::string of = {};                       // how many interpretations: "576"
};

// The verdict on a claim that depends has not as much as that.
constexpr double clear_share = 0.95;

// "61 %"; "under 1 %" and "over 99 %" where it is neither none nor all.
std::string share_words(double share);

// By id. A claim keeps its verdict where that has a clear share, and else depends. All say their shares.
void join(std::vector<Claim>& claims, std::span<const ClaimShares> shares);

}  // namespace ikbench::report
