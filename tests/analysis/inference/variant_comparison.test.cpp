// Variants that are compared while their runs grow.
#include "analysis/inference/variant_comparison.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "analysis/report/variants_table.hpp"
#include "results/analysis_plan_fields.hpp"
#include "tests/analysis/inference/variant_samples.hpp"
#include "tests/catch.hpp"
#include "tests/results/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::variant_samples;

namespace {

const std::vector<std::string> errors_alone{"position_error_cm"};

std::vector<double> first(const std::vector<double>& values, std::size_t number) {
  return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(number)};
}

SequentialComparison looked_at(const std::vector<double>& a, const std::vector<double>& b, const Looks& looks,
                               SequentialComparison earlier = {}) {
  const Variant of_a = variant(a), of_b = variant(b);
  const std::vector<VariantStudy> studies{study_of_both(of_a, of_b, {})};
  return compare_sequentially(studies, errors_alone, looks, std::move(earlier));
}

}  // namespace

TEST_CASE("what is far apart is decided at an early look, and later runs change nothing", "[variants][looks]") {
  const std::vector<double> a = about(1, 0.1), b = about(2, 0.1);
  std::vector<double> other = first(b, 8);
  other.resize(20, 0.001);
  const Looks looks{.step = 4, .most = 20};
  const SequentialComparison found = looked_at(a, b, looks), same = looked_at(a, other, looks);
  CHECK(found.state == LookState::settled);
  CHECK(found.runs <= 8);
  CHECK(is_regression(found.comparisons.front().metrics.front()));
  CHECK(found.comparisons.front().metrics.front().evidence.groups[0].described.n == found.runs);
  CHECK(same.runs == found.runs);
  CHECK(same.comparisons.front().metrics.front().finding().p == found.comparisons.front().metrics.front().finding().p);
}

TEST_CASE("what is not decided is open while runs are missing, and at the limit after the last", "[variants][looks]") {
  const std::vector<double> a = about(1, 0.5), b = about(1.01, 0.4);
  const SequentialComparison open = looked_at(first(a, 14), b, {.step = 5, .most = 20});
  CHECK(open.state == LookState::open);
  CHECK(open.runs == 10);
  const SequentialComparison ended = looked_at(a, b, {.step = 5, .most = 20});
  CHECK(ended.state == LookState::at_limit);
  CHECK(ended.runs == 20);
  CHECK(is_open(ended.comparisons.front().metrics.front()));
  const SequentialComparison continued = looked_at(a, b, {.step = 5, .most = 20}, open);  // only the last two looks
  CHECK(continued.state == ended.state);
  CHECK(continued.runs == ended.runs);
  CHECK(continued.comparisons.front().metrics.front().finding().p ==
        ended.comparisons.front().metrics.front().finding().p);
}

TEST_CASE("a plan of one look is the comparison without looks", "[variants][looks]") {
  const Variant a = variant(about(1, 0.3)), b = variant(about(1.17, 0.3));
  const std::vector<VariantStudy> studies{study_of_both(a, b, {})};
  const SequentialComparison one = compare_sequentially(studies, {}, {.step = 20, .most = 20});
  const VariantComparison plain = compared(a, b);
  for (std::size_t i = 0; i < plain.metrics.size(); ++i) {
    CHECK(one.comparisons.front().metrics[i].finding().relation == plain.metrics[i].finding().relation);
    CHECK(one.comparisons.front().metrics[i].level() == Approx(plain.metrics[i].level()));
  }
}

TEST_CASE("a difference that one look would show needs more of several", "[variants][looks]") {
  const std::vector<double> a = about(1, 0.3), b = about(1.178, 0.3);
  REQUIRE(looked_at(a, b, {.step = 20, .most = 20}).state == LookState::settled);
  CHECK(looked_at(a, b, {.step = 4, .most = 20}).state == LookState::at_limit);
}

