#include "tests/experiments/samples.hpp"
#include "tests/mistakes.hpp"

namespace {

const Overrides tiny{"runs=2", "path.points=2", "stop.iterations=2", "population=6"};
const std::vector<std::string> three_labels{"A", "B", "C"};

struct MeansFolder {
  ScratchFolder folder;
  std::filesystem::path file() const { return folder.path / "series.csv"; }
  std::string text() const { return text_in(file()); }
  std::set<std::string> lines() const {
    std::istringstream all(text());
    std::set<std::string> found;
    for (std::string line; std::getline(all, line);) found.insert(line);
    return found;
  }
};

RunMeans first_points(const Study&, const std::vector<SolveRecord>& solves) {
  RunMeans means;
  std::vector<SolveRecord> sorted = solves;
  std::ranges::sort(sorted, {}, &SolveRecord::run);
  for (const SolveRecord& solve : sorted) {
    if (solve.point != 1) continue;
    means.error_cm.push_back(solve.position_error_cm);
    means.variation_deg.push_back(solve.variation_deg);
  }
  return means;
}

std::vector<RunMeans> solved_into(const MeansFolder& folder, const std::vector<Study>& series, int jobs,
                                  int* solved = nullptr) {
  SeriesMeans kept(folder.file());
  std::atomic<int> count{0};
  auto means = solve_series(series, kept,
                            {.means_of =
                                 [&](const Study& study, std::vector<SolveRecord> solves) {
                                   ++count;
                                   return first_points(study, solves);
                                 },
                             .jobs = jobs});
  if (solved != nullptr) *solved = count;
  return means;
}

std::vector<Dimension> parsed(const std::string& alternatives) {
  return parse_dimensions("[[dimensions]]\nsection = '2.1'\nalternatives = [" + alternatives + "]\n", "open.toml",
                          three_labels);
}

}  // namespace

TEST_CASE("the first alternative of every dimension is the default, and every other is not", "[multiverse]") {
  const Study usual = load_study("slim2023");
  const auto keys_of = [](const Study& study) {
    std::vector<std::string> keys;
    for (const SolverEntry& entry : study.solvers) keys.push_back(series_key(study, entry));
    return keys;
  };
  for (const Dimension& dimension : dimensions("slim2023")) {
    CHECK(dimension.section.starts_with("2."));
    CHECK(dimension.open != dimension.name);
    CHECK(dimension.open.size() <= 40);  // it is part of a line
    for (const Alternative& each : dimension.alternatives) {
      CAPTURE(each.set);
      const bool is_default = &each == &dimension.alternatives.front();
      CHECK((keys_of(load_study("slim2023", {each.set})) == keys_of(usual)) == is_default);
    }
  }
}

TEST_CASE("the small multiverse is part of the default one", "[multiverse]") {
  const auto sets_of = [](Scope scope) {
    std::set<std::string> sets;
    for (const Dimension& dimension : within(scope, dimensions("slim2023"))) {
      CHECK(dimension.alternatives.size() >= 2);
      for (const Alternative& each : dimension.alternatives) sets.insert(each.set);
    }
    return sets;
  };
  const std::set<std::string> small = sets_of(Scope::small), usual = sets_of(Scope::usual);
  CHECK(std::ranges::includes(usual, small));
  CHECK(small.size() < usual.size());
  CHECK(small.contains("population=20"));
  CHECK(small.contains("bounds=initial"));
}

