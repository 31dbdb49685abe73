#include "analysis/claims/multiverse.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <utility>

#include "analysis/claims/printed.hpp"
#include "analysis/papers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/predictive_study.hpp"
#include "results/published.hpp"
#include "tests/analysis/cells.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::inference;
using namespace ikbench::report;
using namespace ikbench::results;
using namespace ikbench::claims;
using namespace ikbench::statistics;

namespace {

const std::vector<std::string> metrics{"position_error_cm", "variation_deg"};
const std::vector<std::string> statistics_of_cell{"mean", "median", "std", "max", "min"};

CsvTable printed() { return published::table("slim2023", "table-3"); }

double printed_number(const std::string& solver, const std::string& metric, const std::string& column) {
  const CsvTable table = printed();
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.rows[row][table.column("algorithm")] == solver && table.rows[row][table.column("metric")] == metric)
      return table.number(row, column);
  }
  return not_defined;
}

double half_unit_of(const std::string& solver, const std::string& metric, const std::string& column) {
  const CsvTable table = printed();
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.rows[row][table.column("algorithm")] == solver && table.rows[row][table.column("metric")] == metric)
      return half_unit(table.rows[row][table.column(column)]);
  }
  return not_defined;
}

// The study has x, and y beside x=0 only; IK-BA has two choices, BA three (two where x=1), DE none. Six runs near the
// printed means, some times off.
Multiverse near_the_print() {
  const auto alternative = [](const std::string& set) { return Multiverse::Alternative{set, "it is " + set}; };
  Multiverse multiverse{
      .dimensions = {{"x", "2.1", "", {alternative("x=0"), alternative("x=1")}, "how x is"},
                     {"y", "2.1", "", {alternative("y=0"), alternative("y=1")}, "how y is"},
                     {"IK-BA.k", "2.2", "IK-BA", {alternative("IK-BA.k=0"), alternative("IK-BA.k=1")}},
                     {"BA.k", "2.3", "BA", {alternative("BA.k=0"), alternative("BA.k=1"), alternative("BA.k=2")}}},
      .solvers = {"IK-BA", "BA", "DE"},
      .studies = {}};
  std::mt19937_64 engine(3);
  const auto own = [&](const std::string& solver, std::vector<Multiverse::Choice> chosen) {
    Multiverse::ChosenSolver one{.chosen = std::move(chosen), .error_cm = {{}}, .variation_deg = {{}}};
    const auto uniform = [&] { return static_cast<double>(engine() >> 11) / 9007199254740992.0; };  // 2^53
    const double off = 0.7 + 0.6 * uniform();
    for (int run = 0; run < 6; ++run) {
      one.error_cm[0].push_back(printed_number(solver, metrics[0], "mean") * off * off * off *
                                (0.85 + 0.3 * uniform()));
      one.variation_deg[0].push_back(printed_number(solver, metrics[1], "mean") * off * (0.85 + 0.3 * uniform()));
    }
    return one;
  };
  const std::vector<std::vector<Multiverse::Choice>> studies{{{0, 0}, {1, 0}}, {{0, 0}, {1, 1}}, {{0, 1}}};
  for (std::size_t g = 0; g < studies.size(); ++g) {
    Multiverse::OfStudy study{.chosen = studies[g], .weight = g < 2 ? 0.25 : 0.5, .solvers = {{}, {}, {}}};
    for (std::size_t k = 0; k < 2; ++k) study.solvers[0].push_back(own("IK-BA", {{2, k}}));
    for (std::size_t k = 0; k < (g < 2 ? 3u : 2u); ++k) study.solvers[1].push_back(own("BA", {{3, k}}));
    study.solvers[2].push_back(own("DE", {}));
    multiverse.studies.push_back(std::move(study));
  }
  return multiverse;
}

// One universe, listed.
struct Universe {
  std::vector<const Multiverse::ChosenSolver*> solvers;
  std::vector<Multiverse::Choice> chosen;
  double weight = 0;
};

std::vector<Universe> universes_of(const Multiverse& multiverse) {
  std::vector<Universe> all;
  for (const Multiverse::OfStudy& study : multiverse.studies) {
    const std::size_t before = all.size();
    for (const Multiverse::ChosenSolver& a : study.solvers[0]) {
      for (const Multiverse::ChosenSolver& b : study.solvers[1]) {
        Universe& one = all.emplace_back();
        one.solvers = {&a, &b, &study.solvers[2].front()};
        for (const auto* chosen : {&study.chosen, &a.chosen, &b.chosen}) {
          one.chosen.insert(one.chosen.end(), chosen->begin(), chosen->end());
        }
      }
    }
    for (std::size_t i = before; i < all.size(); ++i) {
      all[i].weight = study.weight / static_cast<double>(all.size() - before);
    }
  }
  return all;
}

