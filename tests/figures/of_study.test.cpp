// Which figures a judged study has, and the rows that its solves give.
#include "tests/figures/drawn.hpp"

namespace {

using Names = std::vector<std::string>;

const std::string planar_arm =
    R"(, "arm": {"links": [{"joint": "turns", "offset_deg": 0, "d_m": 0, "a_m": 1, "alpha_deg": 0, "limits_deg": [-90, 90]},
       {"joint": "slides", "offset_deg": 0, "d_m": 0, "a_m": 1, "alpha_deg": 0, "limits_m": [-2, 2]},
       {"joint": "turns", "offset_deg": 0, "d_m": 0, "a_m": 1, "alpha_deg": 0, "limits_deg": [-45, 45]}],
       "base": {"position_m": [0, 0, 0], "rpy_deg": [0, 0, 0]}, "tool": {"position_m": [0, 0, 0], "rpy_deg": [0, 0, 0]}})";

// Errors of A are 0.1, 0.2, ... [cm] by run, those of B ten times as large.
void differ(SolveRecord& solve) { solve.position_error_cm = 0.1 * solve.run * (solve.label == "A" ? 1 : 10); }

Look look_of_study(const StudyResults& study, results::FigureStyle style = {}) {
  return look_of(study.series, std::move(style));
}

Names names_of(const std::vector<Figure>& figures) {
  Names names;
  for (const Figure& figure : figures) names.push_back(figure.name);
  return names;
}

const Figure& named(const std::vector<Figure>& figures, std::string_view name) {
  return *std::ranges::find(figures, name, &Figure::name);
}

std::vector<Figure> figures_of_study(const StudyResults& study) {
  const JudgedStudy judged = judge::judge(study);
  return of_study(judged, look_of(judged, {}));
}

}  // namespace

TEST_CASE("a path has curves by point, the path and the joints", "[of_study]") {
  const StudyResults asked = study({.rest = planar_arm}, differ);
  const std::vector<Figure> figures = figures_of_study(asked);
  CHECK(names_of(figures) == Names{"overview", "error-boxes", "time-boxes", "motion-boxes", "error-by-point",
                                   "motion-by-point", "time-by-point", "differences", "path", "joints"});
  const ScratchFolder folder;
  CHECK(drawn_as_svg(figures, folder.path) == "");
  CHECK(contains(figures[1].caption, "Each dot is the mean of one run"));
  const auto caption_of = [](const Asked& other) {
    return named(figures_of_study(study(other, differ)), "error-boxes").caption;
  };
  CHECK(contains(caption_of({.start = "initial"}), "Each dot is one target, as the mean of its runs;"));
  CHECK(contains(caption_of({.start = "initial", .runs = 1}), "Each dot is one target;"));
  CHECK(contains(caption_of({.start = "initial", .points = 1}), "Each dot is one run;"));
  CHECK(contains(caption_of({.start = "initial", .targets = "drawn", .points = 1}), "Each dot is one target;"));
  CHECK(contains(figures[2].caption, "Each dot is the median of one run"));
  const CurveRow row = by_point(asked, "position_error_cm", look_of_study(asked), Average::median).at(0).rows.at(0);
  CHECK(row.x == 1);
  CHECK(row.low == Approx(1.75));  // of 1 to 5 mm, by Hyndman and Fan's type 5
  CHECK(row.y == Approx(3));
  CHECK(row.high == Approx(4.25));
  const StudyResults fails = study({}, [](SolveRecord& solve) {
    if (solve.label == "B") solve.status = Status::crashed;
  });
  CHECK(by_point(fails, "position_error_cm", look_of_study(fails), Average::median).size() == 1);  // of A
}

