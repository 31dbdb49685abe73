// The store shows whether the methods were fixed before the data were seen; some stores say nothing, or nonsense.
#include "analysis/inference/analysis_plan.hpp"

#include "analysis/report/study_tables.hpp"
#include "results/analysis_plan_fields.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

StudyEntry entry_with(const std::string& analysis) {
  return {.name = "s",
          .definition = R"({"runs": 2, "analysis": )" + analysis + "}",
          .series = {{.key = "k", .label = "IK-BA", .algorithm = "ik_bat", .options = "{}"}}};
}

// Solves of sessions 1, 2, ...: as many as said.
SolvesOfSessions solves_by_session(const std::vector<int>& counts) {
  SolvesOfSessions solves;
  for (std::size_t i = 0; i < counts.size(); ++i) solves[static_cast<std::int64_t>(i) + 1] = counts[i];
  return solves;
}

// Sessions 1, 2, ... with these plans; "" for one that recorded none.
std::vector<Session> sessions_with(const std::vector<std::string>& plans) {
  std::vector<Session> sessions;
  for (const std::string& plan : plans) {
    sessions.push_back({.id = static_cast<std::int64_t>(sessions.size()) + 1, .environment = {{"cpu", "one"}}});
    if (!plan.empty()) sessions.back().environment["analysis"] = plan;
  }
  return sessions;
}

bool is_default(const AnalysisPlan& plan) { return changes_between(AnalysisPlan{}, plan).empty(); }

}  // namespace

TEST_CASE("the plan is what the study's definition says, in its units", "[analysis_plan]") {
  const AnalysisPlan plan = plan_of(entry_with(
      R"({"test": "kruskal_wallis", "control": "IK-BA", "significance": 0.01,
          "margin_percent": 20, "margin_cm": 0.01, "quartiles": 7, "unit": "point",
          "estimands": ["typical", "mean"], "within_cm": 0.02, "program_times": "compared"})"));
  CHECK(plan.test == "kruskal_wallis");
  CHECK(plan.control == "IK-BA");
  CHECK(plan.significance == 0.01);
  CHECK(plan.margin == 0.2);  // 20 percent
  CHECK(plan.margin_cm == 0.01);
  CHECK(plan.quartiles == 7);
  CHECK(plan.unit == Unit::point);
  CHECK(plan.estimands == std::vector{Estimand::mean, Estimand::typical});
  CHECK(plan.within_cm == 0.02);
  CHECK(plan.program_times == ProgramTimes::compared);
}

TEST_CASE("a store without a plan is judged by the defaults, and one with a damaged plan is refused",
          "[analysis_plan]") {
  CHECK(is_default(plan_of({.name = "s", .definition = "{}", .series = {}})));
  CHECK(is_default(plan_of({.name = "s", .definition = "no JSON", .series = {}})));
  CHECK(is_default(plan_of({.name = "s", .definition = "", .series = {}})));
  for (const char* plan :
       {"null", "3", "[]", "\"tamhane\"", "{}", R"({"control": "nobody"})", R"({"more": {"a": 1}})"}) {
    CAPTURE(plan);
    CHECK(is_default(plan_of(entry_with(plan))));
  }
  for (const char* nonsense :
       {R"({"test": "t"})", R"({"unit": null})", R"({"significance": 0})", R"({"margin_percent": -1})",
        R"({"significance": "0.01"})", R"({"estimands": []})", R"({"estimands": ["mean", "mode"]})",
        R"({"estimands": "mean"})", R"({"estimands": ["mean", "mean", null]})",
        R"({"quartiles": 18446744073709551615})", R"({"quartiles": 7.5})"}) {
    CAPTURE(nonsense);
    CHECK_THROWS_AS(plan_of(entry_with(nonsense)), std::invalid_argument);
  }
  CHECK_THROWS_WITH(plan_of(entry_with(R"({"quartiles": -3})")),
                    "the analysis plan of a study:1:25: quartiles is -3; expected a whole number from 1 to 9");
}

TEST_CASE("a plan that was there before the first solve is said to be so", "[analysis_plan]") {
  const std::string plan = R"({"significance": 0.01})";
  const auto notes = plan_notes(entry_with(plan), sessions_with({plan, plan}), solves_by_session({3, 2}));
  CHECK(notes == std::vector<std::string>{
                     "The methods were fixed in the study before its first solve in this store (test by_design, "
                     "control none, significance 0.01, margin_percent 5, margin_cm 0, quartiles 5, unit run, "
                     "estimands mean + typical + reliability, within_cm 0.01, program_times apart)."});
  CHECK(plan_changes(entry_with(plan), sessions_with({plan, plan}), solves_by_session({3, 2})).empty());
  CHECK(plan_notes(entry_with(plan), {}, {})
            .at(0)
            .starts_with("The methods are fixed in the study, which has no solves yet"));
}

