#include "tests/show/judged.hpp"

namespace fs = std::filesystem;

namespace {

figures::Figure figure(const std::string& name) {
  return {.name = name,
          .caption = "Median error by iteration",
          .settings = "set logscale y\n",
          .plot = "plot data using 1:2\n",
          .data = "1 2\n2 1\n"};
}

Report make_report(const std::string& mine = "mine") {
  return ikbench::show::make_report(judged_study(mine), {figure("solved"), figure("error-boxes")});
}

std::size_t lines_in(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

ReportModel of_many(std::size_t solvers) {
  std::vector<std::pair<std::string, std::vector<double>>> groups;
  for (std::size_t i = 0; i < solvers; ++i)
    groups.emplace_back(fmt::format("solver {}", i), values_around(1 + 0.3 * static_cast<double>(i), 0.5));
  ReportModel all = make_report_model(
      {judged(numbers("error", "error", "mm", groups)), judged(numbers("time", "time", "ms", groups))});
  for (int i = 0; i < 2; ++i)
    all.warnings.push_back({.kind = judge::WarningKind::runs_missing, .solvers = {"a"}, .count = 1.0 + i, .total = 20});
  return all;
}

}  // namespace

TEST_CASE("each section has its words", "[show]") {
  const ScratchFolder folder;
  for (const char* name : {"solved.svg", "error-boxes.svg"}) base::write_file(folder.path / "figures" / name, "");
  for (const Blocks& blocks : report_sections(make_report())) {
    const std::string text = to_markdown({blocks}, folder.path);
    std::string name = std::get<Heading>(blocks.front()).text;
    if (name.ends_with('.')) name = "first";
    for (char& letter : name) letter = letter == ' ' ? '-' : static_cast<char>(std::tolower(letter));
    std::erase(name, '?');
    check_golden(name + ".md", text);
  }
  check_golden("screen.txt", terminal_report(make_report().model, "out/mine/report.html"));
}

TEST_CASE("a sentence, a table and the data have the same numbers", "[show]") {
  const Report report = make_report();
  const auto json = to_json(report.model);
  const Table results = results_table(report.model);
  const std::string on_screen = terminal_report(report.model);
  for (const auto& row : results.rows) {
    const auto& solver = std::get<std::string>(row[0]);
    for (std::size_t c = 1; c < row.size(); ++c) {
      const std::string metric = c == 1 ? "targets solved" : results.columns[c].name;
      const auto* marked = std::get_if<ValueCell>(&row[c]);
      if (std::holds_alternative<std::monostate>(row[c])) continue;
      if (marked && marked->relative_to_reference) {
        const auto of = std::ranges::find(report.model.metrics, metric,
                                          [](const judge::JudgedMetric& each) { return each.samples.quantity; });
        const judge::Comparison comparison = judge::better_first(*find_comparison(*of, solver, "DLS"), "DLS");
        CHECK(marked->value == comparison.estimate->value);
        CHECK((marked->mark == "*") == (verdict_of(comparison) == judge::Verdict::worse));
        CHECK(on_screen.find(number_text(marked->value, 2) + "x") != std::string::npos);
        continue;
      }
      const auto group = std::ranges::find_if(
          json["groups"], [&](const auto& each) { return each["metric"] == metric && each["solver"] == solver; });
      INFO(metric << " of " << solver);
      REQUIRE(group != json["groups"].end());
      const double value = marked ? marked->value : std::get<double>(row[c]);
      CHECK((*group)[metric == "targets solved" ? "mean" : "median"] == value);
      CHECK((*group)["unit"] == results.columns[c].unit);
      CHECK(contains(on_screen, number_text(value)));
    }
  }
  CHECK(std::string(json["headline"]) == "DLS is best: it solved all 20 targets, PSO 13 and mine 6.");
  for (const auto& comparison : json["comparisons"]) {
    if (comparison["metric"] != "targets solved") continue;
    const std::string first = comparison["first"], second = comparison["second"];
    INFO(first << " vs " << second);
    CHECK(
        contains(on_screen, fmt::format("{} to {}", number_text(comparison["low"]), number_text(comparison["high"]))));
    for (const std::string& number : {number_text(comparison["estimate"]), p_text(comparison["p"], {})})
      CHECK(contains(on_screen, number));
  }
  CHECK(json["comparisons"].size() == 12);
}

namespace {

// Returns a report of a file with one metric, as `stats` makes it.
Report report_of(judge::MetricSamples samples, const judge::AnalysisPlan& plan = {}) {
  Report report{.model = make_report_model({judged(std::move(samples), plan)})};
  report.study.name = "errors.csv";
  report.model.direction = "smaller is better";
  if (report.model.primary().samples.is_paired) report.model.noun = "blocks";
  return report;
}

judge::MetricSamples errors_of(std::size_t solvers) {
  std::vector<std::pair<std::string, std::vector<double>>> groups;
  for (std::size_t i = 0; i < solvers; ++i)
    groups.emplace_back(fmt::format("S{}", i), values_around(1 + 0.3 * static_cast<double>(i), 0.5));
  judge::MetricSamples errors = numbers("error", "error", "mm", groups);
  errors.is_paired = true;
  return errors;
}

// Returns the study of judged_study() with other metrics and labels.
Report study_of(std::vector<judge::JudgedMetric> metrics, std::size_t primary = 0) {
  judge::JudgedStudy study = judged_study();
  study.metrics = std::move(metrics);
  study.primary = primary;
  study.study.labels.clear();
  for (const judge::Group& group : study.metrics.front().samples.groups) study.study.labels.push_back(group.name);
  return ikbench::show::make_report(std::move(study), {});
}

// Returns the reports whose paragraphs are frozen.
std::vector<std::pair<std::string, Report>> reports_with_paragraphs() {
  using Test = results::AnalysisPlan::Test;
  std::vector<std::pair<std::string, Report>> reports;
  const auto add = [&](const char* what, Report report) { reports.emplace_back(what, std::move(report)); };
  add("a study of three", make_report());
  judge::MetricSamples costs = errors_of(3);
  costs.metric = "evaluations";
  costs.quantity = "evaluations";
  costs.unit.clear();
  costs.quantity_kind = judge::QuantityKind::evaluations;
  const std::vector<judge::JudgedMetric> of_tied{
      judged(shares({{"S0", solved(20)}, {"S1", solved(20)}, {"S2", solved(19)}})), judged(costs)};
  Report tied = study_of(of_tied);
  tied.model = make_report_model(of_tied, 0, {"evaluations"});
  tied.model.noun = "targets";
  tied.citation_keys = {"kennedy1995", "slim2023"};
  add("a study that a second metric decides, cited", tied);
  Report path = study_of({judged(errors_of(3), {.test = Test::means})});
  path.study.definition.start = results::Start::previous;
  path.study.definition.path = "helix";
  path.study.definition.draws_targets = false;
  path.study.definition.stop.tolerance = 0;
  path.study.definition.departures = {"runs", "population"};
  add("a path", path);
  Report map = study_of({judged(shares({{"S0", solved(20)}, {"S1", solved(12)}}))});
  map.study.definition.draws_targets = false;
  map.study.definition.runs = 1;
  map.study.definition.points = 20;
  map.study.definition.grid = {.step = 0.05, .across = {1, 0, 0}, .up = {0, 0, 1}, .shoulder = {0, 0, 0.1}};
  add("a grid", map);
  add("nothing solved",
      study_of({judged(shares({{"S0", solved(0)}, {"S1", solved(0)}, {"S2", solved(0)}})), judged(errors_of(3))}, 1));
  add("a sweep", study_of({judged(shares({{"LM, damping=1", solved(20)}, {"LM, damping=0.1", solved(12)}}))}));
  Report paper = study_of({judged(errors_of(3))});
  paper.lead = {Heading{"The conclusion of the \"paper\" holds."}, "We reproduce 41 of 60 statistics.",
                Table{.name = "table-3", .caption = "Table 3", .columns = {{"solver"}}}};
  add("a repeated paper", paper);
  add("a file of two, by ranks", report_of(errors_of(2)));
  add("a file of three, by means", report_of(errors_of(3), {.test = Test::means}));
  judge::MetricSamples unpaired =
      numbers("value", "value", "", {{"A", values_around(1, 1)}, {"B", values_around(1.4, 1)}});
  add("a file of two, inconclusive", report_of(unpaired));
  add("ten", report_of(errors_of(10)));
  add("seventeen", report_of(errors_of(17)));
  add("ten, with a control", report_of(errors_of(10), {.control = "S4"}));
  std::vector<std::pair<std::string, std::vector<double>>> alike{{"S0", solved(20)}};
  for (int i = 1; i < 10; ++i) alike.emplace_back(fmt::format("S{}", i), solved(0));
  add("nine that are alike", study_of({judged(shares(alike))}));
  Report elsewhere =
      study_of({judged(shares({{"LM", solved(20)}, {"mine", solved(12)}, {"KDL", solved(12)}, {"EAIK", solved(19)}}))});
  elsewhere.study.solves = {{.label = 0},
                            {.label = 1, .timing = results::Timing::elsewhere, .is_self_timed = true},
                            {.label = 2, .counted_by = results::CountedBy::none},
                            {.label = 3, .timing = results::Timing::process}};
  elsewhere.study.imported = {.origin = "on another machine, 11/2026", .labels = {"EAIK"}};
  add("answers of a file, uncounted evaluations, and solves of another machine", elsewhere);
  judge::MetricSamples few = errors_of(6);
  for (judge::Group& group : few.groups) std::get<judge::Sample>(group.sample).values.resize(7);
  add("few blocks", report_of(few));
  judge::MetricSamples many = errors_of(6);
  many.metric = "variation";
  many.quantity = "joint motion";
  add("few blocks in one of two metrics", study_of({judged(few), judged(many)}));
  judge::MetricSamples lost = errors_of(3);
  lost.groups[1].sample = judge::ExcludedSample{.missing = 3, .values = {1, 2}};
  add("one not compared", report_of(lost));
  add("too few", report_of(numbers("error", "error", "mm", {{"A", {1, 2, 3}}, {"B", {4, 5, 6}}})));
  return reports;
}

}  // namespace

TEST_CASE("paragraphs for an article are those that were read", "[show]") {
  const ScratchFolder folder;
  std::string all;
  for (const auto& [what, report] : reports_with_paragraphs()) {
    write_article(report, {}, {}, folder.path, "ikbench 2.0.0 (commit)");
    all += fmt::format("% {}\n{}{}\n", what, text_in(folder.path / "article" / "methods.tex"),
                       text_in(folder.path / "article" / "results.tex"));
  }
  check_golden("paragraphs.tex", all);
}

TEST_CASE("paragraphs have few comparisons a sentence, and nothing of a screen", "[show]") {
  for (const auto& [what, report] : reports_with_paragraphs()) {
    std::vector<std::string> sentences = results_sentences(report.model);
    CHECK(sentences.size() <= max_result_sentences);
    for (const std::string& sentence : sentences) {
      std::size_t tests = 0;
      for (std::size_t at = sentence.find("p "); at != std::string::npos; at = sentence.find("p ", at + 1)) ++tests;
      INFO(sentence);
      CHECK(tests <= 4);
    }
    std::ranges::move(methods_sentences(report), std::back_inserter(sentences));
    for (const std::string& sentence : sentences) {
      INFO(what << ": " << sentence);
      CHECK(sentence.ends_with('.'));
      for (const char* const of_screens : {"..", " more", "--", "! ", ": "})
        CHECK_FALSE(contains(sentence, of_screens));
    }
  }
}

TEST_CASE("a table of results shows medians or means, by which solvers are tested", "[show]") {
  const auto text = [](results::AnalysisPlan::Test test) {
    const Table table = results_table(make_report_model(
        {judged(numbers("error", "error", "mm", {{"A", values_around(1, 0.5)}, {"B", values_around(3, 0.5)}}),
                {.test = test})}));
    return to_csv(table) + table.notes.front();
  };
  const std::string by_ranks = text(results::AnalysisPlan::Test::ranks),
                    by_means = text(results::AnalysisPlan::Test::means);
  CHECK(contains(by_ranks, "solver,median error [mm],median error low [mm],median error high [mm]"));
  CHECK(contains(by_ranks, "Medians (quartiles). *"));
  CHECK(contains(by_means, "solver,mean error [mm],mean error sd [mm]"));
  CHECK(contains(by_means, "Means ± standard deviations. * worse than A (p < 0.05)."));
}

TEST_CASE("a screen has the solvers up to 20, ten lines beside them and 100 columns", "[show]") {
  for (const std::size_t solvers : {1u, 2u, 3u, 6u, 7u, 17u, 24u}) {
    const std::string text = terminal_report(of_many(solvers), "out/many/report.html");
    INFO(text);
    CHECK(lines_in(text) <= 9 + std::min<std::size_t>(solvers, 20));
    CHECK(text.find(" vs ") == std::string::npos);  // they are on the page
    CHECK((text.find("more solvers") != std::string::npos) == (solvers == 24));
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) CHECK(character_count(line) <= 100);
  }
  const std::string hostile = std::string(300, 'x') + "\x1b[2J\n";
  const std::string text = terminal_report(make_report_model(judged_study(hostile)));
  CHECK(text.find('\x1b') == std::string::npos);
  CHECK(text.find(std::string(40, 'x')) == std::string::npos);  // nor in a warning
  const std::string of_two = terminal_report(make_report_model(
      {judged(numbers("v", "a\nb\x1b", "", {{"A", values_around(1, 1)}, {"B", values_around(9, 1)}}))}));
  CHECK(contains(of_two, "a b"));
  CHECK(of_two.find('\x1b') == std::string::npos);
}

