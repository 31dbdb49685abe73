#include "analysis/claims/multiverse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

#include "analysis/claims/multiverse_printed.hpp"
#include "analysis/figures/specification_curve.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::claims {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;
using namespace report;

namespace {

// The dimensions that decide nearly as much as the one that decides most, which comes first.
std::vector<std::size_t> deciding_dimensions(const Multiverse& multiverse, const ClaimCounts& counts) {
  constexpr double nearly = 0.8;
  std::vector<std::size_t> result;
  const std::size_t most = counts.deciding();
  if (most == multiverse.dimensions.size()) return result;
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    if (counts.difference(d) >= nearly * counts.difference(most)) result.push_back(d);
  }
  std::ranges::stable_sort(result, std::greater<>(), [&](std::size_t d) { return counts.difference(d); });
  return result;
}

// "who obeys limits (3 % where no solver is clamped, 90 % where every solver is)": the least share first.
std::string words_of_dimension(const Multiverse& multiverse, const ClaimCounts& counts, std::size_t dimension) {
  struct Part {
    double share;
    std::string where;
  };
  std::vector<Part> parts;
  for (std::size_t a = 0; a < counts.alternatives[dimension].size(); ++a) {
    const UniverseCounts& each = counts.alternatives[dimension][a];
    if (each.all() > 0)
      parts.push_back({each.holds / each.all(), multiverse.dimensions[dimension].alternatives[a].where});
  }
  std::ranges::stable_sort(parts, {}, &Part::share);
  std::string words;
  for (const Part& part : parts) {
    words += fmt::format("{}{} where {}", words.empty() ? "" : ", ", share_words(part.share), part.where);
  }
  return fmt::format("{} ({})", multiverse.dimensions[dimension].open, words);
}

ClaimShares shares_of(const Multiverse& multiverse, const ClaimCounts& counts) {
  const double all = counts.all.all(), holds = counts.all.holds / all, fails = counts.all.fails / all,
               undecided = counts.all.undecided / all;
  std::vector<std::string> names;
  std::string words;
  const std::vector<std::size_t> deciding = deciding_dimensions(multiverse, counts);
  for (const std::size_t d : deciding) {
    names.push_back(multiverse.dimensions[d].open);
    words += (words.empty() ? " It depends most on " : "; on ") + words_of_dimension(multiverse, counts, d);
  }
  if (!words.empty()) words += '.';
  return {.id = counts.claim.id,
          .holds = holds,
          .fails = fails,
          .undecided = undecided,
          .decided_by = names,
          .sentence = fmt::format("{} in {} of the interpretations ({} fail, {} undecided).{}", counts.claim.words,
                                  share_words(holds), share_words(fails), share_words(undecided), words)};
}

Cell percent_cell(double part, double all) {
  if (all == 0) return {};
  return std::round(1000 * part / all) / 10 + 0.0;
}

// The largest difference between two seeds in one of the three shares, in percentage points.
Cell seed_difference(const ClaimCounts& counts) {
  if (counts.seeds.size() < 2) return {};
  double largest = 0;
  for (const auto share : {&UniverseCounts::holds, &UniverseCounts::fails, &UniverseCounts::undecided}) {
    const auto [least, most] = std::ranges::minmax(counts.seeds, {}, share);
    largest = std::max(largest, most.*share - least.*share);
  }
  return percent_cell(largest, counts.seeds.front().all());
}

Table claims_table(const Multiverse& multiverse, const std::vector<ClaimCounts>& all, const AnalysisPlan& plan) {
  Table table{.name = "multiverse",
              .caption = "The paper's claims in every interpretation of what the paper leaves open",
              .columns = {"claim", "holds_percent", "fails_percent", "undecided_percent", "deciding_dimension",
                          "difference_percent", "between_seeds_percent", "id"}};
  for (const ClaimCounts& counts : all) {
    const double weight = counts.all.all();
    if (weight == 0) continue;
    const std::size_t deciding = counts.deciding();
    const bool is_decided = deciding < multiverse.dimensions.size();
    table.rows.push_back(
        {counts.claim.words, percent_cell(counts.all.holds, weight), percent_cell(counts.all.fails, weight),
         percent_cell(counts.all.undecided, weight), is_decided ? Cell(multiverse.dimensions[deciding].open) : Cell(),
         is_decided ? percent_cell(counts.difference(deciding), 1) : Cell(), seed_difference(counts), counts.claim.id});
  }
  table.notes.push_back(fmt::format(
      "{} interpretations: {} choices for the study, each with every combination of the solvers' own. All are counted. The "
      "alternatives of the study weigh alike, given what was chosen before them, and so do the interpretations of a choice for "
      "the study. A claim holds where its solver is found better than each rival, and fails where a rival is found "
      "better: by Games and Howell's test of the run means at {}, for {} solvers. It stands in for the test of the study's "
      "plan because it needs two solvers at a time, so that pairs can be counted.",
      count_words(multiverse.universes()), multiverse.studies.size(), plan.significance, multiverse.solvers.size()));
  table.notes.emplace_back(
      "deciding_dimension: between whose alternatives the share that holds differs most, with that difference. "
      "between_seeds: largest difference between two seeds in one of these shares; each seed is a study of its own.");
  const auto out_of_reach =
      std::ranges::count_if(multiverse.studies, [](const auto& study) { return study.out_of_reach > 0; });
  if (out_of_reach > 0) {
    table.notes.push_back(
        fmt::format("In {} of the choices for the study some targets are out of reach.", out_of_reach));
  }
  return table;
}

