#include "analysis/inference/multiverse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "analysis/inference/judge.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/multiple_comparisons.hpp"
#include "analysis/statistics/studentized_range.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// Judges a pair by Games and Howell's test.
class PairJudge {
 public:
  PairJudge(const std::vector<std::string>& solvers, const AnalysisPlan& plan)
      : solvers_(solvers), plan_(plan), range_(static_cast<double>(solvers.size())) {}

  // Returns whether the plan compares two solvers; with a control, only pairs with it.
  bool compares(std::size_t one, std::size_t other) const {
    return plan_.control.empty() || solvers_[one] == plan_.control || solvers_[other] == plan_.control;
  }

  // Relation of the first to the second; smaller is better.
  Relation operator()(const GroupSummary& first, const GroupSummary& second) const {
    const bool is_number = std::isfinite(first.mean), other_is_number = std::isfinite(second.mean);
    if (is_number != other_is_number) return is_number ? Relation::better : Relation::worse;
    const MeanDifference pair = tamhane(std::array{first, second}, 1 - plan_.significance).front();
    const double p = range_.upper_tail(pair.q, pair.df);
    if (std::isnan(p)) return Relation::undecided;
    return relation_of(-sign_of(pair.difference.value), p, plan_.significance);
  }

 private:
  const std::vector<std::string>& solvers_;
  const AnalysisPlan& plan_;
  StudentizedRange range_;
};

// Summarises the runs' means or, for typical, their logarithms; values below rounding count as rounding.
GroupSummary summary_of(const Multiverse::ChosenSolver& own, std::size_t seed, const MultiverseClaim& claim) {
  std::vector<double> values = values_of(own, claim.metric)[seed];
  if (claim.by == Estimand::mean) return summarise(values);
  for (double& value : values) value = std::log10(std::max(value, info_of(claim.metric).rounding));
  return summarise(values);
}

using AnswersOfOne = std::vector<std::vector<Relation>>;    // by solver and its choice; empty for the solver itself
using Summarised = std::vector<std::vector<GroupSummary>>;  // by solver and its choice

// Relations of a solver to each choice of its rivals, for one seed and one choice of the study, by its own choice.
std::vector<AnswersOfOne> answers_of(const Summarised& groups, std::size_t solver, const PairJudge& judge) {
  std::vector<AnswersOfOne> answers;
  for (const GroupSummary& ours : groups[solver]) {
    auto& of_own = answers.emplace_back(groups.size());
    for (std::size_t rival = 0; rival < groups.size(); ++rival) {
      if (rival == solver) continue;
      for (const GroupSummary& theirs : groups[rival]) {
        of_own[rival].push_back(judge.compares(solver, rival) ? judge(ours, theirs) : Relation::undecided);
      }
    }
  }
  return answers;
}

Summarised summaries_of(const Multiverse::OfStudy& study, std::size_t seed, const MultiverseClaim& claim) {
  Summarised groups;
  for (const std::vector<Multiverse::ChosenSolver>& of_solver : study.solvers) {
    groups.emplace_back();
    for (const Multiverse::ChosenSolver& own : of_solver) {
      groups.back().push_back(summary_of(own, seed, claim));
    }
  }
  return groups;
}

// Counts a rival's choices: all, those that the solver is better than, and those that it is worse than.
struct RivalCounts {
  double all = 0, better = 0, worse = 0;
  void operator+=(Relation answer) {
    all += 1;
    better += answer == Relation::better ? 1 : 0;
    worse += answer == Relation::worse ? 1 : 0;
  }
};

// Counts universes as products over rivals; each universe has the weight `weight`.
UniverseCounts product_of(const std::vector<RivalCounts>& rivals, double weight) {
  double all = 1, better = 1, not_worse = 1;
  for (const RivalCounts& each : rivals) {
    all *= each.all;
    better *= each.better;
    not_worse *= each.all - each.worse;
  }
  return {.holds = weight * better, .fails = weight * (all - not_worse), .undecided = weight * (not_worse - better)};
}

