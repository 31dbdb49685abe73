// Sweeps: lists of values in an entry, and by --sweep.
#include "tests/experiments/samples.hpp"

namespace {

using SweptLabels = std::vector<std::string>;

const std::string two_bats =
    "[[solvers]]\nlabel = \"IK-BA\"\nsolver = \"ik_bat\"\n[[solvers]]\nlabel = \"BA\"\nsolver = \"bat\"\n";

}  // namespace

TEST_CASE("an entry with lists becomes one entry per combination", "[sweep]") {
  const Study study = read(
      "[[solvers]]\nlabel = \"IK-BA\"\nsolver = \"ik_bat\"\npopulation = [20, 40]\n"
      "options = { alpha = [0.5, 0.97], bounds = \"clamp\" }\n[[solvers]]\nsolver = \"bat\"\n");
  CHECK(labels_of(study) == SweptLabels{"IK-BA alpha=0.5 population=20", "IK-BA alpha=0.5 population=40",
                                        "IK-BA alpha=0.97 population=20", "IK-BA alpha=0.97 population=40", "bat"});
  const SolverEntry& third = study.solvers[2];
  CHECK(third.sweep_base == "IK-BA");
  CHECK(third.population == 20);
  CHECK(third.options == solvers::Settings{{"alpha", 0.97}, {"bounds", "clamp"}});
  CHECK(study.solvers[4].sweep_base.empty());
}

TEST_CASE("a swept key is of every solver that has it, or of the one before the dot", "[sweep]") {
  const std::string study = two_bats + "[[solvers]]\nsolver = \"newton\"\n";
  CHECK(labels_of(read(study, {sweep_override("alpha=0.5,0.9")})) ==
        SweptLabels{"IK-BA alpha=0.5", "IK-BA alpha=0.9", "BA alpha=0.5", "BA alpha=0.9", "newton"});
  const SweptLabels of_one{"IK-BA", "BA alpha=0.5", "BA alpha=0.9", "newton"};
  CHECK(labels_of(read(study, {sweep_override("BA.alpha=.5,0.90")})) == of_one);
  CHECK(labels_of(read(study, {sweep_override("bat.alpha=0.5,0.9")})) == of_one);
  CHECK(labels_of(read(study, {sweep_override("alpha=0.1"), sweep_override("BA.alpha=0.5,0.9")})).size() == 4);
  CHECK(read(study, {sweep_override("population=10,20")}).solvers.size() == 6);
  CHECK(labels_of(read(two_bats, {sweep_override("IK-BA.bounds=clamp,initial")})) ==
        SweptLabels{"IK-BA bounds=clamp", "IK-BA bounds=initial", "BA"});
}

TEST_CASE("a requirement of a label that a sweep splits is one of each of its solvers", "[sweep]") {
  const auto solvers_required = [](const std::string& label, const Overrides& overrides) {
    SweptLabels labels;
    const std::string require = fmt::format("[require]\n\"{}.solved\" = \"95%\"\n[stop]\ntolerance_cm = 1\n", label);
    for (const results::Requirement& each : read(require + two_bats, overrides).requirements)
      labels.push_back(each.solver);
    return labels;
  };
  const std::string sweep = sweep_override("alpha=0.5,0.9");
  CHECK(solvers_required("BA", {sweep}) == SweptLabels{"BA alpha=0.5", "BA alpha=0.9"});
  CHECK(solvers_required("BA alpha=0.5", {sweep}) == SweptLabels{"BA alpha=0.5"});
  CHECK(solvers_required("BA", {}) == SweptLabels{"BA"});
  CHECK_THROWS_WITH(solvers_required("B", {sweep}), ContainsSubstring("unknown label \"B\""));
  const std::vector<results::Requirement> of_base{{.solver = "BA", .metric = "solved", .share = 0.5}};
  CHECK(results::for_swept_labels(of_base, {"BA", "BA x=1"}) == of_base);
  CHECK(results::for_swept_labels(of_base, {"BA best", "BA best x=1", "BAT x=1"}) == of_base);
}

TEST_CASE("a swept entry and one written by hand with its label share their solves", "[sweep]") {
  const Study study = read("[[solvers]]\nlabel = \"A\"\nsolver = \"ik_bat\"\npopulation = [20, 40]\n");
  const Study by_hand = read("[[solvers]]\nlabel = \"A population=40\"\nsolver = \"ik_bat\"\npopulation = 40\n");
  CHECK(series_key(study, study.solvers[1]) == series_key(by_hand, by_hand.solvers[0]));
  CHECK(series_key(study, study.solvers[0]) != series_key(by_hand, by_hand.solvers[0]));
}