TEST_CASE("a plan has every combination of the alternatives that go together, each series once", "[multiverse]") {
  // wrist_branch has no effect if all joints are searched; DE.bounds contradicts a choice for all solvers.
  const auto varied = named({"bounds", "search", "DE.bounds", "wrist_branch"}, dimensions("slim2023"));
  const MultiversePlan plan = plan_multiverse("slim2023", varied, {.seeds = 1, .overrides = tiny});
  REQUIRE(plan.solvers.size() == 6);
  CHECK(plan.studies.size() == 3 * (4 + 2));
  const auto de = static_cast<std::size_t>(std::ranges::find(plan.solvers, "DE") - plan.solvers.begin());
  std::int64_t series = 0;
  std::set<std::size_t> used;
  for (const MultiversePlan::OfStudy& study : plan.studies) {
    const auto has = [&](const std::string& set) {
      return std::ranges::any_of(study.chosen, [&](const results::Choice& each) {
        return plan.dimensions[each.dimension].alternatives[each.alternative].set == set;
      });
    };
    const bool has_wrist = has("search=wrist");
    CHECK(study.chosen.size() == (has_wrist ? 3 : 2));
    CHECK(study.solvers[de].size() == (has("bounds=per_solver") ? 4 : 1));
    for (const auto& of_solver : study.solvers) {
      series += static_cast<std::int64_t>(of_solver.size());
      for (const auto& own : of_solver) used.insert(own.parts.begin(), own.parts.end());
    }
  }
  CHECK(used.size() == plan.parts.size());
  std::set<std::string> keys;
  for (const Study& part : plan.parts) {
    REQUIRE(part.solvers.size() == 1);
    CHECK(keys.insert(series_key(part, part.solvers.front())).second);
  }
  const MultiverseSize size = size_of(varied, plan.solvers);
  CHECK(size.studies == static_cast<std::int64_t>(plan.studies.size()));
  CHECK(size.series == series);
  CHECK(size.series > static_cast<std::int64_t>(plan.parts.size()));
  CHECK(plan.studies.front().chosen == Chosen{{0, 0}, {1, 0}, {3, 0}});
}

TEST_CASE("the series of a universe are solved with what its choices say, defaults too", "[multiverse]") {
  Overrides unclamped = tiny;
  unclamped.emplace_back("bounds=initial");
  const auto varied = named({"IK-BA.bounds", "DE.bounds"}, dimensions("slim2023"));
  const MultiversePlan plan = plan_multiverse("slim2023", varied, {.seeds = 1, .overrides = unclamped});
  int checked = 0;
  for (const auto& of_solver : plan.studies.front().solvers) {
    for (const MultiversePlan::ChosenSolver& own : of_solver) {
      const Study& part = plan.parts[own.parts.front()];
      if (own.chosen.empty()) continue;
      const results::Choice& choice = own.chosen.front();
      CHECK(plan.dimensions[choice.dimension].alternatives[choice.alternative].set.ends_with(
          "bounds=" + effective_options(part, part.solvers.front()).at("bounds")));
      ++checked;
    }
  }
  CHECK(checked == 2 + 4);
  CHECK_THROWS_WITH(
      plan_multiverse("slim2023", named({"population"}, dimensions("slim2023")), {.overrides = {"population=20"}}),
      Catch::Matchers::StartsWith("--set population=20: population is a dimension that varies"));
}

TEST_CASE("too many readings are refused with their number", "[multiverse]") {
  std::vector<std::string> names;
  for (const Dimension& each : dimensions("slim2023")) names.push_back(each.name);
  CHECK_THROWS_WITH(plan_multiverse("slim2023", named(names, dimensions("slim2023"))),
                    Catch::Matchers::Contains("choose fewer with --dimensions"));
  CHECK_THROWS_WITH(named({"bound"}, dimensions("slim2023")),
                    Catch::Matchers::StartsWith("unknown dimension \"bound\"; did you mean \"bounds\""));
  CHECK_THROWS_AS(named({"bounds", "bounds"}, dimensions("slim2023")), std::invalid_argument);
  CHECK_THROWS_AS(plan_multiverse("slim2023", {}, {.overrides = {"seed=3"}}), std::invalid_argument);
}

