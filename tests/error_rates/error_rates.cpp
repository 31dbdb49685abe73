// Measures how often the verdicts are wrong: draws data sets with a known truth, judges them as a report does, and
// prints the shares as the tables of docs/methods.md.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
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

  int n() const { return sizes.front(); }
};

Observations observations_of(const Scenario& scenario, Random& random) {
  Observations result{.name = "x", .quantity = "x"};
  for (std::size_t g = 0; g < scenario.sizes.size(); ++g) {
    Group& group = result.groups.emplace_back(Group{.name = fmt::format("g{}", g)});
    for (int i = 0; i < scenario.sizes[g]; ++i) group.values.push_back(scenario.draw(random, static_cast<int>(g)));
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
  return all;
}

void print_means(int simulations) {
  fmt::print("| false findings of means, six groups | n | Tamhane | default |\n|---|---|---|---|\n");
  for (const Scenario& scenario : nothing_differs()) {
    const auto found = [&](const std::string& test) { return shares(scenario, test, Counts::any_pair, simulations); };
    fmt::print("| {} | {} | {} | {} |\n", scenario.name, scenario.n(),
               with_error(found("tamhane").decided, simulations), decided_words(found("by_design"), simulations));
  }
  fmt::print("\n");
}

void print_power(int simulations) {
  fmt::print(
      "| pairs that are found, with the one of six groups that differs | n | Tamhane | default |\n"
      "|---|---|---|---|\n");
  for (const Scenario& scenario : first_differs()) {
    const auto found = [&](const std::string& test) {
      return shares(scenario, test, Counts::pairs_with_first, simulations);
    };
    const Shares by_default = found("by_design");
    fmt::print("| {} | {} | {:.3f} | {} |\n", scenario.name, scenario.n(), found("tamhane").decided,
               by_default.judged == 0 ? "refused" : fmt::format("{:.3f}", by_default.decided));
  }
  fmt::print("\n");
}

void print_ranks(int simulations) {
  fmt::print(
      "| false findings of ranks, six groups | n | what decides |\n"
      "|---|---|---|\n");
  for (const Scenario& scenario : for_ranks()) {
    const Shares found = shares(scenario, "kruskal_wallis", Counts::any_pair, simulations);
    fmt::print("| {} | {} | {} |\n", scenario.name, scenario.n(), with_error(found.decided, simulations));
  }
  fmt::print("\n");
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
  print_means(simulations);
  print_power(simulations);
  print_ranks(simulations);
  print_limits(simulations);
  return 0;
}
