#include "analysis/claims/multiverse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "analysis/claims/multiverse_curve.hpp"
#include "analysis/claims/multiverse_printed.hpp"

namespace ikbench::claims {

using namespace results;
using namespace inference;
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
                                  share_words(holds), share_words(fails), share_words(undecided), words),
          .of = count_words(multiverse.universes())};
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

}  // namespace

std::vector<MultiverseClaim> claims_in_universes(const ClaimsFile& file) {
  std::vector<MultiverseClaim> claims;
  for (const ClaimEntry& entry : file.entries) {
    for (const JudgedBy by : entry.universes) {
      const bool is_typical = by == JudgedBy::typical;
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
