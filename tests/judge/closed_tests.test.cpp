// How often closed tests tell alike groups apart, in the blocks and groups in which `compare_pairs` makes them, and
// what they decide. docs/explanation/methods.md has the largest share of each number of groups.
//
//   IKBENCH_SETS=10000 build/check/tests/judge/test_judge '[closed]'

#include "analysis/judge/statistics/closed_tests.hpp"

#include "analysis/judge/statistics/omnibus.hpp"
#include "tests/judge/studies.hpp"

namespace ikbench::judge {
namespace {

// Draws the same numbers on every machine, but for the last bit of a logarithm.
class Draws {
 public:
  double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }
  double normal() { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform()); }
  bool is_head() { return uniform() < 0.5; }

 private:
  std::mt19937_64 engine_{1};
};

// One block of the values of all groups.
using Block = std::vector<double>;

struct ClosedDesign {
  std::string name;
  std::function<double(Draws&, int block, int group, int groups)> value;  // of groups that do not depend on each other
  std::function<bool(int first, int second, int groups)> are_alike;
  std::function<void(Draws&, Block&)> change = [](Draws&, Block&) {};  // of a whole block
};

constexpr double far = 100;  // lies beyond all draws

std::vector<ClosedDesign> closed_designs() {
  const auto normal = [](Draws& draws, int, int, int) { return draws.normal(); };
  const auto in_twos = [](Draws& draws, int, int group, int) { return draws.normal() + far * (group / 2); };
  const auto all = [](int, int, int) { return true; };
  const auto of_two = [](int first, int second, int) { return first / 2 == second / 2; };
  const auto first_two = [](int first, int second, int) { return first < 2 && second < 2; };
  return {
      {"all alike", normal, all},
      {"the same, blocks over four decades", normal, all,
       [](Draws& draws, Block& block) {
         const double hard = 4 * std::log(10) * draws.uniform();
         for (double& value : block) value = std::exp(value + hard);
       }},
      {"the same, three values", [](Draws& draws, int, int, int) { return std::floor(3 * draws.uniform()); }, all},
      {"the same, two values", [](Draws& draws, int, int, int) { return std::floor(2 * draws.uniform()); }, all},
      {"the same, every other block equal",
       [](Draws& draws, int block, int, int) { return block % 2 == 0 ? 0 : draws.normal(); }, all},
      {"two alike in each of groups far apart", in_twos, of_two},
      {"the same, three values",
       [](Draws& draws, int, int group, int) { return std::floor(3 * draws.uniform()) + far * (group / 2); }, of_two},
      {"the same, two equal blocks",
       [](Draws& draws, int block, int group, int) { return block < 2 ? 0 : draws.normal() + far * (group / 2); },
       of_two},
      {"the same, the same one ahead in all groups", [](Draws&, int, int group, int) { return far * (group / 2); },
       of_two,
       [](Draws& draws, Block& block) {
         const double by = draws.normal();
         for (std::size_t group = 0; group < block.size(); group += 2) block[group] += by;
       }},
      {"three alike in each of groups far apart",
       [](Draws& draws, int, int group, int) { return draws.normal() + far * (group / 3); },
       [](int first, int second, int) { return first / 3 == second / 3; }},
      {"two halves far apart",
       [](Draws& draws, int, int group, int k) { return draws.normal() + far * (2 * group / k); },
       [](int first, int second, int k) { return 2 * first / k == 2 * second / k; }},
      {"all alike but one", [](Draws& draws, int, int group, int) { return draws.normal() + (group == 0 ? far : 0); },
       [](int first, int second, int) { return first > 0 && second > 0; }},
      {"two alike, the others far apart",
       [](Draws& draws, int, int group, int) { return draws.normal() + far * std::max(group, 1); }, first_two},
      {"first and last in turn", [](Draws& draws, int, int group, int) { return draws.normal() + 3 * group; },
       first_two,
       [](Draws& draws, Block& block) {
         const bool is_first_ahead = draws.is_head();
         block[0] = draws.normal() + (is_first_ahead ? -50 : far);
         block[1] = draws.normal() + (is_first_ahead ? far : -50);
       }},
      {"spreads from 1 to 5",
       [](Draws& draws, int, int group, int k) { return (1 + 4.0 * group / (k - 1)) * draws.normal(); }, all},
  };
}

MetricSamples drawn_blocks(const ClosedDesign& design, int groups, int blocks, Draws& draws) {
  MetricSamples samples{.metric = "x", .quantity = "x", .kind = Differences{}, .is_paired = true};
  for (int group = 0; group < groups; ++group)
    samples.groups.push_back({.name = fmt::format("{}", group), .sample = Sample{}});
  for (int i = 0; i < blocks; ++i) {
    Block block;
    for (int group = 0; group < groups; ++group) block.push_back(design.value(draws, i, group, groups));
    design.change(draws, block);
    for (std::size_t group = 0; group < block.size(); ++group) values_in(samples.groups[group]).push_back(block[group]);
  }
  return samples;
}

