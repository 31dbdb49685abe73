#include "analysis/statistics/bayesian_signed_rank.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace ikbench::statistics {
namespace {

constexpr int posterior_draws = 10000;
constexpr std::uint64_t posterior_seed = 1;

// Strictly between 0 and 1, in steps of 2^-53.
double uniform(std::mt19937_64& engine) { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; }

// The weights of one draw, of the prior's 0 first, but for a factor that all have: Gamma(1/2), which is half the square
// of a normal number (Box and Muller), and Gamma(1).
void draw_weights(std::mt19937_64& engine, std::vector<double>& weights) {
  const double cosine = std::cos(2 * std::numbers::pi * uniform(engine));
  weights[0] = -std::log(uniform(engine)) * cosine * cosine;
  for (std::size_t i = 1; i < weights.size(); ++i) weights[i] = -std::log(uniform(engine));
}

// One comparison: the differences and the prior's 0 in their order, and for each how many of them, the smallest first,
// lie with it below the region, and how many not above it.
class Comparison {
 public:
  explicit Comparison(const Differences& differences) : sorted_(differences.values), below_(sorted_.size() + 1) {
    sorted_.push_back(0);
    std::ranges::sort(sorted_);
    prior_ = static_cast<std::size_t>(std::ranges::lower_bound(sorted_, 0.0) - sorted_.begin());
    const double rope = 2 * differences.rope;
    for (std::size_t i = 0; i < sorted_.size(); ++i) {
      const auto sum_with = [&](double other) { return sorted_[i] + other; };
      below_[i] = place(std::ranges::lower_bound(sorted_, -rope, {}, sum_with));
      not_above_.push_back(place(std::ranges::upper_bound(sorted_, rope, {}, sum_with)));
    }
    sums_.resize(sorted_.size() + 1);
  }

  void count(const std::vector<double>& weights) {
    const auto weight = [&](std::size_t i) { return weights[i == prior_ ? 0 : i < prior_ ? i + 1 : i]; };
    for (std::size_t i = 0; i < sorted_.size(); ++i) sums_[i + 1] = sums_[i] + weight(i);
    double below = 0, within = 0, above = 0;
    for (std::size_t i = 0; i < sorted_.size(); ++i) {
      below += weight(i) * sums_[below_[i]];
      within += weight(i) * (sums_[not_above_[i]] - sums_[below_[i]]);
      above += weight(i) * (sums_.back() - sums_[not_above_[i]]);
    }
    if (within >= below && within >= above) {
      ++within_wins_;
    } else {
      ++(below > above ? below_wins_ : above_wins_);
    }
  }

  SignedRankPosterior posterior() const {
    return {.below = below_wins_ / posterior_draws,
            .within = within_wins_ / posterior_draws,
            .above = above_wins_ / posterior_draws};
  }

 private:
  std::size_t place(std::vector<double>::const_iterator at) const {
    return static_cast<std::size_t>(at - sorted_.cbegin());
  }

  std::vector<double> sorted_;
  std::size_t prior_ = 0;
  std::vector<std::size_t> below_, not_above_;
  std::vector<double> sums_;
  double below_wins_ = 0, within_wins_ = 0, above_wins_ = 0;
};

std::string obstacle_of(std::span<const Differences> comparisons, const Differences& differences) {
  const std::size_t n = differences.values.size();
  if (n != comparisons.front().values.size()) throw std::invalid_argument("expected as many differences of each pair");
  if (n == 0) return "there are no differences";
  if (n > most_bayesian_differences) return fmt::format("more than {} differences", most_bayesian_differences);
  const bool finite = std::ranges::all_of(differences.values, [](double value) { return std::isfinite(value); });
  if (!finite || !std::isfinite(differences.rope)) return "a difference is not finite";
  return {};
}

}  // namespace

std::vector<SignedRankPosterior> bayesian_signed_rank(std::span<const Differences> comparisons) {
  std::vector<SignedRankPosterior> result;
  std::vector<Comparison> made;
  for (const Differences& differences : comparisons) {
    result.push_back({.undefined = obstacle_of(comparisons, differences)});
    if (result.back().undefined.empty()) made.emplace_back(differences);
  }
  if (made.empty()) return result;
  std::mt19937_64 engine(posterior_seed);
  std::vector<double> weights(comparisons.front().values.size() + 1);
  for (int i = 0; i < posterior_draws; ++i) {
    draw_weights(engine, weights);
    for (Comparison& comparison : made) comparison.count(weights);
  }
  auto next = made.begin();
  for (SignedRankPosterior& posterior : result) {
    if (posterior.undefined.empty()) posterior = (next++)->posterior();
  }
  return result;
}

}  // namespace ikbench::statistics
