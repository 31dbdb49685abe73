#include "analysis/beeson2015/paper.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/beeson2015/solve_rates.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/study_pieces.hpp"

namespace ikbench::beeson2015 {

using namespace inference;
using namespace report;

namespace {

constexpr const char* this_paper = "beeson2015";
constexpr const char* of_readme = "README of TRAC-IK, table of solve rates";

// Why KDL's rate on an arm may differ from the printed one.
std::string_view known_reason(std::string_view arm) {
  if (arm == "KUKA LBR iiwa 14 R820") {
    return " The middle of its limits, where all solves start, is a singular configuration: a start 0.001 deg away already "
           "gives another rate (docs/paper-notes.md). Which rounding the authors' program had there is not known.";
  }
  if (arm == "Jaco2") {
    return " Four of its joints turn without end. Its file gives them limits of a whole turn all the same; with these the "
           "rate is near the printed one (docs/paper-notes.md). Which limits the authors had is not known.";
  }
  if (arm == "Baxter arm") return " Which tip and which limits the authors took is not said.";
  return "";
}

// One arm's two rates are of one number of iterations: what fits into 5 ms. So a rate depends on that number only where
// it can be the other rate's, too.
bool shares_iterations(const Rate& one, const Rate& other) {
  return one.first > 0 && (other.first == 0 || (one.first <= other.last && other.first <= one.last));
}

Claim rate_claim(const ArmRates& one, std::string_view solver, const Rate& rate, const Rate& other,
                 std::string_view why) {
  const auto& [estimate, low, high, undefined] = rate.ours;
  const bool holds = agrees(rate), depends = !holds && shares_iterations(rate, other);
  std::string reason;
  if (!holds && rate.first > 0)
    reason = fmt::format(" It is the printed share within {} to {} iterations", rate.first, rate.last);
  if (depends) reason += ". How many fit into the authors' 5 ms is not known.";
  if (!holds && !depends && rate.first > 0) {
    reason += fmt::format(", but the other rate on this arm takes {} to {}.", other.first, other.last);
  }
  if (!holds) reason += why;
  return {
      .statement = fmt::format("{} solves {:.2f} % on the {}", solver, 100 * rate.printed, one.arm),
      .verdict = !undefined.empty() ? Verdict::untested
                 : holds            ? Verdict::holds
                 : depends          ? Verdict::depends
                                    : Verdict::fails,
      .evidence = !undefined.empty()
                      ? "Not solved here."
                      : fmt::format("Here {:.1f} % are solved in {} iterations (99 % interval {:.1f} to {:.1f} %).{}",
                                    100 * estimate, one.iterations, 100 * low, 100 * high, reason),
      .table = "solve-rates",
      .id = fmt::format("rate-{}-{}", solver, one.arm),
      .section = of_readme,
      .decides =
          "The printed share is inside the 99 % interval of ours, in all iterations or, where it depends, in fewer, "
          "which are as many as the other rate on this arm needs.",
      .number = fmt::format("{:.1f} against {:.2f} %", 100 * estimate, 100 * rate.printed)};
}

Claim restarts_claim(const std::vector<ArmRates>& arms) {
  std::vector<std::string> shown, open, worse;
  for (const ArmRates& one : arms) {
    auto& names = one.restarts.relation == Relation::better  ? shown
                  : one.restarts.relation == Relation::worse ? worse
                                                             : open;
    names.push_back(
        fmt::format("{} ({} to {})", one.arm, percent(one.kdl.ours.estimate), percent(one.kdl_rr.ours.estimate)));
  }
  const auto listed = [](std::string_view words, const std::vector<std::string>& names) {
    return names.empty() ? "" : fmt::format("{}: {}. ", words, fmt::join(names, ", "));
  };
  return {.statement = "Restarts solve more, on every arm",
          .verdict = arms.empty()     ? Verdict::untested
                     : !worse.empty() ? Verdict::fails
                     : !open.empty()  ? Verdict::undecided
                                      : Verdict::holds,
          .evidence = listed("More are solved with restarts", shown) + listed("Not decided", open) +
                      listed("Fewer are solved with restarts", worse),
          .table = "solve-rates",
          .printed = Verdict::holds,
          .id = "restarts",
          .section = of_readme,
          .decides = "On every arm the judge finds a higher share of solved poses for KDL-RR.",
          .number = fmt::format("on {} of {} arms", shown.size(), arms.size())};
}

std::vector<Claim> claims(const Reported& reported) {
  const std::vector<ArmRates> arms = solve_rates(reported);
  std::vector<Claim> all;
  for (const ArmRates& one : arms) {
    all.push_back(rate_claim(one, "KDL", one.kdl, one.kdl_rr, known_reason(one.arm)));
    all.push_back(rate_claim(one, "KDL-RR", one.kdl_rr, one.kdl, ""));
  }
  all.push_back(restarts_claim(arms));
  all.push_back({.statement = "TRAC-IK solves most, on every arm",
                 .verdict = Verdict::untested,
                 .evidence = "TRAC-IK is not among the solvers.",
                 .table = "solve-rates",
                 .printed = Verdict::holds,
                 .id = "trac-ik",
                 .section = of_readme});
  return all;
}

StudyPieces pieces(const Reported& reported) {
  StudyPieces all = study_pieces(reported.study);
  const std::vector<ArmRates> arms = solve_rates(reported);
  if (arms.empty()) return all;
  all.tables.push_back(solve_rates_table(arms));
  all.tables.push_back(iterations_table(arms));
  all.figures.push_back(solve_rates_figure(arms));
  all.results = "solve-rates";
  return all;
}

}  // namespace

Paper paper() {
  return {
      .name = this_paper,
      .in_short = "TRAC-IK's table of solve rates",
      .citation =
          "Beeson and Ames: TRAC-IK: An Open-Source Library for Improved Solving of Generic Inverse "
          "Kinematics. Humanoids 2015, doi:10.1109/HUMANOIDS.2015.7363472; the table is that of its README, "
          "version 1.4.6.",
      .not_reproduced = "Not repeated: TRAC-IK itself, and 16 arms of the table that are not in the library.",
      .studies = {{this_paper, {"seed"}},
                  {"beeson2015-panda", {"seed"}},
                  {"beeson2015-baxter", {"seed"}},
                  {"beeson2015-jaco2", {"seed"}},
                  {"beeson2015-iiwa14", {"seed"}}},
      .claims = claims,
      .pieces = pieces,
      .sections = {.first = {{"Solve rates", "", {"solve-rates-figure", "solve-rates", "solve-rates-iterations"}}}}};
}

}  // namespace ikbench::beeson2015