// Returns whether a pair of alike groups is told apart.
bool is_wrong(const ClosedDesign& design, const std::vector<Comparison>& comparisons, int groups) {
  return std::ranges::any_of(comparisons, [&](const Comparison& comparison) {
    const auto first = static_cast<int>(comparison.first_index), second = static_cast<int>(comparison.second_index);
    return design.are_alike(first, second, groups) && is_difference(verdict_of(comparison));
  });
}

// Returns whether signed ranks alone would tell a pair of alike groups apart at the level of two groups. Otherwise no
// closed test can, so that 2^groups tests need not be made.
bool may_be_wrong(const ClosedDesign& design, const MetricSamples& samples) {
  const std::size_t groups = samples.groups.size();
  for (std::size_t first = 0; first < groups; ++first) {
    for (std::size_t second = first + 1; second < groups; ++second) {
      if (!design.are_alike(static_cast<int>(first), static_cast<int>(second), static_cast<int>(groups))) continue;
      std::vector<double> differences = list_of(samples.groups[first]);
      for (std::size_t i = 0; i < differences.size(); ++i) differences[i] -= values_of(samples.groups[second])[i];
      if (signed_rank_test(differences, 0.05).p < level_of_set(2, groups, 0.05)) return true;
    }
  }
  return false;
}

// A design with the number of groups and blocks in which it is drawn.
struct FewBlocksDesign {
  int groups, blocks;
  ClosedDesign design;
};

// Values are logarithms of times, whose noise is 20 %.
std::vector<FewBlocksDesign> designs_with_differences() {
  const auto none_alike = [](int, int, int) { return false; };
  const auto ratio_to_first = [](const std::string& name, double (*ratio)(int group), auto are_alike) {
    return ClosedDesign{
        name, [ratio](Draws& draws, int, int group, int) { return std::log(ratio(group)) + 0.2 * draws.normal(); },
        are_alike};
  };
  const auto steps_of_20 = [](int group) { return std::pow(1.2, group); };
  const auto steps_of_30 = [](int group) { return std::pow(1.3, group); };
  const auto steps_of_50 = [](int group) { return std::pow(1.5, group); };
  const auto one_ahead = [](int group) { return group == 0 ? 1 : 1.5; };
  const auto twins = [](int group) { return std::pow(1.5, group / 2); };
  const auto others_alike = [](int first, int second, int) { return first > 0 && second > 0; };
  const auto are_twins = [](int first, int second, int) { return first / 2 == second / 2; };
  return {{4, 7, ratio_to_first("steps of 30 %", steps_of_30, none_alike)},
          {5, 8, ratio_to_first("steps of 30 %", steps_of_30, none_alike)},
          {6, 9, ratio_to_first("steps of 20 %", steps_of_20, none_alike)},
          {8, 8, ratio_to_first("steps of 50 %", steps_of_50, none_alike)},
          {8, 10, ratio_to_first("one ahead by 50 %", one_ahead, others_alike)},
          {8, 10, ratio_to_first("twins 50 % apart", twins, are_twins)},
          {12, 8, ratio_to_first("steps of 30 %", steps_of_30, none_alike)},
          {12, 11, ratio_to_first("steps of 20 %", steps_of_20, none_alike)}};
}

// Returns which share of the pairs that differ is decided.
double share_found(const FewBlocksDesign& drawn, int sets) {
  Draws draws;
  int found = 0, all = 0;
  for (int set = 0; set < sets; ++set) {
    const MetricSamples samples = drawn_blocks(drawn.design, drawn.groups, drawn.blocks, draws);
    for (const Comparison& comparison : compare_pairs(samples, AnalysisPlan())) {
      const auto first = static_cast<int>(comparison.first_index), second = static_cast<int>(comparison.second_index);
      if (drawn.design.are_alike(first, second, drawn.groups)) continue;
      ++all;
      found += is_difference(verdict_of(comparison)) ? 1 : 0;
    }
  }
  return static_cast<double>(found) / all;
}

// Returns how many tables are drawn if nobody says so; more in `./check --all`.
int usual_sets() {
  const char* const all = std::getenv("IKBENCH_ALL");
  return all != nullptr && *all != '\0' ? 400 : 25;
}

// The fewest and the most blocks in which so many groups are compared by closed tests.
struct FewBlocks {
  int groups, fewest, most;
};
constexpr std::array few_blocks{FewBlocks{4, 7, 7}, FewBlocks{6, 7, 9}, FewBlocks{8, 8, 10}, FewBlocks{12, 8, 11}};

}  // namespace