TEST_CASE("below the pairs of two solvers stands which metric decides", "[show]") {
  const auto of_two = [](const std::string& metric) {
    return judged(numbers(metric, metric, "", {{"A", values_around(1, 1)}, {"B", values_around(9, 1)}}));
  };
  ReportModel two = make_report_model({of_two("error"), of_two("effort")}, 1);
  const auto is_told = [](const ReportModel& model) {
    return terminal_report(model).find(ranking_note(model)) != std::string::npos;
  };
  CHECK(ranking_note(two) == "Ranked by effort");
  CHECK(is_told(two));
  CHECK(pairs_table(two).notes.front().starts_with(ranking_note(two)));
  two.verdict = "A is worse.";
  two.metrics[1].samples.warnings.push_back(
      {.kind = judge::WarningKind::time_limit_decides, .solvers = {"A"}, .detail = "slow"});
  CHECK(terminal_report(two).starts_with("A is worse.\n\n"));
  CHECK(terminal_report(two).find("! A is not compared: the time limit stopped") != std::string::npos);
  CHECK(ranking_note(two).find("effort") == std::string::npos);
  CHECK(ranking_note(make_report_model({of_two("error")})).empty());
  CHECK(is_told(make_report_model(judged_study())));  // others have marks, too
}

TEST_CASE("a report is few files, and replaces those of the report before it", "[show]") {
  const ScratchFolder folder;
  const std::string hostile = "mine</script><script>alert(1)</script>{{scripts}}|";
  const figures::RenderOptions options{.gnuplot = "none"};
  Report before = make_report();
  before.figures.push_back(figure("joints"));
  base::write_file(folder.path / "store.sqlite", "not ours");
  base::write_file(folder.path / "solves.csv", "");
  base::write_file(folder.path / "tables" / "own.csv", "not ours");
  write_report(before, folder.path, options);
  CHECK(fs::exists(folder.path / "figures"));
  const auto has_gone = [&] {
    return std::ranges::any_of(fs::recursive_directory_iterator(folder.path),
                               [](const auto& entry) { return entry.path().stem() == "joints"; });
  };
  CHECK(has_gone());
  const WrittenReport written = write_report(make_report(hostile), folder.path, options);
  CHECK_FALSE(has_gone());
  CHECK(fs::exists(folder.path / "store.sqlite"));
  CHECK(fs::exists(folder.path / "tables" / "own.csv"));

  const auto json = base::parsed_json(*base::read_file(folder.path / "results.json"));
  CHECK(json["files"].size() < 40);
  for (const auto& file : json["files"]) CHECK(fs::is_regular_file(folder.path / std::string(file)));
  for (const char* file :
       {"report.html", "report.md", "results.json", "solves.csv", "tables/results.csv", "tables/pairs.tex",
        "article/methods.tex", "article/main.tex", "figures/source/style.gp", "tables/descriptives.tex"})
    CHECK(std::ranges::find(json["files"], file) != json["files"].end());

  const std::string page = *base::read_file(written.page), text = *base::read_file(folder.path / "report.md");
  for (const char* theirs : {"<script>alert", "src=\"http"}) CHECK_FALSE(contains(page, theirs));
  CHECK(contains(page, "{{"));  // the label's own, as text
  CHECK(text.find("<script>") == std::string::npos);
}

