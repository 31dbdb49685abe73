#include "analysis/report/report.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "analysis/inference/make_study.hpp"
#include "analysis/papers.hpp"
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
  request.papers = analysis::papers();
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
  CHECK(contains(text, "Of 8 claims, "));
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

TEST_CASE("targets that no configuration reaches are told first", "[report]") {
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, {.definition = R"({"runs": 20, "points": 20, "search": "all_joints", "out_of_reach": )"
                             R"({"points": 3, "farthest_point": 7, "farthest_cm": 1012.345, "reach_cm": 82}})"});
  const Report report =
      written_report(store, {.study = "slim2023", .folder = folder.path / "out", .figures = {.render = false}});
  REQUIRE(!report.warnings.empty());
  CHECK(report.warnings[0].starts_with("3 of the 20 targets of a run cannot be reached."));
  const std::string text = text_of_file(report.file);
  CHECK(text.find("3 of the 20 targets") < text.find("## Summary"));
}

TEST_CASE("times that are not comparable have no verdict anywhere in a report", "[report]") {
  const Unit unit = GENERATE(Unit::run, Unit::point);
  const ScratchFolder folder;
  Store store(folder.path / "store.db", Store::Mode::write);
  save(store, {.slowdown = 2});
  written_report(
      store,
      {.study = "slim2023", .folder = folder.path, .plan = AnalysisPlan{.unit = unit}, .figures = {.render = false}});
  const auto files = files_in(folder.path);
  CHECK(files.contains("tables/statistics-time-groups.csv"));
  for (const char* part : {"tests", "contrasts"}) {
    CHECK(!files.contains("tables/statistics-time-" + std::string(part) + ".csv"));
  }
  for (const char* part : {"differences", "ranks"}) {
    CHECK(!files.contains("figures/statistics-time-" + std::string(part) + ".dat"));
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
