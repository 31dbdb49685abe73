// How often the verdicts are wrong: draws data sets of which the truth is known, has them judged as a report has, and
// prints the shares as the tables of docs/statistics.md, which docs/error-rates writes.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/judge.hpp"
#include "analysis/statistics/bootstrap.hpp"
#include "analysis/statistics/studentized_bootstrap.hpp"

namespace {

using namespace ikbench;
using namespace ikbench::inference;
using results::AnalysisPlan;
using results::DecidingTest;

// The same numbers on every machine but for the last bit of a logarithm.
class Random {
 public:
  // Other numbers for every simulation of every row, by its words (FNV-1a).
  Random(std::string_view row, int simulation) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : row) hash = (hash ^ static_cast<std::uint64_t>(c)) * 1099511628211u;
    engine_.seed(hash + static_cast<std::uint64_t>(simulation));
  }

  double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }
  double exponential() { return -std::log(uniform()); }
  double normal() {
    const double radius = std::sqrt(2 * exponential());
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }
  double lognormal(double sigma) { return std::exp(sigma * normal() - sigma * sigma / 2); }  // of mean 1
  double student_3() {
    const double x = normal(), a = normal(), b = normal(), c = normal();
    return x / std::sqrt((a * a + b * b + c * c) / 3);
  }

 private:
  std::mt19937_64 engine_;
};

struct Scenario {
  std::string name, n;
  std::vector<int> sizes;
  std::function<double(Random&, int group)> draw;
  bool blocked = false;
};

Observations observations_of(const Scenario& scenario, Random& random) {
  Observations result{.name = "x", .quantity = "x"};
  for (std::size_t g = 0; g < scenario.sizes.size(); ++g) {
    Group& group = result.groups.emplace_back(Group{.name = fmt::format("g{}", g)});
    for (int i = 0; i < scenario.sizes[g]; ++i) group.values.push_back(scenario.draw(random, static_cast<int>(g)));
  }
  if (!scenario.blocked) return result;
  for (int i = 0; i < scenario.sizes[0]; ++i) {
    const double problem = 10 * random.lognormal(1);
    for (Group& group : result.groups) group.values[static_cast<std::size_t>(i)] *= problem;
    result.blocks.push_back(fmt::format("{}", i));
  }
  return result;
}

// Pairs that are found to differ, of all or of those with the first group.
enum class Counts { any_pair, pairs_with_first };

// By the test that decides, as it is judged, and by two that are shown beside it.
struct Shares {
  double decided = 0, games_howell = 0, tamhane = 0;
};

Shares found_pairs(const Evidence& evidence, Counts counts) {
  Shares found;
  const auto add = [&](double& share, bool differs) {
    const double all = counts == Counts::any_pair ? 1 : static_cast<double>(evidence.groups.size()) - 1;
    share = std::min(1.0, share + (differs ? 1 / all : 0));
  };
  for (const Contrast& contrast : evidence.contrasts) {
    if (counts == Counts::pairs_with_first && contrast.first != 0) continue;
    const Answer answer =
        judge(evidence, evidence.groups[contrast.first].name, evidence.groups[contrast.second].name).answer;
    add(found.decided, answer == Answer::better || answer == Answer::worse);
    add(found.games_howell, is_significant(contrast.p_unpooled, evidence.plan));
    add(found.tamhane, is_significant(contrast.p_tamhane, evidence.plan));
  }
  return found;
}

Shares shares(const Scenario& scenario, DecidingTest test, Counts counts, int simulations) {
  std::vector<Shares> found(static_cast<std::size_t>(simulations));
  tbb::parallel_for(0, simulations, [&](int simulation) {
    Random random(scenario.name + scenario.n, simulation);
    found[static_cast<std::size_t>(simulation)] =
        found_pairs(tested(observations_of(scenario, random), {.test = test}), counts);
  });
  Shares result;
  for (const Shares& one : found) {
    result.decided += one.decided / simulations;
    result.games_howell += one.games_howell / simulations;
    result.tamhane += one.tamhane / simulations;
  }
  return result;
}