TEST_CASE("drawn targets with a tolerance have shares, and no number of solved ones alone", "[of_study]") {
  const StudyResults asked =
      study({.start = "middle", .targets = "drawn", .tolerance_cm = 0.01, .rest = planar_arm}, [](SolveRecord& solve) {
        differ(solve);
        solve.timing = results::Timing::parallel;
        solve.status = solve.label == "B" && solve.run == 1 ? Status::crashed : Status::ok;
      });
  const std::vector<Figure> figures = figures_of_study(asked);
  CHECK(names_of(figures) == Names{"error-shares", "solved-by-evaluations", "targets", "differences"});
  CHECK(contains(figures[2].data, "# A\nNaN NaN\n0 20\n\n\n# B\nNaN NaN\n0 16\n"));
  CHECK(!contains(figures[2].caption, "solved by none"));
  CHECK(contains(figures[1].data, "# A\n0 0\n100 100\n1e+300 100\n\n\n# B\n0 0\n100 80\n1e+300 80\n"));
  CHECK(contains(figures[0].data, "# A\n0 0\n1 20\n2 40\n"));                          // [mm]
  CHECK(contains(figures[0].data, "4 80\n5 100\n1e+300 100\n\n\n# B\n0 0\n20 20\n"));  // none of a crash
  const auto fails = [](SolveRecord& solve) { solve.status = solve.label == "A" ? Status::crashed : Status::ok; };
  const auto many =
      figures_of_study(study({.tolerance_cm = 0.01}, fails, {"A", "B", "C", "D", "E", "F", "G", "H", "I"}));
  CHECK(contains(named(many, "error-shares").data, "]\n# A\n"));  // the study's first, though it is the last
  CHECK(named(many, "error-shares").caption.ends_with("Left out: H and I; only 7 are drawn."));
}

TEST_CASE("solvers whose costs are not known or not comparable are left out of shares, by name", "[of_study]") {
  const StudyResults asked = study({.start = "middle", .targets = "drawn", .tolerance_cm = 0.01},
                                   [](SolveRecord& solve) {
                                     if (solve.label == "A") solve.counted_by = CountedBy::none;
                                     if (solve.label == "B" || solve.label == "D")
                                       solve.timing = results::Timing::process;
                                     if (solve.label > "B") solve.status = Status::tolerance_missed;
                                   },
                                   {"A", "B", "C", "D"});
  const std::vector<Figure> figures = figures_of_study(asked);
  CHECK(named(figures, "solved-by-evaluations").caption ==
        "Share of targets solved within a number of evaluations. Left out: A, whose evaluations cannot be compared.");
  CHECK(
      named(figures, "solved-by-time").caption ==
      "Share of targets solved within a time. Times: first calls on a target. Left out: B and D, whose time cannot be compared.");
}

TEST_CASE("a difference is told as tables tell it: the better one first, in points or a ratio", "[of_study]") {
  const auto differences_of = [](const Asked& asked) -> Figure {
    return named(figures_of_study(study(asked,
                                        [](SolveRecord& solve) {
                                          differ(solve);
                                          const bool fails = solve.label == "B" && solve.run < 9;
                                          solve.status = fails ? Status::tolerance_missed : Status::ok;
                                        },
                                        {"B", "A"})),
                 "differences");
  };
  const Figure shares =
      differences_of({.start = "middle", .targets = "drawn", .runs = 10, .points = 1, .tolerance_cm = 0.01});
  CHECK(contains(shares.data, "# A - B\n1 80 "));
  CHECK(contains(shares.settings, "'better'"));
  const Figure ratios = differences_of({.runs = 10});
  CHECK(contains(ratios.data, "# A / B\n1 0."));
  CHECK(contains(ratios.settings, "logscale"));
}

TEST_CASE("differences are those that were tested, in the order of the table; of many solvers those of the best",
          "[of_study]") {
  const auto rows_of = [](const std::vector<std::string>& solvers) {
    const StudyResults asked = study(
        {.runs = 12},
        [&](SolveRecord& solve) {
          const auto place = std::ranges::find(solvers, solve.label) - solvers.begin();
          solve.position_error_cm = (1 + 0.01 * solve.run) / static_cast<double>(1 + place);  // the last is the best
        },
        solvers);
    const std::vector<Figure> figures = figures_of_study(asked);
    const auto found = std::ranges::find(figures, "differences", &Figure::name);
    Names rows;
    for (std::size_t at = 0; found != figures.end() && (at = found->data.find("\n# ", at)) != std::string::npos; ++at)
      rows.push_back(found->data.substr(at + 3, found->data.find('\n', at + 1) - at - 3));
    return rows;
  };
  CHECK(rows_of({"A"}).empty());
  CHECK(rows_of({"A", "B", "C"}) == Names{"C / B", "C / A", "B / A"});
  CHECK(rows_of({"A", "B", "C", "D", "E", "F", "G"}) == Names{"G / …", "F", "E", "D", "C", "B", "A"});
}

