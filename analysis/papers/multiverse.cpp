#include "analysis/papers/multiverse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "analysis/papers/published.hpp"
#include "analysis/show/text.hpp"
#include "base/names.hpp"

namespace ikbench::papers {

using namespace judge;
using results::Dimension;

namespace {

using Names = std::vector<std::string>;

bool contains(const auto& all, const auto& one) { return std::ranges::find(all, one) != all.end(); }

std::size_t place_of(const Names& all, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(all, name) - all.begin());
}

// Returns whether a claim says that a solver is better in error, joint motion or the spread of one of these. Only such
// a claim is judged in all interpretations.
bool hangs_on_reading(const Claim& claim) {
  return claim.rule != nullptr && claim.rule->name == "better" && claim.metrics.size() == 1 && claim.study.empty() &&
         contains(metrics_of_readings, claim.metrics.front()->column);
}

// Returns in how many interpretations the claim holds, fails and stays open; no counts if a solver of the claim is
// missing.
InReadings in_readings(const SolvedMultiverse& multiverse, const Claim& claim, const results::AnalysisPlan& plan) {
  const Names& solvers = multiverse.solvers;
  const std::size_t k = solvers.size(), metric = claim.metrics.front()->column == metrics_of_readings[0] ? 0 : 1;
  std::vector<std::size_t> own, rivals;
  for (const std::string& solver : claim.solvers) own.push_back(place_of(solvers, solver));
  for (const std::string& solver : claim.against.empty() ? solvers : claim.against)
    if (!contains(claim.solvers, solver)) rivals.push_back(place_of(solvers, solver));
  if (contains(own, k) || contains(rivals, k)) return {};
  // Each pair is tested by Welch's t at its part of the significance, as a report tests a pair of these solvers.
  const AnalysisPlan of_pair{.test = AnalysisPlan::Test::means,
                             .significance = plan.significance / (static_cast<double>(k * (k - 1)) / 2),
                             .margin = plan.margin};
  std::map<std::pair<std::size_t, std::size_t>, Verdict> known;  // verdicts, since many interpretations share a pair
  const auto verdict = [&](std::size_t one, std::size_t other) {
    const auto [place, is_new] = known.try_emplace({one, other});
    if (!is_new) return place->second;
    MetricSamples samples = empty_samples(*claim.metrics.front());
    samples.groups = {multiverse.means[one][metric], multiverse.means[other][metric]};
    if (claim.of == Of::spread) samples = deviations(samples);
    return place->second = verdict_of(compare_pairs(samples, of_pair).front());
  };
  InReadings counts{.seeds = std::ssize(multiverse.readings[0].parts[0])};
  std::map<std::string, std::int64_t> failing;  // interpretations in which the claim fails, by setting
  for (const auto& [settings, parts] : multiverse.readings) {
    for (std::size_t seed = 0; seed < parts[0].size(); ++seed) {
      Tally tally;
      for (const std::size_t solver : own)
        for (const std::size_t rival : rivals) tally.add(verdict(parts[solver][seed], parts[rival][seed]));
      const Holds holds = holds_of(tally);
      if (holds == Holds::holds) {
        ++counts.hold;
      } else if (holds == Holds::fails) {
        ++counts.fail;
        for (const std::string& setting : settings) ++failing[setting];
      } else {
        ++counts.open;
      }
    }
  }
  std::int64_t most = 0;
  for (const Dimension& dimension : multiverse.dimensions) {
    for (const results::Alternative& alternative : std::span(dimension).subspan(1)) {
      if (failing[alternative.set] <= most) continue;
      most = failing[alternative.set];
      counts.most_fail = fmt::format("{} with {} ({})", most, alternative.set, alternative.where);
    }
  }
  return counts;
}

}  // namespace

Group group_of(std::vector<double> runs) {
  const auto lost = static_cast<int>(std::erase_if(runs, [](double value) { return !std::isfinite(value); }));
  if (lost > 0) return {.sample = ExcludedSample{.missing = lost, .values = std::move(runs)}};
  return {.sample = Sample{std::move(runs)}};
}

JudgedMultiverse judged(const Paper& paper, const SolvedMultiverse& multiverse, const results::AnalysisPlan& plan) {
  JudgedMultiverse result{.in_readings = {},
                          .table = {.name = "multiverse",
                                    .caption = "The claims in every interpretation",
                                    .columns = show::named_columns(
                                        {"claim", "holds", "fails", "inconclusive", "most failures with one answer"}),
                                    .is_of_study = false}};
  for (const Claim& claim : paper.claims) {
    if (!hangs_on_reading(claim)) continue;
    const InReadings counts = in_readings(multiverse, claim, plan);
    if (counts.all() == 0) continue;
    result.in_readings[claim.id] = counts;
    result.table.rows.push_back(
        {claim.sentence, counts.hold, counts.fail, counts.open, counts.most_fail.empty() ? "none" : counts.most_fail});
  }
  const std::int64_t solvers = std::ssize(multiverse.solvers), pairs = solvers * (solvers - 1) / 2;
  result.table.notes = {
      fmt::format(
          "There are {}. A claim holds if its solvers are better than each rival, and fails if one rival is better. The test is "
          "Welch's t (for spreads: on distances from the median) at {:g} / {} ({} of solvers).",
          interpretations_text(std::ssize(multiverse.readings), std::ssize(multiverse.readings[0].parts[0])),
          plan.significance, pairs, base::counted(pairs, "pairs")),
      fmt::format(
          "An interpretation answers {} of the questions that the paper leaves open. The counts depend on which answers "
          "are listed, so they are not probabilities.",
          multiverse.dimensions.size())};
  return result;
}