std::vector<int> six(int n) { return std::vector<int>(6, n); }

std::vector<Scenario> nothing_differs() {
  std::vector<Scenario> all;
  const auto add = [&](std::string name, int n, std::vector<int> sizes, auto draw) {
    all.push_back({std::move(name), fmt::format("{}", n), std::move(sizes), draw});
  };
  const auto spread = [](int g) { return 0.25 * (g + 1); };
  for (const int n : {2, 3, 5, 10, 20}) add("normal", n, six(n), [](Random& r, int) { return 10 + r.normal(); });
  for (const int n : {2, 3, 5}) {
    add("normal; one small group, 5 times as variable as five groups of 20", n, {n, 20, 20, 20, 20, 20},
        [](Random& r, int g) { return 100 + (g == 0 ? 5 : 1) * r.normal(); });
  }
  for (const int n : {2, 3, 5}) {
    add("normal; sizes n to n + 5, deviations 6 to 1", n, {n, n + 1, n + 2, n + 3, n + 4, n + 5},
        [](Random& r, int g) { return 100 + (6 - g) * r.normal(); });
  }
  for (const int n : {5, 20})
    add("Student's t with 3 degrees of freedom", n, six(n), [](Random& r, int) { return r.student_3(); });
  for (const int n : {5, 20}) add("lognormal, sigma 1", n, six(n), [](Random& r, int) { return r.lognormal(1); });
  for (const int n : {2, 3, 5, 10, 20}) {
    add("lognormal, equal means, sigma 0.25 to 1.5", n, six(n),
        [=](Random& r, int g) { return r.lognormal(spread(g)); });
  }
  for (const int n : {10, 20}) {
    add("two lognormal groups, equal means, sigma 0.25 and 1.5", n, {n, n},
        [](Random& r, int g) { return r.lognormal(g == 0 ? 0.25 : 1.5); });
  }
  for (const int n : {10, 20}) {
    add("three exponential groups, three of little spread", n, six(n),
        [](Random& r, int g) { return g < 3 ? r.exponential() : 1 + 0.1 * r.normal(); });
  }
  for (const int n : {10, 20}) {
    add("0 or 1, with probability 0.9 of 1", n, six(n), [](Random& r, int) { return r.uniform() < 0.9 ? 1.0 : 0.0; });
  }
  return all;
}

std::vector<Scenario> first_differs() {
  std::vector<Scenario> all;
  const auto add = [&](std::string name, int n, auto draw) {
    all.push_back({std::move(name), fmt::format("{}", n), six(n), draw});
  };
  for (const int n : {5, 10, 20}) {
    add("normal, lower by 1.2 standard deviations", n,
        [](Random& r, int g) { return (g == 0 ? 8.8 : 10) + r.normal(); });
  }
  for (const int n : {10, 20}) {
    add("lognormal, sigma 0.5, half the mean", n,
        [](Random& r, int g) { return (g == 0 ? 0.5 : 1) * r.lognormal(0.5); });
  }
  for (const int n : {10, 20}) {
    add("lognormal, sigma 1, a quarter of the mean", n,
        [](Random& r, int g) { return (g == 0 ? 0.25 : 1) * r.lognormal(1); });
  }
  for (const int n : {2, 3, 4, 5, 20}) {
    add("no overlap: 1 to 2 against 10 to 11", n, [](Random& r, int g) { return (g == 0 ? 1 : 10) + r.uniform(); });
  }
  return all;
}

std::vector<Scenario> for_ranks() {
  std::vector<Scenario> all;
  for (const bool blocked : {false, true}) {
    for (const int n : {5, 10, 20}) {
      all.push_back(
          {blocked ? "lognormal in blocks, sigma 1; Friedman's test" : "lognormal, sigma 1; Kruskal-Wallis test",
           fmt::format("{}", n), six(n), [](Random& r, int) { return r.lognormal(1); }, blocked});
    }
  }
  return all;
}

