#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/figures/axis.hpp"
#include "analysis/figures/box_figure.hpp"
#include "analysis/figures/overview_figure.hpp"
#include "analysis/figures/process.hpp"
#include "analysis/figures/study_figures.hpp"
#include "analysis/inference/make_study.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/paper_figures.hpp"
#include "tests/analysis/drawn.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/analysis/synthetic.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::figures;
using namespace ikbench::slim2023;

namespace {

const std::vector<std::string> hostile_labels{"<script>alert(1)</script>",
                                              "`touch pwned`",
                                              "$(touch pwned)",
                                              "'; system('touch pwned'); '",
                                              "\"; !touch pwned \"",
                                              "a\nsystem 'touch pwned'",
                                              "@svg @colours",
                                              "a{b}^c_d&{e}",
                                              "%d %s %n %%",
                                              "#{touch pwned}",
                                              "back\\slash\\",
                                              "''",
                                              "'",
                                              "'''x",
                                              "'.system('touch pwned').'",
                                              "' 1, '`touch pwned`' 2",
                                              "\xFF\xFE bytes",
                                              "..\\../pwned",
                                              "a|b, c\td",
                                              ""};

std::vector<Figure> figures_of(std::vector<SolveRecord> solves) {
  return paper_figures(make_study("s", std::move(solves)));
}

const Figure& named(const std::vector<Figure>& figures, const std::string& name) {
  const auto found = std::ranges::find(figures, name, &Figure::name);
  REQUIRE(found != figures.end());
  return *found;
}

}  // namespace

TEST_CASE("an overview of many solvers names the best and the control alone, and says so", "[figure]") {
  std::vector<std::string> labels;
  for (int i = 1; i <= 20; ++i) labels.push_back(fmt::format("solver {}", i));
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = labels, .runs = 3, .points = 2});
  for (SolveRecord& solve : solves) {
    const auto place = std::ranges::find(labels, solve.solver) - labels.begin();
    solve.position_error_cm = std::pow(1.5, static_cast<double>(place));
    solve.variation_deg = 10 + static_cast<double>(place * 37 % 101);
  }
  StudyResults study = make_study("s", solves);
  study.plan.control = "solver 19";
  const Figure figure = overview_figure(study, {});
  const auto is_named = [&](const std::string& solver) {
    return contains(figure.plot, "with labels left noenhanced font names title " + gnuplot_string(solver));
  };
  CHECK(is_named("solver 1"));
  CHECK(is_named("solver 12"));
  CHECK(!is_named("solver 13"));
  CHECK(is_named("solver 19"));
  CHECK(contains(figure.caption, "Named: the best 12 of 20 by position error [cm], and the control."));
  study.plan.control.clear();
  CHECK(contains(overview_figure(study, {}).caption, "Named: the best 12 of 20 by position error [cm]."));
}

TEST_CASE("the figures of the paper have stable names, in the paper's order", "[figure]") {
  std::vector<std::string> names;
  for (const Figure& figure : figures_of(synthetic::solves({.solvers = {"IK-BA", "BA"}, .runs = 2}))) {
    names.push_back(figure.name);
  }
  CHECK(names == std::vector<std::string>{"overview", "figure-5", "figure-6", "figure-7", "figure-8", "figure-9",
                                          "figure-10", "figure-11", "figure-12"});
}

TEST_CASE("whiskers end at the last value within 1.5 box heights", "[figure]") {
  // Type 5 of 1..8 and 20: n p = 2.25 + 0.5, so q1 = 2.75, q3 = 7.25; fences -4 and 14.
  const Box b = box(std::vector<double>{8, 7, 6, 5, 4, 3, 2, 1, 20}, QuantileType::type_5);
  CHECK(b.q1 == 2.75);
  CHECK(b.median == 5);
  CHECK(b.q3 == 7.25);
  CHECK(b.whisker_low == 1);
  CHECK(b.whisker_high == 8);
}

TEST_CASE("a box with too many values that are not finite has no whiskers", "[figure]") {
  const Box b = box(std::vector<double>{1, 2, NAN, NAN}, QuantileType::type_5);
  CHECK(b.not_finite == 2);
  CHECK(std::isnan(b.whisker_low));
  CHECK(std::isnan(b.whisker_high));
  const Box few = box(std::vector<double>{-HUGE_VAL, 1, 2, 3, 4, 5, 6, 7, HUGE_VAL}, QuantileType::type_7);
  CHECK(few.not_finite == 2);
  CHECK(few.q1 == 2);  // the third of nine
  CHECK(few.whisker_low == 1);
  CHECK(few.whisker_high == 7);
}

