// The deciding statistic says which of two groups is better; here it is computed in another way, by counting.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/report/assessment.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

using Groups = std::vector<std::vector<double>>;

// splitmix64 (Steele, Lea and Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double uniform() { return (static_cast<double>(next() >> 12) + 0.5) * 0x1p-52; }  // 0 to 1, without both
  int below(int end) { return static_cast<int>(uniform() * end); }
  double normal() { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform()); }

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

// Laws that make means, medians and ranks point apart: long tails on one side or both, ties, rare and large effects.
enum class Law { normal, skewed, heavy_tailed, tied, often_little_rarely_much };
constexpr std::array<Law, 5> laws{Law::normal, Law::skewed, Law::heavy_tailed, Law::tied,
                                  Law::often_little_rarely_much};

double draw(Law law, Random& random) {
  switch (law) {
    case Law::normal:
      return random.normal();
    case Law::skewed:
      return std::exp(2 * random.normal()) - std::exp(2);  // of mean 0, with a median far below it
    case Law::heavy_tailed:
      return std::tan(std::numbers::pi * (random.uniform() - 0.5));
    case Law::tied:
      return random.below(4) - 1.5;
    default:
      return random.uniform() < 0.55 ? -0.1 * random.uniform() : 2 * random.uniform();
  }
}

struct Made {
  Groups groups;
  bool blocked = false;
  std::optional<std::size_t> control = {};
};

// all_pairs: of two to four groups. control: of three or four, against one of them. many: of more groups than are shown
// in pairs, so against the best.
enum class Design { all_pairs, control, many };

Made make(Design design, Random& random) {
  Made made{.blocked = random.below(2) == 0};
  const int groups = design == Design::many      ? static_cast<int>(most_groups_in_pairs) + 1 + random.below(3)
                     : design == Design::control ? 3 + random.below(2)
                                                 : 2 + random.below(3);
  if (design == Design::control) made.control = static_cast<std::size_t>(random.below(groups));
  const int size = 4 + random.below(40);
  std::vector<double> of_block;
  for (int i = 0; i < size; ++i) of_block.push_back(3 * random.normal());
  for (int g = 0; g < groups; ++g) {
    const Law law = laws[static_cast<std::size_t>(random.below(5))];
    const double spread = std::exp(1.5 * random.normal()), shift = 0.7 * random.normal();
    const int own_size = made.blocked ? size : 4 + random.below(40);
    std::vector<double>& values = made.groups.emplace_back();
    for (int i = 0; i < own_size; ++i) {
      const double common = made.blocked ? of_block[static_cast<std::size_t>(i)] : 0;
      values.push_back(20 + common + shift + spread * draw(law, random));
    }
  }
  return made;
}

