#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/claims/claim_counts.hpp"
#include "analysis/claims/explained.hpp"
#include "analysis/claims/multiverse.hpp"
#include "analysis/report/report_content.hpp"

namespace ikbench::claims {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

using Verdicts = std::vector<std::string>;  // "most_accurate holds"

// A universe: each solver has one choice.
struct Lone {
  Multiverse universe;
  std::optional<Choice> departure = {};  // the choice that is not a default

  const Multiverse::ChosenSolver& own(std::size_t solver) const {
    return universe.studies.front().solvers[solver].front();
  }
};

// The universe of a study's choice in which a solver has one of its own choices and the others their first.
Lone lone(const Multiverse& all, const Multiverse::OfStudy& study, std::size_t solver, std::size_t own) {
  Lone one{.universe = {.dimensions = all.dimensions, .solvers = all.solvers, .studies = {}}};
  Multiverse::OfStudy& only = one.universe.studies.emplace_back(
      Multiverse::OfStudy{.chosen = study.chosen, .out_of_reach = study.out_of_reach});
  std::vector<Choice> chosen = study.chosen;
  for (std::size_t s = 0; s < all.solvers.size(); ++s) {
    only.solvers.push_back({study.solvers[s][s == solver ? own : 0]});
    const std::vector<Choice>& more = only.solvers.back().front().chosen;
    chosen.insert(chosen.end(), more.begin(), more.end());
  }
  const auto found = std::ranges::find_if(chosen, [](const Choice& each) { return each.alternative > 0; });
  if (found != chosen.end()) one.departure = *found;
  return one;
}

// The default first, then in the order of the dimensions.
std::vector<Lone> lone_universes(const Multiverse& multiverse) {
  std::vector<Lone> all;
  for (const Multiverse::OfStudy& study : multiverse.studies) {
    for (std::size_t s = 0; s < study.solvers.size(); ++s) {
      for (std::size_t own = s == 0 ? 0 : 1; own < study.solvers[s].size(); ++own) {
        all.push_back(lone(multiverse, study, s, own));
      }
    }
  }
  std::ranges::stable_sort(all, {}, [](const Lone& each) {
    const auto [dimension, alternative] = each.departure.value_or(Choice{0, 0});
    return std::pair(dimension, alternative);
  });
  return all;
}

// "holds", or "holds in 67 %, undecided in 33 %" if seeds differ.
std::string verdict_words(const UniverseCounts& counts) {
  std::vector<std::string> words;
  for (const auto& [part, word] :
       {std::pair(counts.holds, "holds"), std::pair(counts.fails, "fails"), std::pair(counts.undecided, "undecided")}) {
    if (part == counts.all()) return word;
    if (part > 0) words.push_back(fmt::format("{} in {}", word, share_words(part / counts.all())));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

Verdicts verdicts_in(const ClaimsFile& file, const Multiverse& universe, const AnalysisPlan& plan) {
  Verdicts all;
  for (const ClaimCounts& counts : counted(universe, file.entries, plan)) {
    if (counts.all.all() > 0) all.push_back(fmt::format("{} {}", counts.id, verdict_words(counts.all)));
  }
  return all;
}

Cell rounded(double value) { return std::isfinite(value) ? std::round(value * 1000) / 1000 + 0.0 : value; }

}  // namespace

Table one_at_a_time(const ClaimsFile& file, const Multiverse& multiverse, const AnalysisPlan& plan) {
  if (multiverse.studies.empty() || multiverse.seeds() == 0) {
    throw std::invalid_argument("no universe to report; expected the default first");
  }
  PrintedSolvers printed(file, multiverse);
  Table table{
      .name = "multiverse-one-at-a-time",
      .caption =
          fmt::format("Each alternative alone: what it changes, compared with the printed {}", title_of(file.means)),
      .columns = {"alternative", "notes", "out_of_reach", "algorithm", "error_cm", "error_log_ratio", "error_moved",
                  "variation_deg", "variation_log_ratio", "variation_moved", "explained", "claims"},
      .notes = {fmt::format(
          "Means over the runs of {} seed{}. log_ratio: log10 of our mean divided by the printed mean; 0 means equal, 0.3 "
          "means twice as large. Rows for all algorithms have the root mean square. moved: change of log_ratio "
          "against the default. Algorithms without a row equal the default bit for bit. explained: of the "
          "algorithm's ten printed numbers, how many lie in the range that 95 % of studies of {} runs would have "
          "(Hill's A(n)). claims: by default all, elsewhere those that become another. out_of_reach: number "
          "of targets that no configuration reaches.",
          multiverse.seeds(), multiverse.seeds() == 1 ? "" : "s", printed.most_runs())}};
  const bool has_explained = printed.numbers() > 0;
  const std::vector<Lone> universes = lone_universes(multiverse);
  const Lone& usual = universes.front();
  const Verdicts verdicts = verdicts_in(file, usual.universe, plan);
  const auto log_ratio = [&](const Lone& of, std::size_t solver, std::size_t metric) {
    return std::log10(mean(pooled(of.own(solver), explained_metrics[metric])) /
                      printed.row(solver, metric).printed.mean);
  };
  const auto distance = [&](const Lone& of, std::size_t metric) {
    double sum = 0;
    for (std::size_t s = 0; s < multiverse.solvers.size(); ++s) sum += std::pow(log_ratio(of, s, metric), 2);
    return std::sqrt(sum / static_cast<double>(multiverse.solvers.size()));
  };
  for (const Lone& each : universes) {
    std::vector<Cell> head{"default", Cell(), std::int64_t{each.universe.studies.front().out_of_reach}};
    if (each.departure) {
      const Dimension& dimension = multiverse.dimensions[each.departure->dimension];
      const Alternative& alternative = dimension.alternatives[each.departure->alternative];
      head[0] = alternative.set;
      head[1] = dimension.section;
      table.notes.push_back(fmt::format("{}: {}.", alternative.set, alternative.where));
    }
    const auto add_ratios = [&](std::vector<Cell>& row, double ratio, double of_default) {
      row.push_back(rounded(ratio));
      row.push_back(each.departure ? rounded(ratio - of_default) : Cell());
    };
    std::vector<Cell> all = head;
    all.emplace_back("all");
    for (std::size_t m = 0; m < explained_metrics.size(); ++m) {
      all.emplace_back();
      add_ratios(all, distance(each, m), distance(usual, m));
    }
    const std::size_t place = table.rows.size();
    table.rows.emplace_back();
    std::int64_t explained = 0;
    for (std::size_t s = 0; s < multiverse.solvers.size(); ++s) {
      const Multiverse::ChosenSolver &own = each.own(s), &before = usual.own(s);
      const auto of_solver = static_cast<std::int64_t>(has_explained ? printed.explained(s, own).count() : 0);
      explained += of_solver;
      const bool is_same = own.error_cm == before.error_cm && own.variation_deg == before.variation_deg;
      if (each.departure && is_same) continue;
      std::vector<Cell>& row = table.rows.emplace_back(head);
      row.emplace_back(multiverse.solvers[s]);
      for (std::size_t m = 0; m < explained_metrics.size(); ++m) {
        row.emplace_back(mean(pooled(own, explained_metrics[m])));
        add_ratios(row, log_ratio(each, s, m), log_ratio(usual, s, m));
      }
      row.push_back(has_explained ? Cell(of_solver) : Cell());
      row.emplace_back();
    }
    Verdicts changed = verdicts_in(file, each.universe, plan);
    if (each.departure) {
      std::erase_if(changed, [&](const std::string& verdict) { return std::ranges::count(verdicts, verdict) > 0; });
    }
    all.push_back(has_explained ? Cell(explained) : Cell());
    all.emplace_back(fmt::format("{}", fmt::join(changed, "; ")));
    table.rows[place] = std::move(all);
  }
  return table;
}

}  // namespace ikbench::claims