TEST_CASE("every figure is drawn as SVG, PDF and PNG, without a screen", "[figure]") {
  const ScratchFolder folder;
  const auto figures = figures_of(synthetic::solves({.runs = 3}));
  for (const FigureOutcome& outcome : write_figures(figures, folder.path / "figures", {})) {
    CAPTURE(outcome.name, outcome.error);
    CHECK(outcome.rendered);
    for (const char* type : {".svg", ".pdf", ".png", ".gp", ".dat"}) {
      CHECK(std::filesystem::file_size(folder.path / "figures" / (outcome.name + type)) > 0);
    }
  }
  CHECK(files_in(folder.path).size() == 5 * figures.size() + 1);  // and style.gp; nothing half-drawn
}

TEST_CASE("a user can restyle a figure and draw it again with gnuplot alone", "[figure]") {
  const ScratchFolder folder;
  write_figures(figures_of(synthetic::solves({.runs = 2})), folder.path, {.render = false});
  CHECK(!std::filesystem::exists(folder.path / "figure-6.png"));
  CHECK(run_process({"gnuplot", "figure-6.gp"}, folder.path).succeeded);
  CHECK(std::filesystem::exists(folder.path / "figure-6.png"));
}

TEST_CASE("no text of a study breaks a script, runs a command or leaves the folder", "[figure]") {
  const ScratchFolder folder;
  const auto figures = figures_of(synthetic::solves({.solvers = hostile_labels, .runs = 2, .points = 3}));
  CHECK(drawn_as_svg(figures, folder.path / "figures") == "");
  for (const std::string& file : files_in(folder.path)) {
    CAPTURE(file);
    CHECK(file.starts_with("figures/"));
    CHECK((file == "figures/style.gp" || file.starts_with("figures/figure-") || file.starts_with("figures/overview.")));
    CHECK(!contains(file, "pwned"));
  }
  for (const char* name : {"figure-6.svg", "figure-10.svg"}) {
    const std::string svg = text_of_file(folder.path / "figures" / name);
    CHECK(!contains(svg, "<script"));
    for (const char* shown :
         {"&lt;script>alert(1)&lt;/script>", "`touch pwned`", "$(touch pwned)", "'; system('touch pwned'); '",
          "\"; !touch pwned \"", "a system 'touch pwned'", "@svg @colours", "a{b}^c_d&amp;{e}", "%d %s %n %%",
          "#{touch pwned}", "back\\slash\\", "..\\../pwned", "'''x", "'.system('touch pwned').'"}) {
      CAPTURE(name, shown);
      CHECK(contains(svg, "<text>" + std::string(shown) + "</text>"));  // every label as it is
    }
  }
}

TEST_CASE("every shape of study has its figures", "[figure]") {
  const synthetic::Shape shape =
      GENERATE(values<synthetic::Shape>({{.solvers = {"IK-BA"}, .runs = 1, .points = 1},
                                         {.solvers = {"IK-BA", "BA"}, .runs = 1},
                                         {.solvers = std::vector<std::string>(12, "s"), .runs = 2, .points = 300}}));
  synthetic::Shape distinct = shape;
  for (std::size_t i = 0; i < distinct.solvers.size(); ++i) distinct.solvers[i] += std::to_string(i);
  const ScratchFolder folder;
  CHECK(drawn_as_svg(figures_of(synthetic::solves(distinct)), folder.path) == "");
}

TEST_CASE("figures are drawn where values are zero, not finite, or all the same", "[figure]") {
  std::vector<SolveRecord> solves = synthetic::solves({.runs = 3});
  for (SolveRecord& solve : solves) {
    if (solve.solver == "BA") solve.position_error_cm = 0;
    if (solve.solver == "DE") solve.position_error_cm = NAN;
    if (solve.solver == "PSO" && solve.point == 2) solve.answer_rad.assign(7, HUGE_VAL);
    if (solve.solver == "K-ABC") solve.position_error_cm = 1e-310 * solve.point;
    solve.variation_deg = NAN;
    solve.seconds = 0;
  }
  const auto figures = figures_of(solves);
  CHECK(contains(named(figures, "figure-6").caption,
                 "Values up to 1e-07, which are rounding, are drawn at the lower edge."));
  CHECK(contains(named(figures, "figure-7").settings, "no finite values"));
  CHECK(contains(named(figures, "figure-10").settings, "3 not\\ndrawn"));
  const ScratchFolder folder;
  CHECK(drawn_as_svg(figures, folder.path) == "");
}

