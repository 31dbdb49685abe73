#include "analysis/claims/claim_counts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "analysis/claims/case.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/multiple_comparisons.hpp"
#include "analysis/statistics/studentized_range.hpp"

namespace ikbench::claims {

using namespace results;
using namespace statistics;
using namespace inference;

namespace {

using ChosenSolver = Multiverse::ChosenSolver;

// Relation of the first to the second by Games and Howell's test; smaller is better.
Relation relation_between(const GroupSummary& first, const GroupSummary& second, const StudentizedRange& range,
                          double significance) {
  const bool is_number = std::isfinite(first.mean), other_is_number = std::isfinite(second.mean);
  if (is_number != other_is_number) return is_number ? Relation::better : Relation::worse;
  const MeanDifference pair = tamhane(std::array{first, second}, 1 - significance).front();
  const double p = range.upper_tail(pair.q, pair.df);
  return std::isnan(p) ? Relation::undecided : relation_of(-sign_of(pair.difference.value), p, significance);
}

// Summarises the runs' means or, for typical, their logarithms; values below rounding count as rounding.
GroupSummary summary_of(const ChosenSolver& own, std::size_t seed, Metric metric, Estimand by) {
  std::vector<double> values = values_of(own, metric)[seed];
  if (by == Estimand::mean) return summarise(values);
  for (double& value : values) value = std::log10(std::max(value, info_of(metric).rounding));
  return summarise(values);
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

// Counts of a claim by how many printed numbers the universes explain.
using CountsByExplained = std::vector<UniverseCounts>;

// Joins another solver's choice, which occurs with each universe before it.
void add_joined(CountsByExplained& to, const CountsByExplained& before, Relation relation, std::size_t explained) {
  to.resize(std::max(to.size(), before.size() + explained));
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto& [holds, fails, undecided] = before[i];
    to[i + explained] += relation == Relation::better  ? before[i]
                         : relation == Relation::worse ? UniverseCounts{.fails = holds + fails + undecided}
                                                       : UniverseCounts{.fails = fails, .undecided = holds + undecided};
  }
}

// The relations of one choice of a claim's solvers to the choices of each solver; of these it has this one only.
using Relations = std::vector<std::map<std::size_t, Relation>>;

// Counts the universes that fit by folding them solver by solver; each has the weight `weight`.
UniverseCounts fitting_of(const Relations& relations, const ExplainedUniverses::value_type& explained, int least,
                          double weight) {
  CountsByExplained counts{{.holds = weight}};
  for (std::size_t s = 0; s < relations.size(); ++s) {
    CountsByExplained next;
    for (const auto& [choice, relation] : relations[s])
      add_joined(next, counts, relation, explained[s][choice].count());
    counts = std::move(next);
  }
  UniverseCounts fitting;
  for (auto i = static_cast<std::size_t>(least); i < counts.size(); ++i) fitting += counts[i];
  return fitting;
}

// One choice of each of the claim's solvers.
using OwnChoices = std::map<std::size_t, std::size_t>;

// Counts a claim in all universes of one choice of the study, the one at `place`, and one of each of its solvers.
// `relation_to` is their relation to a choice of a rival.
template <class RelationTo>
void add_universes(ClaimCounts& into, const Multiverse& multiverse, std::size_t place, std::size_t seed,
                   const OwnChoices& own, const Fit& fit, RelationTo relation_to) {
  const Multiverse::OfStudy& study = multiverse.studies[place];
  const double weight = study.weight / study.universes();  // of a universe
  std::vector<RivalCounts> rivals(study.solvers.size(), {.all = 1, .better = 1});
  std::vector<std::map<std::pair<std::size_t, std::size_t>, RivalCounts>> by_alternative(rivals.size());
  Relations relations(rivals.size());
  for (const auto& [solver, choice] : own) relations[solver][choice] = Relation::better;
  for (std::size_t rival = 0; rival < rivals.size(); ++rival) {
    if (own.contains(rival)) continue;
    rivals[rival] = {};
    for (std::size_t choice = 0; choice < study.solvers[rival].size(); ++choice) {
      const ChosenSolver& theirs = study.solvers[rival][choice];
      const Relation relation = relations[rival][choice] = relation_to(rival, theirs);
      rivals[rival] += relation;
      for (const auto& [dimension, alternative] : theirs.chosen)
        by_alternative[rival][{dimension, alternative}] += relation;
    }
  }
  const UniverseCounts counts = product_of(rivals, weight);
  into.all += counts;
  into.seeds[seed] += counts;
  if (!fit.explained.empty()) into.fitting += fitting_of(relations, fit.explained[place], fit.least, weight);
  for (const auto& [dimension, alternative] : study.chosen) into.alternatives[dimension][alternative] += counts;
  for (const auto& [solver, choice] : own) {
    for (const auto& [dimension, alternative] : study.solvers[solver][choice].chosen)
      into.alternatives[dimension][alternative] += counts;
  }
  for (std::size_t rival = 0; rival < rivals.size(); ++rival) {
    std::vector<RivalCounts> restricted = rivals;
    for (const auto& [choice, against] : by_alternative[rival]) {
      restricted[rival] = against;
      into.alternatives[choice.first][choice.second] += product_of(restricted, weight);
    }
  }
}

// Index of a name; the number of names if it is missing.
std::size_t index_of(const std::vector<std::string>& names, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

// Every combination of the choices of these solvers.
std::vector<OwnChoices> combined(const Multiverse::OfStudy& study, const std::vector<std::size_t>& solvers) {
  std::vector<OwnChoices> all(1);
  for (const std::size_t solver : solvers) {
    std::vector<OwnChoices> more;
    for (const OwnChoices& each : all) {
      for (std::size_t choice = 0; choice < study.solvers[solver].size(); ++choice)
        more.emplace_back(each)[solver] = choice;
    }
    all = std::move(more);
  }
  return all;
}

void count_claim(const Multiverse& multiverse, const ClaimEntry& claim, Estimand by, const AnalysisPlan& plan,
                 const Fit& fit, ClaimCounts& counts) {
  const std::vector<std::string>& solvers = multiverse.solvers;
  std::vector<std::size_t> claimed;
  for (const std::string& solver : claim.own()) claimed.push_back(index_of(solvers, solver));
  const std::size_t only_rival = index_of(solvers, claim.against);
  const bool has_rival = !claim.against.empty();
  if (std::ranges::count(claimed, solvers.size()) > 0 || (has_rival && only_rival == solvers.size())) return;
  const StudentizedRange range(static_cast<double>(solvers.size()));
  for (std::size_t g = 0; g < multiverse.studies.size(); ++g) {
    const Multiverse::OfStudy& study = multiverse.studies[g];
    const std::vector<OwnChoices> choices = combined(study, claimed);
    for (std::size_t seed = 0; seed < multiverse.seeds(); ++seed) {
      std::map<std::pair<const ChosenSolver*, const ChosenSolver*>, Relation> known;
      const auto relation = [&](const ChosenSolver& own, const ChosenSolver& theirs) {
        const auto [found, is_new] = known.try_emplace({&own, &theirs});
        if (is_new) {
          const auto summary = [&](const ChosenSolver& of) { return summary_of(of, seed, claim.metrics.front(), by); };
          found->second = relation_between(summary(own), summary(theirs), range, plan.significance);
        }
        return found->second;
      };
      for (const OwnChoices& own : choices) {
        add_universes(counts, multiverse, g, seed, own, fit, [&](std::size_t rival, const ChosenSolver& theirs) {
          if (has_rival && rival != only_rival) return Relation::better;
          PairCounts pairs;
          for (const auto& [solver, choice] : own) {
            // With a control, the plan compares only pairs with it.
            const bool is_compared =
                plan.control.empty() || solvers[solver] == plan.control || solvers[rival] == plan.control;
            pairs.add(is_compared ? relation(study.solvers[solver][choice], theirs) : Relation::undecided);
          }
          return pairs.worse > 0 ? Relation::worse : pairs.open == 0 ? Relation::better : Relation::undecided;
        });
      }
    }
  }
}

}  // namespace

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

std::vector<ClaimCounts> counted(const Multiverse& multiverse, const std::vector<ClaimEntry>& entries,
                                 const AnalysisPlan& plan, const Fit& fit) {
  std::vector<ClaimCounts> all;
  for (const ClaimEntry& entry : entries) {
    for (const Estimand by : entry.universes) {
      const bool is_typical = by == Estimand::typical;
      ClaimCounts& counts =
          all.emplace_back(ClaimCounts{.id = entry.id + (is_typical ? "_typically" : ""),
                                       .words = entry.sentence + (is_typical ? " by geometric means" : "")});
      counts.seeds.resize(multiverse.seeds());
      for (const Dimension& each : multiverse.dimensions) counts.alternatives.emplace_back(each.alternatives.size());
      count_claim(multiverse, entry, by, plan, fit, counts);
    }
  }
  return all;
}

}  // namespace ikbench::claims