Table alternatives_table(const Multiverse& multiverse, const std::vector<ClaimCounts>& all) {
  Table table{.name = "multiverse-alternatives",
              .caption = "Share of the interpretations with each alternative in which a claim holds, in percent",
              .columns = {"alternative", "notes", "default"}};
  for (const ClaimCounts& counts : all) {
    if (counts.all.all() > 0) table.columns.push_back(counts.claim.id);
  }
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    const Multiverse::Dimension& dimension = multiverse.dimensions[d];
    for (std::size_t a = 0; a < dimension.alternatives.size(); ++a) {
      std::vector<Cell> row{dimension.alternatives[a].set, dimension.section, a == 0 ? Cell("default") : Cell()};
      for (const ClaimCounts& counts : all) {
        const UniverseCounts& of = counts.alternatives[d][a];
        if (counts.all.all() > 0) row.push_back(percent_cell(of.holds, of.all()));
      }
      table.rows.push_back(std::move(row));
      table.notes.push_back(fmt::format("{}: {}.", dimension.alternatives[a].set, dimension.alternatives[a].where));
    }
  }
  return table;
}

// The curve draws some universes, evenly by rank, and pools the runs of all seeds.
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

PooledMean pooled(const Multiverse::ChosenSolver& own) {
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
      for (const Multiverse::ChosenSolver& own : of_solver) means.back().push_back(pooled(own));
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

// The rows of the choices, by dimension and alternative; the rivals that are drawn are rows of a separate group.
struct CurveRows {
  std::vector<SpecificationCurve::Group> groups;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> of_choice;
  std::map<std::size_t, std::size_t> of_rival;
};

CurveRows rows_of_curve(const Multiverse& multiverse, std::size_t solver, const std::vector<const BestRival*>& chosen) {
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
    if (std::ranges::find(chosen, s, &BestRival::rival) == chosen.end()) continue;
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

// The specification curve of one solver's mean error by that of its best rival.
Figure error_curve(const Multiverse& multiverse, const std::string& label) {
  const auto solver =
      static_cast<std::size_t>(std::ranges::find(multiverse.solvers, label) - multiverse.solvers.begin());
  const std::vector<BestRival> all = best_rivals(multiverse, solver);
  double universes = 0, weight = 0;
  for (const BestRival& each : all) {
    universes += each.universes;
    weight += each.weight;
  }
  const auto count = static_cast<std::size_t>(std::min(universes, static_cast<double>(most_drawn)));
  std::vector<const BestRival*> chosen;
  double before = 0;
  auto at = all.begin();
  for (std::size_t i = 0; i < count; ++i) {
    const double rank = (static_cast<double>(i) + 0.5) / static_cast<double>(count) * weight;
    while (at + 1 != all.end() && before + at->weight < rank) before += (at++)->weight;
    chosen.push_back(&*at);
  }
  const CurveRows rows = rows_of_curve(multiverse, solver, chosen);
  SpecificationCurve curve{.name = "multiverse",
                           .quantity = fmt::format("mean error of {} / of its best rival", label),
                           .below = label + " is more accurate",
                           .above = "its best rival is",
                           .groups = rows.groups};
  for (const BestRival* each : chosen) curve.universes.push_back(drawn(multiverse, *each, solver, rows));
  curve.caption = fmt::format(
      "Specification curve: mean error of {} divided by that of its best rival, with 95 % intervals, in {} of {} "
      "interpretations, sorted by it and drawn evenly by their weight. Dots below: the choices of each, "
      "without those of the rivals. A colour follows the interval against that one rival; a claim needs the test against all "
      "rivals, so its shares differ.",
      label, count, count_words(universes));
  return specification_curve(curve);
}

}  // namespace

std::vector<MultiverseClaim> claims_in_universes(const ClaimsFile& file) {
  std::vector<MultiverseClaim> claims;
  for (const ClaimEntry& entry : file.entries) {
    for (const Estimand by : entry.universes) {
      const bool is_typical = by == Estimand::typical;
      claims.push_back({.id = entry.id + (is_typical ? "_typically" : ""),
                        .words = entry.sentence + (is_typical ? " by geometric means" : ""),
                        .solver = entry.solver,
                        .rival = entry.against,
                        .metric = entry.metrics.front(),
                        .by = by,
                        .effect_of = entry.dimension});
    }
  }
  return claims;
}

MultiverseReport multiverse_report(const ClaimsFile& file, const Multiverse& multiverse, const AnalysisPlan& plan) {
  if (multiverse.studies.empty() || multiverse.seeds() == 0) {
    throw std::invalid_argument("no universe to report; expected the default first");
  }
  if (std::ranges::find(multiverse.solvers, file.solver) == multiverse.solvers.end()) {
    throw std::invalid_argument(fmt::format("no universe has the solver {}", file.solver));
  }
  const std::vector<ClaimCounts> all = counted(multiverse, claims_in_universes(file), plan);
  MultiverseReport result;
  for (const ClaimCounts& counts : all) {
    if (counts.all.all() > 0) result.claims.push_back(shares_of(multiverse, counts));
  }
  result.tables = {claims_table(multiverse, all, plan), alternatives_table(multiverse, all)};
  result.figures = {error_curve(multiverse, file.solver)};
  add_printed(result, file, multiverse);
  return result;
}

}  // namespace ikbench::claims
