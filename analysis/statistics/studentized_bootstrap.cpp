#include "analysis/statistics/studentized_bootstrap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/sort/pdqsort/pdqsort.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "analysis/statistics/quantile.hpp"
#include "analysis/statistics/rounding.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

using Groups = std::span<const std::vector<double>>;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double tie = 1e-9;  // deviations this close count as equal
constexpr std::size_t fewest_resampled = 3;

// The scale on which means are compared.
enum class Scale { logarithm, mean };

struct Mean {
  double value = not_defined, error = not_defined;  // the mean and its standard error
  double spread = not_defined;                      // the standard error on the scale of the comparison
  double unit = 1;                                  // of the deviations; 0 for a constant
  double alike = 1;                                 // the probability of a resample without spread
  std::vector<double> deviations, squares;  // of each resample on that scale: how far off, squared standard error
};

struct Resample {
  double mean = not_defined;
  double square = not_defined;  // of the standard error; exactly 0 if all values are equal
};

// Summarizes the values at these positions.
Resample summary_of(const std::vector<double>& values, const std::vector<std::size_t>& positions) {
  const auto n = static_cast<double>(positions.size());
  double sum = 0, squares = 0;
  for (const std::size_t at : positions) sum += values[at];
  const double centre = sum / n, first = values[positions.front()];
  bool alike = true;
  for (const std::size_t at : positions) {
    squares += (values[at] - centre) * (values[at] - centre);
    alike &= values[at] == first;
  }
  return {.mean = alike ? first : centre, .square = alike ? 0 : squares / (n * (n - 1))};
}

// The probability that a resample has one value alone. Counted over resamples, it would depend on the order of the
// values.
double chance_of_one_value(std::vector<double> values) {
  std::ranges::sort(values);
  const auto n = static_cast<double>(values.size());
  double chance = 0;
  for (auto from = values.begin(); from != values.end();) {
    const auto to = std::upper_bound(from, values.end(), *from);
    chance += std::pow(static_cast<double>(to - from) / n, n);
    from = to;
  }
  return chance;
}

// Resamples samples of one size, all of them at the same positions, each in a unit in which no square overflows.
std::vector<Mean> resampled(Groups samples, Scale scale, const Resampling& settings) {
  std::vector<Mean> result;
  if (samples.empty()) return result;
  std::vector<std::vector<double>> scaled(samples.begin(), samples.end());
  for (std::vector<double>& sample : scaled) {
    const double unit = power_of_two_below(sample);
    for (double& value : sample) value /= unit;
    Mean& made = result.emplace_back(Mean{
        .value = mean(sample), .error = standard_error(sample), .unit = unit, .alike = chance_of_one_value(sample)});
    made.deviations.reserve(static_cast<std::size_t>(settings.resamples));
    made.squares.reserve(static_cast<std::size_t>(settings.resamples));
  }
  std::vector<std::size_t> positions(samples.front().size());
  Draws draws(settings.seed);
  for (int i = 0; i < settings.resamples; ++i) {
    for (std::size_t& at : positions) at = draws.below(positions.size());
    for (std::size_t s = 0; s < scaled.size(); ++s) {
      const auto [mean, square] = summary_of(scaled[s], positions);
      Mean& of = result[s];
      of.deviations.push_back(scale == Scale::mean ? mean - of.value : std::log(mean / of.value));
      of.squares.push_back(scale == Scale::mean ? square : square / (mean * mean));
    }
  }
  for (Mean& each : result) {
    each.value *= each.unit;
    each.error *= each.unit;
    each.spread = scale == Scale::mean ? each.error : each.error / each.value;
    if (scale == Scale::logarithm) each.unit = 1;  // logarithms have none
    if (scale == Scale::mean && !(each.spread > 0)) each.unit = 0;
  }
  return result;
}

Reason group_undefined(std::span<const double> values, std::size_t index) {
  if (values.size() < fewest_resampled) {
    return {index,
            fmt::format("{{}} has fewer than {} values, of which the bootstrap learns too little", fewest_resampled)};
  }
  if (!all_finite(values)) {
    return {index, "{} has values that are not finite"};
  }
  constexpr double widest = 1e130;  // squares of the values without the largest must not vanish
  double least = infinite, largest = 0;
  for (const double value : values) {
    if (value != 0) least = std::min(least, std::abs(value));
    largest = std::max(largest, std::abs(value));
  }
  if (largest / widest > least) return {index, "{} has values too far apart for double precision"};
  return {};
}

