#include "analysis/papers/multiverse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/papers/published.hpp"
#include "analysis/show/text.hpp"
#include "base/names.hpp"

namespace ikbench::papers {

using namespace judge;
using results::Choice;
using results::Chosen;
using results::Dimension;

namespace {

using ChosenSolver = SolvedMultiverse::ChosenSolver;
using OfStudy = SolvedMultiverse::OfStudy;
using Names = std::vector<std::string>;

bool contains(const auto& all, const auto& one) { return std::ranges::find(all, one) != all.end(); }

std::size_t place_of(const Names& all, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(all, name) - all.begin());
}

// If it is that a solver is better in error, variation or their spread.
bool hangs_on_reading(const Claim& claim) {
  return claim.rule != nullptr && claim.rule->name == "better" && claim.metrics.size() == 1 && claim.study.empty() &&
         contains(metrics_of_readings, claim.metrics.front()->column);
}

Verdict verdict_of(const Group& own, const Group& theirs, const Claim& claim, const Plan& plan) {
  Observations observed = observations_of(*claim.metrics.front());
  observed.groups = {own, theirs};
  return judge::verdict_of(judge::compare(claim.of == Of::spread ? deviations(observed) : observed, plan).front());
}

// How the claim's solvers, by one choice of the study and of each of them, do against each choice of each rival.
struct Against {
  const Chosen* chosen;
  Holds holds;
};
struct Part {
  Chosen chosen;
  std::vector<std::vector<Against>> rivals;
  double others;  // choices of solvers that the claim is not about
};

// One of the combinations of the choices of these solvers: by solver, its choice; none after the last.
using OwnChoices = std::map<std::size_t, std::size_t>;
OwnChoices combination(const OfStudy& study, const std::vector<std::size_t>& solvers, std::size_t number) {
  OwnChoices chosen;
  for (const std::size_t solver : solvers) {
    chosen[solver] = number % study.solvers[solver].size();
    number /= study.solvers[solver].size();
  }
  return number == 0 ? chosen : OwnChoices();
}

// None if a solver of the claim is missing.
std::vector<Part> parts_of(const SolvedMultiverse& multiverse, const Claim& claim, const results::Plan& plan) {
  const Names& solvers = multiverse.solvers;
  const std::size_t k = solvers.size(), metric = claim.metrics.front()->column == metrics_of_readings[0] ? 0 : 1;
  std::vector<std::size_t> own, rivals;
  for (const std::string& solver : claim.solvers) own.push_back(place_of(solvers, solver));
  for (const std::string& solver : claim.against.empty() ? solvers : claim.against)
    if (!contains(claim.solvers, solver)) rivals.push_back(place_of(solvers, solver));
  if (contains(own, k) || contains(rivals, k)) return {};
  // Of each pair alone, by Welch's t, at its part of the significance, as a report judges a pair of these solvers.
  const Plan of_pair{.test = Plan::Test::means,
                     .significance = plan.significance / (static_cast<double>(k * (k - 1)) / 2),
                     .margin = plan.margin};
  std::vector<Part> parts;
  for (const OfStudy& study : multiverse.studies) {
    for (std::size_t seed = 0; seed < study.solvers[0][0].parts.size(); ++seed) {
      const auto verdict = [&](const ChosenSolver& one, const ChosenSolver& other) {
        return verdict_of(multiverse.means[one.parts[seed]][metric], multiverse.means[other.parts[seed]][metric], claim,
                          of_pair);
      };
      OwnChoices chosen;
      for (std::size_t number = 0; !(chosen = combination(study, own, number)).empty(); ++number) {
        Part& part = parts.emplace_back(Part{study.chosen, {}, study.readings()});
        for (const auto& [solver, choice] : chosen) {
          const Chosen& more = study.solvers[solver][choice].chosen;
          part.chosen.insert(part.chosen.end(), more.begin(), more.end());
          part.others /= static_cast<double>(study.solvers[solver].size());
        }
        for (const std::size_t rival : rivals) {
          part.others /= static_cast<double>(study.solvers[rival].size());
          std::vector<Against>& against = part.rivals.emplace_back();
          for (const ChosenSolver& theirs : study.solvers[rival]) {
            Tally tally;
            for (const auto& [solver, choice] : chosen) tally.add(verdict(study.solvers[solver][choice], theirs));
            against.push_back({&theirs.chosen, holds_of(tally)});
          }
        }
      }
    }
  }
  return parts;
}

// Of a part, those that have another answer than this one.
InReadings count(const Part& part, const Choice* without = nullptr) {
  if (without != nullptr && contains(part.chosen, *without)) return {};
  double all = part.others, hold = all, fail_not = all;
  for (const std::vector<Against>& rival : part.rivals) {
    double options = 0, better = 0, worse = 0;
    for (const auto& [chosen, holds] : rival) {
      if (without != nullptr && contains(*chosen, *without)) continue;
      ++options;
      better += holds == Holds::holds;
      worse += holds == Holds::fails;
    }
    all *= options;
    hold *= better;
    fail_not *= options - worse;
  }
  return {hold, all - fail_not, fail_not - hold};
}

InReadings in_readings(const SolvedMultiverse& multiverse, const std::vector<Part>& parts) {
  InReadings of_all;
  for (const Part& part : parts) {
    const InReadings counts = count(part);
    of_all.hold += counts.hold, of_all.fail += counts.fail, of_all.open += counts.open;
  }
  double fewest = of_all.fail;  // without one answer, other than a default
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    for (std::size_t a = 1; a < multiverse.dimensions[d].alternatives.size(); ++a) {
      const Choice answer{d, a};
      double without = 0;
      for (const Part& part : parts) without += count(part, &answer).fail;
      if (without >= fewest) continue;
      fewest = without;
      const results::Alternative& its = multiverse.dimensions[d].alternatives[a];
      of_all.most_fail = fmt::format("{:.0f} with {} ({})", of_all.fail - without, its.set, its.where);
    }
  }
  return of_all;
}

}  // namespace