// For each of its printed numbers, in the order of the paper: do a solver's runs explain it?
std::vector<bool> explained_by(const Multiverse::ChosenSolver& own, const std::string& solver) {
  std::vector<bool> all;
  for (std::size_t m = 0; m < metrics.size(); ++m) {
    const PredictedRanges ranges = predicted_ranges(m == 0 ? own.error_cm[0] : own.variation_deg[0], 20,
                                                    {.resamples = 500, .seed = 1, .level = 0.95});
    for (std::size_t s = 0; s < statistics_of_cell.size(); ++s) {
      const double value = printed_number(solver, metrics[m], statistics_of_cell[s]);
      const double rounding = half_unit_of(solver, metrics[m], statistics_of_cell[s]);
      all.push_back(value + rounding >= ranges[s].low && value - rounding <= ranges[s].high);
    }
  }
  return all;
}

const Table& table_of(const MultiverseReport& report, const std::string& name) {
  return *std::ranges::find(report.tables, name, &Table::name);
}

}  // namespace

TEST_CASE("what universes explain of the printed numbers is what listing them says", "[multiverse]") {
  const Multiverse multiverse = near_the_print();
  const MultiverseReport report = analysis::paper("slim2023").multiverse(multiverse, {});
  const std::vector<Universe> all = universes_of(multiverse);
  REQUIRE(all.size() == 2 * 3 + 2 * 3 + 2 * 2);
  std::vector<std::vector<bool>> explained;  // by universe, by number
  std::vector<int> counts;
  for (const Universe& each : all) {
    std::vector<bool> numbers;
    for (std::size_t s = 0; s < 3; ++s) {
      const std::vector<bool> more = explained_by(*each.solvers[s], multiverse.solvers[s]);
      numbers.insert(numbers.end(), more.begin(), more.end());
    }
    counts.push_back(static_cast<int>(std::ranges::count(numbers, true)));
    explained.push_back(numbers);
  }
  const int most = std::ranges::max(counts);
  const auto best = static_cast<double>(std::ranges::count(counts, most));
  CHECK(most > std::ranges::min(counts) + 3);  // else this would show little

  const Table& support = table_of(report, "multiverse-alternatives");
  std::size_t row = 0;
  for (std::size_t d = 0; d < multiverse.dimensions.size(); ++d) {
    for (std::size_t a = 0; a < multiverse.dimensions[d].alternatives.size(); ++a, ++row) {
      CAPTURE(d, a);
      double sum = 0, weight = 0, in_best = 0;
      int at_most = 0;
      for (std::size_t u = 0; u < all.size(); ++u) {
        const auto is_it = [&](const Multiverse::Choice& each) { return each.dimension == d && each.alternative == a; };
        if (std::ranges::none_of(all[u].chosen, is_it)) continue;
        sum += all[u].weight * counts[u];
        weight += all[u].weight;
        at_most = std::max(at_most, counts[u]);
        in_best += counts[u] == most ? 1 : 0;
      }
      CHECK(number_at(support, row, "explained_on_average") == Approx(sum / weight).margin(0.0501));
      CHECK(number_at(support, row, "explained_at_most") == at_most);
      CHECK(number_at(support, row, "of_the_best_percent") == Approx(100 * in_best / best).margin(0.0501));
    }
  }
  CHECK(row == support.rows.size());

  const Table& numbers = table_of(report, "multiverse-printed");
  REQUIRE(numbers.rows.size() == 30);
  double better_than_default = 0;
  for (std::size_t u = 0; u < all.size(); ++u) better_than_default += counts[u] > counts[0] ? all[u].weight : 0;
  for (std::size_t i = 0; i < 30; ++i) {
    CAPTURE(i);
    double share = 0, of_best = 0;
    for (std::size_t u = 0; u < all.size(); ++u) {
      share += explained[u][i] ? all[u].weight : 0;
      of_best += explained[u][i] && counts[u] == most ? 1 : 0;
    }
    CHECK(number_at(numbers, i, "interpretations_percent") == Approx(100 * share).margin(0.0501));
    CHECK(number_at(numbers, i, "of_the_best_percent") == Approx(100 * of_best / best).margin(0.0501));
    CHECK(std::get<std::string>(cell_at(numbers, i, "default")) == (explained[0][i] ? "inside" : "outside"));
  }
  std::size_t unexplained = 0;
  for (std::size_t i = 0; i < 30; ++i) unexplained += number_at(numbers, i, "interpretations_percent") == 0 ? 1 : 0;
  REQUIRE(report.sentences.size() == 3);
  CHECK_THAT(report.sentences[0], Catch::Matchers::Contains("the default explains " + std::to_string(counts[0])) &&
                                      Catch::Matchers::Contains(share_words(better_than_default)));
  CHECK_THAT(report.sentences[1], Catch::Matchers::StartsWith("The best explain " + std::to_string(most) + ": " +
                                                              std::to_string(static_cast<int>(best)) +
                                                              " interpretation" + (best == 1 ? "," : "s")));
  CHECK(report.sentences[2].starts_with(std::to_string(unexplained) + " of the 30 are explained by no interpretation"));

  std::vector<int> sorted = counts;
  std::ranges::sort(sorted);
  const int least = sorted[sorted.size() / 2];
  double fitting = 0;
  for (std::size_t u = 0; u < all.size(); ++u) fitting += counts[u] >= least ? all[u].weight : 0;
  const MultiverseReport fitted = multiverse_report({.paper = "slim2023",
                                                     .solver = "IK-BA",
                                                     .means = "table-3",
                                                     .fitting = least,
                                                     .entries = {{.id = "best",
                                                                  .sentence = "It is the best",
                                                                  .solver = "IK-BA",
                                                                  .metrics = {Metric::position_error_cm},
                                                                  .universes = {Estimand::mean}}}},
                                                    multiverse, {});
  const std::string those = "those that explain at least " + std::to_string(least) + " of the 30 printed numbers";
  CHECK(has_note(table_of(fitted, "multiverse"), those + ", which are " + share_words(fitting) + " of all"));
  CHECK(fitted.claims[0].fitting_holds == 1);  // as all others
  CHECK(number_at(table_of(fitted, "multiverse"), 0, "fitting_holds_percent") == 100);
  CHECK_THAT(fitted.claims[0].sentence, Catch::Matchers::Contains("undecided), in 100 % of " + those));
}