TEST_CASE("only files that a report has written are replaced or removed", "[show]") {
  const ScratchFolder folder;
  const fs::path out = folder.path / "out", killed = folder.path / "killed";
  for (const char* file :
       {"tables/table-8.csv", "tables/mine.csv", "tables/results.xlsx", "store.sqlite", "../precious.csv"})
    base::write_file(out / file, "");
  base::write_file(out / "results.json", R"({"files": ["results.json", "tables/table-8.csv", "tables/results.xlsx",
      "store.sqlite", "../precious.csv", "tables/../../precious.csv", 7]})");
  const std::string list = text_in(out / "results.json");
  write_text(out / "results.json", R"({"experiment": 7, )" + list.substr(1));  // somebody else's
  CHECK_THROWS_AS(write_report(make_report(), out, {.only = {"none"}}), std::invalid_argument);
  write_text(out / "results.json", list);
  fs::resize_file(out / "results.json", 200'000'001);  // too large to be read
  CHECK_THROWS_WITH(reserve_files(out, {"report.md"}), ContainsSubstring("results.json"));
  write_text(out / "results.json", list);
  write_report(make_report(), out, {.only = {"none"}});
  CHECK_FALSE(fs::exists(out / "tables" / "table-8.csv"));
  for (const char* file : {"tables/mine.csv", "tables/results.xlsx", "store.sqlite", "../precious.csv"})
    CHECK(fs::exists(out / file));
  for (const char* name : {"report.html", "report.md", "results.json", "solves.csv", "article/main.tex",
                           "tables/results.csv", "figures/source/style.gp"}) {
    const fs::path other = folder.path / fs::path(name).filename();
    base::write_file(other / name, "not ours");
    CHECK_THROWS_WITH(reserve_files(other, {name}), ContainsSubstring(name));
    if (name != std::string("solves.csv"))  // which publish does not write
      CHECK_THROWS_WITH(write_report(make_report(), other, {.gnuplot = "none"}), ContainsSubstring(name));
    CHECK(*base::read_file(other / name) == "not ours");
    fs::remove(other / name);
    fs::create_symlink("nowhere", other / name);
    CHECK_THROWS_WITH(reserve_files(other, {name}), ContainsSubstring(name));
  }
  // A report that was killed is continued.
  reserve_files(killed, report_files({"results"}, {}));
  base::write_file(killed / "tables" / "results.csv", "");
  CHECK_NOTHROW(reserve_files(killed, report_files({"results"}, {})));
}