TEST_CASE("random targets are not joined by a line", "[figure]") {
  const auto solves = synthetic::solves({.solvers = {"IK-BA"}, .runs = 1});
  const auto path_of = [&](const char* definition) {
    return path_figure(make_study(StudyEntry{.name = "s", .definition = definition, .series = {}}, solves), "path");
  };
  CHECK(contains(path_of(R"({"path": {"kind": "helix"}})").plot, "with lines"));
  const Figure random = path_of(R"({"path": {"kind": "random"}})");
  CHECK(!contains(random.plot, "with lines"));
  CHECK(!contains(random.plot, "start"));
  CHECK(random.caption.starts_with("Targets, and positions that IK-BA reached"));
}

TEST_CASE("a study of which nothing is solved has no figures", "[figure]") { CHECK(figures_of({}).empty()); }

TEST_CASE("the data file of a box plot has the numbers of the box", "[figure]") {
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"IK-BA"}, .runs = 9, .points = 1});
  const double errors[] = {1, 2, 3, 4, 5, 6, 7, 8, 20};
  for (std::size_t i = 0; i < solves.size(); ++i) solves[i].position_error_cm = errors[i];
  const auto data = [](const StudyResults& study) {
    return box_figure(study, Metric::position_error_cm, "boxes").data;
  };
  const std::string drawn = data(make_study("s", solves));
  CHECK(
      drawn.starts_with("# row, lower whisker, q1, median, q3, upper whisker, observations, of those not finite\n"
                        "# IK-BA\n1 1 2.75 5 7.25 8 9 0\n"));  // quartiles of type 5 by hand, as in the test of box()
  CHECK(contains(drawn, "\n20 1."));                           // a value, not in the box
  StudyResults by_type_7 = make_study("s", solves);
  by_type_7.plan.quartiles = 7;
  CHECK(contains(data(by_type_7), "1 1 3 5 7 8 9 0"));  // type 7 by hand: 1 + 0.25 * 8 = rank 3, rank 7
}

TEST_CASE("a box plot says how small values and failures count, and whose drawn times are not compared", "[figure]") {
  const Observations counted{
      .name = "o", .quantity = "error", .groups = {{"A", {1, 2}}}, .counting = {"Below 1 is 1."}};
  CHECK(box_figure(counted, QuantileType::type_5, "o").caption.ends_with(" every value. Below 1 is 1."));
  std::vector<SolveRecord> solves = synthetic::solves({.solvers = {"A", "B", "C"}, .runs = 9, .points = 1});
  for (SolveRecord& solve : solves) solve.cpu_seconds = (solve.solver == "C" ? 0.5 : 1) * solve.seconds;
  const Figure times = box_figure(make_study("s", solves), Metric::seconds, "times");
  CHECK(contains(times.plot, "for [row=1:3] data index row using"));  // C is drawn
  CHECK(contains(times.caption, "Times of C are not compared, because 9 of 9 solves"));
}

TEST_CASE("a solver keeps its colour where another one is left out", "[figure]") {
  const StudyResults all = make_study("s", synthetic::solves({.solvers = {"A", "B"}, .runs = 9, .points = 1}));
  const StudyResults alone = of_solvers(all, [](std::string_view solver) { return solver == "B"; });
  CHECK(contains(box_figure(alone, Metric::position_error_cm, "boxes").settings,
                 "colour(row) = colour_of(int(word('2', row)))"));
}

TEST_CASE("where gnuplot is missing or fails there is its message, the scripts, and no stale picture", "[figure]") {
  const ScratchFolder folder;
  const Figure good{
      .name = "figure-x", .caption = "x", .settings = "", .plot = "plot 'figure-x.dat'", .data = "1 1\n2 2\n"};
  REQUIRE(write_figures({good}, folder.path, {})[0].rendered);

  const auto missing = write_figures({good}, folder.path, {.gnuplot = "no-such-gnuplot"});
  CHECK(!missing[0].rendered);
  CHECK(contains(missing[0].error, "cannot start no-such-gnuplot: No such file or directory"));
  CHECK(files_in(folder.path) == std::set<std::string>{"figure-x.dat", "figure-x.gp", "style.gp"});

  Figure bad = good;
  bad.plot = "plot nonsense(";
  const auto failed = write_figures({bad}, folder.path, {});
  CHECK(!failed[0].rendered);
  CHECK(contains(failed[0].error, "plot nonsense("));
  CHECK(contains(failed[0].error, "line"));
}

