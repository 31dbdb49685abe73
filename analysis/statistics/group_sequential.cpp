#include "analysis/statistics/group_sequential.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {
namespace {

void check_boundary(const Boundary& boundary) {
  if (boundary.looks >= 1 && boundary.looks <= 100 && boundary.shape >= 0 && boundary.shape <= 0.5) return;
  throw std::invalid_argument(
      fmt::format("{} looks of shape {}: expected 1 to 100, and 0 to 0.5", boundary.looks, boundary.shape));
}

struct Node {
  double place;
  double weight;
};

// Gauss and Legendre's nodes, in panels over which a normal density of variance 1 is smooth.
std::vector<Node> nodes(double low, double high) {
  using Rule = boost::math::quadrature::gauss<double, 20>;
  constexpr double widest = 6;
  const int panels = std::max(1, static_cast<int>(std::ceil((high - low) / widest)));
  const double half = (high - low) / panels / 2;
  std::vector<Node> result;
  for (int panel = 0; panel < panels; ++panel) {
    const double middle = low + (2 * panel + 1) * half;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const double sign : {-1.0, 1.0}) {
        result.push_back({.place = middle + sign * half * Rule::abscissa()[i], .weight = half * Rule::weights()[i]});
      }
    }
  }
  return result;
}

double normal_above(double z) { return 0.5 * std::erfc(z / std::sqrt(2.0)); }

}  // namespace

double chance_to_cross(double c, const Boundary& boundary) {
  check_boundary(boundary);
  if (std::isnan(c)) return not_defined;
  constexpr double density_at_0 = 0.3989422804014327;  // of the standard normal
  constexpr double farthest = 9;                       // standard deviations; the rest is below 1e-18
  const auto end = [&](int look) {                     // of the sum S_k = Z_k sqrt(k), whose steps have variance 1
    return c * std::pow(look, boundary.shape) * std::pow(boundary.looks, 0.5 - boundary.shape);
  };
  double crossed = normal_above(end(1));
  std::vector<Node> last{{.place = 0, .weight = 1}};  // S_0; then weights times the density of S_k that has not crossed
  for (int look = 1; look < boundary.looks; ++look) {
    const double low = -farthest * std::sqrt(look), high = std::min(end(look), -low);
    if (!(high > low)) return 1;
    std::vector<Node> now = nodes(low, high);
    for (Node& node : now) {
      double density = 0;
      for (const Node& before : last) {
        const double step = node.place - before.place;
        density += before.weight * std::exp(-step * step / 2);
      }
      node.weight *= density_at_0 * density;
    }
    last = std::move(now);
    for (const Node& node : last) crossed += node.weight * normal_above(end(look + 1) - node.place);
  }
  return std::min(crossed, 1.0);
}

double constant_of(double level, const Boundary& boundary) {
  double low = -10, high = 40;  // the chance falls with c
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (chance_to_cross(middle, boundary) > level ? low : high) = middle;
  }
  return high;
}

double level_of_look(double c, int look, const Boundary& boundary) {
  check_boundary(boundary);
  return normal_above(c * std::pow(static_cast<double>(look) / boundary.looks, boundary.shape - 0.5));
}

}  // namespace ikbench::statistics