// Counts a claim in all universes of one choice of the study and one of the solver.
void add_universes(ClaimCounts& into, const Multiverse::OfStudy& study, std::size_t seed,
                   const Multiverse::ChosenSolver& own, const AnswersOfOne& answers) {
  const double weight = study.weight / study.universes();  // of a universe
  std::vector<RivalCounts> rivals(answers.size(), {.all = 1, .better = 1});
  for (std::size_t rival = 0; rival < answers.size(); ++rival) {
    if (!answers[rival].empty()) rivals[rival] = {};
    for (const Relation answer : answers[rival]) rivals[rival] += answer;
  }
  const UniverseCounts counts = product_of(rivals, weight);
  into.all += counts;
  into.seeds[seed] += counts;
  for (const auto* chosen : {&study.chosen, &own.chosen}) {
    for (const Multiverse::Choice& each : *chosen) into.alternatives[each.dimension][each.alternative] += counts;
  }
  for (std::size_t rival = 0; rival < answers.size(); ++rival) {
    std::map<std::pair<std::size_t, std::size_t>, RivalCounts> by_alternative;
    for (std::size_t b = 0; b < answers[rival].size(); ++b) {
      for (const Multiverse::Choice& each : study.solvers[rival][b].chosen) {
        by_alternative[{each.dimension, each.alternative}] += answers[rival][b];
      }
    }
    std::vector<RivalCounts> restricted = rivals;
    for (const auto& [choice, against] : by_alternative) {
      restricted[rival] = against;
      into.alternatives[choice.first][choice.second] += product_of(restricted, weight);
    }
  }
}

std::optional<std::size_t> place_of_solver(const Multiverse& multiverse, std::string_view label) {
  const auto found = std::ranges::find(multiverse.solvers, label);
  if (found == multiverse.solvers.end()) return std::nullopt;
  return static_cast<std::size_t>(found - multiverse.solvers.begin());
}

ClaimCounts no_counts(const Multiverse& multiverse, const MultiverseClaim& claim) {
  ClaimCounts counts{.claim = claim};
  counts.seeds.resize(multiverse.seeds());
  for (const Multiverse::Dimension& each : multiverse.dimensions) {
    counts.alternatives.emplace_back(each.alternatives.size());
  }
  return counts;
}

// The same answer for every choice of every rival.
AnswersOfOne alike(const Multiverse::OfStudy& study, std::size_t solver, Relation answer) {
  AnswersOfOne answers;
  for (const auto& of_solver : study.solvers) answers.emplace_back(of_solver.size(), answer);
  answers[solver].clear();
  return answers;
}

// Counts several claims of one solver with the same metric and judgement; they share the answers.
void count_ranking(const Multiverse& multiverse, const std::vector<ClaimCounts*>& alike_judged,
                   const PairJudge& judge) {
  const MultiverseClaim& first = alike_judged.front()->claim;
  const std::optional<std::size_t> solver = place_of_solver(multiverse, first.solver);
  if (!solver) return;
  for (const Multiverse::OfStudy& study : multiverse.studies) {
    for (std::size_t seed = 0; seed < multiverse.seeds(); ++seed) {
      const std::vector<AnswersOfOne> answers = answers_of(summaries_of(study, seed, first), *solver, judge);
      for (ClaimCounts* counts : alike_judged) {
        const std::string& named = counts->claim.rival;
        const std::optional<std::size_t> rival = place_of_solver(multiverse, named);
        if (!named.empty() && !rival) continue;
        for (std::size_t own = 0; own < answers.size(); ++own) {
          AnswersOfOne held = rival ? alike(study, *solver, Relation::better) : answers[own];
          if (rival) held[*rival] = answers[own][*rival];
          add_universes(*counts, study, seed, study.solvers[*solver][own], held);
        }
      }
    }
  }
}

// Finds the choice that equals `own` but has the dimension's default; null if there is none, or `own` has the default.
const Multiverse::ChosenSolver* twin_of(const std::vector<Multiverse::ChosenSolver>& all,
                                        const Multiverse::ChosenSolver& own, std::size_t dimension) {
  std::vector<Multiverse::Choice> wanted = own.chosen;
  const auto found = std::ranges::find(wanted, dimension, &Multiverse::Choice::dimension);
  if (found == wanted.end() || found->alternative == 0) return nullptr;
  found->alternative = 0;
  const auto is_wanted = [&](const Multiverse::ChosenSolver& each) {
    return std::ranges::equal(each.chosen, wanted, [](const auto& a, const auto& b) {
      return a.dimension == b.dimension && a.alternative == b.alternative;
    });
  };
  const auto twin = std::ranges::find_if(all, is_wanted);
  return twin == all.end() ? nullptr : &*twin;
}

