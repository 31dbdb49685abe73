#include "analysis/claims/multiverse_printed.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/claims/printed.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/predictive_study.hpp"

namespace ikbench::claims {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

constexpr std::array<Metric, 2> explained_metrics{Metric::position_error_cm, Metric::variation_deg};
static_assert(predicted_statistics == printed_statistics.size());
constexpr std::size_t numbers_of_solver = explained_metrics.size() * predicted_statistics;
constexpr Resampling predictive{.resamples = 500, .seed = 1, .level = 0.95};

struct PrintedNumber {
  std::string text;  // as printed
  double value = not_defined, rounding = 0;
};

// One solver's printed numbers of error, then of variation; fewer if some are not printed.
struct PrintedSolver {
  std::array<PrintedNumber, numbers_of_solver> numbers;
  std::size_t runs = 0;
};

// By solver; without runs if the paper has none of that name.
std::vector<PrintedSolver> printed_solvers(const ClaimsFile& file, const Multiverse& multiverse) {
  std::vector<PrintedSolver> all(multiverse.solvers.size());
  for (std::size_t m = 0; m < explained_metrics.size(); ++m) {
    for (const PrintedRow& row : printed_rows(file.paper, file.means, explained_metrics[m])) {
      const auto solver = std::ranges::find(multiverse.solvers, row.algorithm);
      if (solver == multiverse.solvers.end()) continue;
      PrintedSolver& printed = all[static_cast<std::size_t>(solver - multiverse.solvers.begin())];
      printed.runs = static_cast<std::size_t>(row.printed.n);
      for (std::size_t i = 0; i < predicted_statistics; ++i) {
        printed.numbers[m * predicted_statistics + i] = {row.digits[i], row.printed.*printed_statistics[i].second,
                                                         half_unit(row.digits[i])};
      }
    }
  }
  return all;
}

using Ranges = std::array<Estimate, numbers_of_solver>;

// Known ranges by their values, since many universes share a series.
class KnownRanges {
 public:
  Ranges of(const Multiverse::ChosenSolver& own, std::size_t runs) {
    Ranges ranges;
    for (std::size_t m = 0; m < explained_metrics.size(); ++m) {
      std::vector<double> all;
      for (const std::vector<double>& seed : values_of(own, explained_metrics[m])) {
        all.insert(all.end(), seed.begin(), seed.end());
      }
      const auto [found, is_new] = known_.try_emplace(std::pair(runs, all));
      if (is_new) found->second = predicted_ranges(all, runs, predictive);
      std::ranges::copy(found->second, ranges.begin() + static_cast<std::ptrdiff_t>(m * predicted_statistics));
    }
    return ranges;
  }

