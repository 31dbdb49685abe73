#include "analysis/judge/data/imported.hpp"

#include "tests/judge/studies.hpp"

namespace {

// Of solves that may take a second, in which LM takes `seconds`.
StudyResults of_machine(const std::vector<std::string>& solvers, double seconds, const std::string& rest = "",
                        int runs = 6) {
  const Asked asked{.start = "random", .targets = "drawn", .runs = runs, .points = 10, .tolerance_cm = 1, .rest = rest};
  StudyResults all = study(
      asked,
      [&](SolveRecord& solve) {
        if (solve.label == "LM") solve.seconds = solve.cpu_seconds = seconds;
        if (solve.label == "late" && solve.run == 1) solve.status = Status::tolerance_missed, solve.seconds = 0.99;
      },
      solvers);
  for (ikbench::results::Series& series : all.series)
    if (series.label == "LM") series.algorithm = time_reference_solver;
  all.definition.stop.seconds = 1;
  return all;
}

const Group& its_group(const MetricSamples& samples, std::string_view name) {
  return samples.groups[index_of(samples, name)];
}

}  // namespace

TEST_CASE("Beside a study, shares are compared where no time ended a solve, and times never") {
  StudyResults here = of_machine({"mine", "LM"}, 0.001),
               there = of_machine({"LM", "early", "late", "mine"}, 0.004, "", 8);
  there.imported.origin = "on another machine, 11/2026";
  add_imported(here, there);
  CHECK(here.labels == std::vector<std::string>{"mine", "LM", "early", "late", "mine (there)"});
  CHECK(here.imported.labels == std::vector<std::string>{"early", "late", "mine (there)"});
  CHECK(here.imported.reference_seconds == 0.004);
  CHECK(here.of("early").size() == 60);  // of the runs that are here, too
  CHECK(here.definition.plan.control == "mine");
  const MetricSamples solved = make_samples(here, metric_named("solved")),
                      times = make_samples(here, metric_named("seconds"));
  for (const char* name : {"mine", "LM", "early"}) CHECK(excluded(its_group(solved, name)) == nullptr);
  REQUIRE(excluded(its_group(solved, "late")) != nullptr);
  CHECK(values_of(its_group(solved, "late")).size() == 60);  // shown
  CHECK(excluded(its_group(times, "mine")) == nullptr);
  for (const std::string& name : here.imported.labels) {
    REQUIRE(excluded(its_group(times, name)) != nullptr);
    CHECK(values_of(its_group(times, name)).empty());  // of no machine that a table could name
  }
  const auto says = [](const std::vector<Warning>& warnings, const std::string& words) {
    return std::ranges::count_if(warnings, [&](const Warning& warning) { return warning_text(warning) == words; });
  };
  CHECK(says(times.warnings,
             "times of early, late and mine (there) are not compared: solved on another machine, 11/2026") == 1);
  CHECK(says(solved.warnings,
             "late is not compared: the time limit stopped 10 of 60 solves on another machine, 11/2026") == 1);
}

TEST_CASE("Another study does not stand beside, and what differs is said") {
  const StudyResults here = of_machine({"mine"}, 0.001);
  CHECK_THROWS_WITH(require_same_study(of_machine({"LM"}, 0.001, R"(, "seed": 2)"), here),
                    ContainsSubstring("seed is 2 and"));
  CHECK_NOTHROW(require_same_study(of_machine({"LM"}, 0.001, R"(, "title": "mine")"), here));
}

TEST_CASE("The archive has libraries of three arms, and LM of each") {
  for (const std::string robot : {"franka_panda", "kuka_iiwa14", "ur5e"}) {
    const StudyResults all = read_archive(robot);
    CHECK(all.labels.size() >= 17);
    for (const std::string& label : all.labels) CHECK(all.of(label).size() == 200);
    CHECK(std::ranges::all_of(all.of("LM"), [](const SolveSummary& solve) {
      return solve.status == Status::ok && solve.seconds > 0 && solve.position_error_cm <= 0.001;
    }));
    CHECK(std::ranges::count(all.series, time_reference_solver, &ikbench::results::Series::algorithm) == 1);
  }
  CHECK_THROWS_WITH(read_archive("puma560"), ContainsSubstring("kuka_iiwa14"));
}