TEST_CASE("a swept study is written entry by entry, and read again with the same series", "[sweep]") {
  const Study study = read(two_bats, {sweep_override("population=10,20,50"), sweep_override("IK-BA.alpha=0.5,0.9"),
                                      sweep_override("IK-BA.bounds=clamp,initial")});
  const Study again = read(to_toml(study));
  CHECK(to_toml(again) == to_toml(study));
  CHECK(to_json(again) == to_json(study));
  CHECK(series_of(again).size() == 15);
  CHECK(std::ranges::equal(series_of(again), series_of(study), {}, &Series::key, &Series::key));
}

TEST_CASE("mistakes in a sweep are told with their place and what was expected", "[sweep]") {
  CHECK(contains(statements_of(two_bats, {sweep_override("BB.alpha=0.5")}), "unknown solver \"BB\""));
  CHECK(contains(statements_of(two_bats, {sweep_override("alhpa=0.5")}),
                 "--sweep alhpa: unknown setting \"alhpa\"; did you mean \"alpha\"?"));
  CHECK(contains(statements_of(two_bats, {sweep_override("BA.alhpa=0.5")}), "alpha"));
  CHECK(contains(statements_of(two_bats, {sweep_override("population=1,b")}), "a whole number"));
  for (const std::string text : {"population", "=1", "population="})
    CHECK(contains(complaint<std::invalid_argument>([&] { sweep_override(text); }), "expected setting=values"));
  CHECK(contains(statements_of(two_bats, {sweep_override("alpha=nan,1")}), "a finite number"));
}

TEST_CASE("a study has at most 400 entries, swept ones too", "[sweep]") {
  std::string values = "1";
  for (int value = 2; value <= 40; ++value) values += "," + std::to_string(value);
  const Overrides both{sweep_override("IK-BA.population=" + values),
                       sweep_override("IK-BA.alpha=0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8,0.9,0.95,0.99")};
  CHECK(contains(statements_of(two_bats, both), "the sweep of IK-BA makes more than 400 solvers"));
  const Overrides each{sweep_override("population=" + values), sweep_override("alpha=0.1,0.2,0.3,0.4,0.5,0.6")};
  CHECK(contains(statements_of(two_bats, each), "the entries make more than 400 solvers; expected at most 400"));
}

TEST_CASE("a label that is kept may have commas", "[sweep]") {
  std::string text = two_bats;
  text.replace(text.find("\"BA\""), 4, "\"IK-BA, twice\"");
  for (const SweptLabels& lists : {SweptLabels{"IK-BA, twice,IK-BA"}, {"IK-BA", "IK-BA, twice"}}) {
    Study both = read(text);
    select_solvers(both, lists);
    CHECK(both.solvers.size() == 2);
  }
  Study one = read(text);
  select_solvers(one, {"IK-BA, twice"});
  CHECK(labels_of(one) == SweptLabels{"IK-BA, twice"});
  CHECK(contains(complaint<std::invalid_argument>([&] { select_solvers(one, {"IK-BA, twice, IK-BA"}); }),
                 "unknown label \" IK-BA\""));
}

TEST_CASE("what is no label may be one in other cases of letters, or name a solver", "[sweep]") {
  const auto kept = [](const SweptLabels& lists) {
    Study study = parse_study(
        "robot = \"planar_3\"\nsearch = \"all_joints\"\n[path]\nkind = \"random\"\n"
        "[[solvers]]\nsolver = \"levenberg_marquardt\"\n[[solvers]]\nlabel = \"lm\"\nsolver = \"newton\"\n"
        "[[solvers]]\nlabel = \"Mine\"\nsolver = \"damped_least_squares\"\n"
        "[[solvers]]\nlabel = \"Mine too\"\nsolver = \"damped_least_squares\"\n",
        "study.toml");
    select_solvers(study, lists);
    return labels_of(study);
  };
  CHECK(kept({"MINE"}) == SweptLabels{"Mine"});
  CHECK(kept({"lm"}) == SweptLabels{"lm"});
  CHECK(kept({"levenberg_MARQUARDT,mine"}) == SweptLabels{"levenberg_marquardt", "Mine"});
  CHECK(kept({"dls"}) == SweptLabels{"Mine", "Mine too"});
  CHECK(contains(complaint<std::invalid_argument>([&] { kept({"pso"}); }), "unknown label \"pso\""));
  CHECK(contains(complaint<std::invalid_argument>([&] { kept({","}); }), "unknown label \"\""));
  CHECK(solver_named("Lm") == "levenberg_marquardt");
  CHECK(solver_named("ik-ba") == "ik_bat");
  CHECK(solver_named("ik_bta") == "ik_bta");
}