TEST_CASE("closed tests tell alike groups apart in at most 5 % of tables", "[closed]") {
  const char* const wanted = std::getenv("IKBENCH_SETS");
  const int sets = wanted != nullptr ? std::atoi(wanted) : usual_sets();
  const std::size_t sizes = wanted != nullptr ? few_blocks.size() : 3;
  const double largest = 0.05 + 4 * std::sqrt(0.05 * 0.95 / sets);
  for (const ClosedDesign& design : closed_designs()) {
    std::string row = "| " + design.name;
    for (const FewBlocks& few : std::span(few_blocks).first(sizes)) {
      double worst = 0;
      for (int blocks = few.fewest; blocks <= few.most; ++blocks) {
        Draws draws;
        int wrong = 0;
        for (int set = 0; set < sets; ++set) {
          const MetricSamples samples = drawn_blocks(design, few.groups, blocks, draws);
          if (!may_be_wrong(design, samples)) continue;
          wrong += is_wrong(design, compare_pairs(samples, AnalysisPlan()), few.groups) ? 1 : 0;
        }
        worst = std::max(worst, static_cast<double>(wrong) / sets);
      }
      CAPTURE(design.name, few.groups);
      CHECK(worst <= largest);
      row += fmt::format(" | {:.3f}", worst);
    }
    if (wanted == nullptr) continue;
    fmt::print("{} |\n", row);
    std::fflush(stdout);
  }
}

TEST_CASE("closed tests find differences for which Bonferroni's correction has too few blocks", "[closed]") {
  const char* const wanted = std::getenv("IKBENCH_SETS");
  const int sets = wanted != nullptr ? 100 : 5;
  for (const FewBlocksDesign& drawn : designs_with_differences()) {
    const double found = share_found(drawn, sets);
    CAPTURE(drawn.groups, drawn.blocks, drawn.design.name);
    CHECK(found > 0.4);
    if (wanted == nullptr) continue;
    fmt::print("| {} solvers, {} blocks, {} | {:.0f} % |\n", drawn.groups, drawn.blocks, drawn.design.name,
               100 * found);
    std::fflush(stdout);
  }
}

// Groups of which each is ahead of the next one in all blocks.
MetricSamples separated(int groups, int blocks) {
  MetricSamples samples{.metric = "x", .quantity = "x", .kind = Differences{}, .is_paired = true};
  for (int group = 0; group < groups; ++group) {
    Sample sample;
    for (int block = 0; block < blocks; ++block) sample.values.push_back(10 * group + block + 0.01 * group * block);
    samples.groups.push_back({.name = fmt::format("{}", group), .sample = std::move(sample)});
  }
  return samples;
}

TEST_CASE("where the blocks are too few for signed ranks, closed tests decide and say so", "[closed]") {
  // Four groups in seven blocks: 1 / 64 of two of four groups is 1 - (63 / 64)^2 of all. Friedman's p is smaller: 21
  // with three degrees of freedom, and 14 with two.
  for (const FlatComparison& pair : compared(separated(4, 7), AnalysisPlan())) {
    CHECK(pair.verdict == Verdict::better);
    CHECK(*pair.p == Approx(127 / 4096.0));
    CHECK(pair.test == closed_tests_name);
    CHECK(pair.estimate);
    CHECK_FALSE(pair.interval);
  }
  CHECK(are_by_closed_tests(compare_pairs(separated(8, 8), AnalysisPlan())));
  CHECK_FALSE(are_by_closed_tests(compare_pairs(separated(8, 11), AnalysisPlan())));  // signed ranks decide
  const AnalysisPlan control{.control = "0"};
  for (const FlatComparison& pair : compared(separated(8, 8), control)) CHECK(pair.verdict == Verdict::better);
  // Two metrics halve the significance, for which seven blocks are too few.
  const FlatComparison of_two = compared(separated(4, 7), AnalysisPlan(), 2).front();
  CHECK(of_two.why == ResultKind::too_few);
  CHECK(of_two.needed == 8);
  CHECK(*compared(separated(4, 8), AnalysisPlan(), 2).front().p == Approx(2 * (1 - 127.0 * 127 / 128 / 128)));
  // Closed tests are made of four to twelve groups.
  CHECK(compared(separated(3, 6), AnalysisPlan()).front().needed == 7);
  CHECK(compared(separated(12, 7), AnalysisPlan()).front().needed == 8);
  CHECK(compared(separated(12, 8), AnalysisPlan()).front().verdict == Verdict::better);
  CHECK(compared(separated(13, 8), AnalysisPlan()).front().needed == 12);
}

TEST_CASE("a pair that a larger set does not tell apart is not decided", "[closed]") {
  MetricSamples samples = separated(4, 7);
  for (std::size_t group = 1; group < 4; ++group) values_in(samples.groups[group]) = values_in(samples.groups[0]);
  values_in(samples.groups[3])[0] += 1;
  for (double& value : values_in(samples.groups[3])) value += 0.5;
  const std::vector<FlatComparison> pairs = compared(samples, AnalysisPlan());
  CHECK(pairs[0].verdict == Verdict::inconclusive);  // 0 and 1 are equal
  CHECK(*pairs[0].p == 1);
  CHECK(pairs[2].verdict == Verdict::better);  // 0 against 3
  // Floors and roundings make values of a block equal for all tests.
  samples.kind = Ratios{.floor = 100};
  for (const FlatComparison& pair : compared(samples, AnalysisPlan())) CHECK(pair.verdict == Verdict::inconclusive);
}

}  // namespace ikbench::judge
