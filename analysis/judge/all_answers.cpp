#include "analysis/judge/all_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/json.hpp"
#include "base/names.hpp"
#include "results/goal_freedoms.hpp"

namespace ikbench::judge {

using results::AnswerCount;
using results::KnownAnswers;

namespace {

using Place = std::pair<int, int>;  // run and point

// Adds the count of a target that counts.
void add_target(AnswerSummary& summary, const AnswerCount& count, int known) {
  const double share = static_cast<double>(count.found) / known;
  summary.coverage += share;
  summary.lowest_coverage = std::min(summary.lowest_coverage, share);
  summary.highest_coverage = std::max(summary.highest_coverage, share);
  summary.mean_found += count.found;
  summary.most_found = std::max(summary.most_found, count.found);
  summary.fewest_found = std::min(summary.fewest_found, count.found);
  summary.declined += count.given == 0 ? 1 : 0;
}

// Returns the number of known answers of each target that counts. Fills in what `all` says of the targets.
std::map<Place, int> known_answers(const std::vector<KnownAnswers>& targets, AllAnswers& all) {
  std::map<Place, int> known;
  for (const KnownAnswers& target : targets) {
    if (target.is_continuum)
      ++all.continua;
    else if (target.known == 0)
      ++all.unknown;
    else
      known[{target.run, target.point}] = target.known;
  }
  all.targets = static_cast<int>(known.size());
  if (known.empty()) return known;
  const auto number = &std::pair<const Place, int>::second;
  all.fewest_known = std::ranges::min_element(known, {}, number)->second;
  all.most_known = std::ranges::max_element(known, {}, number)->second;
  for (const auto& [place, answers] : known) all.mean_known += static_cast<double>(answers) / all.targets;
  return known;
}

}  // namespace

std::optional<AllAnswers> all_answers_of(const StudyResults& study) {
  if (study.answers.targets.empty()) return std::nullopt;
  const results::StudyDefinition& definition = study.definition;
  AllAnswers all{.all_targets = std::int64_t{definition.points} * (definition.draws_targets ? definition.runs : 1),
                 .repeats = definition.draws_targets ? 1 : definition.runs};
  const std::map<Place, int> known = known_answers(study.answers.targets, all);
  MetricSamples complete{
      .metric = "complete", .quantity = "complete", .better = Better::larger, .kind = Proportions{}, .is_paired = true};
  for (const results::Series& series : study.series) {
    AnswerSummary summary{.solver = series.label, .fewest_found = all.most_known};
    std::map<Place, std::pair<double, int>> is_complete;  // sum over the runs, and their number
    int solves = 0;
    for (const AnswerCount& count : study.answers.counts) {
      if (count.series != series.key) continue;
      summary.wrong += count.wrong;
      summary.doubled += count.doubled;
      if (count.found > 0) summary.wrong_beside_right += count.wrong;
      const auto target = known.find({definition.draws_targets ? count.run : 1, count.point});
      if (target == known.end() || target->second < count.found) continue;
      add_target(summary, count, target->second);
      auto& [sum, runs] = is_complete[target->first];
      sum += count.found == target->second ? 1 : 0;
      ++runs;
      ++solves;
    }
    if (is_complete.size() < known.size()) {  // solved by another version, or after the answers were counted
      all.left_out.push_back(series.label);
      continue;
    }
    if (solves > 0) {
      summary.coverage /= solves;
      summary.mean_found /= solves;
    }
    Sample values;
    for (const auto& [place, runs] : is_complete) {
      values.values.push_back(runs.first / runs.second);
      summary.complete += values.values.back();
    }
    summary.complete /= std::max(1, all.targets);
    complete.groups.push_back({.name = series.label, .sample = std::move(values)});
    all.solvers.push_back(std::move(summary));
  }
  if (all.repeats > 1) complete.kind = Proportions{.trials_per_value = all.repeats};
  if (all.targets > 0 && !complete.groups.empty()) all.complete = judge(std::move(complete), definition.plan);
  return all;
}

std::string why_not_counted(const StudyResults& study) {
  if (!study.has_several_answers) return "";
  if (const std::optional<AllAnswers> all = all_answers_of(study)) {
    const auto has = [](int count) { return count == 1 ? "has" : "have"; };
    if (all->complete) return "";
    if (all->targets > 0) return "The answers are not counted yet. `ikbench run` with the store counts them.";
    return fmt::format("The answers are not counted: of {}, {} {} a singular answer and {} {} no known one.",
                       base::counted(std::int64_t{all->looked_at()}, "targets"), all->continua, has(all->continua),
                       all->unknown, has(all->unknown));
  }
  const auto arm = base::parsed_json(study.definition.arm);
  const std::size_t joints = arm.contains("links") ? arm["links"].size() : 0;
  const std::size_t freedoms = results::goal_freedoms(study.definition.search);
  if (freedoms == 0) return "The answers are not counted: the search is not for all joints.";
  if (joints == freedoms) return "";
  return fmt::format("The answers are not counted: {} joints for {} freedoms have {}.", joints, freedoms,
                     joints > freedoms ? "infinitely many" : "no answer to most targets");
}

}  // namespace ikbench::judge
