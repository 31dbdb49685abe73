#include "analysis/report/set_up.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace results;
using namespace inference;
using namespace fmt::literals;

namespace {

std::string searched_for(const StudyFacts& facts) {
  return facts.pose ? "a pose" : facts.wrist ? "a position of the wrist" : "a position";
}

// "1000 iterations, 10000 evaluations or 0.005 s"
std::string limits_of(const StudyFacts::Stop& stop) {
  std::vector<std::string> limits;
  if (stop.iterations > 0) limits.push_back(fmt::format("{} iterations", stop.iterations));
  if (stop.evaluations > 0) limits.push_back(fmt::format("{} evaluations", stop.evaluations));
  if (stop.seconds > 0) limits.push_back(fmt::format("{} s", stop.seconds));
  if (limits.size() < 2) return fmt::format("{}", fmt::join(limits, ""));
  const std::string last = limits.back();
  limits.pop_back();
  return fmt::format("{} or {}", fmt::join(limits, ", "), last);
}

std::string tolerance_of(const StudyFacts::Stop& stop) {
  std::string words;
  if (stop.tolerance_cm > 0) words = fmt::format("{} cm", short_number(stop.tolerance_cm));
  if (stop.tolerance_deg > 0)
    words += fmt::format("{}{} deg", words.empty() ? "" : " and ", short_number(stop.tolerance_deg));
  return words;
}

std::string_view start_words(std::string_view start) {
  constexpr std::pair<std::string_view, std::string_view> words[]{{"previous", "where the previous one left the arm"},
                                                                  {"initial", "at one configuration"},
                                                                  {"middle", "in the middle of the joint limits"},
                                                                  {"random", "at a random configuration"},
                                                                  {"near", "near a solution"}};
  const auto* const found = std::ranges::find(words, start, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(words) ? start : found->second;
}

// The different values of a fact in the sessions.
std::string values_of(const std::vector<Session>& sessions, const std::string& fact) {
  std::set<std::string> values;
  for (const Session& session : sessions) {
    const auto found = session.environment.find(fact);
    if (found != session.environment.end() && !found->second.empty()) values.insert(found->second);
  }
  return fmt::format("{}", fmt::join(values, " and "));
}

}  // namespace

std::vector<std::string> set_up_sentences(const JudgedStudy& study, const Paper& paper,
                                          const std::vector<Session>& sessions) {
  const StudyFacts& facts = study.facts;
  std::vector<std::string> sentences{paper.citation};
  if (!departs_from_paper(study)) sentences.insert(sentences.end(), {paper.kind, paper.not_reproduced});
  std::erase(sentences, "");
  if (facts.robot.empty()) return sentences;
  sentences.push_back(fmt::format(words::set_up_solvers, "count"_a = study.solvers.size(),
                                  "solvers"_a = listed(study.solvers), "goal"_a = searched_for(facts),
                                  "arm"_a = facts.robot));
  sentences.push_back(fmt::format(fmt::runtime(facts.draws_targets ? words::set_up_drawn : words::set_up_path),
                                  "points"_a = study.points, "path"_a = facts.path, "runs"_a = study.runs,
                                  "start"_a = start_words(facts.start), "seed"_a = facts.seed));
  if (const std::string limits = limits_of(facts.stop); !limits.empty()) {
    sentences.push_back(fmt::format(words::set_up_limits, "limits"_a = limits));
  }
  if (const std::string tolerance = tolerance_of(facts.stop); !tolerance.empty()) {
    sentences.push_back(fmt::format(words::set_up_tolerance, "tolerance"_a = tolerance));
  }
  sentences.emplace_back(facts.enforces_limits ? words::set_up_enforced : words::set_up_recorded);
  const Evidence& evidence = study.evidence(Metric::position_error_cm);
  if (!evidence.contrasts.empty()) {
    sentences.push_back(fmt::format(words::set_up_test, "test"_a = deciding_words(evidence),
                                    "significance"_a = study.plan.significance));
  }
  const std::string cpu = values_of(sessions, "cpu"), compiler = values_of(sessions, "compiler"),
                    version = values_of(sessions, "version");
  if (!cpu.empty()) {
    sentences.push_back(
        fmt::format(words::set_up_machine, "version"_a = version, "compiler"_a = compiler, "cpu"_a = cpu));
  }
  return sentences;
}

}  // namespace ikbench::report