void print_shares(std::string_view title, const std::vector<Scenario>& scenarios, Counts counts, int simulations) {
  fmt::print("| {} | n | Games-Howell | Tamhane | studentized bootstrap |\n|---|---|---|---|---|\n", title);
  for (const Scenario& scenario : scenarios) {
    const Shares found = shares(scenario, DecidingTest::by_design, counts, simulations);
    fmt::print("| {} | {} | {:.3f} | {:.3f} | {:.3f} |\n", scenario.name, scenario.n, found.games_howell, found.tamhane,
               found.decided);
    std::fflush(stdout);
  }
  fmt::print("\n");
}

void print_ranks(int simulations) {
  fmt::print("| false findings by ranks, six groups alike | n | share |\n|---|---|---|\n");
  for (const Scenario& scenario : for_ranks()) {
    const DecidingTest test = scenario.blocked ? DecidingTest::friedman : DecidingTest::kruskal_wallis;
    fmt::print("| {} | {} | {:.3f} |\n", scenario.name, scenario.n,
               shares(scenario, test, Counts::any_pair, simulations).decided);
  }
  fmt::print("\n");
}

struct Covered {
  std::atomic<int> student = 0, bca = 0, studentized = 0;
};

void count_covered(const std::vector<double>& values, double truth, Covered& covered) {
  using namespace statistics;
  const auto has = [&](double low, double high) { return low <= truth && truth <= high ? 1 : 0; };
  const MeanInterval student = mean_interval(summarise(values), 0.95);
  const auto mean_of = [](std::span<const double> sample) { return mean(sample); };
  const BootstrapInterval bca = bootstrap(values, mean_of, {.resamples = 1999});
  const MeanInterval studentized = studentized_interval(values, {.resamples = 1999});
  covered.student += has(student.low, student.high);
  covered.bca += has(bca.bca_low, bca.bca_high);
  covered.studentized += has(studentized.low, studentized.high);
}

void print_coverage(int simulations) {
  struct Source {
    std::string name;
    double mean;
    std::function<double(Random&)> draw;
  };
  const std::vector<Source> sources{{"normal", 0, [](Random& r) { return r.normal(); }},
                                    {"exponential", 1, [](Random& r) { return r.exponential(); }},
                                    {"lognormal, sigma 0.5", 1, [](Random& r) { return r.lognormal(0.5); }},
                                    {"lognormal, sigma 1", 1, [](Random& r) { return r.lognormal(1); }}};
  fmt::print(
      "| 95 % intervals of a mean that hold | n | Student's t | BCa | studentized bootstrap |\n|---|---|---|---|---|\n");
  for (const Source& source : sources) {
    for (const int n : {5, 10, 20, 50}) {
      Covered covered;
      tbb::parallel_for(0, simulations, [&](int simulation) {
        Random random(source.name + std::to_string(n), simulation);
        std::vector<double> values;
        for (int i = 0; i < n; ++i) values.push_back(source.draw(random));
        count_covered(values, source.mean, covered);
      });
      const auto share = [&](int count) { return static_cast<double>(count) / simulations; };
      fmt::print("| {} | {} | {:.3f} | {:.3f} | {:.3f} |\n", source.name, n, share(covered.student), share(covered.bca),
                 share(covered.studentized));
    }
  }
}

}  // namespace

// error_rates [SIMULATIONS of each row]
int main(int argc, char** argv) {
  int simulations = 1500;
  if (argc > 1) {
    const std::string_view text = argv[1];
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), simulations);
    if (error != std::errc{} || end != text.data() + text.size() || simulations < 1) {
      fmt::print(stderr, "error_rates: '{}': expected a number of simulations\n", text);
      return 1;
    }
  }
  print_shares("false findings, six groups of equal means", nothing_differs(), Counts::any_pair, simulations);
  print_shares("found pairs with the first of six groups, which differs", first_differs(), Counts::pairs_with_first,
               simulations);
  print_ranks(simulations);
  print_coverage(simulations);
  return 0;
}
