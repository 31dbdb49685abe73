// Compares our study of Slim et al. 2023 with the paper's printed numbers (Table 3). The readings of
// docs/papers/slim2023-notes.md put each solver into these ranges, for the default seed and for the mean over seeds 1
// to 5.

#include "analysis/judge/judge.hpp"
#include "analysis/judge/statistics/omnibus.hpp"
#include "experiments/runner.hpp"
#include "experiments/study/reader.hpp"
#include "tests/common.hpp"

using namespace ikbench::results;
using namespace ikbench::experiments;
using namespace ikbench::judge;

namespace {

struct Range {
  double from, to;
};
const std::map<std::string, Range> errors_cm{{"IK-BA", {0.0016, 0.0023}}, {"BA", {1.0, 1.8}},
                                             {"DE", {0.30, 0.55}},        {"PSO", {0.25, 0.70}},
                                             {"K-ABC", {0.18, 0.28}},     {"MO-PSO", {0.9, 1.4}}};
const std::map<std::string, Range> variations_deg{{"IK-BA", {25, 115}}, {"BA", {240, 330}},    {"DE", {240, 330}},
                                                  {"PSO", {240, 330}},  {"K-ABC", {240, 330}}, {"MO-PSO", {25, 115}}};

// The study with that seed, solved into a temporary store.
StudyResults solved(int seed) {
  const ScratchFolder folder;
  const Study study = load_study("slim2023", {"seed=" + std::to_string(seed)});
  Store store(folder.path / "store.sqlite", Store::Mode::write);
  run(study, store, {.jobs = 1});
  return read_study(store, store.study(study.name));
}

void check_means(const std::map<std::string, double>& means, const std::map<std::string, Range>& ranges) {
  REQUIRE(means.size() == ranges.size());
  for (const auto& [solver, mean] : means) {
    CAPTURE(solver, mean);
    CHECK(mean >= ranges.at(solver).from);
    CHECK(mean <= ranges.at(solver).to);
  }
}

}  // namespace

TEST_CASE("the helix study comes out as the paper's Table 3 in the readings of the notes", "[paper]") {
  constexpr int seeds = 5;
  const std::map<std::string, const std::map<std::string, Range>*> ranges{{"position_error_cm", &errors_cm},
                                                                          {"variation_deg", &variations_deg}};
  std::map<std::string, std::map<std::string, double>> over_seeds;
  std::map<std::string, std::vector<double>> p;
  for (int seed = 1; seed <= seeds; ++seed) {
    const StudyResults study = solved(seed);
    REQUIRE(study.solves.size() == 6 * 20 * 20);
    for (const auto& [metric, range] : ranges) {
      const JudgedMetric judged = judge::judge(make_samples(study, metric_named(metric)), study.definition.plan);
      std::map<std::string, double> means;
      for (std::size_t i = 0; i < judged.descriptives.size(); ++i) {
        const std::string& solver = judged.samples.groups[i].name;
        means[solver] = judged.descriptives[i].mean;
        over_seeds[metric][solver] += means[solver] / seeds;
      }
      // The paper: 7.2e-24 and 7.2e-70.
      p[metric].push_back(anova(judged.samples).front().p);
      if (seed == 1) check_means(means, *range);
    }
  }
  for (auto& [metric, values] : p) {
    CAPTURE(metric);
    std::sort(values.begin(), values.end());
    CHECK(values.back() < 1e-15);
    CHECK(values[seeds / 2] < 1e-20);
  }
  for (const auto& [metric, range] : ranges) check_means(over_seeds[metric], *range);
}