TEST_CASE("a table says no more below it than it has", "[show]") {
  const auto of = [](judge::MetricSamples samples) { return make_report_model({judged(std::move(samples))}); };
  const ReportModel of_shares = of(shares({{"A", solved(20)}, {"B", solved(9)}}));
  CHECK(results_table(of_shares).notes.front() ==
        "* worse than A (p < 0.05). Brackets: 95 % intervals.");  // no medians
  CHECK(results_table(of(shares({{"A", solved(20)}, {"B", solved(20)}}))).notes.size() == 1);
  const ReportModel of_errors = of(numbers("error", "error", "mm", {{"A", solved(20)}, {"B", solved(20)}}));
  CHECK(results_table(of_errors).columns.size() == 2);  // the solver and its median
  CHECK(results_table(of_errors).notes == std::vector<std::string>{"Medians (quartiles)."});
  const ReportModel of_few = of(numbers("error", "error", "mm", {{"A", {1, 2, 3}}, {"B", {4, 5, 6}}}));
  CHECK(pairs_table(of_few).notes.empty());
  CHECK(descriptives_table(of_errors).notes[0].find("Wilson") == std::string::npos);
  CHECK(descriptives_table(of_shares).notes[0].find("Wilson") != std::string::npos);
  ReportModel of_none = of(numbers("value", "value", "", {{"A", {}}, {"B", {}}}));
  of_none.direction = "smaller is better";
  CHECK(results_table(of_none).notes == std::vector<std::string>{"-: without a value (value)."});
}