TEST_CASE("an axis is logarithmic where it is asked for or the spread is large", "[figure]") {
  const std::vector<double> near{1, 2, 3};
  const std::vector<double> far{0.001, 2, 3};
  CHECK(!value_axis(near, {"x", "cm"}, Scale::by_spread).logarithmic);
  CHECK(value_axis(far, {"x", "cm"}, Scale::by_spread).logarithmic);
  CHECK(value_axis(near, {"x", "cm"}, Scale::logarithmic).logarithmic);
  CHECK(contains(value_axis(far, {"x", "cm"}, Scale::by_spread).settings, "set yrange [1e-3:1e1]"));
  CHECK(!value_axis(std::vector<double>{0, 0}, {"x", "cm"}, Scale::logarithmic).logarithmic);
}

TEST_CASE("a name of two lines beside an axis is whole", "[figure]") {
  const NameWithUnit solved{"share of solves within 0.001 cm and 0.05 deg, inside the joint limits", ""};
  CHECK(contains(value_axis(std::vector<double>{0, 1}, solved, Scale::linear).settings,
                 R"('share of solves within 0.001 cm and'."\n".'0.05 deg, inside the joint limits')"));
}

TEST_CASE("a logarithmic axis shows zero at its lower edge, a decade below the rest", "[figure]") {
  const Axis axis = value_axis(std::vector<double>{0, 0.02, 3}, {"x", "cm"}, Scale::logarithmic);
  CHECK(axis.shows_at_edge);
  CHECK(contains(axis.settings, "set yrange [1e-3:1e1]"));
  CHECK(contains(axis.settings, "set ytics add ('0' 1e-3)"));
}

TEST_CASE("on a logarithmic axis rounding is at the lower edge, unless all is rounding", "[figure]") {
  const Axis axis = value_axis(std::vector<double>{1e-13, 1e-3, 3}, {"x", "cm"}, Scale::logarithmic, 1e-7);
  CHECK(axis.shows_at_edge);
  CHECK(contains(axis.settings, "set yrange [1e-4:1e1]"));
  CHECK(contains(axis.settings, "set ytics add ('≤1e-07' 1e-4)"));
  CHECK(contains(axis.settings, "shown(y) = y > 1e-07 ? y * 1 : (y <= 1e-07 ? 1e-4 : NaN)"));
  const Axis of_rounding = value_axis(std::vector<double>{1e-15, 3e-14}, {"x", "cm"}, Scale::logarithmic, 1e-7);
  CHECK(!of_rounding.shows_at_edge);
  CHECK(contains(of_rounding.settings, "set yrange [1e-15:1e-13]"));
}

TEST_CASE("the unit of a time is the same on the axis and in the caption", "[figure]") {
  const auto figures = figures_of(synthetic::solves({.runs = 2}));
  for (const char* name : {"figure-8", "figure-12"}) {
    CHECK(named(figures, name).caption.starts_with("Computing time [ms]: "));
    CHECK(contains(named(figures, name).settings, "computing time [ms]"));
  }
  const Axis logarithmic = value_axis(std::vector<double>{1e-4, 0.05}, {"time", "s"}, Scale::logarithmic);
  CHECK(logarithmic.quantity == "time [ms]");
  CHECK(contains(logarithmic.settings, "set yrange [1e-1:1e2]"));
}

TEST_CASE("the path is drawn with the arm at its first point", "[figure]") {
  auto solves = synthetic::solves({.solvers = {"IK-BA"}, .runs = 1});
  for (SolveRecord& solve : solves) solve.answer_rad = {0};
  const Figure figure = path_figure(make_study(StudyEntry{.name = "s",
                                                          .definition = R"({"path": {"kind": "helix"},
                                              "arm": {"links": [{"joint": "turns", "offset_deg": 0, "d_m": 0.5,
                                                                 "a_m": 0.25, "alpha_deg": 0}],
                                                      "base": {"position_m": [0, 0, 0], "rpy_deg": [0, 0, 0]},
                                                      "tool": {"position_m": [0, 0, 0], "rpy_deg": [0, 0, 0]}}})",
                                                          .series = {}},
                                               solves),
                                    "path");
  CHECK(contains(figure.data, "from the base to the tool: x, y, z [cm]\n0 0 0 \n0 0 50 \n25 0 50 \n"));
  for (const char* label : {"'path'", "'target'", "'reached'", "'arm at point 1'"}) CHECK(contains(figure.plot, label));
}