TEST_CASE("a control that is swept or left out is none, which is told", "[sweep]") {
  const std::string controlled = two_bats + "[analysis]\ncontrol = \"BA\"\n[figures]\nsolvers = [\"IK-BA\"]\n";
  Study split = read(controlled, {sweep_override("BA.alpha=0.5,0.9")}), whole = read(controlled);
  CHECK(split.plan.control.empty());
  CHECK(split.notes.size() == 1);
  select_solvers(split, {"BA"});
  CHECK(split.figures.solvers.empty());
  CHECK(labels_of(split) == SweptLabels{"BA alpha=0.5", "BA alpha=0.9"});
  select_solvers(whole, {"BA,IK-BA"});
  CHECK(whole.plan.control == "BA");
  CHECK(whole.notes.empty());
  CHECK(contains(complaint<std::invalid_argument>([&] { select_solvers(whole, {"AB"}); }), "unknown label \"AB\""));
  select_solvers(whole, {"IK-BA"});
  CHECK(labels_of(whole) == SweptLabels{"IK-BA"});
  CHECK(whole.plan.control.empty());
  CHECK(contains(statements_of(two_bats + "[analysis]\ncontrol = \"AB\"\n"), "unknown label \"AB\""));
}

TEST_CASE("a sweep is of the solvers if any has such an option, otherwise of the study", "[sweep]") {
  for (const char* const of_study : {"near_deg=1,10", "robot=ur5e,my.urdf", "stop.seconds=1,2", "path.pitch_cm=1,2",
                                     "runs=5,10", "study.population=20,50"})
    CHECK(is_sweep_of_study(of_study));
  for (const char* const of_solvers :
       {"population=10,20", "bounds=clamp,initial", "alpha=0.5,0.9", "IK-BA.alpha=1,2", "mine.w=1,2", "alhpa=1,2"})
    CHECK_FALSE(is_sweep_of_study(of_solvers));
}

TEST_CASE("a sweep of a study makes every combination, with its overrides", "[sweep]") {
  const std::vector<SweptStudy> studies = swept_studies({"near_deg=1,.5e1", "robot=ur5e,arms/my.urdf"});
  REQUIRE(studies.size() == 4);
  using Values = std::vector<std::pair<std::string, std::string>>;
  CHECK(studies[1].place.values == Values{{"near_deg", "1"}, {"robot", "my"}});
  CHECK(studies[1].overrides == Overrides{"--sweep near_deg=1", "--sweep robot=arms/my.urdf"});
  CHECK(studies[2].place.label() == "near_deg=5 robot=ur5e");
  CHECK(swept_studies({"robot=a/my.urdf,b/my.urdf"})[1].place.label() == "b/my.urdf");
  CHECK(swept_studies({"study.population=20,50"})[0].overrides == Overrides{"--sweep population=20"});
  CHECK(swept_studies({"initial_deg=[0,0],[1,1]"})[1].overrides == Overrides{"--sweep initial_deg=[1,1]"});
  CHECK(swept_studies({"seed=18446744073709551615,1"})[0].place.label() == "18446744073709551615");
}

TEST_CASE("mistakes in a sweep of a study name the value and what to do", "[sweep]") {
  const auto mistake = [](const std::string& text) {
    return complaint<std::invalid_argument>([&] { swept_studies({text}); });
  };
  CHECK(contains(mistake("near_deg=1,1.0"), "given twice"));
  CHECK(contains(mistake("near_deg=1,"), "is not a value"));
  for (const char* const fixed : {"figures.font=a,b", "name=a,b", "rounds=4,6", "analysis.margin_percent=5,20"})
    CHECK(contains(mistake(fixed), "changes no answer"));
  CHECK(contains(mistake("study.DLS.damping=1,2"), "not a table of a study"));
  CHECK(contains(complaint<std::invalid_argument>([] {
                   swept_studies({"near_deg=1,2", "study.near_deg=3,4"});
                 }),
                 "swept twice"));
  CHECK(contains(mistake("study.nothing=1,2"), "a study has no such key"));
  std::string many = "seed=0";
  for (int seed = 1; seed <= 100; ++seed) many += "," + std::to_string(seed);
  CHECK(contains(mistake(many), "more than 100 studies"));
}

TEST_CASE("a study of a sweep keeps its place in the store, but is read again without it", "[sweep]") {
  Study study = read(two_bats, {"--sweep runs=3"});
  const std::string key = series_key(study, study.solvers[0]);
  study.sweep = {.name = "my-by-runs", .values = {{"runs", "3"}}};
  const StoredStudy stored = to_stored(study);
  CHECK(stored.definition.sweep.name == "my-by-runs");
  CHECK(stored.definition.sweep.label() == "3");
  CHECK(stored.series[0].key == key);  // the place decides no solve
}