TEST_CASE("a pair has one effect size, named by its standardiser", "[show]") {
  judge::MetricSamples of =
      numbers("error", "error", "mm", {{"A", values_around(1, 0.5)}, {"B", values_around(3, 0.6)}});
  using Test = results::AnalysisPlan::Test;
  for (const auto& [is_paired, test, name] :
       {std::tuple(true, Test::ranks, "a12"), {true, Test::means, "g_av"}, {false, Test::means, "g"}}) {
    of.is_paired = is_paired;
    const auto pair = to_json(pairs_table(make_report_model({judged(of, {.test = test})})))[0];
    for (const char* const other : {"a12", "g_av", "g"}) CHECK(pair[other].is_null() == (other != std::string(name)));
  }
}

TEST_CASE("marks say who is worse or better than the reference, and stand at what the test was of", "[show]") {
  const auto a = values_around(1, 0.5), b = values_around(3, 0.5), c = values_around(3.03, 0.6);
  const auto text = [](judge::MetricSamples costs, results::AnalysisPlan plan = {}, int last = 6) {
    std::get<judge::Ratios>(costs.kind).is_conditional_on_success = true;
    costs.is_paired = true;
    const auto shown_of = shares({{"A", solved(6)}, {"B", solved(20)}, {"C", solved(last)}});
    const Table table = results_table(make_report_model({judged(shown_of, plan), judged(std::move(costs), plan)}));
    return to_text(table);
  };
  judge::MetricSamples costs = numbers("variation", "motion", "deg", {{"A", a}, {"B", b}, {"C", c}});
  CHECK(text(costs) ==
        "solver   solved           motion\n"
        "B        100 % (84-100)   3 deg\n"
        "A        30 % (15-52) *   0.33x +\n"
        "C        30 % (15-52) *   1.01x\n"
        "* worse and + better than B (p < 0.05, corrected). Brackets: 95 % intervals. Motion: relative to B's\n"
        "median.\n"
        "Ratios use only values that both solved.\n");
  std::vector<double> near = b;
  for (double& value : near) value *= 1.02;
  CHECK(contains(text(numbers("variation", "motion", "deg", {{"A", a}, {"B", b}, {"C", near}})),
                 "C        30 % (15-52) *   1.02x\n"));  // shown, p < 0.05, and less than 5 %
  CHECK(text(costs, {.control = "A"}) ==
        "solver   solved             motion\n"
        "B        100 % (84-100) +   3x *\n"
        "A        30 % (15-52)       1 deg\n"
        "C        30 % (15-52)       3x *\n"
        "* worse and + better than A (p < 0.05, corrected). Brackets: 95 % intervals. Motion: relative to A's\n"
        "median.\n"
        "Ratios use only values that both solved.\n");
  text(costs, {}, 20);
  CHECK(contains(text(costs, {.control = "B"}), "A        30 % (15-52) *   0.33x +\n"));
  const std::string by_means = text(costs, {.test = results::AnalysisPlan::Test::means, .control = "A"});
  INFO(by_means);
  CHECK(contains(by_means, "B        100 % (84-100) +   +2.08 deg *"));
  CHECK(contains(by_means, "Motion: differences"));
  costs.groups[2].sample = judge::ExcludedSample{.reason = judge::ExclusionReason::not_comparable,
                                                 .values = std::get<judge::Sample>(costs.groups[2].sample).values};
  costs.groups[0].sample = judge::Sample{};
  CHECK(text(costs).find("A        30 % (15-52) *   -") != std::string::npos);  // it solved nothing that B did
  CHECK(contains(text(costs), "Motion: median over the values that each solver solved"));
  // C is worse than B, and not shown to be worse than the first.
  std::vector<double> wide(20, 1);
  std::fill_n(wide.begin(), 9, 50);
  const ReportModel second = make_report_model(
      {judged(numbers("error", "error", "mm", {{"A", wide}, {"B", b}, {"C", values_around(6, 0.5)}}))});
  CHECK(contains(to_text(results_table(second)), "C        6 mm (4.7-7.7) *\nMedians (quartiles). * worse than some"));
  CHECK(reference_of_marks(second) == "some other solver");
}