int sign(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// The first less the second: above 0 if the first has the larger values by the statistic.
double of_means(const std::vector<double>& first, const std::vector<double>& second) {
  const auto mean = [](const std::vector<double>& values) {
    long double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<long double>(values.size());
  };
  return static_cast<double>(mean(first) - mean(second));
}

// The number of pairs of values in which the first is above, less those in which it is below.
double of_pairs(const std::vector<double>& first, const std::vector<double>& second) {
  double sum = 0;
  for (const double one : first) {
    for (const double other : second) sum += sign(one - other);
  }
  return sum;
}

double deciding_statistic(const std::string& test, const Groups& groups, const Finding& pair) {
  const std::vector<double>&first = groups[pair.first], &second = groups[pair.second];
  return test == "kruskal_wallis" ? of_pairs(first, second) : of_means(first, second);
}

Made negated(Made made) {
  for (auto& group : made.groups) {
    for (double& value : group) value = -value;
  }
  return made;
}

// Like evidence(), without parts that decide nothing.
Evidence judged(const Made& made, Better better, const std::string& test) {
  const auto name = [](std::size_t group) { return fmt::format("g{}", group); };
  Evidence found{.name = "x",
                 .quantity = "x",
                 .better = better,
                 .blocks = made.blocked ? made.groups[0].size() : 0,
                 .plan = {.test = test, .control = made.control ? name(*made.control) : ""}};
  found.method = &method_for(found);
  std::vector<GroupSummary> summaries;
  for (std::size_t i = 0; i < made.groups.size(); ++i) {
    found.groups.push_back({.name = name(i), .described = describe(made.groups[i])});
    summaries.push_back(summarise(made.groups[i]));
  }
  const Groups ranked = better == Better::smaller ? made.groups : negated(made).groups;
  add_contrasts(found, {.summaries = summaries, .values = made.groups, .ranked = ranked});
  return found;
}

Made reversed(Made made) {
  std::ranges::reverse(made.groups);
  if (made.control) made.control = made.groups.size() - 1 - *made.control;
  return made;
}

// The number of decided pairs, and of those in which another measure is for the other group.
struct Decided {
  int pairs = 0, against_the_mean = 0, against_the_median = 0, against_the_share = 0;
};

void count(const Evidence& found, const Finding& pair, Decided& decided) {
  const int ahead = pair.relation == Relation::better ? 1 : -1;
  const Description& first = found.groups[pair.first].described;
  const Description& second = found.groups[pair.second].described;
  ++decided.pairs;
  decided.against_the_mean += sign(second.mean - first.mean) == -ahead ? 1 : 0;
  decided.against_the_median += sign(second.median - first.median) == -ahead ? 1 : 0;
  decided.against_the_share += sign(pair.superiority.value - 0.5) == -ahead ? 1 : 0;
}

void check_ahead(const Evidence& found, const Made& made, const std::string& test, Decided& decided) {
  for (const Finding& pair : found.contrasts) {
    if (pair.relation != Relation::better && pair.relation != Relation::worse) continue;
    count(found, pair, decided);
    const int ahead = pair.relation == Relation::better ? 1 : -1;
    CHECK(sign(deciding_statistic(test, made.groups, pair)) == -ahead);
  }
}

// Nothing changes if larger values are better and all are negated, or in another order; but for the bootstrap, which
// then draws other resamples and compares differences in place of ratios.
void check_directions(const Made& made, const std::string& test, Decided& decided) {
  const Evidence found = judged(made, Better::smaller, test);
  if (test == "bootstrap") return check_ahead(found, made, test, decided);
  const Evidence other = judged(negated(made), Better::larger, test);
  const Evidence swapped = judged(reversed(made), Better::smaller, test);
  const std::size_t last = made.groups.size() - 1;
  // If several groups are the best, the first is the reference; in reverse order it may be another.
  const bool same_reference = !found.reference || *swapped.reference == last - *found.reference;
  CHECK(found.reference.has_value() == (made.control || last >= most_groups_in_pairs));
  for (std::size_t i = 0; i < found.contrasts.size(); ++i) {
    const Finding& pair = found.contrasts[i];
    CHECK(other.contrasts[i].relation == pair.relation);
    const auto same = [&](const Finding& c) { return c.first == last - pair.second && c.second == last - pair.first; };
    if (same_reference) {
      const auto there = std::ranges::find_if(swapped.contrasts, same);
      REQUIRE(there != swapped.contrasts.end());
      CHECK(there->relation == inference::reversed(pair.relation));
    }
  }
  check_ahead(found, made, test, decided);
}

}  // namespace

TEST_CASE("the better one is better by the statistic that decides", "[assessment][directions]") {
  const std::string test = GENERATE("tamhane", "bootstrap", "kruskal_wallis");
  CAPTURE(test);
  Random random(2023);
  Decided decided;
  std::array<int, 3> of_design{};
  // The bootstrap takes longer, so it has fewer sets, and none of many groups. Ranks rarely point against the median.
  const bool by_bootstrap = test == "bootstrap", by_ranks = test == "kruskal_wallis";
  const int sets = by_bootstrap ? 200 : by_ranks ? 1000 : 500;
  for (int set = 0; set < sets; ++set) {
    const bool is_many = set % (by_ranks ? 100 : 50) == 0 && !by_bootstrap,
               has_control = set % (by_bootstrap ? 3 : 10) == 1;
    const Design design = is_many ? Design::many : has_control ? Design::control : Design::all_pairs;
    const Made made = make(design, random);
    CAPTURE(set, made.blocked, made.groups.size());
    const int before = decided.pairs;
    check_directions(made, test, decided);
    of_design[static_cast<std::size_t>(design)] += decided.pairs - before;
  }
  for (const Design design : {Design::all_pairs, Design::control, Design::many}) {
    if (design != Design::many || !by_bootstrap) CHECK(of_design[static_cast<std::size_t>(design)] > 10);
  }
  // The sets are such that every other measure would have said otherwise of some pair. Tests of means decide by means.
  if (by_ranks) CHECK(decided.against_the_mean > 0);
  if (!by_ranks) CHECK(decided.against_the_mean == 0);
  CHECK(decided.against_the_median > 0);
  // The share of pairs, or of blocks, is what the rank tests test.
  if (by_ranks) CHECK(decided.against_the_share == 0);
  if (!by_ranks) CHECK(decided.against_the_share > 0);
}

