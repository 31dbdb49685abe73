// Measures how often the verdicts are wrong: draws data sets with a known truth, judges them as a report does, and
// prints the shares as the tables of docs/methods.md.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/inference/judge.hpp"
#include "analysis/statistics/studentized_bootstrap.hpp"
#include "analysis/statistics/welch.hpp"
#include "tests/error_rates/bca.hpp"
#include "tests/error_rates/draws.hpp"
#include "tests/error_rates/limits.hpp"

namespace {

using namespace ikbench;
using namespace ikbench::inference;
using namespace ikbench::error_rates;
using results::AnalysisPlan;

// Groups of one population each, named by how their draws differ.
struct Scenario {
  std::string name;
  std::vector<int> sizes;
  std::function<double(Random&, int group)> draw;
  bool blocked = false;

  int n() const { return sizes.front(); }
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

// Counts pairs that are found to differ: of all, or of those with the first group.
enum class Counts { any_pair, pairs_with_first };

// Shares of pairs that a deciding test decides, and of pairs that it judges at all.
struct Shares {
  double decided = 0, judged = 0;

  static constexpr std::array all{&Shares::decided, &Shares::judged};
};

Shares found_pairs(const Evidence& evidence, Counts counts) {
  Shares found;
  double pairs = 0;
  const auto add = [&](double& count, bool differs) { count += differs ? 1 : 0; };
  for (const Finding& contrast : evidence.contrasts) {
    if (counts == Counts::pairs_with_first && contrast.first != 0) continue;
    const Finding judged = judge(evidence, evidence.groups[contrast.first].name, evidence.groups[contrast.second].name);
    add(found.decided, judged.relation == Relation::better || judged.relation == Relation::worse);
    add(found.judged, judged.why.empty());
    ++pairs;
  }
  for (const auto share : Shares::all) {
    const bool is_any = counts == Counts::any_pair && share != &Shares::judged;
    found.*share = is_any ? std::min(1.0, found.*share) : found.*share / pairs;
  }
  return found;
}

Shares shares(const Scenario& scenario, const std::string& test, Counts counts, int simulations) {
  std::vector<Shares> found(static_cast<std::size_t>(simulations));
  tbb::parallel_for(0, simulations, [&](int simulation) {
    Random random(fmt::format("{}{}", scenario.name, scenario.n()), simulation);
    found[static_cast<std::size_t>(simulation)] =
        found_pairs(evidence(observations_of(scenario, random), {.test = test}), counts);
  });
  Shares result;
  for (const auto share : Shares::all) {
    for (const Shares& one : found) result.*share += one.*share / simulations;
  }
  return result;
}

// The share of decided pairs, in words; a test may judge no pair.
std::string decided_words(const Shares& found, int simulations) {
  if (found.judged == 0) return "refused";
  const std::string share = with_error(found.decided, simulations);
  return found.judged > 0.995 ? share : fmt::format("{}; {:.0f} % of pairs judged", share, 100 * found.judged);
}

std::vector<int> six(int n) { return std::vector<int>(6, n); }

std::vector<Scenario> of_unequal_spread() {
  std::vector<Scenario> all;
  for (const int n : {2, 3, 5}) {
    all.push_back({.name = "false findings: normal, sizes n to n + 5, deviations 6 to 1",
                   .sizes = {n, n + 1, n + 2, n + 3, n + 4, n + 5},
                   .draw = [](Random& r, int g) { return 100 + (6 - g) * r.normal(); }});
  }
  for (const int n : {2, 3, 5, 10, 20}) {
    all.push_back({.name = "false findings: lognormal, sigma 0.25 to 1.5",
                   .sizes = six(n),
                   .draw = [](Random& r, int g) { return r.lognormal(0.25 * (g + 1)); }});
  }
  return all;
}

std::vector<Scenario> nothing_differs() {
  std::vector<Scenario> all;
  const auto add = [&](std::string name, std::vector<int> sizes, auto draw) {
    all.push_back({.name = std::move(name), .sizes = std::move(sizes), .draw = draw});
  };
  for (const int n : {3, 5, 10, 20}) add("normal", six(n), [](Random& r, int) { return 10 + r.normal(); });
  for (const int n : {3, 5, 10}) {
    add("normal; one small group, 5 times as variable as five groups of 20", {n, 20, 20, 20, 20, 20},
        [](Random& r, int g) { return 100 + (g == 0 ? 5 : 1) * r.normal(); });
  }
  for (const int n : {5, 20}) {
    add("Student's t with 3 degrees of freedom", six(n), [](Random& r, int) { return r.student_3(); });
  }
  for (const int n : {5, 20}) add("lognormal, sigma 1", six(n), [](Random& r, int) { return r.lognormal(1); });
  for (const int n : {10, 20}) {
    add("two lognormal groups, sigma 0.25 and 1.5", {n, n},
        [](Random& r, int g) { return r.lognormal(g == 0 ? 0.25 : 1.5); });
  }
  for (const int n : {10, 20}) {
    add("three exponential groups, three of little spread", six(n),
        [](Random& r, int g) { return g < 3 ? r.exponential() : 1 + 0.1 * r.normal(); });
  }
  return all;
}

std::vector<Scenario> first_differs() {
  std::vector<Scenario> all;
  const auto add = [&](std::string name, int n, auto draw) {
    all.push_back({.name = std::move(name), .sizes = six(n), .draw = draw});
  };
  for (const int n : {5, 10, 20}) {
    add("normal, lower by 1.2 standard deviations", n,
        [](Random& r, int g) { return (g == 0 ? 8.8 : 10) + r.normal(); });
  }
  for (const int n : {10, 20}) {
    add("lognormal, sigma 1, a quarter of the mean", n,
        [](Random& r, int g) { return (g == 0 ? 0.25 : 1) * r.lognormal(1); });
  }
  for (const int n : {3, 4, 5}) {
    add("no overlap: 1 to 2 against 10 to 11", n, [](Random& r, int g) { return (g == 0 ? 1 : 10) + r.uniform(); });
  }
  return all;
}

std::vector<Scenario> for_ranks() {
  std::vector<Scenario> all;
  const auto add = [&](std::string name, std::vector<int> sizes, auto draw) {
    all.push_back({.name = std::move(name), .sizes = std::move(sizes), .draw = draw});
  };
  for (const int n : {6, 10, 20}) add("all alike, lognormal", six(n), [](Random& r, int) { return r.lognormal(1); });
  for (const int n : {6, 10, 20}) {
    add("normal, equal medians, deviations 1 to 6", six(n), [](Random& r, int g) { return (g + 1) * r.normal(); });
  }
  for (const int n : {6, 10, 20}) {
    add("the same, sizes n to n + 5, the smallest the most variable", {n, n + 1, n + 2, n + 3, n + 4, n + 5},
        [](Random& r, int g) { return (6 - g) * r.normal(); });
  }
  for (const int n : {10, 20}) {
    add("all alike, lognormal, in blocks (sign test)", six(n), [](Random& r, int) { return r.lognormal(1); });
    all.back().blocked = true;
  }
  return all;
}

// Shares of 95 % intervals that contain the true mean.
struct Covered {
  double student = 0, bca = 0, studentized = 0;
};

struct Source {
  std::string name;
  double mean;
  std::function<double(Random&)> draw;
};

Covered coverage(const Source& source, int n, int simulations) {
  using namespace statistics;
  std::atomic<int> student = 0, bca = 0, studentized = 0;
  tbb::parallel_for(0, simulations, [&](int simulation) {
    Random random(fmt::format("{}{}", source.name, n), simulation);
    std::vector<double> values;
    for (int i = 0; i < n; ++i) values.push_back(source.draw(random));
    const auto has = [&](double low, double high) { return low <= source.mean && source.mean <= high ? 1 : 0; };
    const Estimate by_t = mean_interval(summarise(values), 0.95);
    const Estimate by_bca = bca_of_mean(values);
    const Estimate by_bootstrap = studentized_interval(values, {});
    student += has(by_t.low, by_t.high);
    bca += has(by_bca.low, by_bca.high);
    studentized += has(by_bootstrap.low, by_bootstrap.high);
  });
  const auto share = [&](int count) { return static_cast<double>(count) / simulations; };
  return {share(student), share(bca), share(studentized)};
}

const Source normal_source{"normal", 0, [](Random& r) { return r.normal(); }};

void print_before_and_now(int simulations) {
  fmt::print("| what is measured | n | before | now |\n|---|---|---|---|\n");
  for (const Scenario& scenario : of_unequal_spread()) {
    const auto found = [&](const std::string& test) { return shares(scenario, test, Counts::any_pair, simulations); };
    fmt::print("| {} | {} | {} | {} |\n", scenario.name, scenario.n(), with_error(found("welch").decided, simulations),
               decided_words(found("by_design"), simulations));
  }
  for (const int n : {5, 10, 20}) {
    const Covered covered = coverage(normal_source, n, simulations);
    fmt::print("| 95 % bootstrap intervals that hold: normal mean | {} | {} | {} |\n", n,
               with_error(covered.bca, simulations), with_error(covered.studentized, simulations));
  }
  fmt::print("\n");
}

void print_means(int simulations) {
  fmt::print("| false findings of means, six groups | n | Games-Howell | Tamhane | default |\n|---|---|---|---|---|\n");
  for (const Scenario& scenario : nothing_differs()) {
    const auto found = [&](const std::string& test) { return shares(scenario, test, Counts::any_pair, simulations); };
    fmt::print("| {} | {} | {} | {} | {} |\n", scenario.name, scenario.n(),
               with_error(found("welch").decided, simulations), with_error(found("tamhane").decided, simulations),
               decided_words(found("by_design"), simulations));
  }
  fmt::print("\n");
}

void print_power(int simulations) {
  fmt::print(
      "| pairs that are found, with the one of six groups that differs | n | Games-Howell | Tamhane | default |\n"
      "|---|---|---|---|---|\n");
  for (const Scenario& scenario : first_differs()) {
    const auto found = [&](const std::string& test) {
      return shares(scenario, test, Counts::pairs_with_first, simulations);
    };
    const Shares by_default = found("by_design");
    fmt::print("| {} | {} | {:.3f} | {:.3f} | {} |\n", scenario.name, scenario.n(), found("welch").decided,
               found("tamhane").decided,
               by_default.judged == 0 ? "refused" : fmt::format("{:.3f}", by_default.decided));
  }
  fmt::print("\n");
}

void print_ranks(int simulations) {
  fmt::print(
      "| false findings of ranks, six groups | n | what decides |\n"
      "|---|---|---|\n");
  for (const Scenario& scenario : for_ranks()) {
    const std::string test = scenario.blocked ? "friedman" : "kruskal_wallis";
    const Shares found = shares(scenario, test, Counts::any_pair, simulations);
    fmt::print("| {} | {} | {} |\n", scenario.name, scenario.n(), with_error(found.decided, simulations));
  }
  fmt::print("\n");
}

void print_coverage(int simulations) {
  const std::vector<Source> sources{normal_source,
                                    {"exponential", 1, [](Random& r) { return r.exponential(); }},
                                    {"lognormal, sigma 1", 1, [](Random& r) { return r.lognormal(1); }}};
  fmt::print(
      "| 95 % intervals of a mean that hold | n | Student's t | BCa | studentized bootstrap |\n|---|---|---|---|---|\n");
  for (const Source& source : sources) {
    for (const int n : {5, 10, 20, 50}) {
      const Covered covered = coverage(source, n, simulations);
      fmt::print("| {} | {} | {} | {} | {} |\n", source.name, n, with_error(covered.student, simulations),
                 with_error(covered.bca, simulations), with_error(covered.studentized, simulations));
    }
  }
}

}  // namespace

// error_rates [SIMULATIONS per row]
int main(int argc, char** argv) {
  int simulations = 500;
  if (argc > 1) {
    const std::string_view text = argv[1];
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), simulations);
    if (error != std::errc{} || end != text.data() + text.size() || simulations < 1) {
      fmt::print(stderr, "error_rates: '{}': expected a number of simulations\n", text);
      return 1;
    }
  }
  fmt::print("Each row has {} data sets; ± is the standard error.\n\n", simulations);
  print_before_and_now(simulations);
  print_means(simulations);
  print_power(simulations);
  print_ranks(simulations);
  print_coverage(simulations);
  print_limits(simulations);
  return 0;
}