 private:
  std::map<std::pair<std::size_t, std::vector<double>>, PredictedRanges> known_;
};

// The explained numbers of a solver.
using Explained = std::bitset<numbers_of_solver>;

Explained explained_numbers(const PrintedSolver& printed, const Ranges& ranges) {
  Explained explained;
  for (std::size_t i = 0; i < numbers_of_solver; ++i) {
    const PrintedNumber& number = printed.numbers[i];
    explained[i] = number.value + number.rounding >= ranges[i].low && number.value - number.rounding <= ranges[i].high;
  }
  return explained;
}

// Indexed by choice of the study, by solver, by its own choice.
using ExplainedBy = std::vector<std::vector<std::vector<Explained>>>;

// The universes with one alternative of a dimension.
struct AlternativeSupport {
  double explained = 0, weight = 0;  // sum of their explained numbers by their weights, and of the weights
  int most = 0;                      // explained numbers at most
  double best = 0;                   // number of the best universes among them
};

// The universes that explain one printed number.
struct NumberSupport {
  double weight = 0, best = 0;  // their weight, and the number of the best universes among them
};

struct Support {
  std::vector<std::vector<AlternativeSupport>> alternatives;          // by dimension
  std::vector<std::array<NumberSupport, numbers_of_solver>> numbers;  // by solver
  double more = 0, all = 0;  // weights of the universes that explain more numbers than the default, and of all
  int by_default = 0, most = 0;
  double best = 0;  // number of universes that explain the most
};

int count_of(const Explained& explained) { return static_cast<int>(explained.count()); }

// The numbers of universes of a study's choice, by how many numbers they explain.
std::vector<double> spread_of(const std::vector<std::vector<Explained>>& solvers) {
  std::vector<double> spread{1};
  for (const std::vector<Explained>& of_solver : solvers) {
    std::vector<double> next(spread.size() + numbers_of_solver);
    for (const Explained& each : of_solver) {
      for (std::size_t i = 0; i < spread.size(); ++i) next[i + static_cast<std::size_t>(count_of(each))] += spread[i];
    }
    spread = std::move(next);
  }
  return spread;
}

// Sums for one choice of the study.
struct StudySums {
  double universes = 1, attaining = 1;
  int best = 0;                  // sum over the solvers of their best choices' explained numbers
  double mean = 0;               // the sum of the solvers' means
  std::vector<double> means;     // by solver
  std::vector<int> bests;        // by solver
  std::vector<double> how_many;  // per solver: number of choices that attain its best
};

StudySums sums_of(const std::vector<std::vector<Explained>>& solvers) {
  StudySums sums;
  for (const std::vector<Explained>& of_solver : solvers) {
    double total = 0;
    int best = 0;
    for (const Explained& each : of_solver) {
      total += count_of(each);
      best = std::max(best, count_of(each));
    }
    const auto attaining = static_cast<double>(
        std::ranges::count_if(of_solver, [&](const Explained& each) { return count_of(each) == best; }));
    sums.means.push_back(total / static_cast<double>(of_solver.size()));
    sums.bests.push_back(best);
    sums.how_many.push_back(attaining);
    sums.mean += sums.means.back();
    sums.best += best;
    sums.universes *= static_cast<double>(of_solver.size());
    sums.attaining *= attaining;
  }
  return sums;
}

// Adds the universes of one choice of the study.
void add_study(Support& support, const Multiverse::OfStudy& study,
               const std::vector<std::vector<Explained>>& explained) {
  const StudySums sums = sums_of(explained);
  const std::vector<double> spread = spread_of(explained);
  for (std::size_t i = static_cast<std::size_t>(support.by_default) + 1; i < spread.size(); ++i) {
    support.more += spread[i] * study.weight / sums.universes;
  }
  const bool has_best = sums.best == support.most;
  support.all += study.weight;
  if (has_best) support.best += sums.attaining;
  // Universes of that weight explain `mean` numbers on average and `most` at most; `best` of them are among the best.
  const auto count = [&](const Multiverse::Choice& choice, double mean, double weight, int most, double best) {
    AlternativeSupport& of = support.alternatives[choice.dimension][choice.alternative];
    of.explained += mean * weight;
    of.weight += weight;
    of.most = std::max(of.most, most);
    of.best += best;
  };
  for (const Multiverse::Choice& each : study.chosen) {
    count(each, sums.mean, study.weight, sums.best, has_best ? sums.attaining : 0);
  }
  for (std::size_t s = 0; s < explained.size(); ++s) {
    const double weight = study.weight / static_cast<double>(explained[s].size());
    for (std::size_t a = 0; a < explained[s].size(); ++a) {
      const int ours = count_of(explained[s][a]);
      const double best = has_best && ours == sums.bests[s] ? sums.attaining / sums.how_many[s] : 0;
      for (const Multiverse::Choice& each : study.solvers[s][a].chosen) {
        count(each, sums.mean - sums.means[s] + ours, weight, sums.best - sums.bests[s] + ours, best);
      }
      for (std::size_t i = 0; i < numbers_of_solver; ++i) {
        if (!explained[s][a][i]) continue;
        support.numbers[s][i].weight += weight;
        support.numbers[s][i].best += best;
      }
    }
  }
}

Support support_of(const Multiverse& multiverse, const ExplainedBy& explained) {
  Support support;
  support.numbers.resize(multiverse.solvers.size());
  for (const Multiverse::Dimension& each : multiverse.dimensions) {
    support.alternatives.emplace_back(each.alternatives.size());
  }
  for (const std::vector<Explained>& of_solver : explained.front()) support.by_default += count_of(of_solver.front());
  for (const auto& study : explained) support.most = std::max(support.most, sums_of(study).best);
  for (std::size_t g = 0; g < explained.size(); ++g) add_study(support, multiverse.studies[g], explained[g]);
  return support;
}

Cell rounded_percent(double share) { return std::round(1000 * share) / 10 + 0.0; }

Table alternatives_support(const Multiverse& multiverse, const Support& support, int printed) {
  Table table{.name = "multiverse-support",
              .caption = fmt::format(
                  "How many of the {} printed numbers of error and variation interpretations explain", printed),
              .columns = {"alternative", "notes", "default", "explained_on_average", "explained_at_most",
                          "of_the_best_percent"}};
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    const Multiverse::Dimension& dimension = multiverse.dimensions[d];
    for (std::size_t a = 0; a < dimension.alternatives.size(); ++a) {
      const AlternativeSupport& of = support.alternatives[d][a];
      table.rows.push_back({dimension.alternatives[a].set, dimension.section, a == 0 ? Cell("default") : Cell(),
                            std::round(10 * of.explained / of.weight) / 10, std::int64_t{of.most},
                            rounded_percent(of.best / support.best)});
    }
  }
  table.notes.emplace_back(
      "A number is explained where it lies, but for its rounding, in the range that 95 % of studies of 20 runs would "
      "have (Hill's A(n)). Of the right interpretation about 5 % of the numbers would lie outside. of_the_best: share of the "
      "interpretations that explain the most.");
  return table;
}