TEST_CASE("looks that are too many, too early or without runs are refused", "[variants][looks]") {
  const std::vector<double> a = about(1, 0.3);
  for (const Looks& looks : {Looks{.step = 1, .most = 10}, Looks{.step = 5, .most = 12}, Looks{.step = 5, .most = 0},
                             Looks{.step = 2, .most = 100}, Looks{.step = -5, .most = -5}}) {
    CHECK_THROWS_AS(looked_at(a, a, looks), std::invalid_argument);
  }
  CHECK_THROWS_WITH(looked_at(first(a, 4), a, {}),
                    ContainsSubstring("4 complete runs in common, and the first look is after 5"));
  const Solved targets{.runs = 6, .points = 3, .definition = R"({"path": {"kind": "helix"}, "start": "initial"})"};
  const Variant each = variant(targets, [](int run, int point) { return run + point; });
  CHECK_THROWS_WITH(compare_sequentially(std::vector{study_of_both(each, each, {})}, errors_alone, {}),
                    ContainsSubstring("runs add no targets"));
}

TEST_CASE("labels that did not change fail a gate that looks five times in at most 5 % of repetitions",
          "[variants][looks]") {
  constexpr int repetitions = 100, labels = 3;
  std::mt19937_64 random(2);
  int failed = 0;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    std::vector<Variant> all;
    for (int side = 0; side < 2 * labels; ++side) {
      std::vector<double> errors;
      for (int run = 0; run < 20; ++run) errors.push_back(1 + static_cast<double>(random() >> 11) / 9007199254740992.0);
      all.push_back(variant(errors));
    }
    std::vector<VariantStudy> studies;
    for (std::size_t label = 0; label < labels; ++label) {
      studies.push_back(study_of_both(all[label], all[labels + label], {.margin = 0}));
    }
    const SequentialComparison found = compare_sequentially(studies, errors_alone, {.step = 4, .most = 20});
    failed +=
        std::ranges::any_of(found.comparisons,
                            [](const VariantComparison& each) { return is_decided(each.metrics.front().finding()); })
            ? 1
            : 0;
  }
  CHECK(failed > 0);
  CHECK(failed <= 0.05 * repetitions + 3 * std::sqrt(0.05 * 0.95 * repetitions));  // 11
}

TEST_CASE("what is equal in the first runs may differ in the next", "[variants][looks]") {
  std::vector<double> later = about(1, 0.1);
  for (std::size_t i = 5; i < later.size(); ++i) later[i] *= 50;
  const auto varied = [](results::SolveRecord& solve) { solve.variation_deg = 10 + 0.1 * (solve.run * 7 % 20); };
  const auto varied_more = [](results::SolveRecord& solve) {
    solve.variation_deg = 10.05 + 0.1 * (solve.run * 3 % 20);
  };
  const Variant a = variant(about(1, 0.1), varied), b = variant(later, varied_more);
  const SequentialComparison found =
      compare_sequentially(std::vector{study_of_both(a, b, {.margin = 0})},
                           std::vector<std::string>{"position_error_cm", "variation_deg"}, {.step = 5, .most = 20});
  CHECK(found.runs > 5);
  CHECK(is_regression(found.comparisons.front().metrics.front()));
}

TEST_CASE("the number of runs is that of the metrics that no early look decided", "[variants][looks]") {
  const auto varied = [](results::SolveRecord& solve) { solve.variation_deg = 10 + 0.1 * (solve.run * 7 % 20); };
  const auto varied_more = [](results::SolveRecord& solve) {
    solve.variation_deg = 10.05 + 0.1 * (solve.run * 3 % 20);
  };
  const Variant a = variant(about(2, 0.1), varied), b = variant(about(1, 0.1), varied_more);
  const SequentialComparison found =
      compare_sequentially(std::vector{study_of_both(a, b, {.margin = 0})},
                           std::vector<std::string>{"position_error_cm", "variation_deg"}, {.step = 5, .most = 20});
  REQUIRE(found.runs == 20);
  REQUIRE(found.comparisons.front().metrics.front().evidence.groups[0].described.n < 20);
  CHECK_THAT(report::variants_notes(found.comparisons).front(),
             ContainsSubstring("Independent runs, 20 of A and 20 of B"));
}

TEST_CASE("looks at every level that a plan may ask end", "[variants][looks]") {
  const Variant a = variant(about(1, 0.3)), b = variant(about(1.2, 0.3));
  for (const double significance : {significances.first, significances.second}) {
    const std::vector<VariantStudy> studies{study_of_both(a, b, {.significance = significance})};
    CHECK_NOTHROW(compare_sequentially(studies, errors_alone, {.step = 2, .most = 40}));
  }
}