TEST_CASE("where only the reference was timed on a busy machine, it alone has the mark", "[show]") {
  const auto a = values_around(1, 0.5), b = values_around(3, 0.5);
  judge::MetricSamples times = numbers("time", "time", "ms", {{"A", a}, {"B", b}, {"C", b}});
  times.groups[0].sample = judge::ExcludedSample{.reason = judge::ExclusionReason::not_comparable, .values = a};
  const Table table = results_table(make_report_model(
      {judged(shares({{"A", solved(20)}, {"B", solved(9)}, {"C", solved(8)}})), judged(std::move(times))}));
  std::string marks;
  for (const auto& row : table.rows) marks += std::get<ValueCell>(row[2]).mark + ';';
  CHECK(marks == "!;;;");
}

TEST_CASE("a leader that no test reached is marked", "[show]") {
  const auto by = [](double first, int n) {
    std::vector<double> values;
    for (int i = 0; i < n; ++i) values.push_back(first + 0.1 * i);
    return values;
  };
  const ReportModel of =
      make_report_model({judged(numbers("error", "error", "mm", {{"A", by(1, 2)}, {"B", by(2, 7)}, {"C", by(3, 7)}}))});
  const Table table = results_table(of);
  const auto cell = [&](std::size_t row) { return std::get<ValueCell>(table.rows[row][1]); };
  CHECK(cell(0).mark == "!");
  CHECK(cell(1).mark.empty());
  CHECK(cell(2).mark == "*");
}