TEST_CASE("series that are solved are kept, the same by any number of jobs", "[multiverse]") {
  const auto series =
      plan_multiverse("slim2023", named({"bounds"}, dimensions("slim2023")), {.seeds = 2, .overrides = tiny}).parts;
  int solved = 0;
  const MeansFolder one;
  const std::vector<RunMeans> means = solved_into(one, series, 1, &solved);
  REQUIRE(means.size() == series.size());
  CHECK(solved == static_cast<int>(series.size()));
  const std::set<std::string> lines = one.lines();
  solved_into(one, series, 1, &solved);
  CHECK(solved == 0);
  std::filesystem::remove(one.file());
  const std::vector<RunMeans> again = solved_into(one, series, 3);
  CHECK(one.lines() == lines);
  for (std::size_t i = 0; i < series.size(); ++i) {
    CHECK(again[i].error_cm == means[i].error_cm);
    CHECK(again[i].variation_deg == means[i].variation_deg);
  }
  // Fewer runs are the first of many; more are solved again.
  std::vector<Study> shorter{series.front()};
  shorter.front().runs = 1;
  const std::vector<RunMeans> first = solved_into(one, shorter, 1, &solved);
  CHECK(solved == 0);
  CHECK(first.front().error_cm == std::vector<double>{means.front().error_cm.front()});
  shorter.front().runs = 3;
  solved_into(one, shorter, 1, &solved);
  CHECK(solved == 1);
}

TEST_CASE("a file that was cut anywhere is continued to the same lines", "[multiverse]") {
  const auto series =
      plan_multiverse("slim2023", named({"bounds"}, dimensions("slim2023")), {.seeds = 1, .overrides = tiny}).parts;
  const MeansFolder folder;
  solved_into(folder, series, 1);
  const std::set<std::string> lines = folder.lines();
  const auto size = static_cast<double>(folder.text().size());
  for (const double share : {0.0, 0.002, 0.3, 0.55, 0.999}) {
    std::filesystem::resize_file(folder.file(), static_cast<std::uintmax_t>(share * size));
    solved_into(folder, series, 2);
    CHECK(folder.lines() == lines);
  }
}

TEST_CASE("a file of series that was edited is refused with its line and what to do", "[multiverse]") {
  const MeansFolder folder;
  const auto refuses = [&](const std::string& text, const std::string& words) {
    CAPTURE(text);
    write_text(folder.file(), text);
    CHECK_THROWS_AS(SeriesMeans(folder.file()), std::invalid_argument);
    CHECK_THROWS_WITH(SeriesMeans(folder.file()), Catch::Matchers::StartsWith(folder.file().string() + words) &&
                                                      Catch::Matchers::Contains("choose another --out"));
  };
  // The file with one series of these means, as it is kept.
  const auto kept = [&](const RunMeans& means) {
    std::filesystem::remove(folder.file());
    SeriesMeans(folder.file()).keep("key", means);
    return folder.text();
  };
  const std::string good = kept({{0, HUGE_VAL}, {1, 2}});
  refuses("not ours\n", ":1: expected the header 'series,position_error_cm,variation_deg,check'; remove the file");
  for (std::size_t at = good.find("key"); at + 1 < good.size(); ++at) {
    std::string edited = good;
    edited[at] = edited[at] == '3' ? '4' : '3';
    refuses(edited, ":2: the file was edited");
  }
  for (const RunMeans& wrong : {RunMeans{{1}, {1, 2}}, {{}, {}}, {{1, NAN}, {1, 2}}, {{1, 1}, {1, -1}}})
    refuses(kept(wrong), ":2: the file was edited");
  write_text(folder.file(), good + good.substr(good.find("key"), 9));  // the last line lacks its end
  CHECK(SeriesMeans(folder.file()).find("key", 2)->error_cm == std::vector<double>{0, HUGE_VAL});
  CHECK(folder.text() == good);
}

TEST_CASE("what cannot be kept is an error that names the file", "[multiverse]") {
  const auto cannot_keep = [](const std::filesystem::path& file) {
    CHECK_THROWS_AS(SeriesMeans(file).keep("key", {{1}, {1}}), std::runtime_error);
    CHECK_THROWS_WITH(SeriesMeans(file).keep("key", {{1}, {1}}),
                      Catch::Matchers::StartsWith("cannot write " + file.string() + ": ") &&
                          Catch::Matchers::Contains("; make it writable"));
  };
  const MeansFolder folder;
  write_text(folder.file(), "series,position_error_cm,variation_deg,check\n");
  cannot_keep(folder.file() / "series.csv");  // a file in the place of the folder
  std::filesystem::permissions(folder.file(), std::filesystem::perms::owner_read);
  if (!std::ofstream(folder.file(), std::ios::app)) cannot_keep(folder.file());  // root can write anyway
  CHECK_THROWS_WITH(SeriesMeans(folder.folder.path),
                    Catch::Matchers::EndsWith("is no regular file; choose another --out"));
}

