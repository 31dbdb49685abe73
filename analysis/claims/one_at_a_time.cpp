#include "analysis/claims/one_at_a_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/claims/multiverse.hpp"
#include "analysis/claims/multiverse_printed.hpp"
#include "analysis/claims/printed.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/report_content.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::claims {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

constexpr std::array<Metric, 2> compared_metrics{Metric::position_error_cm, Metric::variation_deg};

// The universe of a study's choice in which a solver has one of its own choices and the others their first, as a
// separate multiverse.
Multiverse universe_of(const Multiverse& all, const Multiverse::OfStudy& study, std::size_t solver, std::size_t own) {
  Multiverse one{.dimensions = all.dimensions, .solvers = all.solvers, .studies = {}};
  one.studies.push_back({.chosen = study.chosen, .weight = 1, .out_of_reach = study.out_of_reach, .solvers = {}});
  for (std::size_t s = 0; s < all.solvers.size(); ++s) {
    one.studies.front().solvers.push_back({study.solvers[s][s == solver ? own : 0]});
  }
  return one;
}

const Multiverse::ChosenSolver& own_of(const Multiverse& universe, std::size_t solver) {
  return universe.studies.front().solvers[solver].front();
}

// The choice that is not a default; none for the default universe.
std::optional<Choice> departure_of(const Multiverse& universe) {
  Chosen chosen = universe.studies.front().chosen;
  for (std::size_t s = 0; s < universe.solvers.size(); ++s) {
    const Chosen& own = own_of(universe, s).chosen;
    chosen.insert(chosen.end(), own.begin(), own.end());
  }
  const auto found = std::ranges::find_if(chosen, [](const Choice& each) { return each.alternative > 0; });
  return found == chosen.end() ? std::nullopt : std::optional(*found);
}

// The default first, then in the order of the dimensions.
std::vector<Multiverse> universes_of(const Multiverse& multiverse) {
  std::vector<Multiverse> universes;
  for (const Multiverse::OfStudy& study : multiverse.studies) {
    for (std::size_t s = 0; s < study.solvers.size(); ++s) {
      for (std::size_t own = s == 0 ? 0 : 1; own < study.solvers[s].size(); ++own) {
        universes.push_back(universe_of(multiverse, study, s, own));
      }
    }
  }
  std::ranges::stable_sort(universes, {}, [](const Multiverse& each) {
    const std::optional<Choice> choice = departure_of(each);
    return choice ? std::pair(choice->dimension, choice->alternative) : std::pair(std::size_t{0}, std::size_t{0});
  });
  return universes;
}

double pooled_mean(const std::vector<std::vector<double>>& seeds) {
  std::vector<double> all;
  for (const std::vector<double>& runs : seeds) all.insert(all.end(), runs.begin(), runs.end());
  return mean(all);
}

// log10 of our mean by the printed one.
double log_ratio(const ClaimsFile& file, const Multiverse& universe, std::size_t solver, Metric metric) {
  const std::vector<PrintedRow> rows = printed_rows(file.paper, file.means, metric);
  const auto row = std::ranges::find(rows, universe.solvers[solver], &PrintedRow::algorithm);
  if (row == rows.end()) return not_defined;
  return std::log10(pooled_mean(values_of(own_of(universe, solver), metric)) / row->printed.mean);
}

// All solvers at once: root mean square of the log ratios.
double distance(const ClaimsFile& file, const Multiverse& universe, Metric metric) {
  double sum = 0;
  for (std::size_t s = 0; s < universe.solvers.size(); ++s) sum += std::pow(log_ratio(file, universe, s, metric), 2);
  return std::sqrt(sum / static_cast<double>(universe.solvers.size()));
}

bool is_same(const Multiverse::ChosenSolver& one, const Multiverse::ChosenSolver& other) {
  return one.error_cm == other.error_cm && one.variation_deg == other.variation_deg;
}

// "holds", or "holds in 67 %, undecided in 33 %" if seeds differ.
std::string verdict_words(const UniverseCounts& counts) {
  std::string words;
  for (const auto& [part, word] :
       {std::pair(counts.holds, "holds"), std::pair(counts.fails, "fails"), std::pair(counts.undecided, "undecided")}) {
    if (part == 0) continue;
    if (part == counts.all()) return word;
    words += fmt::format("{}{} in {}", words.empty() ? "" : ", ", word, share_words(part / counts.all()));
  }
  return words;
}

using Verdicts = std::vector<std::pair<std::string, std::string>>;  // of each claim, by id