TEST_CASE("unpaired and paired values have tests of all solvers", "[show]") {
  judge::MetricSamples of = numbers("error", "error", "mm", {{"A", values_around(1, 1)}, {"B", values_around(2, 1)}});
  const results::AnalysisPlan by_means{.test = results::AnalysisPlan::Test::means};
  CHECK(omnibus_table(make_report_model({judged(of, by_means)})).rows.size() == 4);
  CHECK(omnibus_table(make_report_model({judged(of)})).rows.size() == 4);
  // The share of the groups is partial where that of blocks is left out.
  const auto has = [&](const char* title) {
    const Table table = omnibus_table(make_report_model({judged(of)}));
    const auto column = std::ranges::find(table.columns, title, &Column::name) - table.columns.begin();
    return std::holds_alternative<double>(table.rows[0].at(static_cast<std::size_t>(column)));
  };
  CHECK(has("eta squared"));
  CHECK_FALSE(has("partial eta squared"));
  of.is_paired = true;
  CHECK_FALSE(has("eta squared"));
  CHECK(has("partial eta squared"));
  CHECK(std::get<std::string>(omnibus_table(make_report_model({judged(of)})).rows[0][1]) ==
        "ANOVA of repeated measures");
  of.groups[1].sample = judge::Sample{.values = {2}, .is_deterministic = true};
  CHECK(omnibus_table(make_report_model({judged(of)})).rows.empty());
}

TEST_CASE("a report without a picture has no folder of pictures", "[show]") {
  const ScratchFolder folder;
  write_report(make_report(), folder.path, {.gnuplot = "none"});
  write_report(make_report(), folder.path / "drawn", {.only = {"none"}});
  CHECK_FALSE(fs::exists(folder.path / "drawn" / "figures"));
  for (const char* file : {"report.html", "report.md"})
    CHECK_FALSE(contains(text_in(folder.path / "drawn" / file), "Pictures"));
  Report none = make_report();
  none.figures.clear();
  for (const std::string& file : write_report(none, folder.path, {}).files) CHECK_FALSE(file.starts_with("figures"));
  CHECK_FALSE(fs::exists(folder.path / "figures" / "source" / "style.gp"));
  write_report(none, folder.path / "other", {});
  CHECK_FALSE(fs::exists(folder.path / "other" / "figures"));
}

