#include "analysis/claims/multiverse.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

#include "analysis/claims/claim_counts.hpp"
#include "analysis/claims/explained.hpp"
#include "analysis/figures/specification_curve.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::claims {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;
using namespace report;

namespace {

// A number of universes: "43.2 million", "144".
std::string count_words(double count) {
  if (count >= 1e9) return short_number(count / 1e9) + " billion";
  if (count >= 1e6) return short_number(count / 1e6) + " million";
  return fmt::format("{:.0f}", count);
}

// A share in percent, with one digit after the point.
Cell percent_cell(double part, double all = 1) {
  if (all == 0) return {};
  return std::round(1000 * part / all) / 10 + 0.0;
}

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
std::string words_of_dimension(const Multiverse::Dimension& dimension,
                               const std::vector<UniverseCounts>& alternatives) {
  std::vector<std::pair<double, std::string>> parts;
  for (std::size_t a = 0; a < alternatives.size(); ++a) {
    const UniverseCounts& each = alternatives[a];
    if (each.all() > 0) parts.emplace_back(each.holds / each.all(), dimension.alternatives[a].where);
  }
  std::ranges::stable_sort(parts, {}, &std::pair<double, std::string>::first);
  std::vector<std::string> words;
  for (const auto& [share, where] : parts) words.push_back(fmt::format("{} where {}", share_words(share), where));
  return fmt::format("{} ({})", dimension.open, fmt::join(words, ", "));
}

// The printed numbers, and how many of them an interpretation explains that fits.
struct PrintedNumbers {
  int all = 0, fitting = 0;
};

// "those that explain at least 25 of the 60 printed numbers"
std::string fitting_words(const PrintedNumbers& numbers) {
  return fmt::format("those that explain at least {} of the {} printed numbers", numbers.fitting, numbers.all);
}

ClaimShares shares_of(const Multiverse& multiverse, const ClaimCounts& counts, const PrintedNumbers& numbers) {
  const double all = counts.all.all(), fitting = counts.fitting.all();
  ClaimShares shares{.id = counts.id,
                     .holds = counts.all.holds / all,
                     .fails = counts.all.fails / all,
                     .undecided = counts.all.undecided / all};
  std::vector<std::string> words;
  for (const std::size_t d : deciding_dimensions(multiverse, counts)) {
    shares.decided_by.push_back(multiverse.dimensions[d].open);
    words.push_back(words_of_dimension(multiverse.dimensions[d], counts.alternatives[d]));
  }
  shares.sentence = fmt::format("{} in {} of the interpretations ({} fail, {} undecided)", counts.words,
                                share_words(shares.holds), share_words(shares.fails), share_words(shares.undecided));
  if (fitting > 0) {
    shares.fitting_holds = counts.fitting.holds / fitting;
    shares.fitting_fails = counts.fitting.fails / fitting;
    shares.sentence +=
        fmt::format(", in {} of {} ({} fail, {} undecided)", share_words(shares.fitting_holds), fitting_words(numbers),
                    share_words(shares.fitting_fails), share_words(counts.fitting.undecided / fitting));
  }
  shares.sentence += '.';
  if (!words.empty()) shares.sentence += fmt::format(" It depends most on {}.", fmt::join(words, "; on "));
  return shares;
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

Table claims_table(const Multiverse& multiverse, const std::vector<ClaimCounts>& all, const AnalysisPlan& plan,
                   const PrintedNumbers& numbers, const UniverseSupport& support) {
  Table table{.name = "multiverse",
              .caption = "The paper's claims in every interpretation of what the paper leaves open",
              .columns = {"claim", "holds_percent", "fails_percent", "undecided_percent", "fitting_holds_percent",
                          "fitting_fails_percent", "fitting_undecided_percent", "deciding_dimension",
                          "difference_percent", "between_seeds_percent", "id"}};
  for (const ClaimCounts& counts : all) {
    const double weight = counts.all.all(), fitting = counts.fitting.all();
    const std::size_t deciding = counts.deciding();
    const bool is_decided = deciding < multiverse.dimensions.size();
    table.rows.push_back({counts.words, percent_cell(counts.all.holds, weight), percent_cell(counts.all.fails, weight),
                          percent_cell(counts.all.undecided, weight), percent_cell(counts.fitting.holds, fitting),
                          percent_cell(counts.fitting.fails, fitting), percent_cell(counts.fitting.undecided, fitting),
                          is_decided ? Cell(multiverse.dimensions[deciding].open) : Cell(),
                          is_decided ? percent_cell(counts.difference(deciding)) : Cell(), seed_difference(counts),
                          counts.id});
  }
  table.notes.push_back(fmt::format(
      "{} interpretations: {} choices for the study, each with every combination of the solvers' own. All are counted. The "
      "alternatives of the study weigh alike, given what was chosen before them, and so do the interpretations of a choice for "
      "the study. A claim holds where its solver is found better than each rival, and fails where a rival is found "
      "better: by Games and Howell's test of the run means at {}, for {} solvers. It stands in for the test of the study's "
      "plan because it needs two solvers at a time, so that pairs can be counted.",
      count_words(multiverse.universes()), multiverse.studies.size(), plan.significance, multiverse.solvers.size()));
  if (numbers.all > 0) {
    table.notes.push_back(
        fmt::format("fitting: of {}, which are {} of all: alternatives that the numbers themselves refute "
                    "should not decide against the authors.",
                    fitting_words(numbers), share_words(support.fitting / support.all.weight)));
  }
  table.notes.emplace_back(
      "deciding dimension: between whose alternatives the share that holds differs most, with that difference. "
      "between seeds: largest difference between two seeds in one of these shares; each seed is a study of its own.");
  const auto out_of_reach =
      std::ranges::count_if(multiverse.studies, [](const auto& study) { return study.out_of_reach > 0; });
  if (out_of_reach > 0) {
    table.notes.push_back(
        fmt::format("In {} of the choices for the study some targets are out of reach.", out_of_reach));
  }
  return table;
}

// `support` is null if nothing is explained.
Table alternatives_table(const Multiverse& multiverse, const std::vector<ClaimCounts>& all,
                         const UniverseSupport* support, int printed_runs) {
  Table table{.name = "multiverse-alternatives",
              .caption =
                  "How often each claim holds with each alternative [% of its interpretations], and how many printed "
                  "numbers these explain",
              .columns = {"alternative", "notes", "default"}};
  for (const ClaimCounts& counts : all) table.columns.push_back(counts.id);
  if (support != nullptr) {
    table.columns.insert(table.columns.end(), {"explained_on_average", "explained_at_most", "of_the_best_percent"});
    table.notes.push_back(fmt::format(
        "A number is explained where it lies, but for its rounding, in the range that 95 % of studies of {} runs would "
        "have (Hill's A(n)). Of the right interpretation about 5 % of the numbers would lie outside. of the best: share of the "
        "interpretations that explain the most.",
        printed_runs));
  }
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    const Multiverse::Dimension& dimension = multiverse.dimensions[d];
    for (std::size_t a = 0; a < dimension.alternatives.size(); ++a) {
      const Alternative& alternative = dimension.alternatives[a];
      std::vector<Cell>& row = table.rows.emplace_back(
          std::vector<Cell>{alternative.set, dimension.section, a == 0 ? Cell("default") : Cell()});
      for (const ClaimCounts& counts : all) {
        const UniverseCounts& of = counts.alternatives[d][a];
        row.push_back(percent_cell(of.holds, of.all()));
      }
      table.notes.push_back(fmt::format("{}: {}.", alternative.set, alternative.where));
      if (support == nullptr) continue;
      const auto& [explained, weight, most, best] = support->alternatives[d][a];
      row.insert(row.end(),
                 {std::round(10 * explained / weight) / 10, std::int64_t{most}, percent_cell(best, support->all.best)});
    }
  }
  return table;
}

// Each printed number, one row each.
Table numbers_table(const Multiverse& multiverse, PrintedSolvers& printed, const UniverseSupport& support) {
  Table table{
      .name = "multiverse-printed",
      .caption = "Each printed number: whether the default explains it, and which share of the interpretations does",
      .columns = {"algorithm", "metric", "statistic", "printed", "default_range", "default", "interpretations_percent",
                  "of_the_best_percent"}};
  for (std::size_t s = 0; s < multiverse.solvers.size(); ++s) {
    if (!printed.is_printed(s)) continue;
    const Multiverse::ChosenSolver& usual = multiverse.studies.front().solvers[s].front();
    const PrintedSolvers::Ranges ranges = printed.ranges(s, usual);
    const Explained explained = printed.explained(s, usual);
    for (std::size_t i = 0; i < numbers_of_solver; ++i) {
      const std::size_t m = i / predicted_statistics, statistic = i % predicted_statistics;
      table.rows.push_back({multiverse.solvers[s], Id{std::string(name_of(explained_metrics[m]))},
                            std::string(printed_statistics[statistic].first), printed.row(s, m).digits[statistic],
                            Range{ranges[i].low, ranges[i].high}, explained[i] ? "inside" : "outside",
                            percent_cell(support.numbers[s][i].weight, support.all.weight),
                            percent_cell(support.numbers[s][i].best, support.all.best)});
    }
  }
  return table;
}

// "2 of the 60 are explained by no interpretation: variation of BA (mean, median)."
std::string unexplained_sentence(const Multiverse& multiverse, PrintedSolvers& printed,
                                 const UniverseSupport& support) {
  int count = 0;
  std::vector<std::string> rows;
  for (std::size_t s = 0; s < multiverse.solvers.size(); ++s) {
    for (std::size_t m = 0; printed.is_printed(s) && m < explained_metrics.size(); ++m) {
      std::vector<std::string_view> names;
      for (std::size_t i = 0; i < predicted_statistics; ++i) {
        if (support.numbers[s][m * predicted_statistics + i].weight == 0) names.push_back(printed_statistics[i].first);
      }
      count += static_cast<int>(names.size());
      if (names.empty()) continue;
      rows.push_back(fmt::format("{} of {} ({})", info_of(explained_metrics[m]).name, multiverse.solvers[s],
                                 fmt::join(names, ", ")));
    }
  }
  return fmt::format("{} of the {} are explained by no interpretation{}{}.", count, printed.numbers(),
                     rows.empty() ? "" : ": ", fmt::join(rows, "; "));
}

// The choices that all best universes share.
std::string best_sentence(const Multiverse& multiverse, const UniverseSupport& support) {
  std::vector<std::string> shared;
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    for (std::size_t a = 0; a < multiverse.dimensions[d].alternatives.size(); ++a) {
      if (support.alternatives[d][a].best == support.all.best)
        shared.push_back(multiverse.dimensions[d].alternatives[a].set);
    }
  }
  return fmt::format("The best explain {}: {} interpretation{}{}.", support.all.most, count_words(support.all.best),
                     support.all.best == 1 ? "" : "s",
                     shared.empty() ? std::string(" that share no alternative")
                                    : fmt::format(", all with {}", fmt::join(shared, ", ")));
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
using PooledMeans = std::vector<std::vector<PooledMean>>;  // by solver, by its choice

PooledMeans pooled_means(const Multiverse::OfStudy& study) {
  PooledMeans means;
  for (const auto& of_solver : study.solvers) {
    means.emplace_back();
    for (const Multiverse::ChosenSolver& own : of_solver) {
      const std::vector<double> values = pooled(own, Metric::position_error_cm);
      means.back().push_back({mean(values), standard_error(values)});
    }
  }
  return means;
}

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
    const PooledMeans means = pooled_means(study);
    for (std::size_t rival = 0; rival < means.size(); ++rival) {
      if (rival == solver) continue;
      for (const PooledMean& theirs : means[rival]) {
        const double universes = universes_of_best(means, solver, rival, theirs.mean);
        for (std::size_t a = 0; a < means[solver].size() && universes > 0; ++a) {
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
  SpecificationCurve curve{.name = "multiverse",
                           .quantity = fmt::format("mean error of {} / of its best rival", label),
                           .below = label + " is more accurate",
                           .above = "its best rival is"};
  // The rows of the choices, by dimension and alternative; the rivals that are drawn are rows of a separate group.
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> row_of_choice;
  std::map<std::size_t, std::size_t> row_of_rival;
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    const Multiverse::Dimension& dimension = multiverse.dimensions[d];
    if (!dimension.solver.empty() && dimension.solver != label) continue;
    curve.groups.emplace_back();
    for (std::size_t a = 0; a < dimension.alternatives.size(); ++a) {
      curve.groups.back().push_back(dimension.alternatives[a].where);
      row_of_choice.emplace(std::pair(d, a), row_of_choice.size());
    }
  }
  curve.groups.emplace_back();
  for (std::size_t s = 0; s < multiverse.solvers.size(); ++s) {
    if (std::ranges::count(chosen, s, &BestRival::rival) == 0) continue;
    curve.groups.back().push_back("best rival: " + multiverse.solvers[s]);
    row_of_rival.emplace(s, row_of_choice.size() + row_of_rival.size());
  }
  for (const BestRival* each : chosen) {
    const double reach = normal_critical(0.95) * each->error;
    auto& universe = curve.universes.emplace_back();
    universe = {.estimate = each->estimate, .low = each->estimate - reach, .high = each->estimate + reach, .rows = {}};
    const Multiverse::OfStudy& study = multiverse.studies[each->study];
    for (const auto* choices : {&study.chosen, &study.solvers[solver][each->own].chosen}) {
      for (const auto& [dimension, alternative] : *choices) {
        universe.rows.push_back(row_of_choice.at({dimension, alternative}));
      }
    }
    universe.rows.push_back(row_of_rival.at(each->rival));
  }
  curve.caption = fmt::format(
      "Specification curve: mean error of {} divided by that of its best rival, with 95 % intervals, in {} of {} "
      "interpretations, sorted by it and drawn evenly by their weight. Dots below: the choices of each, "
      "without those of the rivals. A colour follows the interval against that one rival; a claim needs the test against all "
      "rivals, so its shares differ.",
      label, count, count_words(universes));
  return specification_curve(curve);
}

}  // namespace

MultiverseReport multiverse_report(const ClaimsFile& file, const Multiverse& multiverse, const AnalysisPlan& plan) {
  if (multiverse.studies.empty() || multiverse.seeds() == 0) {
    throw std::invalid_argument("no universe to report; expected the default first");
  }
  if (std::ranges::count(multiverse.solvers, file.solver) == 0) {
    throw std::invalid_argument(fmt::format("no universe has the solver {}", file.solver));
  }
  PrintedSolvers printed(file, multiverse);
  const PrintedNumbers numbers{.all = printed.numbers(), .fitting = file.fitting};
  const Fit fit{.explained = numbers.all > 0 ? explained_in(multiverse, printed) : ExplainedUniverses(),
                .least = file.fitting};
  const UniverseSupport support = numbers.all > 0 ? support_of(multiverse, fit) : UniverseSupport();
  std::vector<ClaimCounts> all = counted(multiverse, file.entries, plan, fit);
  std::erase_if(all, [](const ClaimCounts& counts) { return counts.all.all() == 0; });
  MultiverseReport result;
  for (const ClaimCounts& counts : all) result.claims.push_back(shares_of(multiverse, counts, numbers));
  result.tables = {claims_table(multiverse, all, plan, numbers, support),
                   alternatives_table(multiverse, all, numbers.all > 0 ? &support : nullptr, printed.most_runs())};
  result.figures = {error_curve(multiverse, file.solver)};
  if (numbers.all == 0) return result;
  result.tables.push_back(numbers_table(multiverse, printed, support));
  result.sentences = {
      fmt::format(
          "Of the {} printed numbers of error and variation the default explains {} (they lie in the 95 % range "
          "of a study of {} runs); {} of the interpretations explain more.",
          numbers.all, support.by_default, printed.most_runs(), share_words(support.more / support.all.weight)),
      best_sentence(multiverse, support), unexplained_sentence(multiverse, printed, support)};
  return result;
}

}  // namespace ikbench::claims
