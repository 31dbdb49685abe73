#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/papers/published.hpp"

namespace ikbench::papers {
namespace {

// From (0, 1), the same on every machine.
double open_uniform(std::mt19937_64& engine) { return (static_cast<double>(engine() >> 32) + 0.5) * 0x1p-32; }

// Mean excess of the outermost fifth over the next.
double tail_slope(const std::vector<double>& outwards) {
  const std::size_t tail = std::max<std::size_t>(2, outwards.size() / 5);
  double sum = 0;
  for (std::size_t i = outwards.size() - tail; i < outwards.size(); ++i)
    sum += std::abs(outwards[i] - outwards[outwards.size() - tail - 1]);
  return sum / static_cast<double>(tail);
}

}  // namespace

std::optional<Ranges> predicted_ranges(const std::vector<double>& values, int runs) {
  constexpr std::size_t studies = 500, least = 12, most = 487;  // of the sorted ones: 2.5 and 97.5 %
  if (values.size() < 5 || std::ranges::min(values) <= 0) return {};
  std::vector<double> logs;
  for (const double value : values) logs.push_back(std::log(value));
  std::ranges::sort(logs);
  const double above = tail_slope(logs), below = tail_slope({logs.rbegin(), logs.rend()});
  std::mt19937_64 engine(1);
  std::array<std::vector<double>, statistics.size()> replicates;
  for (std::size_t i = 0; i < studies; ++i) {
    std::vector<double> known = logs;
    compare::Group study;
    for (int run = 0; run < runs; ++run) {
      const double place = open_uniform(engine) * static_cast<double>(known.size() + 1), u = open_uniform(engine);
      const auto gap = static_cast<std::size_t>(place);
      const double value = gap == 0              ? known.front() + below * std::log(u)
                           : gap == known.size() ? known.back() - above * std::log(u)
                                                 : known[gap - 1] + u * (known[gap] - known[gap - 1]);
      known.insert(known.begin() + static_cast<std::ptrdiff_t>(gap), value);
      study.values.push_back(std::exp(value));
    }
    const compare::Description its = compare::describe(study);
    for (std::size_t s = 0; s < statistics.size(); ++s) replicates[s].push_back(its.*statistics[s].of);
  }
  Ranges ranges;
  for (std::size_t s = 0; s < statistics.size(); ++s) {
    std::ranges::sort(replicates[s]);
    ranges[s] = {replicates[s][least], replicates[s][most]};
  }
  return ranges;
}

}  // namespace ikbench::papers