TEST_CASE("a paper has its own first screen and sections", "[show]") {
  Report paper = make_report();
  paper.lead = {Heading{"The paper's claim holds."},
                Table{.name = "table-3", .caption = "Table 3", .columns = {{"solver"}}}};
  paper.claims = {Heading{"Claims"}, "It holds."};
  paper.has_own_numbers = true;
  const std::vector<Blocks> sections = report_sections(paper);
  std::vector<std::string> headings;
  for (const Blocks& blocks : sections) headings.push_back(std::get<Heading>(blocks.front()).text);
  CHECK(headings == std::vector<std::string>{"The paper's claim holds.", "Claims", "Pictures", "Who is better?",
                                             "Warnings", "Set-up"});
}

TEST_CASE("the moving arm has the first run of each solver, and no text that ends its element", "[show]") {
  judge::StudyResults study;
  study.definition.arm = R"({"links": [
      {"joint": "turns", "offset_deg": 0, "d_m": 0, "a_m": 1, "alpha_deg": 0, "limits_deg": [-90, 90]},
      {"joint": "turns", "offset_deg": 0, "d_m": 0, "a_m": 1, "alpha_deg": 0, "limits_deg": [-90, 90]}],
      "base": {"position_m": [0, 0, 0], "rpy_deg": [0, 0, 0]}, "tool": {"position_m": [0, 0, 0], "rpy_deg": [0, 0, 0]}})";
  study.labels = {"</script>", "B"};
  study.definition.runs = 2;
  study.definition.points = 1;
  for (const std::string& solver : study.labels) {
    for (const int run : {1, 2}) {
      results::SolveRecord solve{.label = solver, .run = run};
      solve.target_position_m = {1, 1, 0};
      solve.start_rad = {0, 0};
      solve.answer_rad = {0.5 * run, 2};
      solve.position_error_cm = 0.1;
      study.plotted.push_back(solve);
      study.solves.push_back({.run = run, .label = solver == "B" ? 1 : 0, .exceeds_velocity = solver == "B"});
    }
  }
  const auto scene = animation_json(study, study.labels);
  REQUIRE(scene);
  CHECK(scene->find('<') == std::string::npos);
  const auto json = base::parsed_json(*scene);
  CHECK(json["solvers"][0]["name"] == "</script>");
  CHECK(json["solvers"][1]["steps"].size() == 1);
  CHECK(json["solvers"][1]["steps"][0]["answer"] == std::vector<double>{0.5, 2});
  CHECK(json["solvers"][1]["steps"][0]["error"] == 1);
  CHECK(json["solvers"][0]["steps"][0]["too_fast"] == false);
  CHECK(json["solvers"][1]["steps"][0]["too_fast"] == true);
  CHECK(json["which"] == "");

  study.labels = {"A"};  // 1000 targets: some evenly, and the ends
  study.definition.points = 1000;
  const results::SolveRecord first = study.plotted.front();
  study.plotted.clear(), study.solves.clear();
  for (int point = 1; point <= 1000; ++point) {
    study.plotted.push_back(first);
    study.plotted.back().label = "A", study.plotted.back().point = point;
    study.solves.push_back({.point = point});
  }
  const auto of_long = base::parsed_json(*animation_json(study, study.labels));
  std::set<int> points;
  for (const auto& step : of_long["solvers"][0]["steps"]) points.insert(int(step["point"]));
  CHECK(points.size() > 150);
  CHECK(points.size() <= 200);
  for (const int point : {1, 1000}) CHECK(points.contains(point));
  CHECK(contains(of_long["which"], fmt::format("Only {} of 1000 targets are shown", points.size())));
  study.definition.arm.clear();
  CHECK_FALSE(animation_json(study, study.labels));
}
