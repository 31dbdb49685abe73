#include "analysis/report/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "analysis/collections.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/report/study_tables.hpp"
#include "analysis/report/summary.hpp"
#include "results/csv.hpp"
#include "results/files.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::report;

namespace {

struct Example {
  std::string name = "slim2023";
  std::string definition =
      R"({"robot": "iiwa", "path": {"kind": "helix", "points": 20}, "runs": 20, "published": "slim2023"})";
  synthetic::Shape shape = {};
  std::string command = "ikbench run slim2023 --out out";
  double slowdown = 1;  // wall time by CPU time
};

// Saves a study of made-up solves; its keys begin with its name.
void save(Store& store, const Example& example) {
  StudyEntry entry{.name = example.name, .definition = example.definition, .series = {}};
  std::vector<SolveRecord> solves = synthetic::solves(example.shape);
  const std::int64_t session =
      store.begin_session({{"cpu", "a <fast> one"}, {"compiler", "g++ 12"}, {"command", example.command}});
  for (std::size_t i = 0; i < example.shape.solvers.size(); ++i) {
    entry.series.push_back({.key = example.name + "-series-" + std::to_string(i),
                            .label = example.shape.solvers[i],
                            .algorithm = "algorithm",
                            .options = R"({"alpha": 0.97, "acceptance": "greedy"})"});
  }
  for (SolveRecord& solve : solves) {
    solve.study = example.name;
    solve.series = example.name + "-" + solve.series;
    solve.session = session;
    solve.cpu_seconds = solve.seconds / example.slowdown;
  }
  store.save_study(entry);
  store.append(solves);
}

Report written_report(const Store& store, ReportRequest request) {
  request.collections = analysis::collections();
  return write_report(store, request);
}

}  // namespace

TEST_CASE("a report has its tables, figures and report.md", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, {});
  const Report report = written_report(store, {.study = "slim2023", .folder = folder.path / "out"});
  CHECK(report.file == folder.path / "out" / "report.md");
  CHECK(report.page == folder.path / "out" / "report.html");
  CHECK(std::filesystem::file_size(report.page) < 3'000'000);
  REQUIRE(report.warnings.size() == 1);
  CHECK(contains(report.warnings[0], "follows the gradient"));
  const auto files = files_in(folder.path / "out");
  for (const char* name : {"definition", "options", "analysis-plan", "environment", "status", "table-3", "table-4",
                           "table-5", "table-6"}) {
    for (const char* type : {".md", ".csv", ".tex"}) CHECK(files.contains("tables/" + std::string(name) + type));
  }
  CHECK(files.contains("figures/figure-10.pdf"));
  const std::string text = text_of_file(report.file);
  for (const char* words :
       {"Report of the study slim2023", "## Verdict", "| IK-BA is the most accurate | holds | holds | ", "## Summary",
        "    ikbench run slim2023 --out out", "| path.kind | helix |", "| IK-BA | algorithm | alpha | 0.97 |",
        "a &lt;fast&gt; one", "](figures/figure-9.png)", "Table 6: one-way ANOVA"}) {
    CAPTURE(words);
    CHECK(contains(text, words));
  }
  CHECK(!contains(text, "## Baselines"));
}