// The explained printed numbers, one row each.
Table numbers_support(const Multiverse& multiverse, const std::vector<PrintedSolver>& printed, const Support& support,
                      KnownRanges& ranges) {
  Table table{
      .name = "multiverse-printed",
      .caption = "Each printed number: whether the default explains it, and which share of the interpretations does",
      .columns = {"algorithm", "metric", "statistic", "printed", "default_range", "default", "interpretations_percent",
                  "of_the_best_percent"}};
  for (std::size_t s = 0; s < printed.size(); ++s) {
    if (printed[s].runs == 0) continue;
    const Ranges of_default = ranges.of(multiverse.studies.front().solvers[s].front(), printed[s].runs);
    const Explained explained = explained_numbers(printed[s], of_default);
    for (std::size_t i = 0; i < numbers_of_solver; ++i) {
      table.rows.push_back({multiverse.solvers[s], std::string(name_of(explained_metrics[i / predicted_statistics])),
                            std::string(printed_statistics[i % predicted_statistics].first), printed[s].numbers[i].text,
                            Range{of_default[i].low, of_default[i].high}, explained[i] ? "inside" : "outside",
                            rounded_percent(support.numbers[s][i].weight / support.all),
                            rounded_percent(support.numbers[s][i].best / support.best)});
    }
  }
  return table;
}

// "MO-PSO's mean error"
std::string number_words(const Multiverse& multiverse, std::size_t solver, std::size_t number) {
  return fmt::format("{}'s {} {}", multiverse.solvers[solver], printed_statistics[number % predicted_statistics].first,
                     number < predicted_statistics ? "error" : "variation");
}

std::string unexplained_sentence(const Multiverse& multiverse, const std::vector<PrintedSolver>& printed,
                                 const Support& support) {
  std::vector<std::string> none;
  for (std::size_t s = 0; s < printed.size(); ++s) {
    for (std::size_t i = 0; i < numbers_of_solver && printed[s].runs > 0; ++i) {
      if (support.numbers[s][i].weight == 0) none.push_back(number_words(multiverse, s, i));
    }
  }
  if (none.empty()) return "Each printed number is explained by some interpretation.";
  constexpr std::size_t most_named = 10;
  const std::size_t named = std::min(none.size(), most_named);
  return fmt::format("No interpretation explains {}{}.",
                     fmt::join(none.begin(), none.begin() + static_cast<int>(named), ", "),
                     named < none.size() ? fmt::format(" and {} more", none.size() - named) : "");
}