TEST_CASE("mean ranks are those of the blocks, with a critical difference where all have all, and are none of means",
          "[of_study]") {
  MetricSamples of{
      .metric = "error", .quantity = "error", .unit = "mm", .kind = Ratios{.floor = 1e-9}, .is_paired = true};
  std::vector<results::Series> solvers;
  for (int s = 0; s < 4; ++s) {
    Sample sample;
    for (int i = 0; i < 20; ++i) sample.values.push_back(1 + s * (i % 4 == 0 ? 1 : 3) % 4 + 0.01 * i);
    of.groups.push_back({.name = std::string(1, static_cast<char>('A' + s)), .sample = std::move(sample)});
    solvers.push_back({.label = of.groups.back().name, .algorithm = "x"});
  }
  const Look look = look_of(solvers, {});
  const auto ranked = [&](const AnalysisPlan& plan) {
    return ranks_of(judge::judge(of, plan), {"A", "B", "C", "D"}, look);
  };
  const Figure figure = ranked({}).value();
  CHECK(contains(figure.data, "# A\n1 1 "));  // the first in each block; of B, C and D every fourth is turned
  CHECK(contains(figure.data, "# D\n2 2.5 "));
  CHECK(contains(figure.data, "# B\n4 3.5 "));
  CHECK(contains(figure.settings, "CD 1.05"));  // 2.569 sqrt(4 * 5 / (6 * 20))
  CHECK(contains(figure.caption, "critical difference"));
  CHECK_FALSE(contains(ranked({.significance = 0.01})->caption, "critical"));
  CHECK_FALSE(ranked({.test = AnalysisPlan::Test::means}));
  CHECK_FALSE(ranked({.control = "A"}));
  of.is_paired = false;
  const std::string unpaired = ranked({})->caption;
  CHECK(contains(unpaired, "A12"));
  CHECK_FALSE(contains(unpaired, "critical"));
  of.is_paired = true;
  of.groups[1].sample = ExcludedSample{.reason = ExclusionReason::not_comparable};
  CHECK(contains(ranked({})->caption, "0.741"));  // of three alone: 2.344 sqrt(3 * 4 / (6 * 20))
  CHECK(contains(ranked({})->caption, "all: B."));
  of.groups[2].sample = ExcludedSample{.reason = ExclusionReason::not_comparable};
  CHECK_FALSE(ranked({}));
}

TEST_CASE("the plan's metric has boxes, whatever it is", "[of_study]") {
  const auto names = [](const std::string& metric) {
    return names_of(figures_of_study(study({.start = "middle",
                                            .targets = "drawn",
                                            .tolerance_cm = 0.01,
                                            .rest = fmt::format(R"(, "analysis": {{"metric": "{}"}})", metric)},
                                           differ)));
  };
  CHECK(std::ranges::count(names("position_error_cm"), "error-boxes") == 1);
  CHECK(std::ranges::count(names("iterations"), "metric-boxes") == 0);  // each solver's are of what it solved
  CHECK(std::ranges::count(names("solved"), "metric-boxes") == 0);
}