TEST_CASE("every link of a report leads to a file", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, {.shape = {.runs = 2}});
  const std::string text = text_of_file(written_report(store, {.study = "slim2023", .folder = folder.path}).file);
  int links = 0;
  for (std::size_t at = text.find("](figures/"); at != std::string::npos; at = text.find("](figures/", at + 1)) {
    const std::string target = text.substr(at + 2, text.find(')', at) - at - 2);
    CAPTURE(target);
    CHECK(std::filesystem::exists(folder.path / target));
    ++links;
  }
  int figures = 0, tables = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder.path / "figures")) {
    figures += file.path().extension() == ".dat" ? 1 : 0;
  }
  for (const auto& file : std::filesystem::directory_iterator(folder.path / "tables")) {
    tables += file.path().extension() == ".csv" ? 1 : 0;
  }
  CHECK(figures > 13);          // the paper's, and those of the statistics
  CHECK(links == figures * 5);  // each as picture, SVG, PDF, script and data

  const std::string page = text_of_file(folder.path / "report.html");
  links = 0;
  for (std::size_t at = page.find("href=\""); at != std::string::npos; at = page.find("href=\"", at + 1)) {
    const std::string target = page.substr(at + 6, page.find('"', at + 6) - at - 6);
    if (target.starts_with('#')) continue;
    CAPTURE(target);
    CHECK(std::filesystem::exists(folder.path / target));
    ++links;
  }
  // Each figure has SVG, PDF, PNG, script and data, except the one beside the verdict; each table has three files; then
  // report.md, solves.csv and statistics.json.
  CHECK(links == (figures - 1) * 5 + tables * 3 + 3);
}

TEST_CASE("a study with the same targets is shown as a baseline, one with others is not", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, {.shape = {.runs = 2}});
  save(store, {.name = "context", .definition = R"({"runs": 2})", .shape = {.solvers = {"random search"}, .runs = 2}});
  save(
      store,
      {.name = "shorter", .definition = R"({"runs": 2})", .shape = {.solvers = {"elsewhere"}, .runs = 2, .points = 5}});
  save(store, {.name = "inside",
               .definition = R"({"runs": 2, "limits": "enforced"})",
               .shape = {.solvers = {"not beside the others"}, .runs = 2}});
  const Report report =
      written_report(store, {.study = "slim2023", .folder = folder.path / "out", .figures = {.render = false}});
  CHECK(contains(text_of_file(report.file), "## Baselines"));
  CHECK(!contains(text_of_file(report.file), "not beside the others"));
  const std::string csv = text_of_file(folder.path / "out/tables/baselines.csv");
  CHECK(contains(csv, "\ncontext,random search,"));
  CHECK(contains(csv, "\nslim2023,MO-PSO,"));
  CHECK(!contains(csv, "elsewhere"));
}

TEST_CASE("a study of another arm is not held against the paper that it names, and says so in a line", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, {.name = "mine",
               .definition = R"({"robot": "arm", "path": {"kind": "helix", "points": 20}, "runs": 3,
                                 "published": "slim2023", "departures": ["robot", "runs"]})",
               .shape = {.runs = 3}});
  const Report report =
      written_report(store, {.study = "mine", .folder = folder.path / "out", .figures = {.render = false}});
  const std::string text = text_of_file(report.file);
  CHECK(contains(text,
                 "This study names the paper slim2023, but has another arm or task (robot, runs): it is not held "
                 "against the paper."));
  for (const char* of_paper : {"Dobot", "untestable", "Robotics 2023", "As printed"}) CHECK(!contains(text, of_paper));
  CHECK(!std::filesystem::exists(folder.path / "out/tables/table-3.csv"));
}

TEST_CASE("of the paper's claims a study is judged by those that it has the solvers for", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, {.name = "mine",
               .definition = R"({"robot": "iiwa", "path": {"kind": "helix", "points": 20}, "runs": 5,
                                 "published": "slim2023", "departures": ["runs"], "missing_solvers": ["DE", "PSO", "MO-PSO"]})",
               .shape = {.solvers = {"IK-BA", "BA", "mine"}, .runs = 5}});
  const Report report =
      written_report(store, {.study = "mine", .folder = folder.path / "out", .figures = {.render = false}});
  const std::string text = text_of_file(report.file);
  CHECK(contains(text, "Only claims that it has the solvers for can be judged."));
  CHECK(contains(text, "Of 1"));
  for (const char* of_paper : {"The Dobot was simulated", "untestable", "cannot be tested here"})
    CHECK(!contains(text, of_paper));
}

