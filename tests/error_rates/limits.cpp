#include "tests/error_rates/limits.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/statistics/proportion.hpp"
#include "tests/error_rates/draws.hpp"

namespace ikbench::error_rates {

using namespace inference;
using results::AnalysisPlan;

namespace {

using Draw = std::function<double(Random&, int group)>;
using Values = std::vector<std::vector<double>>;

// The share of data sets for which `holds` is true.
double share_of(const std::string& row, int simulations, const std::function<bool(Random&)>& holds) {
  std::atomic<int> count = 0;
  tbb::parallel_for(0, simulations, [&](int simulation) {
    Random random(row, simulation);
    count += holds(random) ? 1 : 0;
  });
  return static_cast<double>(count) / simulations;
}

Values drawn(Random& random, std::pair<int, int> groups_and_values, const Draw& draw) {
  Values values(static_cast<std::size_t>(groups_and_values.first));
  for (int i = 0; i < groups_and_values.second; ++i) {
    for (std::size_t g = 0; g < values.size(); ++g) values[g].push_back(draw(random, static_cast<int>(g)));
  }
  return values;
}

Observations observed(const Values& values, Better better = Better::smaller) {
  Observations result{.name = "x", .quantity = "x", .better = better};
  for (std::size_t g = 0; g < values.size(); ++g) result.groups.push_back({fmt::format("g{}", g), values[g]});
  return result;
}

// Multiplies each value by the scale of its block.
Observations in_blocks(Values values, Random& random) {
  std::vector<std::string> blocks;
  for (std::size_t i = 0; i < values[0].size(); ++i) {
    const double scale = 10 * random.lognormal(0.5);
    for (auto& group : values) group[i] *= scale;
    blocks.push_back(fmt::format("{}", i));
  }
  Observations result = observed(values);
  result.blocks = std::move(blocks);
  return result;
}

bool any_is_better(const Evidence& found) { return std::ranges::any_of(found.contrasts, is_decided); }

bool any_is_the_same(const Evidence& found) {
  return std::ranges::any_of(found.contrasts, [](const Finding& pair) { return pair.relation == Relation::same; });
}

double failing(Random& random, double share, double size) { return random.uniform() < share ? size : 1; }

void print_blocks(int simulations) {
  const std::vector<std::pair<std::string, Draw>> laws{
      {"all alike, normal", [](Random& r, int) { return 10 + r.normal(); }},
      {"all alike, lognormal", [](Random& r, int) { return r.lognormal(1); }},
      {"equal means; a tenth of the first's fail",
       [](Random& r, int g) { return 0.1 * r.normal() + (g == 0 ? failing(r, 0.1, 3) : 1.2); }}};
  fmt::print(
      "\n| false findings within blocks | groups | blocks | default (means) | `typical` |\n"
      "|---|---|---|---|---|\n");
  for (const auto& [name, draw] : laws) {
    for (const auto& [groups, blocks] : {std::pair(2, 10), {2, 20}, {3, 10}, {3, 20}, {6, 10}, {6, 20}}) {
      const auto found = [&](ValueScale scale) {
        return with_error(share_of(fmt::format("{}{}{}", name, groups, blocks), simulations,
                                   [&](Random& random) {
                                     Observations sets = in_blocks(drawn(random, {groups, blocks}, draw), random);
                                     sets.scale = scale;
                                     for (Group& group : sets.groups) {
                                       for (double& value : group.values) {
                                         if (scale == ValueScale::log10) value = std::log10(std::max(value, 1e-7));
                                       }
                                     }
                                     return any_is_better(evidence(sets, {}));
                                   }),
                          simulations);
      };
      const bool are_means = name.starts_with("equal means");  // the means are equal; typical values differ
      fmt::print("| {} | {} | {} | {} | {} |\n", name, groups, blocks, found(ValueScale::plain),
                 are_means ? "they differ" : found(ValueScale::log10));
    }
  }
}

void print_same(int simulations) {
  fmt::print(
      "\n| \"the same within 5 %\" of what differs by more | n | said without a limit | said with its limit | "
      "not excluded |\n|---|---|---|---|---|\n");
  const auto print = [&](const std::string& name, int n, bool are_shares, const Draw& draw) {
    const std::string row = fmt::format("{}{}", name, n);
    const double in_stats = share_of(row, simulations, [&](Random& random) {
      return any_is_the_same(
          evidence(observed(drawn(random, {2, n}, draw), are_shares ? Better::larger : Better::smaller), {}));
    });
    fmt::print("| {} | {} | {} | {} | {:.2g} % |\n", name, n, are_shares ? with_error(in_stats, simulations) : "-",
               are_shares ? "-" : with_error(in_stats, simulations), 100 * statistics::most_without_success(n, 0.05));
  };
  for (const int n : {4, 5, 10, 20}) {
    print("shares of 1 and 0.8", n, true, [](Random& r, int g) { return g == 0 || r.uniform() < 0.8 ? 1.0 : 0.0; });
  }
  for (const int n : {5, 20, 50, 100}) {
    print("1 % of the second fail, with eleven times the value", n, false,
          [](Random& r, int g) { return 0.01 * r.normal() + (g == 0 ? 1 : failing(r, 0.01, 11)); });
  }
  for (const int n : {5, 20, 50, 100}) {
    print("5 % of the second fail, with three times the value", n, false,
          [](Random& r, int g) { return 0.01 * r.normal() + (g == 0 ? 1 : failing(r, 0.05, 3)); });
  }
}

void print_rare(int simulations) {
  fmt::print(
      "\n| \"better\" though the means are equal: 5 % of the first fail | n | default | not excluded |\n|---|---|---|---|\n");
  for (const int n : {5, 10, 20, 50}) {
    const double found = share_of(fmt::format("rare{}", n), simulations, [&](Random& random) {
      const Draw draw = [](Random& r, int g) { return 0.01 * r.normal() + (g == 0 ? failing(r, 0.05, 3) : 1.1); };
      return any_is_better(evidence(observed(drawn(random, {2, n}, draw)), {}));
    });
    fmt::print("| three times the value | {} | {} | {:.2g} % |\n", n, with_error(found, simulations),
               100 * statistics::most_without_success(n, 0.05));
  }
}

}  // namespace

void print_limits(int simulations) {
  print_blocks(simulations);
  print_same(simulations);
  print_rare(simulations);
}

}  // namespace ikbench::error_rates