TEST_CASE("where no arm is drawn, a mark is at the first target", "[figure]") {
  const StudyResults study =
      make_study(StudyEntry{.name = "s", .definition = R"({"path": {"kind": "helix"}})", .series = {}},
                 synthetic::solves({.runs = 1}));
  CHECK(contains(path_figure(study, "path").plot, "every ::0::0 using 1:2:3 with points"));
  CHECK(contains(path_figure(study, "path").plot, "title 'start'"));
}

TEST_CASE("panels in a row share the first one's numbers on the axis", "[figure]") {
  const Figure figure =
      *joints_figure(make_study("s", synthetic::solves({.runs = 1})), "joints");  // six, three in a row
  std::vector<std::string> formats;
  for (std::size_t at = 0; (at = figure.plot.find("set format y ", at)) != std::string::npos; ++at) {
    formats.push_back(figure.plot.substr(at + 13, figure.plot.find('\n', at) - at - 13));
  }
  CHECK(formats == std::vector<std::string>{"'%g'", "''", "''", "'%g'", "''", "''"});
}

TEST_CASE("several panels have letters, and angles outside the joint limits have rings", "[figure]") {
  std::vector<SolveRecord> solves = synthetic::dobot_solves();
  const auto drawn = [&] {
    return *joints_figure(
        make_study(StudyEntry{.name = "s", .definition = synthetic::dobot_definition, .series = {}}, solves), "joints");
  };
  CHECK(contains(drawn().plot, "set title 'IK-BA'"));
  CHECK(!contains(drawn().caption, "Rings"));
  for (const SolveRecord& solve : synthetic::dobot_solves()) {
    solves.push_back(solve);
    solves.back().solver = "BA";
  }
  solves.back().answer_rad[0] = 2;  // rad; its limit is 90 deg
  CHECK(contains(drawn().plot, "set title '(a) IK-BA'"));
  CHECK(contains(drawn().plot, "set title '(b) BA'"));
  CHECK(contains(drawn().plot, "using 1:($2 < -90.000001 || $2 > 90.000001 ? $2 : NaN) with points"));
  CHECK(contains(drawn().caption, "Rings: angles outside them."));
}

TEST_CASE("numbers from elsewhere stand in grey below the values of their group", "[figure]") {
  const StudyResults study = make_study("s", synthetic::solves({.solvers = {"A", "B"}, .runs = 3}));
  const Figure figure =
      box_figure(study, Metric::position_error_cm, "boxes", {{"B", 5e-5, 0.01, 0.02, true}, {"unknown", 1, 2, 3}});
  CHECK(figure.data.ends_with(
      "# marks: row, smallest, median, largest, whether the smallest is less\n2 5e-05 0.01 0.02 1\n"));
  CHECK(contains(figure.plot, "($5==1 ? shown($2) : NaN):($1+0.4):(shown($4)-shown($2)):(0) with vectors backhead"));
  CHECK(contains(figure.plot, "data index 3 using"));
}

TEST_CASE("a printed minimum of zero is below its last digit", "[figure][paper]") {
  StudyResults study = make_study("s", synthetic::solves({.runs = 3}));
  study.facts.published = "slim2023";
  CHECK(contains(named(paper_figures(study), "figure-10").caption,
                 "Arrow: the printed minimum of PSO is 0, so below 5e-05."));
}

TEST_CASE("small times are shown in milli- and microseconds", "[figure]") {
  CHECK(contains(value_axis(std::vector<double>{0.002}, {"time", "s"}, Scale::linear).settings, "time [ms]"));
  CHECK(contains(value_axis(std::vector<double>{2e-6}, {"time", "s"}, Scale::linear).settings, "time [µs]"));
  CHECK(contains(value_axis(std::vector<double>{2.0}, {"time", "s"}, Scale::linear).settings, "time [s]"));
}