TEST_CASE("a solver has one line style in all figures of a report, and figures show the chosen solvers", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  const std::string definition = R"({"runs": 5, "figures": {"solvers": ["C", "A"], "colours": {"C": "#123456"}}})";
  save(store, {.name = "mine", .definition = definition, .shape = {.solvers = {"A", "B", "C"}, .runs = 5}});
  written_report(store, {.study = "mine", .folder = folder.path / "out", .figures = {.render = false}});
  const std::filesystem::path figures = folder.path / "out/figures";
  CHECK(contains(text_of_file(figures / "style.gp"), "#000000 #123456"));  // the eighth colour
  for (const char* const name : {"error-boxes", "statistics-error-observations", "time-boxes"}) {
    CAPTURE(name);
    const std::string script = text_of_file(figures / (name + std::string(".gp")));
    CHECK(contains(script, "colour_of(int(word('8 1', row)))"));
    CHECK(contains(script, "('C' 1, 'A' 2)"));
  }
  CHECK(contains(text_of_file(figures / "error.gp"), "ls 8 "));
  CHECK(!contains(text_of_file(figures / "error.dat"), "# B\n"));
  const ReportRequest unknown{.study = "mine", .folder = folder.path / "no", .style = FigureStyle{.solvers = {"D"}}};
  CHECK_THROWS_AS(written_report(store, unknown), std::invalid_argument);

  save(store, {.name = "damaged", .definition = R"({"runs": 5, "figures": {"font": "a'; !b"}})", .shape = {.runs = 5}});
  CHECK_THROWS_AS(written_report(store, {.study = "damaged", .folder = folder.path / "no"}), std::invalid_argument);
}

TEST_CASE("without gnuplot the tables are written and the report says what is missing", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, {.shape = {.runs = 20}});
  const Report report = written_report(
      store, {.study = "slim2023", .folder = folder.path / "out", .figures = {.gnuplot = "no-such-gnuplot"}});
  REQUIRE(report.warnings.size() == 2);  // one for all figures
  CHECK(contains(report.warnings[0], "follows the gradient"));
  CHECK(contains(report.warnings[1], "cannot start no-such-gnuplot"));
  CHECK(contains(report.warnings[1], "figure-12"));
  CHECK(std::filesystem::exists(folder.path / "out/tables/table-3.csv"));
  const std::string text = text_of_file(report.file);
  CHECK(contains(text, "## Warnings"));
  CHECK(!contains(text, "!["));
  CHECK(contains(text, "`figures/` has the script and the data of every figure"));
}

TEST_CASE("names of a study and its solvers show as text in the report", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  const std::string name = "<script>alert(1)</script>`|\n# x";
  save(store, {.name = name,
               .definition = R"({"runs": 2, "title": "<script>\n# x"})",
               .shape = {.solvers = {"<b>`|\n\n# y", "![](x)"}, .runs = 2, .points = 2},
               .command = "ikbench '\n# z'"});
  const Report report = written_report(store, {.study = name, .folder = folder.path / "out"});
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path / "out")) {
    if (entry.path().extension() != ".md") continue;
    const std::string text = text_of_file(entry.path());
    CAPTURE(entry.path());
    CHECK(!contains(text, "<script"));
    CHECK(!contains(text, "<b>"));
    CHECK(!contains(text, "\n# x"));
    CHECK(!contains(text, "\n# y"));
    CHECK(!contains(text, "\n# z"));
    CHECK(!contains(text, "![](x)"));
  }
  const std::string page = text_of_file(report.page);
  CHECK(!contains(page, "<script>alert"));
  CHECK(!contains(page, "<b>"));
  CHECK(contains(page, "&lt;script&gt;alert(1)&lt;/script&gt;`|"));
  CHECK(contains(text_of_file(report.file),
                 "Report of the study &lt;script&gt;alert(1)&lt;/script&gt;&#96;&#124; \\# x"));
}