Group group_of(std::vector<double> runs) {
  const auto lost = static_cast<int>(std::erase_if(runs, [](double value) { return !std::isfinite(value); }));
  if (lost > 0) return {.sample = Untold{.lost = lost, .values = std::move(runs)}};
  return {.sample = Measured{std::move(runs)}};
}

JudgedMultiverse judged(const Paper& paper, const SolvedMultiverse& multiverse, const results::Plan& plan) {
  JudgedMultiverse result{.in_readings = {},
                          .table = {.name = "multiverse",
                                    .caption = "The claims in every reading",
                                    .columns = show::columns_of(
                                        {"claim", "holds", "fails", "not decided", "most failures with one answer"}),
                                    .is_of_study = false}};
  for (const Claim& claim : paper.claims) {
    if (!hangs_on_reading(claim)) continue;
    const std::vector<Part> parts = parts_of(multiverse, claim, plan);
    if (parts.empty()) continue;
    const InReadings& counts = result.in_readings[claim.id] = in_readings(multiverse, parts);
    const auto number = [](double count) { return static_cast<std::int64_t>(count); };
    result.table.rows.push_back({claim.sentence, number(counts.hold), number(counts.fail), number(counts.open),
                                 counts.most_fail.empty() ? "none" : counts.most_fail});
  }
  const std::size_t seeds = multiverse.studies[0].solvers[0][0].parts.size();
  const std::int64_t solvers = std::ssize(multiverse.solvers), pairs = solvers * (solvers - 1) / 2;
  result.table.notes = {
      fmt::format(
          "{:.0f} readings{}. A claim holds where its solvers are better than each rival, and fails where a rival is "
          "better, by Welch's t (spreads: of distances from the median) at {:g} / {} ({} of solvers).",
          static_cast<double>(seeds) * multiverse.readings(),
          seeds > 1 ? fmt::format(": {:.0f}, each with seeds 1 to {}", multiverse.readings(), seeds) : "",
          plan.significance, pairs, base::counted(pairs, "pairs")),
      fmt::format("A reading answers {} of the questions that the paper leaves open. Counts depend on the answers "
                  "listed: they are no chances.",
                  multiverse.dimensions.size())};
  return result;
}

SeedCounts counts_by_seed(const Paper& paper, const SolvedMultiverse& multiverse) {
  SeedCounts counts;
  const std::size_t seeds = multiverse.studies.front().solvers[0][0].parts.size();
  std::map<std::pair<std::size_t, std::size_t>, int> alike;  // numbers of the second seed in ranges of the first
  counts.all.resize(seeds);
  for (std::size_t m = 0; m < metrics_of_readings.size(); ++m) {
    for (const PrintedRow& row : printed_means(paper.name, paper.means, metrics_of_readings[m])) {
      const std::size_t solver = place_of(multiverse.solvers, row.solver);
      if (solver == multiverse.solvers.size()) continue;
      std::vector<Description> ours;
      std::vector<std::optional<Ranges>> ranges;
      std::vector<double> together;
      for (const std::size_t part : multiverse.studies.front().solvers[solver][0].parts) {
        const Group& group = multiverse.means[part][m];
        const std::vector<double> values(values_of(group).begin(), values_of(group).end());
        ranges.push_back(lost_in(group) > 0 ? std::nullopt : predicted_ranges(values, row.numbers.n));
        ours.push_back(described(values));
        together.insert(together.end(), values.begin(), values.end());
      }
      if (std::ranges::none_of(ranges, [](const auto& each) { return each.has_value(); })) return {};
      const std::optional<Ranges> of_all = predicted_ranges(together, row.numbers.n);
      const Description all = described(together);
      std::vector<int>& of_row = counts.rows[row.solver];
      of_row.resize(seeds);
      for (std::size_t s = 0; s < statistics.size(); ++s) {
        ++counts.of;
        counts.together += of_all && repeats(all.*statistics[s].of, (*of_all)[s], row.digits[s]);
        for (std::size_t seed = 0; seed < seeds; ++seed) {
          if (!ranges[seed]) continue;
          const Interval& range = (*ranges[seed])[s];
          const bool is_in = repeats(ours[seed].*statistics[s].of, range, row.digits[s]);
          of_row[seed] += is_in, counts.all[seed] += is_in;
          for (std::size_t other = 0; other < seeds; ++other) {
            const double theirs = ours[other].*statistics[s].of;
            if (other != seed) alike[{seed, other}] += range.low <= theirs && theirs <= range.high;
          }
        }
      }
    }
  }
  for (const auto& [pair, count] : alike) counts.same.push_back(count);
  return counts;
}

std::string span_of(const std::vector<int>& counts) {
  const auto [least, most] = std::ranges::minmax(counts);
  return least == most ? fmt::to_string(least) : fmt::format("{} to {}", least, most);
}

}  // namespace ikbench::papers