TEST_CASE("a plan that was changed after some of the solves is said to be, with what changed", "[analysis_plan]") {
  const auto sessions =
      sessions_with({R"({"significance": 0.05})", R"({"unit": "point"})", R"({"significance": 0.01})", "{}"});
  const auto notes = plan_notes(entry_with(R"({"significance": 0.01})"), sessions, solves_by_session({3, 1, 5, 2}));
  CHECK(notes == std::vector<std::string>{
                     // the fourth session says the default, as the first
                     "The analysis plan was changed after 5 of 11 solves were made: significance 0.05 -> 0.01.",
                     "The analysis plan was changed after 1 of 11 solves were made: significance 0.05 -> 0.01, unit "
                     "point -> run."});
}

TEST_CASE("solvers that were dropped after they had solved are told, and those of other studies are not",
          "[analysis_plan]") {
  std::vector<Session> sessions = sessions_with({"{}", "{}", "{}", "{}"});
  const auto said = [&](std::size_t session, const char* study, const char* solvers) {
    sessions[session].environment["study"] = study;
    sessions[session].environment["solvers"] = solvers;
  };
  said(0, "s", R"(["IK-BA"])");
  said(1, "another", R"(["IK-BA", "BA"])");
  said(2, "s", R"(nonsense)");
  CHECK(plan_changes(entry_with("{}"), sessions, solves_by_session({3, 2, 1, 1})).empty());
  said(3, "s", R"(["IK-BA", "PSO", 7, "DE", "PSO"])");
  CHECK(list_of(plan_changes(entry_with("{}"), sessions, solves_by_session({3, 2, 1, 1}))) ==
        std::vector<std::string>{"The study had more solvers when its solves were made: PSO, DE. The correction for "
                                 "several comparisons counts only those that are left."});
}

TEST_CASE("to repeat a study that was merged of shards is to repeat all of it", "[analysis_plan]") {
  StudyResults study;
  SolveData data;
  data.sessions = {1};
  study.solve_data = std::make_shared<const SolveData>(std::move(data));
  study.solves = SolveList({Solve{}});
  const auto repeated = [&](const char* command, bool is_shard) {
    std::map<std::string, std::string> environment{{"command", command}};
    if (is_shard) environment["shard"] = "3/3";
    return command_of(study, {{.id = 1, .environment = std::move(environment)}});
  };
  CHECK(repeated("ikbench run a.toml --shard 3/3 --out parts/3 --set runs=3", true) ==
        "ikbench run a.toml --set runs=3");
  CHECK(repeated("ikbench run a.toml --out='my parts/3' --set runs=3 --shard=3/3", true) ==
        "ikbench run a.toml --set runs=3");
  CHECK(repeated(R"(ikbench run 'it'\''s.toml' '--out=a b' --shard 1/3)", true) == R"(ikbench run 'it'\''s.toml')");
  CHECK(repeated("ikbench run a.toml --out all", false) == "ikbench run a.toml --out all");
}

TEST_CASE("solves without a record of their plan are counted, and an absent control is told", "[analysis_plan]") {
  const auto notes =
      plan_notes(entry_with("{}"), sessions_with({"", "{}", "garbage"}), solves_by_session({3, 4, 2, 1}));
  CHECK(notes ==  // 3 of the first, 2 of the third, 1 of a session that is not there
        std::vector<std::string>{"6 of 10 solves have no record of the plan under which they were made."});
  CHECK(plan_notes(entry_with(R"({"control": "nobody"})"), {}, {}) ==
        std::vector<std::string>{"The plan's control nobody is no solver of the study, so all pairs are compared."});
}

TEST_CASE("the table of the plan has every field with its value and meaning", "[analysis_plan]") {
  const Table table = plan_table(entry_with("{}"), AnalysisPlan{.margin = 0.1}, {"a note"});
  CHECK(table.name == "analysis-plan");
  REQUIRE(table.rows.size() == 10);  // the fields of AnalysisPlan
  CHECK(readable(table.rows[3][0]) == "margin_percent");
  CHECK(readable(table.rows[3][1]) == "10");
  for (const auto& row : table.rows) CHECK(!readable(row[2]).empty());
  CHECK(table.notes ==
        std::vector<std::string>{
            "a note",
            "Set on the command line after the data were collected, not by the study: margin_percent 5 -> 10."});
}