TEST_CASE("cancelled, the series before the first that is missing are told and kept", "[multiverse]") {
  const auto series =
      plan_multiverse("slim2023", named({"bounds"}, dimensions("slim2023")), {.seeds = 1, .overrides = tiny}).parts;
  const MeansFolder folder;
  std::atomic<bool> cancelled{false};
  SeriesMeans kept(folder.file());
  const auto means = solve_series(series, kept,
                                  {.means_of =
                                       [&](const Study& study, std::vector<SolveRecord> solves) {
                                         cancelled = true;
                                         return first_points(study, solves);
                                       },
                                   .cancelled = &cancelled});
  CHECK(means.size() == 1);
  CHECK(std::ranges::count(folder.text(), '\n') == 2);
}

TEST_CASE("a series that is solved is kept though one before it is not", "[multiverse]") {
  const auto series =
      plan_multiverse("slim2023", named({"bounds"}, dimensions("slim2023")), {.seeds = 1, .overrides = tiny}).parts;
  const MeansFolder folder;
  SeriesMeans kept(folder.file());
  const std::string first = series_key(series.front(), series.front().solvers.front());
  std::atomic<std::size_t> others{0};
  const auto means_of = [&](const Study& study, std::vector<SolveRecord> solves) {
    if (series_key(study, study.solvers.front()) == first) {
      while (others + 1 < series.size()) std::this_thread::yield();
      throw std::runtime_error("killed");
    }
    ++others;
    return first_points(study, solves);
  };
  CHECK_THROWS_WITH(solve_series(series, kept, {.means_of = means_of, .jobs = 2}), "killed");
  const SeriesMeans again(folder.file());
  CHECK(again.find(first, 1) == nullptr);
  for (std::size_t i = 1; i < series.size(); ++i) {
    CHECK(again.find(series_key(series[i], series[i].solvers.front()), 2) != nullptr);
  }
}

TEST_CASE("a file of dimensions says in one sentence where it is wrong", "[multiverse]") {
  const std::string good = "{set='x=1', where='a'}, {set='x=2', where='b', in='small'}";
  REQUIRE(parsed(good).size() == 1);
  CHECK(parsed(good).front().name == "x");
  CHECK(parsed("{set='B.x=1', where='a'}, {set='B.x=2', where='b'}").front().solver == "B");
  check_mistakes("alternatives", "open.toml:", parsed);
  const auto excepting = [](const std::string& solver, const std::string& other) {
    return "[[dimensions]]\nsection = '2.1'\nalternatives = [{set='A.x=1', where='a'}, {set='A.x=2', where='b'}]\n"
           "[[dimensions]]\nsection = '2.1'\nalternatives = [{set='" +
           solver + ".y=1', where='a'}, {set='" + solver + ".y=2', where='b', except=['" + other + "']}]\n";
  };
  CHECK(parse_dimensions(excepting("A", "A.x=2"), "open.toml", three_labels).size() == 2);
  for (const std::string& wrong : {excepting("A", "A.x=3"), excepting("B", "A.x=2")}) {
    CHECK_THROWS_WITH(parse_dimensions(wrong, "open.toml", three_labels),
                      Catch::Matchers::StartsWith("open.toml:6:") && Catch::Matchers::Contains("in except"));
  }
  std::string many;
  for (int i = 0; i < 30; ++i) many += "{set='x=" + std::to_string(i) + "', where='a'},";
  CHECK_THROWS_WITH(parsed(many), Catch::Matchers::Contains("a list of 1 to 20 tables"));
  CHECK_THROWS_AS(parse_dimensions("dimensions = 3", "open.toml", three_labels), std::invalid_argument);
  CHECK_THROWS_AS(parse_dimensions("", "open.toml", three_labels), std::invalid_argument);
  CHECK_THROWS_AS(parse_dimensions("[[dimensions", "open.toml", three_labels), std::invalid_argument);
}
