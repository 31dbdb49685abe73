// What a report has of a paper, and that it needs none. Here the papers are slim2023 and that of tests/examples.
#include "analysis/report/paper.hpp"

#include <set>
#include <string>

#include "analysis/papers.hpp"
#include "analysis/report/report.hpp"
#include "analysis/report/summary.hpp"
#include "analysis/tiny/paper.hpp"
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
    solve.evaluations = (solve.solver == "alpha" ? 10 : 12) + solve.run;
  }
  store.save_study(entry);
  store.append(solves);
}

// What would be slim2023's, in the names of the pieces and in the words.
void has_nothing_of_slim2023(const std::set<std::string>& files, const std::string& text) {
  for (const std::string& file : files) {
    CAPTURE(file);
    CHECK_FALSE(contains(file, "table-3"));
    CHECK_FALSE(contains(file, "figure-5"));
    CHECK_FALSE(contains(file, "printed-"));
  }
  for (const char* words : {"slim2023", "Slim", "IK-BA", "Table 3", "Table 7", "Dobot"}) {
    CAPTURE(words);
    CHECK_FALSE(contains(text, words));
  }
}

}  // namespace

TEST_CASE("a second paper's claim, table and figure are in the report of its study, and no other paper's", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, "mine", "tiny");
  const Report report = write_report(
      store,
      {.study = "mine", .folder = folder.path / "out", .figures = {.render = false}, .papers = analysis::papers()});
  const auto files = files_in(folder.path / "out");
  const std::string text = text_of_file(report.file), page = text_of_file(report.page);
  CHECK(report.warnings.empty());
  CHECK(contains(text, "Of 1 claim, 1 holds. As printed, 1 of 1 hold."));
  CHECK(contains(text, "| Alpha needs the fewest evaluations | holds | holds | "));
  CHECK(contains(text, "## What is printed\n\n**Table 1 as printed**"));
  CHECK(contains(page, "href=\"#table-1\""));
  CHECK(files.contains("tables/table-1.csv"));
  CHECK(files.contains("figures/figure-1.gp"));
  CHECK(files.contains("tables/results.csv"));  // what any study has stays
  has_nothing_of_slim2023(files, text);
}

TEST_CASE("a study without a paper has its results, status, statistics and figures under plain names", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, "mine", "");
  const Report report = write_report(
      store,
      {.study = "mine", .folder = folder.path / "out", .figures = {.render = false}, .papers = analysis::papers()});
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
  CHECK(contains(text, "Evaluations (mean, smallest first): alpha, beta."));
  CHECK(text.find("## Summary") < text.find("## Results"));
  CHECK(text.find("## Results") < text.find("## Statistics: position error"));
  CHECK_FALSE(contains(text, "## Verdict"));
  CHECK_FALSE(contains(text, "## Further"));
  CHECK_FALSE(contains(text, "aper"));  // neither "The paper" nor "paper_mean"
  has_nothing_of_slim2023(files, text);
}

TEST_CASE("a study of a paper that is not there is told so", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, "mine", "nobody1999");
  const std::vector<Paper> papers{tiny::paper()};
  const Report report = write_report(
      store, {.study = "mine", .folder = folder.path / "out", .figures = {.render = false}, .papers = papers});
  REQUIRE(report.warnings.size() == 1);
  CHECK(report.warnings[0] == "no published tables of 'nobody1999'; known papers: tiny");
}

TEST_CASE("a paper's other studies begin with the name of its own, and its name is the folder's", "[report]") {
  for (const Paper& paper : analysis::papers()) {
    CAPTURE(paper.name);
    CHECK(&analysis::paper(paper.name) == &paper);
    CHECK((std::filesystem::is_directory("analysis/" + paper.name) ||
           std::filesystem::is_directory("tests/examples/analysis/" + paper.name)));
    REQUIRE_FALSE(paper.studies.empty());
    for (const PaperStudy& study : paper.studies) CHECK(study.name.starts_with(paper.studies.front().name));
  }
  CHECK_THROWS_WITH(analysis::paper("slim2032"),
                    Catch::Matchers::StartsWith("unknown paper \"slim2032\"; did you mean \"slim2023\""));
}

TEST_CASE("a tally counts the claims that hold, hold in part, fail and are undecided", "[report]") {
  const auto of = [](std::vector<Verdict> verdicts) {
    std::vector<Claim> claims;
    for (const Verdict verdict : verdicts) claims.push_back({"s", verdict, "e", ""});
    return tally(claims);
  };
  using enum Verdict;
  CHECK(of({holds, holds, in_part, in_part, fails, fails, undecided, undecided}) ==
        "Of 8 claims, 2 hold, 2 hold in part, 2 fail and 2 are undecided.");
  CHECK(of({holds, undecided}) == "Of 2 claims, 1 holds and 1 is undecided.");
  CHECK(of({fails}) == "Of 1 claim, 1 fails.");
}