// The choices that all best universes share.
std::string best_sentence(const Multiverse& multiverse, const Support& support) {
  std::vector<std::string> shared;
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    for (std::size_t a = 0; a < multiverse.dimensions[d].alternatives.size(); ++a) {
      if (support.alternatives[d][a].best == support.best)
        shared.push_back(multiverse.dimensions[d].alternatives[a].set);
    }
  }
  return fmt::format("The best explain {}: {} interpretations{}.", support.most, count_words(support.best),
                     shared.empty() ? std::string(" that share no alternative")
                                    : fmt::format(", all with {}", fmt::join(shared, ", ")));
}

bool can_predict(const Multiverse& multiverse) {
  const Multiverse::ChosenSolver& usual = multiverse.studies.front().solvers.front().front();
  return usual.error_cm.size() * usual.error_cm.front().size() >= fewest_predicting;
}

}  // namespace

void add_printed(MultiverseReport& report, const ClaimsFile& file, const Multiverse& multiverse) {
  const std::vector<PrintedSolver> printed = printed_solvers(file, multiverse);
  const auto solvers = std::ranges::count_if(printed, [](const PrintedSolver& each) { return each.runs > 0; });
  if (solvers == 0 || !can_predict(multiverse)) return;
  KnownRanges ranges;
  ExplainedBy explained;
  for (const Multiverse::OfStudy& study : multiverse.studies) {
    auto& of_study = explained.emplace_back();
    for (std::size_t s = 0; s < printed.size(); ++s) {
      auto& of_solver = of_study.emplace_back();
      for (const Multiverse::ChosenSolver& own : study.solvers[s]) {
        of_solver.push_back(printed[s].runs == 0 ? Explained()
                                                 : explained_numbers(printed[s], ranges.of(own, printed[s].runs)));
      }
    }
  }
  const Support support = support_of(multiverse, explained);
  const int numbers = static_cast<int>(solvers) * static_cast<int>(numbers_of_solver);
  report.sentences.push_back(fmt::format(
      "Of the {} printed numbers of error and variation the default explains {} (they lie in the 95 % range "
      "of a study of 20 runs); {} of the interpretations explain more.",
      numbers, support.by_default, share_words(support.more / support.all)));
  report.sentences.push_back(best_sentence(multiverse, support));
  report.sentences.push_back(unexplained_sentence(multiverse, printed, support));
  report.tables.push_back(alternatives_support(multiverse, support, numbers));
  report.tables.push_back(numbers_support(multiverse, printed, support, ranges));
}

std::vector<std::vector<int>> explained_numbers(const ClaimsFile& file, const std::vector<Multiverse>& universes) {
  std::vector<std::vector<int>> counts;
  if (!can_predict(universes.front())) return counts;
  const std::vector<PrintedSolver> printed = printed_solvers(file, universes.front());
  KnownRanges ranges;
  for (const Multiverse& universe : universes) {
    auto& of_universe = counts.emplace_back();
    for (std::size_t s = 0; s < printed.size(); ++s) {
      const Multiverse::ChosenSolver& own = universe.studies.front().solvers[s].front();
      of_universe.push_back(
          printed[s].runs == 0 ? 0 : count_of(explained_numbers(printed[s], ranges.of(own, printed[s].runs))));
    }
  }
  return counts;
}

std::string count_words(double count) {
  if (count >= 1e9) return short_number(count / 1e9) + " billion";
  if (count >= 1e6) return short_number(count / 1e6) + " million";
  return fmt::format("{:.0f}", count);
}

}  // namespace ikbench::claims