namespace {

// The values of one solver in one metric, with a part per seed.
struct SeedValues {
  std::vector<Descriptives> by_seed = {};
  std::vector<std::optional<Ranges>> ranges = {};  // by seed; nullopt: too few values, or some are missing
  std::vector<double> together = {};               // values of all seeds
};

// Returns the values of these parts. The ranges are those of new studies with `runs` runs.
SeedValues values_by_seed(const SolvedMultiverse& multiverse, const std::vector<std::size_t>& parts, std::size_t metric,
                          int runs) {
  SeedValues all;
  for (const std::size_t part : parts) {
    const Group& group = multiverse.means[part][metric];
    const std::vector<double> values(values_of(group).begin(), values_of(group).end());
    all.ranges.push_back(missing_in(group) > 0 ? std::nullopt : predicted_ranges(values, runs));
    all.by_seed.push_back(describe_values(values));
    all.together.insert(all.together.end(), values.begin(), values.end());
  }
  return all;
}

// Returns how many statistics of a study lie in the ranges of another study.
int statistics_inside(const Descriptives& study, const Ranges& ranges) {
  int count = 0;
  for (std::size_t s = 0; s < statistics.size(); ++s) {
    const double number = study.*statistics[s].of;
    count += ranges[s].low <= number && number <= ranges[s].high;
  }
  return count;
}

// Returns how many statistics of another row our ranges match, as the mean over all rows but our own.
double repeated_of_others(const Descriptives& ours, const Ranges& ranges, const PrintedRows& rows,
                          const PrintedRow& own) {
  double sum = 0;
  for (const PrintedRow& row : rows)
    if (&row != &own) sum += repeated_statistics(ours, ranges, row);
  return rows.size() < 2 ? 0 : sum / static_cast<double>(rows.size() - 1);
}

}  // namespace

SeedCounts counts_by_seed(const Paper& paper, const SolvedMultiverse& multiverse) {
  SeedCounts counts;
  const auto& parts = multiverse.readings.front().parts;
  const std::size_t seeds = parts[0].size();
  std::map<std::pair<std::size_t, std::size_t>, int> alike;  // numbers of the second seed in ranges of the first
  std::vector<double> of_others(seeds);
  counts.all.resize(seeds);
  counts.wide.resize(seeds);
  for (std::size_t m = 0; m < metrics_of_readings.size(); ++m) {
    const PrintedRows rows = printed_means(paper.name, paper.means, metrics_of_readings[m]);
    for (const PrintedRow& row : rows) {
      const std::size_t solver = place_of(multiverse.solvers, row.solver);
      if (solver == multiverse.solvers.size()) continue;
      const auto [ours, ranges, together] = values_by_seed(multiverse, parts[solver], m, row.numbers.n);
      if (std::ranges::none_of(ranges, [](const auto& each) { return each.has_value(); })) return {};
      if (const std::optional<Ranges> of_all = predicted_ranges(together, row.numbers.n))
        counts.together += repeated_statistics(describe_values(together), *of_all, row);
      counts.of += static_cast<int>(statistics.size());
      std::vector<int>& of_row = counts.rows[row.solver];
      of_row.resize(seeds);
      for (std::size_t seed = 0; seed < seeds; ++seed) {
        if (!ranges[seed]) continue;
        const int repeated = repeated_statistics(ours[seed], *ranges[seed], row);
        of_row[seed] += repeated;
        counts.all[seed] += repeated;
        counts.wide[seed] += static_cast<int>(std::ranges::count_if(*ranges[seed], is_wide));
        of_others[seed] += repeated_of_others(ours[seed], *ranges[seed], rows, row);
        for (std::size_t other = 0; other < seeds; ++other)
          if (other != seed) alike[{seed, other}] += statistics_inside(ours[other], *ranges[seed]);
      }
    }
  }
  for (const auto& [pair, count] : alike) counts.same.push_back(count);
  for (const double count : of_others) counts.other_rows.push_back(static_cast<int>(std::lround(count)));
  return counts;
}

std::string span_of(const std::vector<int>& counts) {
  const auto [least, most] = std::ranges::minmax(counts);
  return least == most ? fmt::to_string(least) : fmt::format("{} to {}", least, most);
}

}  // namespace ikbench::papers