TEST_CASE("the specification curve is drawn evenly by the weight of the universes", "[multiverse]") {
  const Multiverse multiverse = near_the_print();
  std::vector<std::pair<double, double>> sorted;  // log10 of the ratio, weight
  for (const Universe& each : universes_of(multiverse)) {
    const double rival = std::min(mean(each.solvers[1]->error_cm[0]), mean(each.solvers[2]->error_cm[0]));
    sorted.emplace_back(std::log10(mean(each.solvers[0]->error_cm[0]) / rival), each.weight);
  }
  std::ranges::sort(sorted);
  const figures::Figure curve = analysis::paper("slim2023").multiverse(multiverse, {}).figures.front();
  std::istringstream lines(curve.data);
  std::string line;
  std::getline(lines, line);  // the heading
  std::size_t drawn = 0;
  for (; std::getline(lines, line) && !line.empty(); ++drawn) {
    double place = 0, estimate = 0, weight = 0;
    std::istringstream(line) >> place >> estimate;
    std::size_t at = 0;
    for (; at + 1 < sorted.size() && weight + sorted[at].second < place / 100; ++at) weight += sorted[at].second;
    CHECK(estimate == Approx(sorted[at].first));
  }
  CHECK(drawn == sorted.size());
}

TEST_CASE("the specification curve has a row for the rivals that are the best in a universe, and for no other",
          "[multiverse]") {
  Multiverse multiverse = near_the_print();
  const auto has_row_of = [&](const std::string& rival) {
    return contains(analysis::paper("slim2023").multiverse(multiverse, {}).figures.front().settings,
                    "best rival: " + rival);
  };
  CHECK(has_row_of("DE"));
  CHECK(has_row_of("BA"));
  for (Multiverse::OfStudy& study : multiverse.studies) {
    for (Multiverse::ChosenSolver& ba : study.solvers[1]) {
      for (double& error : ba.error_cm[0]) error *= 100;
    }
  }
  CHECK(has_row_of("DE"));
  CHECK(!has_row_of("BA"));
}

TEST_CASE("the claims that every universe judges are those that say so", "[multiverse]") {
  const MultiverseReport report = analysis::paper("slim2023").multiverse(near_the_print(), {});
  std::vector<std::string> ids;
  for (const ClaimShares& each : report.claims) {
    ids.push_back(each.id);
    CHECK(each.holds + each.fails + each.undecided == Approx(1));
  }
  // No MO-PSO here, so nothing about it and IK-BA.
  CHECK(ids == std::vector<std::string>{"most_accurate", "most_accurate_typically", "better_than_ba"});
  // Printed, and here: IK-BA has a thousandth of the others' errors.
  CHECK(report.claims[0].sentence.starts_with(
      "IK-BA is the most accurate in 100 % of the interpretations (0 % fail, 0 % "));
  const Table& table = table_of(report, "multiverse");
  CHECK(number_at(table, 0, "holds_percent") == 100);
  CHECK(is_empty(table, 0, "fitting_holds_percent"));  // no interpretation explains 25 of only 30 numbers
  CHECK(table.rows.size() == ids.size());
  CHECK(has_note(table, "16 interpretations: 3 choices for the study"));
  Multiverse few = near_the_print();
  for (Multiverse::OfStudy& study : few.studies) {
    for (auto& of_solver : study.solvers) {
      for (Multiverse::ChosenSolver& own : of_solver) own.error_cm[0].resize(fewest_predicting - 1);
    }
  }
  CHECK(analysis::paper("slim2023").multiverse(few, {}).sentences.empty());  // too few runs to say what is next
  few.solvers.front() = "PSO";
  CHECK_THROWS_AS(analysis::paper("slim2023").multiverse(few, {}), std::invalid_argument);
  CHECK_THROWS_AS(analysis::paper("slim2023").multiverse({}, {}), std::invalid_argument);
}