TEST_CASE("traces are curves by iteration; a solve that ended keeps its last error", "[of_study]") {
  const StudyResults traced = study({.runs = 2, .points = 1}, [](SolveRecord& solve) {
    if (solve.label == "A") solve.trace_cm = solve.run == 1 ? std::vector<double>{4, 2} : std::vector<double>{8, 8, 6};
  });
  const std::vector<Line> all = by_iteration(traced, look_of_study(traced), Average::median);
  REQUIRE(all.size() == 2);
  CHECK(all[1].rows.empty());  // B has no trace
  REQUIRE(all[0].rows.size() == 3);
  CHECK(all[0].rows[0].y == Approx(60));  // [mm]
  CHECK(all[0].rows[2].y == Approx(40));
  CHECK(all[0].rows[2].low == Approx(20));
  CHECK(std::ranges::count(names_of(figures_of_study(traced)), "error-by-iteration") == 1);
}

TEST_CASE("joints are the turning ones of the first run, in degrees", "[of_study]") {
  const StudyResults asked = study({.points = 2, .rest = planar_arm}, [](SolveRecord& solve) {
    solve.answer_rad = {solve.run * 3.14159265358979312 / 6, 7, 0};
  });
  const auto [rows, columns] = joint_rows(asked, look_of_study(asked));
  REQUIRE(columns.size() == 2);
  CHECK(columns[1].label == "3");
  CHECK(columns[1].upper_deg == Approx(45));
  REQUIRE(rows.size() == 2);
  REQUIRE(rows[0].angles_deg.size() == 2);
  CHECK(rows[0].angles_deg[0][0] == Approx(30));
}

TEST_CASE("chosen solvers are drawn alone, in their order, in their colours", "[of_study]") {
  const StudyResults asked = study({}, differ, {"A", "B", "C"});
  const Look all = look_of_study(asked), chosen = look_of_study(asked, {.solvers = {"C", "B"}});
  CHECK(drawn_solvers(asked, chosen) == Names{"C", "B"});
  CHECK(all.lines == std::map<std::string, int>{{"A", 1}, {"B", 2}, {"C", 3}});
  const Look short_palette = look_of_study(asked, {.palette = {"#8D1804", "#1E8CF8"}, .solvers = {"C", "B"}});
  CHECK(short_palette.lines == std::map<std::string, int>{{"A", 3}, {"B", 2}, {"C", 1}});
  const std::vector<BoxRow> rows = box_rows(make_samples_by_target(asked, metric_named("seconds")), {"ms", 1000},
                                            drawn_solvers(asked, chosen), chosen);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].label == "C");
  CHECK(rows[0].box[2] == Approx(1));  // [ms]
  CHECK(rows[0].style == chosen.lines.at("C"));
}

TEST_CASE("the paper's figures have the printed numbers beside ours", "[of_study]") {
  const std::string published = R"(, "published": "slim2023")" + planar_arm;
  const StudyResults helix = study({.rest = published}, differ, {"IK-BA", "BA"});
  const std::vector<Figure> figures = slim2023::figures_of(judge::judge(helix), look_of_study(helix));
  CHECK(names_of(figures) == Names{"overview", "figure-5", "figure-6", "figure-7", "figure-8", "figure-9", "figure-10",
                                   "figure-11", "figure-12"});
  CHECK(contains(figures[6].data, " 0.0016 0.0019 0.0022\n"));  // Table 3, in its unit
  CHECK(contains(figures[8].data, "NaN NaN NaN\n"));            // no times of another machine
  const StudyResults circle =
      study({.runs = 1, .rest = R"(, "published": "slim2023", "robot": "dobot_magician")" + planar_arm},
            [](SolveRecord& solve) {
              solve.trace_cm = {1, 0.5};
            },
            {"IK-BA"});
  StudyResults on_circle = circle;
  on_circle.definition.path = "circle";
  const std::vector<Figure> of_circle = slim2023::figures_of(judge::judge(on_circle), look_of_study(on_circle));
  CHECK(names_of(of_circle) == Names{"figure-15", "figure-16", "figure-17", "figure-18"});
  CHECK(contains(of_circle[2].data, "# paper\n1 2.04e-14 "));
  const ScratchFolder folder;
  CHECK(drawn_as_svg(figures, folder.path) == "");
  CHECK(drawn_as_svg(of_circle, folder.path) == "");
}