// The groups that can be resampled, with their indices: each sorted, and in the order of their values. So neither the
// order of the groups nor that of their values changes what is drawn.
std::vector<std::pair<std::vector<double>, std::size_t>> in_order_of_values(Groups groups) {
  std::vector<std::pair<std::vector<double>, std::size_t>> result;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (!group_undefined(groups[i], i).empty()) continue;
    std::ranges::sort(result.emplace_back(groups[i], i).first);
  }
  std::ranges::sort(result);
  return result;
}

bool is_of(const MeanDifference& pair, std::optional<std::size_t> group) {
  return !group || pair.first == *group || pair.second == *group;
}

// A pair and its resampled means: those of its groups, or within blocks that of its differences and nothing.
struct ResampledPair {
  MeanDifference pair;
  const Mean* first = nullptr;
  const Mean* second = nullptr;
  bool within_blocks = false;
};

// Squared deviations of a pair in squared standard errors, for every resample; infinite if it has no spread. Both units
// are powers of two, so nothing is rounded; that of a constant does not count.
void studentize(const Mean& first, const Mean& second, std::vector<double>& squares) {
  const double unit = std::max(first.unit, second.unit);
  const double one = first.unit / unit, other = second.unit / unit;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const double off = one * first.deviations[i] - other * second.deviations[i];
    squares[i] = off == 0 ? 0 : off * off / (one * one * first.squares[i] + other * other * second.squares[i]);
  }
}

// The number of different values that rarely have a resample without spread: n values have one in n^(1 - n) of them.
// Both groups of a pair need so many, or one if the other is constant.
int enough_values(double tolerated_share, int groups) {
  auto n = static_cast<int>(fewest_resampled);
  while (std::pow(n, groups * (1 - n)) > tolerated_share) ++n;
  return n;
}

Reason too_little_spread(const ResampledPair& of, std::size_t pairs, double tolerated_share) {
  const std::string needs =
      fmt::format("the bootstrap{} needs", pairs == 1 ? std::string() : fmt::format(" of {} pairs", pairs));
  if (of.within_blocks) {
    return fmt::format("too few different differences within blocks: {} {}", needs, enough_values(tolerated_share, 1));
  }
  const bool first_varies = of.first->spread > 0, second_varies = of.second->spread > 0;
  if (first_varies && second_varies) {
    return fmt::format("too few different values: {} {} in each group", needs, enough_values(tolerated_share, 2));
  }
  return {first_varies ? of.pair.second : of.pair.first,
          fmt::format("the values of {{}} are all equal, and the other group has too few different ones: {} {}", needs,
                      enough_values(tolerated_share, 1))};
}

// The tolerated share of resamples without spread, per pair: half of what may be beyond the critical value, for all
// pairs together. Whether a pair has a p must not depend on the level, so that is the usual one.
double tolerated_share(std::size_t pairs, double level = 0.95) { return (1 - level) / 2 / static_cast<double>(pairs); }

// The unusualness of each resample, over all pairs: the smallest share, over the pairs, of resamples in which that pair
// deviates by as much.
struct FamilyDeviations {
  std::vector<std::vector<double>> squares = {};  // of each wanted pair, ascending; empty if it is undefined
  std::vector<double> least_shares = {};          // ascending
};

// The number of resamples that reach a squared deviation.
double reaching(const std::vector<double>& ascending, double square) {
  return static_cast<double>(ascending.end() - std::ranges::lower_bound(ascending, square * (1 - tie)));
}

// Sorts the squared deviations, and lowers each resample's share to that of the resamples that reach its own.
std::vector<double> sorted_and_ranked(const std::vector<double>& squares, std::vector<double>& least_shares) {
  std::vector<std::pair<double, std::size_t>> order(squares.size());
  for (std::size_t i = 0; i < squares.size(); ++i) order[i] = {squares[i], i};
  boost::sort::pdqsort_branchless(order.begin(), order.end(),
                                  [](const auto& one, const auto& other) { return one.first < other.first; });
  std::vector<double> sorted;
  sorted.reserve(order.size());
  std::size_t below = 0;
  for (const auto& [square, resample] : order) {
    sorted.push_back(square);
    while (order[below].first < square * (1 - tie)) ++below;
    const double share = static_cast<double>(order.size() - below) / static_cast<double>(order.size() + 1);
    least_shares[resample] = std::min(least_shares[resample], share);
  }
  return sorted;
}