Verdicts verdicts_in(const ClaimsFile& file, const Multiverse& universe, const AnalysisPlan& plan) {
  Verdicts all;
  for (const ClaimCounts& counts : counted(universe, claims_in_universes(file), plan)) {
    if (counts.all.all() > 0) all.emplace_back(counts.claim.id, verdict_words(counts.all));
  }
  return all;
}

// The verdicts that differ from the usual ones; all if there are none.
std::string changed_verdicts(const Verdicts& verdicts, const Verdicts& usual) {
  std::string words;
  for (const auto& each : verdicts) {
    if (std::ranges::find(usual, each) != usual.end()) continue;
    words += fmt::format("{}{} {}", words.empty() ? "" : "; ", each.first, each.second);
  }
  return words;
}

Cell rounded(double value) { return std::isfinite(value) ? std::round(value * 1000) / 1000 + 0.0 : value; }

}  // namespace

Table one_at_a_time(const ClaimsFile& file, const Multiverse& multiverse, const AnalysisPlan& plan) {
  if (multiverse.studies.empty() || multiverse.seeds() == 0) {
    throw std::invalid_argument("no universe to report; expected the default first");
  }
  Table table{
      .name = "multiverse-one-at-a-time",
      .caption =
          fmt::format("Each alternative alone: what it changes, compared with the printed {}", title_of(file.means)),
      .columns = {"alternative", "notes", "out_of_reach", "algorithm", "error_cm", "error_log_ratio", "error_moved",
                  "variation_deg", "variation_log_ratio", "variation_moved", "explained", "claims"}};
  const std::vector<Multiverse> universes = universes_of(multiverse);
  const std::vector<std::vector<int>> explained = explained_numbers(file, universes);
  const Multiverse& usual = universes.front();
  const Verdicts verdicts = verdicts_in(file, usual, plan);
  for (std::size_t u = 0; u < universes.size(); ++u) {
    const Multiverse& universe = universes[u];
    const std::optional<Choice> choice = departure_of(universe);
    const Dimension* const dimension = choice ? &multiverse.dimensions[choice->dimension] : nullptr;
    const std::string name = choice ? dimension->alternatives[choice->alternative].set : "default";
    const std::vector<Cell> head{name, choice ? Cell(dimension->section) : Cell(),
                                 std::int64_t{universe.studies.front().out_of_reach}};
    const auto add = [&](const std::string& label, std::optional<std::size_t> solver) {
      std::vector<Cell>& row = table.rows.emplace_back(head);
      row.emplace_back(label);
      for (const Metric metric : compared_metrics) {
        const auto against_print = [&](const Multiverse& of) {
          return solver ? log_ratio(file, of, *solver, metric) : distance(file, of, metric);
        };
        row.push_back(solver ? Cell(pooled_mean(values_of(own_of(universe, *solver), metric))) : Cell());
        row.push_back(rounded(against_print(universe)));
        row.push_back(u == 0 ? Cell() : rounded(against_print(universe) - against_print(usual)));
      }
      row.push_back(explained.empty() ? Cell()
                    : solver          ? Cell(std::int64_t{explained[u][*solver]})
                             : Cell(std::accumulate(explained[u].begin(), explained[u].end(), std::int64_t{})));
      row.push_back(solver ? Cell()
                           : Cell(changed_verdicts(verdicts_in(file, universe, plan), choice ? verdicts : Verdicts())));
    };
    add("all", std::nullopt);
    for (std::size_t s = 0; s < universe.solvers.size(); ++s) {
      if (!choice || !is_same(own_of(universe, s), own_of(usual, s))) add(universe.solvers[s], s);
    }
    if (choice) table.notes.push_back(fmt::format("{}: {}.", name, dimension->alternatives[choice->alternative].where));
  }
  table.notes.insert(
      table.notes.begin(),
      fmt::format(
          "Means over the runs of {} seed{}. log_ratio: log10 of our mean divided by the printed mean; 0 means equal, 0.3 "
          "means twice as large. Rows for all algorithms have the root mean square. moved: change of log_ratio "
          "against the default. Algorithms without a row equal the default bit for bit. explained: of the "
          "algorithm's ten printed numbers, how many lie in the range that 95 % of studies of 20 runs would have "
          "(Hill's A(n)). claims: by default all, elsewhere those that become another. out_of_reach: number "
          "of targets that no configuration reaches.",
          multiverse.seeds(), multiverse.seeds() == 1 ? "" : "s"));
  return table;
}

}  // namespace ikbench::claims
