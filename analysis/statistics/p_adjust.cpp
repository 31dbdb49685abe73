#include "analysis/statistics/p_adjust.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace ikbench::statistics {
namespace {

// The factor for the p of the given rank, 1 for the smallest, among m.
double factor(Correction correction, double rank, double m) {
  switch (correction) {
    case Correction::holm:
    case Correction::hochberg:
      return m - rank + 1;
    case Correction::bonferroni:
      return m;
    case Correction::benjamini_hochberg:
      return m / rank;
  }
  return m;
}

}  // namespace

std::vector<double> adjusted(std::span<const double> p, Correction correction) {
  std::vector<double> result(p.begin(), p.end());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (std::isnan(p[i])) continue;
    if (p[i] < 0 || p[i] > 1) throw std::invalid_argument(fmt::format("p-value {}: expected 0 to 1", p[i]));
    order.push_back(i);
  }
  std::ranges::sort(order, {}, [&](std::size_t i) { return p[i]; });
  const double m = static_cast<double>(order.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    double& value = result[order[rank]];
    value = std::min(1.0, factor(correction, static_cast<double>(rank) + 1, m) * value);
  }
  // An adjusted p is never below that of a smaller p: Holm steps down from the smallest, the others up from the
  // largest.
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (correction == Correction::holm) {
      result[order[i]] = std::max(result[order[i]], result[order[i - 1]]);
    } else {
      const std::size_t rank = order.size() - 1 - i;
      result[order[rank]] = std::min(result[order[rank]], result[order[rank + 1]]);
    }
  }
  return result;
}

}  // namespace ikbench::statistics