// Relation of the default to the alternative; worse if both have the same bits.
Relation effect_between(const Multiverse::ChosenSolver& usual, const Multiverse::ChosenSolver& other, std::size_t seed,
                        const MultiverseClaim& claim, const PairJudge& judge) {
  if (usual.error_cm[seed] == other.error_cm[seed] && usual.variation_deg[seed] == other.variation_deg[seed]) {
    return Relation::worse;
  }
  return judge(summary_of(usual, seed, claim), summary_of(other, seed, claim));
}

void count_effect(const Multiverse& multiverse, ClaimCounts& counts, const PairJudge& judge) {
  const std::optional<std::size_t> solver = place_of_solver(multiverse, counts.claim.solver);
  const auto dimension = std::ranges::find(multiverse.dimensions, counts.claim.effect_of, &Multiverse::Dimension::name);
  if (!solver || dimension == multiverse.dimensions.end()) return;
  const auto place = static_cast<std::size_t>(dimension - multiverse.dimensions.begin());
  for (const Multiverse::OfStudy& study : multiverse.studies) {
    for (std::size_t seed = 0; seed < multiverse.seeds(); ++seed) {
      for (const Multiverse::ChosenSolver& own : study.solvers[*solver]) {
        const Multiverse::ChosenSolver* twin = twin_of(study.solvers[*solver], own, place);
        if (twin == nullptr) continue;
        add_universes(counts, study, seed, own,
                      alike(study, *solver, effect_between(*twin, own, seed, counts.claim, judge)));
      }
    }
  }
}

}  // namespace

double Multiverse::OfStudy::universes() const {
  double product = 1;
  for (const std::vector<Multiverse::ChosenSolver>& of_solver : solvers)
    product *= static_cast<double>(of_solver.size());
  return product;
}

double Multiverse::universes() const {
  double all = 0;
  for (const OfStudy& study : studies) all += study.universes();
  return all;
}

bool is_of_universes(Metric metric) { return metric == Metric::position_error_cm || metric == Metric::variation_deg; }

const std::vector<std::vector<double>>& values_of(const Multiverse::ChosenSolver& own, Metric metric) {
  return metric == Metric::position_error_cm ? own.error_cm : own.variation_deg;
}

void UniverseCounts::operator+=(const UniverseCounts& more) {
  holds += more.holds;
  fails += more.fails;
  undecided += more.undecided;
}

double ClaimCounts::difference(std::size_t dimension) const {
  double least = 1, most = 0;
  for (const UniverseCounts& each : alternatives[dimension]) {
    if (each.all() == 0) continue;
    least = std::min(least, each.holds / each.all());
    most = std::max(most, each.holds / each.all());
  }
  return std::max(0.0, most - least);
}

std::size_t ClaimCounts::deciding() const {
  std::size_t most = alternatives.size();
  for (std::size_t d = 0; d < alternatives.size(); ++d) {
    if (difference(d) > (most == alternatives.size() ? 0 : difference(most))) most = d;
  }
  return most;
}

std::vector<ClaimCounts> counted(const Multiverse& multiverse, const std::vector<MultiverseClaim>& claims,
                                 const AnalysisPlan& plan) {
  const PairJudge judge(multiverse.solvers, plan);
  std::vector<ClaimCounts> all;
  for (const MultiverseClaim& claim : claims) all.push_back(no_counts(multiverse, claim));
  std::map<std::tuple<std::string, Metric, Estimand>, std::vector<ClaimCounts*>> judged_alike;
  for (ClaimCounts& counts : all) {
    const MultiverseClaim& claim = counts.claim;
    if (claim.effect_of.empty()) {
      judged_alike[{claim.solver, claim.metric, claim.by}].push_back(&counts);
    } else {
      count_effect(multiverse, counts, judge);
    }
  }
  for (const auto& [judged, group] : judged_alike) count_ranking(multiverse, group, judge);
  return all;
}

}  // namespace ikbench::inference
