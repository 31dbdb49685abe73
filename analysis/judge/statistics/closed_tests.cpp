#include "analysis/judge/statistics/closed_tests.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/judge/statistics/omnibus.hpp"

namespace ikbench::judge {
namespace {

// Returns the part of the significance of a set, as an exponent.
double share_of_set(std::size_t size, std::size_t groups) {
  return size + 1 >= groups ? 1 : static_cast<double>(size) / static_cast<double>(groups);
}

// Returns the places of the bits of a number.
std::vector<std::size_t> members_of(std::size_t set, std::size_t groups) {
  std::vector<std::size_t> members;
  for (std::size_t group = 0; group < groups; ++group)
    if ((set >> group & 1U) != 0) members.push_back(group);
  return members;
}

}  // namespace

bool may_be_closed(std::size_t groups) {
  constexpr std::size_t fewest = 4, most = 12;
  return groups >= fewest && groups <= most;
}

double level_of_set(std::size_t size, std::size_t groups, double significance) {
  return -std::expm1(share_of_set(size, groups) * std::log1p(-significance));
}

double scaled_p(double p, std::size_t size, std::size_t groups) {
  return p < 1 ? -std::expm1(std::log1p(-p) / share_of_set(size, groups)) : 1;
}

std::vector<double> largest_p_of_sets(const std::vector<std::span<const double>>& groups) {
  const std::size_t k = groups.size();
  std::vector<double> largest(k * k);
  for (std::size_t set = 0; set < std::size_t{1} << k; ++set) {
    const std::vector<std::size_t> members = members_of(set, k);
    if (members.size() < 3) continue;
    std::vector<std::span<const double>> values;
    for (const std::size_t member : members) values.push_back(groups[member]);
    const double p = scaled_p(friedman_p(values), members.size(), k);
    for (const std::size_t first : members)
      for (const std::size_t second : members) largest[first * k + second] = std::max(largest[first * k + second], p);
  }
  return largest;
}

}  // namespace ikbench::judge