// A pair of which too many resamples have no spread gets a reason and takes no part.
FamilyDeviations family_deviations(std::vector<ResampledPair>& all, const PairFamily& family,
                                   const Resampling& settings) {
  const auto resamples = static_cast<std::size_t>(settings.resamples);
  FamilyDeviations result{.least_shares = std::vector<double>(resamples, 1.0)};
  std::vector<double> own(resamples);
  const double tolerated = tolerated_share(all.size());
  for (ResampledPair& each : all) {
    std::vector<double> sorted;
    if (each.pair.undefined.empty()) {
      if (each.first->alike * each.second->alike > tolerated) {
        each.pair.lacks_spread = true;
        each.pair.undefined = too_little_spread(each, all.size(), tolerated);
      } else {
        studentize(*each.first, *each.second, own);
        sorted = sorted_and_ranked(own, result.least_shares);
      }
    }
    if (is_of(each.pair, family.only_with)) result.squares.push_back(std::move(sorted));
  }
  boost::sort::pdqsort_branchless(result.least_shares.begin(), result.least_shares.end());
  return result;
}

// The distance of the means in standard errors if `shift` is added to the second, or its opposite to the first.
double apart(const Mean& first, const Mean& second, double shift, Scale scale) {
  if (scale == Scale::mean) return (first.value - second.value - shift) / std::hypot(first.spread, second.spread);
  const double up = first.value + std::max(-shift, 0.0), down = second.value + std::max(shift, 0.0);
  return (std::log(up) - std::log(down)) / std::hypot(first.error / up, second.error / down);
}

// The border between a shift at which `holds` is true and one at which it is not.
template <class Holds>
double border(double inside, double outside, Holds holds) {
  for (int i = 0; i < 100; ++i) {
    const double middle = inside + (outside - inside) / 2;
    (holds(middle) ? inside : outside) = middle;
  }
  return inside;
}

// Adds the interval of differences that are not refuted at the critical value. An end beyond a thousand times the
// larger mean says nothing, and then there is no interval.
void add_interval(MeanDifference& pair, const Mean& first, const Mean& second, double critical, Scale scale) {
  const auto holds = [&](double shift) { return std::abs(apart(first, second, shift, scale)) <= critical; };
  const double farthest = 1000 * std::max({std::abs(first.value), std::abs(second.value), first.error, second.error});
  const bool all_on_one_side = !holds(0);
  const double low_end = all_on_one_side && pair.difference.value > 0 ? 0 : -farthest;
  const double high_end = all_on_one_side && pair.difference.value < 0 ? 0 : farthest;
  if (!std::isfinite(farthest) || holds(low_end) || holds(high_end)) return;
  pair.difference.low = border(pair.difference.value, low_end, holds);
  pair.difference.high = border(pair.difference.value, high_end, holds);
}

}  // namespace

int affordable_resamples(std::size_t values, std::size_t groups, double level) {
  constexpr double enough = 9999, fewest_resamples = 999, most_work = 5e7, work_of_pair = 0.25;  // a value's is 1
  const auto k = static_cast<double>(groups);
  const double work = static_cast<double>(values) + work_of_pair * k * (k - 1) / 2;
  const double pairs = k * (k - 1) / 2;
  const double wanted = std::max({enough, 20 / (1 - level), 4 * pairs / (1 - level)});  // some beyond the level
  const double possible = std::min(wanted, most_work / work);
  // The smallest possible p over all pairs is about the number of pairs by that of resamples.
  const double needed = std::max(fewest_resamples, 1.2 * pairs / (1 - level));
  return possible < needed ? 0 : static_cast<int>(std::lround(possible));
}

int fewest_blocks(std::size_t pairs, double level) {
  return enough_values(std::min(tolerated_share(pairs), tolerated_share(pairs, level)), 1);
}

