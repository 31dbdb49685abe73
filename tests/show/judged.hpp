// A study of three solvers, judged: its values are made, its findings are those of compare().
#pragma once

#include <fmt/ranges.h>

#include "analysis/judge/judge.hpp"
#include "analysis/show/article.hpp"
#include "analysis/show/block.hpp"
#include "analysis/show/headline.hpp"
#include "analysis/show/methods_paragraph.hpp"
#include "analysis/show/moving_arm.hpp"
#include "analysis/show/page.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/publish.hpp"
#include "analysis/show/report.hpp"
#include "analysis/show/result_tables.hpp"
#include "analysis/show/results_paragraph.hpp"
#include "analysis/show/terminal.hpp"
#include "analysis/show/text.hpp"
#include "base/csv.hpp"
#include "base/files.hpp"
#include "base/json.hpp"
#include "base/names.hpp"
#include "tests/common.hpp"

using namespace ikbench::show;

namespace ikbench::show {

// 20 values around a middle, a spread apart.
inline std::vector<double> values_around(double middle, double spread) {
  std::vector<double> values;
  for (int i = 0; i < 20; ++i) values.push_back(middle * std::exp(spread * ((i * 7) % 20 - 9.5) / 10));
  return values;
}

inline std::vector<double> solved(int count, int n = 20) {
  std::vector<double> values(static_cast<std::size_t>(n), 0);
  std::fill_n(values.begin(), count, 1);
  return values;
}

inline judge::MetricSamples shares(std::vector<std::pair<std::string, std::vector<double>>> groups) {
  judge::MetricSamples of{.metric = "solved",
                          .quantity = "targets solved",
                          .quantity_kind = judge::QuantityKind::solved,
                          .better = judge::Better::larger,
                          .kind = judge::Proportions{},
                          .is_paired = true};
  for (auto& [name, values] : groups) of.groups.push_back({.name = name, .sample = judge::Sample{std::move(values)}});
  return of;
}

inline judge::MetricSamples numbers(std::string metric, std::string quantity, std::string unit,
                                    std::vector<std::pair<std::string, std::vector<double>>> groups) {
  judge::MetricSamples of{.metric = std::move(metric),
                          .quantity = std::move(quantity),
                          .unit = std::move(unit),
                          .kind = judge::Ratios{.floor = 1e-9}};
  for (auto& [name, values] : groups) of.groups.push_back({.name = name, .sample = judge::Sample{std::move(values)}});
  return of;
}

inline judge::JudgedMetric judged(judge::MetricSamples of, const judge::AnalysisPlan& plan = {}) {
  return judge::judge(std::move(of), plan);
}

inline judge::JudgedStudy judged_study(const std::string& mine = "mine") {
  judge::JudgedStudy all;
  judge::StudyResults& study = all.study;
  study.name = "mine";
  study.series = {{"1@a", mine, "python_pso", R"({"w":"0.7"})"},
                  {"2@a", "PSO", "particle_swarm", R"({"inertia":"0.53514"})"},
                  {"3@a", "DLS", "damped_least_squares", R"({"damping":"0.001"})"}};
  results::StudyDefinition& definition = study.definition;
  definition.robot = "ur5e";
  definition.search = results::Search::all_joints;
  definition.start = results::Start::middle;
  definition.path = "random";
  definition.runs = 4;
  definition.points = 5;
  definition.seed = 1;
  definition.draws_targets = true;
  definition.stop = {.iterations = 100, .tolerance = 0.0001, .evaluations = 4000};
  study.labels = {mine, "PSO", "DLS"};
  study.sessions = {{.id = 1, .environment = {{"cpu", "a processor"}, {"os", "Linux"}, {"version", "2.0"}}}};

  all.metrics.push_back(judged(shares({{mine, solved(6)}, {"PSO", solved(13)}, {"DLS", solved(20)}})));
  const auto add = [&](judge::MetricSamples costs) {
    std::get<judge::Ratios>(costs.kind).is_conditional_on_success = true;
    all.metrics.push_back(judged(std::move(costs)));
  };
  add(numbers("variation", "joint motion", "deg",
              {{mine, values_around(491, 0.5)}, {"PSO", values_around(524, 0.5)}, {"DLS", values_around(340, 0.5)}}));
  judge::MetricSamples times = numbers(
      "time", "time", "s",
      {{mine, values_around(0.084, 0.2)}, {"PSO", values_around(4.5e-5, 0.2)}, {"DLS", values_around(4.2e-6, 0.2)}});
  times.groups[0].sample = judge::ExcludedSample{.reason = judge::ExclusionReason::not_comparable,
                                                 .values = std::get<judge::Sample>(times.groups[0].sample).values};
  add(std::move(times));
  all.metrics.back().samples.warnings.push_back({.kind = judge::WarningKind::times_not_comparable,
                                                 .solvers = {mine},
                                                 .count = 20,
                                                 .total = 20,
                                                 .detail = "the machine was busy"});
  add(numbers("evaluations", "evaluations", "",
              {{mine, values_around(3715, 0.1)}, {"PSO", values_around(2620, 0.1)}, {"DLS", values_around(17, 0.1)}}));
  return all;
}

// The text is that of the file; with IKBENCH_GOLDEN set it becomes that.
inline void check_golden(const std::string& name, const std::string& text) {
  const std::filesystem::path file = "tests/show/golden/" + name;
  if (std::getenv("IKBENCH_GOLDEN")) base::write_file(file, text);
  CHECK(text_in(file) == text);
}

}  // namespace ikbench::show
