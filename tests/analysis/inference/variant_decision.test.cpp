// What the tests of several labels and metrics say together.
#include "analysis/inference/variant_decision.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/report/variants_table.hpp"
#include "tests/analysis/inference/variant_samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::inference;
using namespace ikbench::report;
using namespace ikbench::variant_samples;

namespace {

MetricComparison tested(double p_worse, double p_better = 1) {
  MetricComparison metric{.metric = "position_error_cm"};
  metric.p_worse = p_worse;
  metric.p_better = p_better;
  return metric;
}

std::vector<VariantComparison> two_labels() {
  return {{.label = "one", .metrics = {tested(0.001), tested(0.04)}},
          {.label = "other", .metrics = {tested(0.012), tested(0.3)}}};
}

}  // namespace

TEST_CASE("p of all labels and metrics are corrected together, by Holm", "[variants][decision]") {
  // By hand: 4 * 0.001, 3 * 0.012, 2 * 0.04 and 0.3.
  std::vector<VariantComparison> labels = two_labels();
  decide(labels, {});
  CHECK(labels[0].metrics[0].p_worse == Approx(0.004));
  CHECK(labels[0].metrics[1].p_worse == Approx(0.08));
  CHECK(labels[1].metrics[0].p_worse == Approx(0.036));
  CHECK(labels[1].metrics[1].p_worse == Approx(0.3));
  CHECK(labels[0].metrics[0].outcome == Outcome::worse);
  CHECK(labels[0].metrics[1].outcome == Outcome::undecided);
  CHECK(labels[0].metrics[1].remark == "worse before Holm's correction, but not after it");
  CHECK(labels[1].metrics[0].outcome == Outcome::worse);
}

TEST_CASE("the order of labels and metrics decides nothing", "[variants][decision]") {
  std::vector<VariantComparison> labels = two_labels(), turned = two_labels();
  std::ranges::reverse(turned);
  for (VariantComparison& label : turned) std::ranges::reverse(label.metrics);
  decide(labels, {});
  decide(turned, {});
  for (std::size_t label = 0; label < 2; ++label) {
    for (std::size_t metric = 0; metric < 2; ++metric) {
      CHECK(labels[label].metrics[metric].p_worse == turned[1 - label].metrics[1 - metric].p_worse);
      CHECK(labels[label].metrics[metric].outcome == turned[1 - label].metrics[1 - metric].outcome);
    }
  }
}

TEST_CASE("a fact and what is not compared have no p, and do not count", "[variants][decision]") {
  std::vector<VariantComparison> labels{{.label = "one", .metrics = {tested(0.04), {.is_fact = true}}}};
  labels[0].metrics[1].outcome = Outcome::same;
  decide(labels, {});
  CHECK(labels[0].metrics[0].p_worse == Approx(0.04));
  CHECK(labels[0].metrics[0].outcome == Outcome::worse);
  CHECK(labels[0].metrics[1].outcome == Outcome::same);
}

TEST_CASE("as many runs as there are already are not said to decide", "[variants][decision]") {
  std::vector<VariantComparison> labels{{.label = "one", .metrics = {tested(0.3), tested(0.3), tested(0.001)}}};
  for (MetricComparison& metric : labels[0].metrics) metric.n_to_decide = metric.a.n = metric.b.n = 5;
  labels[0].metrics[1].n_to_decide = 6;
  decide(labels, {});
  CHECK(labels[0].metrics[0].remark == "no difference shown");
  CHECK(labels[0].metrics[1].remark ==
        "no difference shown; about 6 runs a side show a difference of the margin, or that there is none");
  CHECK(labels[0].metrics[2].n_to_decide == 5);  // decided
}

TEST_CASE("a label that is worse alone may be so by chance among twenty", "[variants][decision]") {
  // One of twenty labels is 17 % off, of which a t-test of it alone finds p = 0.04.
  const Variant a = variant(about(1, 0.3)), b = variant(about(1.17, 0.3)), same = variant(about(1, 0.3));
  const std::vector<std::string> error{"position_error_cm"};
  CHECK(compare_variants({{a, b}}, error, {}).front().metrics.front().outcome == Outcome::worse);
  std::vector<VariantPair> pairs{{a, b}};
  const Variant wide = variant(about(1.01, 0.31));
  for (int label = 1; label < 20; ++label) pairs.push_back({same, wide});
  const std::vector<VariantComparison> all = compare_variants(pairs, error, {});
  CHECK(count(all, Outcome::worse) == 0);
  // It takes more runs to decide twenty labels than one.
  const double runs = compare_variants({{same, wide}}, error, {}).front().metrics.front().n_to_decide;
  CHECK(std::isfinite(runs));
  CHECK(all.back().metrics.front().n_to_decide > runs);
}

TEST_CASE("what is the same within the margin and differs is better or worse by less than it", "[variants][decision]") {
  const Variant a = variant(about(1, 0.01));
  const MetricComparison worse = error_of(a, variant(about(1.02, 0.01))),
                         better = error_of(variant(about(1.02, 0.01)), a);
  CHECK(worse.outcome == Outcome::worse_by_less);
  CHECK(better.outcome == Outcome::better_by_less);
  CHECK(error_of(a, variant(about(1.001, 0.01))).outcome == Outcome::same);
  const std::vector<VariantComparison> all{compared(a, variant(about(1.02, 0.01)), {"position_error_cm"})};
  CHECK(variants_verdict(all, {}) == "No regression beyond 5 %. Of 1 comparison: 1 worse by less than 5 %.");
}

TEST_CASE("values that are never negative have no negative ratio", "[variants][decision]") {
  std::vector<double> wide(20, 0.01);
  wide[3] = 9;
  wide[7] = 4;
  const MetricComparison comparison = error_of(variant(about(1, 0.4)), variant(wide));
  CHECK(comparison.ratio.low == 0);
  CHECK(comparison.ratio.high > 1);
}

TEST_CASE("means that a ratio is of stand beside it where some answers are not finite", "[variants][decision]") {
  std::vector<double> a = about(1, 0.1), b = about(1.25, 0.1);
  a[0] = statistics::not_defined;
  const MetricComparison comparison = error_of(variant(a), variant(b));
  CHECK(comparison.b.mean / comparison.a.mean == Approx(comparison.ratio.ratio));
}

TEST_CASE("a single run is said once, for all labels and metrics", "[variants][decision]") {
  const Variant one = variant({1}), many = variant(about(1.3, 0.1));
  const std::vector<VariantComparison> all = compare_variants({{one, many}, {one, many}}, {}, {});
  const std::vector<std::string> notes = variants_notes(all);
  CHECK(std::ranges::count(notes, "A has a single run, which shows no variation; use more runs (--set runs=20).") == 1);
  CHECK(all.front().metrics.front().remark == "a single run");
}
