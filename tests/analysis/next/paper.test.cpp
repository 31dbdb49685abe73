// The parts of a report that come from a paper, and a report without one. The papers here are slim2023 and that of
// tests/examples.
#include "analysis/report/paper.hpp"

#include <set>
#include <string>

#include "analysis/collections.hpp"
#include "analysis/report/report.hpp"
#include "analysis/report/summary.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

// Saves a study of two solvers, of which alpha needs fewer evaluations.
void save(Store& store, const std::string& name, const std::string& published) {
  StudyEntry entry{.name = name, .definition = R"({"runs": 5, "published": ")" + published + "\"}", .series = {}};
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"alpha", "beta"}, .runs = 5, .points = 4});
  const std::int64_t session = store.begin_session({});
  for (const char* label : {"alpha", "beta"}) {
    entry.series.push_back({.key = name + label, .label = label, .algorithm = "algorithm", .options = "{}"});
  }
  for (SolveRecord& solve : solves) {
    solve.study = name;
    solve.series = name + solve.solver;
    solve.session = session;
    solve.evaluations = (solve.solver == "alpha" ? 10 : 20) + solve.run;
  }
  store.save_study(entry);
  store.append(solves);
}

// Checks that neither the names of the files nor the text are slim2023's.
void has_nothing_of_slim2023(const std::set<std::string>& files, const std::string& text) {
  for (const std::string& file : files) {
    CAPTURE(file);
    CHECK_FALSE(contains(file, "table-3"));
    CHECK_FALSE(contains(file, "figure-5"));
    CHECK_FALSE(contains(file, "printed-error"));
  }
  for (const char* words : {"slim2023", "Slim", "IK-BA", "Table 3", "Table 7", "Dobot"}) {
    CAPTURE(words);
    CHECK_FALSE(contains(text, words));
  }
}

}  // namespace

TEST_CASE("a paper is data alone: its claim and what it prints are in the report of its study", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, "mine", "tiny");
  const Report report = write_report(store, {.study = "mine",
                                             .folder = folder.path / "out",
                                             .figures = {.render = false},
                                             .collections = analysis::collections()});
  const auto files = files_in(folder.path / "out");
  const std::string text = text_of_file(report.file);
  CHECK(report.warnings.empty());
  CHECK(contains(text, "Nobody: A Small Swarm Is Enough."));
  CHECK(contains(text, "Of 1 claim, 1 holds. As printed, 0 of 1 hold."));  // t = 1.98 of 8 degrees of freedom
  CHECK(contains(text, "| Alpha needs the fewest evaluations | holds | undecided | mean 13, beta 23 | Table 1 |"));
  CHECK(contains(text, "Evaluations: alpha 13, beta 23"));
  CHECK(files.contains("tables/statistics-printed-evaluations-contrasts.csv"));
  CHECK(files.contains("tables/results.csv"));  // what any study has stays
  has_nothing_of_slim2023(files, text);
}

TEST_CASE("an item of a paper's audit is an entry", "[report]") {
  const std::vector<AuditItem> items = analysis::paper("tiny").audit();
  REQUIRE(items.size() == 1);
  CHECK(items.front().id == "1a");
  CHECK(items.front().printed == "25");
  CHECK(items.front().follows == "20");  // 12 / 10
  CHECK(words_of(items.front()) == "contradiction");
}

TEST_CASE("a study without a paper has its results, status, statistics and figures under plain names", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, "mine", "");
  const Report report = write_report(store, {.study = "mine",
                                             .folder = folder.path / "out",
                                             .figures = {.render = false},
                                             .collections = analysis::collections()});
  const auto files = files_in(folder.path / "out");
  const std::string text = text_of_file(report.file);
  CHECK(report.warnings.empty());
  CHECK(report.results.name == "results");
  for (const char* table : {"results", "status", "anova-error", "anova-evaluations", "statistics-error-contrasts"}) {
    CAPTURE(table);
    CHECK(files.contains("tables/" + std::string(table) + ".csv"));
  }
  for (const char* figure : {"path", "error", "time-boxes", "joints", "statistics-error-differences"}) {
    CAPTURE(figure);
    CHECK(files.contains("figures/" + std::string(figure) + ".gp"));
  }
  CHECK(text.find("## Summary") < text.find("## Results"));
  CHECK(text.find("## Results") < text.find("## Statistics: position error"));
  CHECK_FALSE(contains(text, "## Verdict"));
  CHECK_FALSE(contains(text, "## Further"));
  CHECK_FALSE(contains(text, "he paper"));
  CHECK_FALSE(contains(text, "paper_"));
  has_nothing_of_slim2023(files, text);
}

TEST_CASE("a study of a paper that is not there is told so", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, "mine", "nobody1999");
  const std::vector<Collection> collections{analysis::collection("tiny"), analysis::collection("arms")};
  const Report report = write_report(
      store,
      {.study = "mine", .folder = folder.path / "out", .figures = {.render = false}, .collections = collections});
  REQUIRE(report.warnings.size() == 1);
  CHECK(report.warnings[0] == "no published tables of 'nobody1999'; known papers: tiny");
}

TEST_CASE("a collection's other studies begin with the name of its own, which is that of its folder", "[report]") {
  for (const Collection& each : analysis::collections()) {
    CAPTURE(each.name);
    CHECK(&analysis::collection(each.name) == &each);
    CHECK((std::filesystem::is_directory("analysis/" + each.name) ||
           std::filesystem::is_directory("tests/examples/analysis/" + each.name)));
    CHECK_FALSE(each.in_short.empty());
    REQUIRE_FALSE(each.studies.empty());
    CHECK(each.studies.front().name == each.name);
    for (const CollectedStudy& study : each.studies) CHECK(study.name.starts_with(each.name));
    if (each.paper) CHECK_FALSE(each.paper->citation.empty());
  }
  CHECK_THROWS_WITH(analysis::collection("slim2032"),
                    Catch::Matchers::StartsWith("unknown paper or collection \"slim2032\"; did you mean \"slim2023\""));
  CHECK_FALSE(analysis::collection("arms").paper);
  CHECK_THROWS_WITH(analysis::paper("arms"), Catch::Matchers::StartsWith("unknown paper \"arms\""));
}

TEST_CASE("a tally counts the claims that hold, hold in part, fail and are undecided", "[report]") {
  const auto of = [](std::vector<Verdict> verdicts) {
    std::vector<Claim> claims;
    for (const Verdict verdict : verdicts) claims.push_back({"s", verdict, {"e"}, ""});
    return tally(claims);
  };
  using enum Verdict;
  CHECK(of({holds, holds, in_part, in_part, fails, fails, undecided, undecided}) ==
        "Of 8 claims, 2 hold, 2 hold in part, 2 fail and 2 are undecided.");
  CHECK(of({holds, undecided}) == "Of 2 claims, 1 holds and 1 is undecided.");
  CHECK(of({fails}) == "Of 1 claim, 1 fails.");
}