TEST_CASE("a study of which nothing is solved has a report that says so", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, {.shape = {.runs = 0}});
  const Report report = written_report(store, {.study = "slim2023", .folder = folder.path});
  CHECK(contains(text_of_file(report.file), "This study has no solves yet."));
  CHECK(report.warnings.size() == 6);  // each solver: 0 of 400
}

TEST_CASE("an incomplete study, parallel times and answers outside the limits are said at the top", "[report]") {
  std::vector<SolveRecord> solves = synthetic::solves({.runs = 3});
  solves.pop_back();
  solves[0].timing = Timing::parallel;
  solves[1].limit_violation_deg = 7.5;
  const auto sentences = summary({JudgedStudy(make_study("s", solves))}, {});
  const auto says = [&](const std::string& words) {
    return std::ranges::any_of(sentences, [&](const std::string& sentence) { return contains(sentence, words); });
  };
  CHECK(says("1 of 359 answers are outside the joint limits ("));
  CHECK(says("; the worst joint is outside by 7.5 deg."));
  solves[1].limit_violation_deg = std::numeric_limits<double>::infinity();  // 1e308 rad
  const auto beyond = summary({JudgedStudy(make_study("s", solves))}, {});
  CHECK(std::ranges::any_of(beyond, [](const std::string& sentence) {
    return contains(sentence, "; the worst joint is outside by more than 1e308 deg.");
  }));
  CHECK(says("Solves: 359 of 360 expected"));
  CHECK(says("Computing times are not ranked or tested: times are not comparable (see the warnings)."));
}

TEST_CASE("the table beside answers that count failures says that its numbers are as measured", "[report]") {
  StudyResults study = make_study("s", synthetic::solves({.runs = 3}));
  const auto noted = [&] {
    const std::array metrics{Metric::position_error_cm};
    const Table table = results_table(study, metrics);
    return std::ranges::count(
        table.notes,
        "The numbers of this table are as measured. The report's answers count an error below the "
        "tolerance as the tolerance, and the cost of a solve without status ok as 10 times the study's limit or, "
        "without one, the dearest solve.");
  };
  CHECK(noted() == 0);  // no tolerance: nothing counts as a failure
  study.facts = facts_of(R"({"stop": {"tolerance_cm": 1}})");
  CHECK(noted() == 1);
}

TEST_CASE("targets that no configuration reaches are told first", "[report]") {
  const ScratchFolder folder;
  const auto report_where = [&](const std::string& search, const std::string& out_of_reach) {
    Store store(folder.path / (search + ".db"), Store::Mode::write);
    save(store, {.definition = R"({"runs": 20, "points": 20, "search": ")" + search + R"(", "out_of_reach": )" +
                               out_of_reach + "}"});
    return written_report(store, {.study = "slim2023", .folder = folder.path / search, .figures = {.render = false}});
  };
  const Report three =
      report_where("all_joints", R"({"points": 3, "farthest_point": 7, "farthest_cm": 1012.345, "reach_cm": 82})");
  REQUIRE(!three.warnings.empty());
  CHECK(three.warnings[0] ==
        "3 of the 20 targets of a run cannot be reached. The farthest is point 7: it is 1012 cm from the shoulder; the "
        "reach is 82 cm. No solver can solve these, so their errors say nothing about the solvers.");
  const std::string text = text_of_file(three.file), page = text_of_file(three.page);
  CHECK(text.find("3 of the 20 targets") < text.find("## Summary"));
  CHECK(page.find("3 of the 20 targets") < page.find(">Summary<"));

  const Report wrist =
      report_where("wrist", R"({"points": 1, "farthest_point": 7, "farthest_cm": 100, "reach_cm": 82})");
  REQUIRE(!wrist.warnings.empty());
  CHECK(
      wrist.warnings[0] ==
      "1 of the 20 targets of a run cannot be reached. The farthest is point 7: the wrist's centre would be 100 cm from "
      "the shoulder; the reach is 82 cm. No solver can solve these, so their errors say nothing about the solvers.");
}

