#include "analysis/show/then.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "analysis/show/text.hpp"
#include "analysis/show/words.hpp"

namespace ikbench::show {

using namespace judge;

namespace {

// How a metric is told: "LM is the fastest; DLS takes 1.2 times as long", "Nobody is shown to be faster than DLS".
struct Words {  // in the order in which they are asked
  std::string_view column, of_one, of_several, nobody, takes, as, tie;
};
constexpr std::array all_words{
    Words{"seconds", "is the fastest", "are the fastest", "be faster", "takes", "as long",
          "Time tells none of them apart."},
    Words{"evaluations", "needs the fewest evaluations", "need the fewest evaluations", "need fewer evaluations",
          "takes", "as many", "Evaluations tell none of them apart."},
    Words{"variation_deg", "moves the joints least", "move the joints least", "move the joints less", "moves them",
          "as far", "Joint motion tells none of them apart."}};

// A metric of the answer, or what stands in its place where a target failed; null: there is none.
const JudgedMetric* told_metric(const Answer& answer, std::string_view column) {
  const std::string slug(metric_named(column).slug), per_solved = slug + "-per-solved";
  const auto found = std::ranges::find_if(answer.metrics, [&](const JudgedMetric& judged) {
    return judged.observations.metric == slug || judged.observations.metric == per_solved;
  });
  return found == answer.metrics.end() ? nullptr : &*found;
}

// "DLS takes 1.2 times, SLSQP 27 times as long"; of many their range.
std::string slower(const JudgedMetric& judged, const Words& words, const std::vector<std::string>& best,
                   const std::vector<std::string>& beaten) {
  constexpr std::size_t most = 4;
  std::vector<std::string> told;
  std::vector<double> ratios;
  for (const std::string& name : beaten) {
    const auto beats = [&](const std::string& winner) {
      const Finding* const pair = finding_of(judged, winner, name);
      return pair != nullptr && is_difference(verdict_of(*pair));
    };
    const auto winner = std::ranges::find_if(best, beats);
    if (winner == best.end()) continue;
    const Finding pair = better_first(*finding_of(judged, *winner, name), "");
    const Amount* const amount = amount_of(pair);
    if (amount == nullptr || pair.scale != Scale::ratio) continue;
    ratios.push_back(1 / amount->value);
    told.push_back(fmt::format("{}{} {} times", name, told.empty() ? fmt::format(" {}", words.takes) : "",
                               number_text(ratios.back())));
  }
  if (told.empty()) return "";
  if (told.size() <= most) return fmt::format("; {} {}", fmt::join(told, ", "), words.as);
  const auto [least, largest] = std::ranges::minmax(ratios);
  return fmt::format("; {} others {} to {} times {}", told.size(), number_text(least), number_text(largest), words.as);
}

}  // namespace

std::string then_of(const Answer& answer) {
  const JudgedMetric& first = answer.decisive();
  const std::set<std::string> losers = losers_of(first.findings);
  std::vector<std::string> rest, said;
  for (const std::string& name : answer.solvers())
    if (!losers.contains(name)) rest.push_back(name);
  if (!answer.goes_on || rest.size() < 2 || !first.plan.control.empty()) return "";
  bool is_any_tested = false;
  for (const Words& words : all_words) {
    const JudgedMetric* const judged = told_metric(answer, words.column);
    if (judged == nullptr || judged == &first) continue;
    const auto is_one = [&](const std::string& name) { return std::ranges::count(rest, name) > 0; };
    std::vector<Finding> between = judged->findings;
    std::erase_if(between, [&](const Finding& pair) { return !is_one(pair.first) || !is_one(pair.second); });
    const auto is_tested = [](const Finding& pair) { return verdict_of(pair) != Verdict::not_tested; };
    const std::set<std::string> beaten = losers_of(between);
    if (std::ranges::none_of(between, is_tested)) {
      if (judged->observations.fewest > 0) said.push_back("Times are not compared.");  // a warning says why
      continue;
    }
    if (beaten.empty()) {
      said.emplace_back(words.tie);
      is_any_tested = true;
      continue;
    }
    std::vector<std::string> best, others;
    for (const std::string& name : rest) (beaten.contains(name) ? others : best).push_back(name);
    const bool are_best = std::ranges::all_of(between, [&](const Finding& pair) {
      return beaten.contains(pair.first) == beaten.contains(pair.second) || is_difference(verdict_of(pair));
    });
    said.push_back(best.empty() ? fmt::format("By {} each is worse than another.", judged->observations.quantity)
                   : are_best
                       ? fmt::format("{} {}{}.", names_of(best), best.size() == 1 ? words.of_one : words.of_several,
                                     slower(*judged, words, best, others))
                       : fmt::format("Nobody of them is shown to {} than {}{}.", words.nobody, names_of(best),
                                     slower(*judged, words, best, others)));
    is_any_tested = true;
    break;
  }
  if (!is_any_tested) return "";
  return fmt::format("{}", fmt::join(said, " "));
}

}  // namespace ikbench::show