namespace {

std::vector<MeanDifference> resampled_pairs(Groups groups, const PairFamily& family, const Resampling& settings) {
  check_level(settings.level);
  if (settings.resamples < 2) throw std::invalid_argument("fewer than two resamples");
  std::vector<MeanDifference> pairs = pairs_of(groups.size(), family.control);
  std::vector<Reason> undefined;
  for (std::size_t i = 0; i < groups.size(); ++i) undefined.push_back(group_undefined(groups[i], i));
  for (MeanDifference& pair : pairs) {
    pair.undefined = undefined[pair.first].empty() ? undefined[pair.second] : undefined[pair.first];
  }
  return pairs;
}

// Computes p and interval of the wanted pairs.
std::vector<MeanDifference> judged(std::vector<ResampledPair> all, const PairFamily& family, const Resampling& settings,
                                   Scale scale) {
  const FamilyDeviations deviations = family_deviations(all, family, settings);
  const std::vector<double>& shares = deviations.least_shares;
  const auto p_of = [&](double share) {  // all pairs together
    const auto as_unusual = std::ranges::upper_bound(shares, share * (1 + tie)) - shares.begin();
    return (1 + static_cast<double>(as_unusual)) / (settings.resamples + 1);
  };
  // The largest number of a pair's resamples that may reach as far if p < 1 - level.
  int most_reaching = -1;
  while (p_of((most_reaching + 2.0) / (settings.resamples + 1)) < (1 - settings.level) * (1 - tie)) ++most_reaching;
  std::vector<MeanDifference> result;
  auto squares = deviations.squares.begin();
  for (const ResampledPair& each : all) {
    if (!is_of(each.pair, family.only_with)) continue;
    const std::vector<double>& own = *squares++;
    MeanDifference& pair = result.emplace_back(each.pair);
    if (!pair.undefined.empty()) continue;
    const Mean &first = *each.first, &second = *each.second;
    pair.difference.value = first.value - second.value;
    pair.standard_error = std::hypot(first.error, second.error);
    const double found = std::abs(apart(first, second, 0, scale));
    if (!std::isfinite(found)) {
      pair.undefined = "the difference or its spread is too large for double precision";
      continue;
    }
    pair.p_alone = (1 + reaching(own, found * found)) / (settings.resamples + 1);
    pair.p = p_of(pair.p_alone);
    const double critical =
        most_reaching < 0 ? infinite : std::sqrt(own[own.size() - static_cast<std::size_t>(most_reaching) - 1]);
    add_interval(pair, first, second, critical * (1 + tie), scale);
  }
  return result;
}

}  // namespace

std::vector<MeanDifference> studentized_bootstrap(Groups groups, const PairFamily& family, const Resampling& settings) {
  const bool positive = std::ranges::all_of(groups, [](const std::vector<double>& group) {
    return std::ranges::all_of(group, [](double value) { return value > 0 || !std::isfinite(value); });
  });
  const Scale scale = positive && family.by_ratios ? Scale::logarithm : Scale::mean;
  std::vector<Mean> means(groups.size());
  std::uint64_t seed = settings.seed;  // a stream of draws for each group
  for (const auto& [values, i] : in_order_of_values(groups)) {
    means[i] = resampled({&values, 1}, scale, {.resamples = settings.resamples, .seed = seed++}).front();
  }
  std::vector<ResampledPair> all;
  for (MeanDifference& pair : resampled_pairs(groups, family, settings)) {
    const Mean &first = means[pair.first], &second = means[pair.second];
    if (pair.undefined.empty() && !(first.spread > 0 || second.spread > 0)) pair.undefined = "both groups are constant";
    all.push_back({.pair = std::move(pair), .first = &first, .second = &second});
  }
  return judged(std::move(all), family, settings, scale);
}

std::vector<MeanDifference> bootstrap_within_blocks(Groups groups, const PairFamily& family,
                                                    const Resampling& settings) {
  std::vector<MeanDifference> pairs = resampled_pairs(groups, family, settings);
  const std::vector<double> zeros(static_cast<std::size_t>(settings.resamples), 0.0);
  const Mean nothing{.value = 0, .error = 0, .spread = 0, .unit = 0, .deviations = zeros, .squares = zeros};
  std::vector<std::vector<double>> differences;  // of the pairs that can be resampled
  std::vector<bool> has_differences(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!pairs[i].undefined.empty()) continue;
    std::vector<double> own = differences_without_rounding(groups[pairs[i].first], groups[pairs[i].second]);
    has_differences[i] = group_undefined(own, 0).empty();
    if (has_differences[i]) differences.push_back(std::move(own));
  }
  const std::vector<Mean> means = resampled(differences, Scale::mean, settings);
  auto next = means.begin();
  std::vector<ResampledPair> all;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Mean& own = has_differences[i] ? *next++ : nothing;
    if (pairs[i].undefined.empty() && !(own.spread > 0)) {
      pairs[i].undefined = "the differences within blocks are all equal, or too far apart";
    }
    all.push_back({.pair = std::move(pairs[i]), .first = &own, .second = &nothing, .within_blocks = true});
  }
  return judged(std::move(all), family, settings, Scale::mean);
}

}  // namespace ikbench::statistics
