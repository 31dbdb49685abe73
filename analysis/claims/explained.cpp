#include "analysis/claims/explained.hpp"

#include <algorithm>

namespace ikbench::claims {

using namespace statistics;
using namespace inference;

namespace {

static_assert(predicted_statistics == printed_statistics.size());

// The numbers of universes by how many numbers they explain.
using Tally = std::vector<double>;

// Counts the universes of one choice of the study or, with `own`, those with that choice of that solver.
Tally tally_of(const ExplainedUniverses::value_type& solvers, std::size_t solver = 0, const Explained* own = nullptr) {
  Tally tally{1};
  for (std::size_t s = 0; s < solvers.size(); ++s) {
    Tally next(tally.size() + numbers_of_solver);
    for (const Explained& each : solvers[s]) {
      if (own != nullptr && s == solver && &each != own) continue;
      for (std::size_t i = 0; i < tally.size(); ++i) next[i + each.count()] += tally[i];
    }
    tally = std::move(next);
  }
  return tally;
}

// Adds universes of that weight together. `most` is what the best of all explain.
void add(Support& to, const Tally& tally, double weight, int most) {
  double universes = 0, explained = 0;
  for (std::size_t i = 0; i < tally.size(); ++i) {
    universes += tally[i];
    explained += static_cast<double>(i) * tally[i];
    if (tally[i] > 0) to.most = std::max(to.most, static_cast<int>(i));
  }
  to.explained += explained / universes * weight;
  to.weight += weight;
  if (static_cast<std::size_t>(most) < tally.size()) to.best += tally[static_cast<std::size_t>(most)];
}

}  // namespace

std::vector<double> pooled(const Multiverse::ChosenSolver& own, Metric metric) {
  std::vector<double> all;
  for (const std::vector<double>& seed : values_of(own, metric)) all.insert(all.end(), seed.begin(), seed.end());
  return all;
}

PrintedSolvers::PrintedSolvers(const ClaimsFile& file, const Multiverse& multiverse)
    : rows_(multiverse.solvers.size()),
      can_predict_(pooled(multiverse.studies.front().solvers.front().front(), explained_metrics[0]).size() >=
                   fewest_predicting) {
  for (std::size_t m = 0; m < explained_metrics.size(); ++m) {
    for (const PrintedRow& row : printed_rows(file.paper, file.means, explained_metrics[m])) {
      const auto solver = std::ranges::find(multiverse.solvers, row.algorithm);
      if (solver != multiverse.solvers.end())
        rows_[static_cast<std::size_t>(solver - multiverse.solvers.begin())][m] = row;
    }
  }
}

int PrintedSolvers::numbers() const {
  int numbers = 0;
  for (std::size_t s = 0; s < rows_.size() && can_predict_; ++s)
    numbers += is_printed(s) ? static_cast<int>(numbers_of_solver) : 0;
  return numbers;
}

int PrintedSolvers::most_runs() const {
  int most = 0;
  for (const auto& [error, variation] : rows_) most = std::max({most, error.printed.n, variation.printed.n});
  return most;
}

PrintedSolvers::Ranges PrintedSolvers::ranges(std::size_t solver, const Multiverse::ChosenSolver& own) {
  Ranges ranges;
  auto end = ranges.begin();
  for (std::size_t m = 0; m < explained_metrics.size(); ++m) {
    const auto runs = static_cast<std::size_t>(row(solver, m).printed.n);
    const auto [known, is_new] = known_.try_emplace({runs, pooled(own, explained_metrics[m])});
    if (is_new)
      known->second = predicted_ranges(known->first.second, runs, {.resamples = 500, .seed = 1, .level = 0.95});
    end = std::ranges::copy(known->second, end).out;
  }
  return ranges;
}

Explained PrintedSolvers::explained(std::size_t solver, const Multiverse::ChosenSolver& own) {
  Explained explained;
  if (!is_printed(solver)) return explained;
  const Ranges all = ranges(solver, own);
  for (std::size_t i = 0; i < numbers_of_solver; ++i) {
    const std::string& digits = row(solver, i / predicted_statistics).digits[i % predicted_statistics];
    explained[i] = !digits.empty() && can_be(all[i].low, all[i].high, digits);
  }
  return explained;
}

ExplainedUniverses explained_in(const Multiverse& multiverse, PrintedSolvers& printed) {
  ExplainedUniverses explained;
  for (const Multiverse::OfStudy& study : multiverse.studies) {
    auto& of_study = explained.emplace_back(study.solvers.size());
    for (std::size_t s = 0; s < study.solvers.size(); ++s) {
      for (const Multiverse::ChosenSolver& own : study.solvers[s]) of_study[s].push_back(printed.explained(s, own));
    }
  }
  return explained;
}

UniverseSupport support_of(const Multiverse& multiverse, const Fit& fit) {
  const ExplainedUniverses& explained = fit.explained;
  UniverseSupport support;
  support.numbers.resize(multiverse.solvers.size());
  for (const Multiverse::Dimension& each : multiverse.dimensions) {
    support.alternatives.emplace_back(each.alternatives.size());
  }
  int most = 0;
  for (const auto& of_study : explained) {
    int best = 0;
    for (const std::vector<Explained>& of_solver : of_study)
      best += static_cast<int>(std::ranges::max(of_solver, {}, &Explained::count).count());
    most = std::max(most, best);
  }
  for (const auto& of_solver : explained.front()) support.by_default += static_cast<int>(of_solver.front().count());
  for (std::size_t g = 0; g < explained.size(); ++g) {
    const Multiverse::OfStudy& study = multiverse.studies[g];
    const Tally tally = tally_of(explained[g]);
    const auto count = [&](const std::vector<Multiverse::Choice>& chosen, const Tally& universes, double weight) {
      for (const Multiverse::Choice& each : chosen) {
        add(support.alternatives[each.dimension][each.alternative], universes, weight, most);
      }
    };
    add(support.all, tally, study.weight, most);
    count(study.chosen, tally, study.weight);
    for (std::size_t i = 0; i < tally.size(); ++i) {
      const double universes = tally[i] * study.weight / study.universes();
      support.more += static_cast<int>(i) > support.by_default ? universes : 0;
      support.fitting += static_cast<int>(i) >= fit.least ? universes : 0;
    }
    for (std::size_t s = 0; s < study.solvers.size(); ++s) {
      const double weight = study.weight / static_cast<double>(study.solvers[s].size());
      for (std::size_t a = 0; a < study.solvers[s].size(); ++a) {
        const Explained& own = explained[g][s][a];
        const Tally with_it = tally_of(explained[g], s, &own);
        count(study.solvers[s][a].chosen, with_it, weight);
        for (std::size_t i = 0; i < numbers_of_solver; ++i) {
          if (own[i]) add(support.numbers[s][i], with_it, weight, most);
        }
      }
    }
  }
  return support;
}

}  // namespace ikbench::claims