TEST_CASE("what is said of times follows one state of them, in every part of a report", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  const auto report_of = [&](double slowdown, const std::string& name) {
    save(store, {.name = name, .definition = R"({"runs": 20, "published": "slim2023"})", .slowdown = slowdown});
    written_report(store, {.study = name, .folder = folder.path / name, .figures = {.render = false}});
    return text_of_file(folder.path / name / "report.md");
  };
  const auto table = [&](const std::string& name, const std::string& which) {
    return text_of_file(folder.path / name / "tables" / (which + ".md"));
  };
  const std::string clean = report_of(1, "clean");
  CHECK(!contains(clean, "not comparable"));
  CHECK(contains(clean, "Shortest typical time (geometric mean): "));
  CHECK(contains(clean, "## Statistics: typical computing time\n"));
  CHECK(!contains(table("clean", "table-3"), "not comparable"));

  const std::string busy = report_of(2, "busy");
  std::size_t said = 0;
  const std::string head = busy.substr(0, busy.find("## Study"));
  for (std::size_t at = head.find("2400 of 2400 solves took more than 1.1 times their CPU time");
       at != std::string::npos; at = head.find("2400 of 2400 solves took more than 1.1 times their CPU time", at + 1))
    ++said;
  CHECK(said == 1);  // the reason, among the warnings
  CHECK(contains(head, "Computing times are not ranked or tested: times are not comparable"));
  CHECK(!contains(head, "Shortest typical time (geometric mean): "));
  CHECK(!contains(head, "relative time"));
  CHECK(!contains(head, "computing time \\[s\\]: "));
  CHECK(contains(
      head,
      "| undecided | holds in part | times are not comparable | Table 3 | Here: not ranked, because times are not comparable (see the warnings)."));
  CHECK(contains(head, "Computing time: not tested, because times are not comparable (see the warnings)."));
  CHECK(contains(table("busy", "table-3"), "Times are not comparable"));
}

