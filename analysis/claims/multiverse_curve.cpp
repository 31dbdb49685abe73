#include "analysis/claims/multiverse_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/claims/multiverse_printed.hpp"
#include "analysis/figures/specification_curve.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::claims {

using namespace statistics;
using namespace inference;
using namespace figures;

namespace {

constexpr std::size_t most_drawn = 150;

// The universes of one choice of the study and one of the solver in which the same choice of the same rival is the
// best.
struct BestRival {
  double estimate = 0;   // log10 of the solver's mean by the rival's
  double error = 0;      // its standard error, by propagation of those of the means
  double universes = 0;  // their number
  double weight = 0;     // their weight together
  std::size_t study = 0, own = 0, rival = 0;
};

struct PooledMean {
  double mean = not_defined, error = not_defined;
};

PooledMean pooled(const Multiverse::Own& own) {
  std::vector<double> all;
  for (const std::vector<double>& runs : own.error_cm) all.insert(all.end(), runs.begin(), runs.end());
  return {mean(all), standard_error(all)};
}

using PooledMeans = std::vector<std::vector<PooledMean>>;  // by solver, by its choice

// The number of combinations of all other rivals' choices in which this mean is the smallest; of equal ones the first
// counts.
double universes_of_best(const PooledMeans& means, std::size_t solver, std::size_t rival, double best) {
  double universes = 1;
  for (std::size_t other = 0; other < means.size(); ++other) {
    if (other == solver || other == rival) continue;
    universes *= static_cast<double>(std::ranges::count_if(means[other], [&](const PooledMean& each) {
      return !(each.mean < best) && (each.mean != best || other > rival);
    }));
  }
  return universes;
}

std::vector<BestRival> best_rivals(const Multiverse& multiverse, std::size_t solver) {
  std::vector<BestRival> all;
  for (std::size_t g = 0; g < multiverse.studies.size(); ++g) {
    const Multiverse::OfStudy& study = multiverse.studies[g];
    PooledMeans means;
    for (const auto& of_solver : study.solvers) {
      means.emplace_back();
      for (const Multiverse::Own& own : of_solver) means.back().push_back(pooled(own));
    }
    for (std::size_t rival = 0; rival < means.size(); ++rival) {
      if (rival == solver) continue;
      for (const PooledMean& theirs : means[rival]) {
        const double universes = universes_of_best(means, solver, rival, theirs.mean);
        if (universes == 0) continue;
        for (std::size_t a = 0; a < means[solver].size(); ++a) {
          const PooledMean& ours = means[solver][a];
          const double estimate = std::log10(ours.mean / theirs.mean);
          if (!std::isfinite(estimate)) continue;
          all.push_back({.estimate = estimate,
                         .error = std::hypot(ours.error / ours.mean, theirs.error / theirs.mean) / std::log(10),
                         .universes = universes,
                         .weight = universes * study.weight / study.universes(),
                         .study = g,
                         .own = a,
                         .rival = rival});
        }
      }
    }
  }
  std::ranges::stable_sort(all, {}, &BestRival::estimate);
  return all;
}

// The rows of the choices, by dimension and alternative; rivals are rows of a separate group.
struct CurveRows {
  std::vector<SpecificationCurve::Group> groups;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> of_choice;
  std::map<std::size_t, std::size_t> of_rival;
};

CurveRows rows_of_curve(const Multiverse& multiverse, std::size_t solver) {
  CurveRows rows;
  std::size_t row = 0;
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    const Multiverse::Dimension& dimension = multiverse.dimensions[d];
    if (!dimension.solver.empty() && dimension.solver != multiverse.solvers[solver]) continue;
    auto& group = rows.groups.emplace_back();
    group.name = dimension.name;
    for (std::size_t a = 0; a < dimension.alternatives.size(); ++a) {
      group.rows.push_back(dimension.alternatives[a].where);
      rows.of_choice[{d, a}] = row++;
    }
  }
  rows.groups.push_back({.name = "best rival", .rows = {}});
  for (std::size_t s = 0; s < multiverse.solvers.size(); ++s) {
    if (s == solver) continue;
    rows.groups.back().rows.push_back("best rival: " + multiverse.solvers[s]);
    rows.of_rival[s] = row++;
  }
  return rows;
}

SpecificationCurve::Universe drawn(const Multiverse& multiverse, const BestRival& from, std::size_t solver,
                                   const CurveRows& rows) {
  const double reach = normal_critical(0.95) * from.error;
  SpecificationCurve::Universe universe{
      .estimate = from.estimate, .low = from.estimate - reach, .high = from.estimate + reach, .rows = {}};
  const Multiverse::OfStudy& study = multiverse.studies[from.study];
  for (const auto* chosen : {&study.chosen, &study.solvers[solver][from.own].chosen}) {
    for (const Multiverse::Choice& each : *chosen) {
      universe.rows.push_back(rows.of_choice.at({each.dimension, each.alternative}));
    }
  }
  universe.rows.push_back(rows.of_rival.at(from.rival));
  return universe;
}

}  // namespace

Figure error_curve(const Multiverse& multiverse, const std::string& label) {
  const auto solver =
      static_cast<std::size_t>(std::ranges::find(multiverse.solvers, label) - multiverse.solvers.begin());
  const std::vector<BestRival> all = best_rivals(multiverse, solver);
  double universes = 0, weight = 0;
  for (const BestRival& each : all) {
    universes += each.universes;
    weight += each.weight;
  }
  const CurveRows rows = rows_of_curve(multiverse, solver);
  SpecificationCurve curve{.name = "multiverse",
                           .quantity = fmt::format("mean error of {} / of its best rival", label),
                           .below = label + " is more accurate",
                           .above = "its best rival is",
                           .groups = rows.groups};
  const auto count = static_cast<std::size_t>(std::min(universes, static_cast<double>(most_drawn)));
  double before = 0;
  auto at = all.begin();
  for (std::size_t i = 0; i < count; ++i) {
    const double rank = (static_cast<double>(i) + 0.5) / static_cast<double>(count) * weight;
    while (at + 1 != all.end() && before + at->weight < rank) before += (at++)->weight;
    curve.universes.push_back(drawn(multiverse, *at, solver, rows));
  }
  curve.caption = fmt::format(
      "Specification curve: mean error of {} divided by that of its best rival, with 95 % intervals, in {} of {} "
      "interpretations, sorted by it and drawn evenly by their weight. Dots below: the choices of each, "
      "without those of the rivals.",
      label, count, count_words(universes));
  return specification_curve(curve);
}

}  // namespace ikbench::claims