namespace {

std::string text_of_evidence(const Evidence& found) {
  std::string text;
  for (const std::string& sentence : words_of(sentences_of(found))) text += sentence + '\n';
  return text;
}

// 100 pairs: x is smaller in so many of them, by 0.01 and more, and y in the others, by 2 and more.
Observations often_little_rarely_much(int often) {
  Observations pairs{.name = "x", .quantity = "x", .groups = {{"x"}, {"y"}}, .block = "a problem"};
  for (int i = 1; i <= 100; ++i) {
    const double difference = i <= often ? -0.01 * i : 1.5 + 0.01 * i;
    pairs.groups[0].values.push_back(10 + difference);
    pairs.groups[1].values.push_back(10 + 1e-4 * i);
    pairs.blocks.push_back(fmt::format("{}", i));
  }
  return pairs;
}

}  // namespace

TEST_CASE("in blocks, the mean decides", "[assessment][directions]") {
  // x is less by 0.01 to 0.51 in 51 blocks and more by about 2 in 49: its mean is above that of y.
  const Evidence found = evidence(often_little_rarely_much(51), {});
  CHECK(found.method->compares == Compares::means);
  CHECK(found.contrasts[0].relation == Relation::worse);
  // A little less in most blocks, and in two of twenty so much more that the means are equal: nothing is found by
  // means.
  Observations rare{.name = "x", .quantity = "x", .groups = {{"x"}, {"y"}}, .block = "a problem"};
  for (int i = 0; i < 20; ++i) {
    const double scale = 1 + 0.1 * i;
    rare.groups[0].values.push_back(scale - (i % 10 == 3 ? -0.46 : 0.05 + 1e-4 * i));
    rare.groups[1].values.push_back(scale);
    rare.blocks.push_back(fmt::format("{}", i));
  }
  CHECK(evidence(rare, {}).contrasts[0].relation == Relation::undecided);
}

TEST_CASE("of several groups, who is better of two does not depend on the third", "[assessment][directions]") {
  // 52 of the 100 values of b lie just below all of a, and 48 far above; the 200 of c lie between a and those 48.
  Observations sets{.name = "x", .quantity = "x", .groups = {{"a"}, {"b"}, {"c"}}};
  for (int i = 0; i < 100; ++i) sets.groups[0].values.push_back(50 + 0.01 * i);
  for (int i = 0; i < 100; ++i) sets.groups[1].values.push_back(i < 52 ? 49 + 0.01 * i : 100 + i);
  for (int i = 0; i < 200; ++i) sets.groups[2].values.push_back(60 + 0.01 * i);
  const Evidence found = evidence(sets, {.test = "kruskal_wallis"});
  // Mean ranks: a 52 + 50.5 = 102.5; b (52 * 26.5 + 48 * 376.5) / 100 = 194.5; c 152 + 100.5 = 252.5.
  const Finding& pair = found.contrasts[0];
  CHECK(pair.superiority.value == Approx(0.48));
  CHECK(pair.relation == Relation::undecided);
}

TEST_CASE("means and medians that rounding alone keeps apart point nowhere", "[assessment][directions]") {
  const auto text_with = [](double of_first) {
    Evidence found{.name = "x", .quantity = "x", .plan = {.test = "kruskal_wallis"}, .pairs = 1};
    found.groups = {{.name = "x"}, {.name = "y"}};
    found.groups[0].described.n = found.groups[1].described.n = 20;
    found.method = &method_for(found);
    found.groups[0].described.mean = found.groups[0].described.median = of_first;
    found.groups[1].described.mean = found.groups[1].described.median = 0.3;
    found.contrasts = {{.first = 0, .second = 1, .p = 0.01, .ahead = 1, .relation = Relation::better}};
    return text_of_evidence(found);
  };
  REQUIRE(0.1 + 0.2 > 0.3);
  CHECK(text_with(0.1 + 0.2).find("x is better by ranks than y") != std::string::npos);
  CHECK(text_with(0.1 + 0.2).find("the other") == std::string::npos);
  CHECK(text_with(0.301).find("although the mean and the median favour the other") != std::string::npos);
}