namespace {

// The section from a heading to the next one of its level; empty if there is no such heading.
std::string section_of(const std::string& report, const std::string& heading, const std::string& next) {
  const std::size_t at = report.find(heading);
  return at == std::string::npos ? "" : report.substr(at, report.find(next, at + heading.size()) - at);
}

std::size_t times_said(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("times that are not comparable have no verdict anywhere in a report", "[report]") {
  const Unit unit = GENERATE(Unit::run, Unit::point);
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, {.slowdown = 2});
  written_report(
      store,
      {.study = "slim2023", .folder = folder.path, .plan = AnalysisPlan{.unit = unit}, .figures = {.render = false}});
  const std::string text = text_of_file(folder.path / "report.md");
  const std::string page = text_of_file(folder.path / "report.html");
  const std::string in_text = section_of(text, "## Statistics: typical computing time\n", "\n## ");
  const std::string in_page = section_of(page, ">Statistics: typical computing time</h2>", "<h2");
  for (const std::string& section : {in_text, in_page}) {
    CAPTURE(section);
    CHECK(contains(section, "Observations: typical computing time"));
    CHECK(contains(section, "Not judged"));
    CHECK(times_said(section, "2400 of 2400 solves took more than 1.1 times their CPU time") ==
          2);  // once with the table, once with the figure
    for (const char* verdict : {"In short", "Methods", "All groups together", "is better than", "are the same within",
                                "p = ", "Tests of all groups", "A12"}) {
      CAPTURE(verdict);
      CHECK(!contains(section, verdict));
    }
  }
  const auto files = files_in(folder.path);
  CHECK(files.contains("tables/statistics-time-groups.csv"));
  for (const char* part : {"tests", "contrasts"}) {
    CHECK(!files.contains("tables/statistics-time-" + std::string(part) + ".csv"));
  }
  for (const char* part : {"differences", "ranks"}) {
    CHECK(!files.contains("figures/statistics-time-" + std::string(part) + ".dat"));
  }
  // The comparison of the printed times has its own section: "computing time, as printed".
  for (const std::string& whole : {text, page}) {
    for (const char* verdict :
         {"<li>typical computing time [s]: ", "- typical computing time \\[s\\]: ",
          "Pairwise comparisons: typical computing time", "Tests of all groups: typical computing time",
          "Computing time (median, smallest first)", "relative only: near", "relative only: differs"}) {
      CAPTURE(verdict);
      CHECK(!contains(whole, verdict));
    }
  }
  const CsvTable table_6 = parse_csv(text_of_file(folder.path / "tables/table-6.csv"), "table-6.csv");
  for (const auto& row : table_6.rows) {
    CHECK(row[table_6.column("F")].empty());
    CHECK(row[table_6.column("p")].empty());
  }
  CHECK(contains(text_of_file(folder.path / "tables/table-6.md"), "Times are not comparable"));
  const auto statistics = nlohmann::json::parse(text_of_file(folder.path / "statistics.json"));
  for (const auto& assessment : statistics) {
    if (assessment["quantity"] != "typical computing time [s]") continue;
    CHECK(assessment["tests"].empty());
    CHECK(assessment["contrasts"].empty());
    CHECK(assessment["groups"].size() == 6);
  }
}

TEST_CASE("points as observations are flagged at the top, in the tables and in the plan", "[report][analysis]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, {.shape = {.runs = 20}});
  save(store, {.name = "context", .definition = R"({"runs": 20})", .shape = {.solvers = {"random search"}}});
  const Report report = written_report(store, {.study = "slim2023",
                                               .folder = folder.path / "out",
                                               .plan = AnalysisPlan{.quartiles = 7, .unit = Unit::point},
                                               .figures = {.render = false}});
  REQUIRE(!report.warnings.empty());
  CHECK(report.warnings[0] ==
        "Points of one run depend on each other; used as observations because --force was given.");
  const auto table = [&](const std::string& name) { return text_of_file(folder.path / "out/tables" / (name + ".md")); };
  CHECK(contains(table("table-4"), "p-values and standard deviations are too optimistic"));
  CHECK(contains(table("analysis-plan"), "Set on the command line after the data were collected, not by the study: "));
  CHECK(contains(table("analysis-plan"), "quartiles 5 -&gt; 7, unit run -&gt; point"));
}

TEST_CASE("without a word on the command line the study's plan decides", "[report][analysis]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, {.definition = R"({"runs": 20, "analysis": {"quartiles": 7, "unit": "point"}})"});
  const Report report =
      written_report(store, {.study = "slim2023", .folder = folder.path, .figures = {.render = false}});
  CHECK(contains(report.warnings.at(0), "Points of one run depend on each other"));
  CHECK(contains(text_of_file(folder.path / "tables/analysis-plan.csv"), "\nquartiles,7,"));
  CHECK(!contains(text_of_file(folder.path / "tables/analysis-plan.md"), "Set on the command line"));
}

TEST_CASE("an unknown study is refused by name", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  CHECK_THROWS_AS(written_report(store, {.study = "nothing", .folder = folder.path}), std::invalid_argument);
}

TEST_CASE("a file that cannot be written is an error that names it, and nothing is left of it", "[report]") {
  const ScratchFolder folder;
  write_file(folder.path / "file", "text");
  CHECK(text_of_file(folder.path / "file") == "text");
  CHECK_THROWS_AS(write_file(folder.path / "file" / "below", "x"), std::invalid_argument);
  std::filesystem::create_directory(folder.path / "taken");
  write_file(folder.path / "taken" / "x", "");
  CHECK_THROWS_AS(write_file(folder.path / "taken", "x"), std::invalid_argument);
  CHECK(files_in(folder.path) == std::set<std::string>{"file", "taken/x"});
}
