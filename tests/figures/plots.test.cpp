// The kinds of figures: what their data files have, and that gnuplot draws them whatever the labels are.
#include "tests/figures/drawn.hpp"

namespace {

const std::string hostile = "'\"`;!touch pwned`$H#@x{}\\^_%s ]]> &<b>\xFF\n\u20ac";

About error_in(const std::string& name) { return {name, name, "error", "cm", 1e-7}; }

std::vector<Figure> every_kind(const std::string& label) {
  const About about = error_in(label.size() > 20 ? "x" : "y");
  const auto named = [&](const char* name) {
    About own = about;
    own.name += name;
    own.quantity = label;
    return own;
  };
  std::vector<Figure> all{path(named("path"), {.targets = {{1, 2, 3}, {2, 3, 4}},
                                               .reached = {{1, 2, 3}, {nowhere, 0, 0}},
                                               .arms = {{label, {{0, 0, 0}, {1, 1, 1}}}},
                                               .reached_label = label})};
  for (const std::optional<Figure>& figure : {
           boxes(named("boxes"), {{.label = label,
                                 .values = {1, 2, 300},
                                 .box = {1, 1.5, 2, 3, 300},
                                 .printed = {0, 1, 2},
                                 .remark = label},
                                  {.label = label, .style = 9}}),
           curves(named("curves"), {.title = label},
                  {{label, 1, {{1, 0, 0, 0.5}, {2, 3, 1, 4}}}, {label, 0, {{1, 1000}, {2, nowhere}}}, {label, 2}}),
           shares(named("shares"), "solved", {{label, 1, {3, 5}, 4}, {label, 2, {}, 4}}, 4),
           ranks(named("ranks"), {{label, 1, 1.2}, {label + "2", 2, 1.5, {"x"}}, {"x", 3, 3, {label + "2"}}}, 0.9),
           differences(named("ratios"), {{label, 2, 0.5, 4, label, 2}, {label}, {label, 1, 0.9, double{INFINITY}}},
                       true),
           differences(named("differences"), {{label, -2, -5, 4}, {label, 0, 0, 0}}, false),
           std::optional(solved_rows(named("targets"), {{label, 1, {true, false}}, {label, 2, {false, false}}}, 1)),
           joints(named("joints"), {{{label, 1, {{10, 20}, {15, 95}}}, {label, 2}}, {{label, -90, 90}, {label}}}),
           overview(named("overview"), label,
                    {{label, 1, 10, 0.5, 20, 0.1}, {label, 2, 1, 1}, {label, 2, nowhere, nowhere}}),
       })
    all.push_back(figure.value());
  return all;
}

}  // namespace

TEST_CASE("bars join solvers that are not told apart, few of them, and each such pair", "[plots]") {
  // Of 20 drawn sets of pairs: what bars join is what is not apart.
  std::mt19937_64 engine(7);
  for (std::size_t n = 3; n <= 22; ++n) {
    std::vector<RankRow> rows;
    for (std::size_t i = 0; i < n; ++i) rows.push_back({fmt::format("S{}", i), 1, static_cast<double>(i)});
    std::set<std::pair<std::size_t, std::size_t>> alike, joined;
    const std::size_t drawn = std::min<std::size_t>(n, 20);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        if (engine() % 3 > 0)
          rows[i].apart.push_back(rows[j].label), rows[j].apart.push_back(rows[i].label);
        else if (j < drawn)
          alike.emplace(i, j);
      }
    }
    const Figure figure = ranks(error_in("ranks"), rows).value();
    std::istringstream lines(figure.data);
    std::vector<std::vector<int>> bars;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with('#')) continue;
      std::istringstream numbers(line);
      bars.emplace_back();
      for (double number; numbers >> number;) bars.back().push_back(static_cast<int>(number));
    }
    REQUIRE(bars.size() == drawn);
    for (std::size_t b = 2; b < bars[0].size(); ++b) {
      for (std::size_t i = 0; i < drawn; ++i) {
        for (std::size_t j = i + 1; j < drawn; ++j) {
          if (bars[i][b] == 1 && bars[j][b] == 1) joined.emplace(i, j);
        }
      }
    }
    CHECK(joined == alike);
  }
}

TEST_CASE("every kind is drawn, and no label of a user is run or breaks the picture", "[plots]") {
  const ScratchFolder folder;
  for (const std::string& label : {hostile, std::string("mine"), std::string()}) {
    const std::vector<Figure> figures = every_kind(label);
    REQUIRE(drawn_as_svg(figures, folder.path) == "");
    if (label != hostile) continue;
    for (const Figure& figure : figures) {
      if (figure.name == "xarm") continue;  // has no label
      CAPTURE(figure.name);
      const std::string svg = text_in(folder.path / (figure.name + ".svg"));
      CHECK(contains(svg, "touch pwned"));  // as text
      CHECK_FALSE(contains(svg, "<b>"));
    }
    CHECK_FALSE(std::filesystem::exists(folder.path / "pwned"));
  }
}

TEST_CASE("a figure without a mark is none", "[plots]") {
  const About about = error_in("a");
  CHECK_FALSE(boxes(about, {{.label = "A", .remark = "3 missing"}}));
  CHECK_FALSE(curves(about, {.title = "point"}, {{.label = "A", .rows = {{1, nowhere}}}}));
  CHECK_FALSE(shares(about, "solved", {{"A", 1, {}, 4}, {"B", 2, {2001}, 4}}, 2));
  CHECK_FALSE(differences(about, {{.label = "A - B", .verdict = "not decided"}}, false));
  CHECK_FALSE(overview(about, "x", {{.label = "A", .x = 1}, {.label = "B", .x = 1, .y = 1}}));  // one is none
  CHECK_FALSE(joints(about, {{{.label = "A"}}, {{"joint 1"}}}));
}

TEST_CASE("the word at the dashed line stays clear of the names beside the right edge", "[plots]") {
  const auto settings_of = [](std::vector<double> errors) {
    return shares(error_in("a"), "solved", {{"A", 1, errors, 4}, {"B", 2, errors, 4}}, 2).value().settings;
  };
  CHECK(contains(settings_of({0.01, 0.02, 2}), "'tolerance' at 2, graph 1 right"));
  CHECK(contains(settings_of({1, 20, 1000}), "'tolerance' at 2, graph 1 left"));
}

TEST_CASE("seven lines are drawn, their names in order and none above another", "[plots]") {
  std::vector<Line> lines;
  for (int i = 0; i < 10; ++i)
    lines.push_back({fmt::format("solver {}", i), i + 1, {{1, 5}, {2, i < 5 ? 9 : 6.0 / (i + 1)}}});
  const Figure figure = *curves(error_in("c"), {.title = "point"}, lines);
  CHECK(figure.caption == "c Left out: solver 7, solver 8 and solver 9; only 7 are drawn.");
  CHECK(contains(figure.data, "# solver 9\n1 5 NaN NaN\n2 0.6 NaN NaN\n"));
  CHECK_FALSE(contains(figure.plot, "data index 7"));
  std::vector<double> heights;
  for (int i = 0; i < 7; ++i) {
    const std::size_t at =
        figure.settings.find("graph ", figure.settings.find(fmt::format("set label 'solver {}'", i)));
    heights.push_back(std::stod(figure.settings.substr(at + 6)));
  }
  const double row = 0.34 / (figure.height_cm - 1.3);
  CHECK(heights[3] == Approx(std::min(9 / 9.45 - row, 1 - 3 * row)));  // around the ends of all five
  for (std::size_t i = 0; i < heights.size(); ++i) {
    CHECK((0 <= heights[i] && heights[i] <= 1));
    if (i > 0) CHECK(heights[i - 1] - heights[i] >= Approx(row));
  }
  lines[9].label += " by a name that is long";  // not drawn, so that it takes no room
  CHECK(curves(error_in("c"), {.title = "point"}, lines)->legend == 0);
  lines[0].label = "solver 0 by a name that is long";
  const Figure below = *curves(error_in("c"), {.title = "point"}, lines);
  CHECK(below.legend == 7);
  CHECK(contains(below.settings, "set label 'solver 6' at screen 0.05, screen up(0.35)"));
  lines.resize(1);
  CHECK_FALSE(contains(curves(error_in("c"), {.title = "point"}, lines)->settings, "solver 0"));
}

TEST_CASE("a box has its five numbers, what is printed, and all values", "[plots]") {
  const Figure figure =
      *boxes(error_in("b"), {{.label = "A", .values = {3, 1}, .box = {1, 1.5, 2, 2.5, 3}, .printed = {0.5, 2, 4}},
                             {.label = "B", .values = {7, INFINITY}, .box = {7, 7, 7, INFINITY, INFINITY}}});
  CHECK(figure.data ==
        "# row; smallest, lower quartile, median, upper quartile, largest; as printed: smallest, median, largest\n"
        "# A\n1 1 1.5 2 2.5 3 0.5 2 4\n# B\n2 7 7 7 1e+300 1e+300 NaN NaN NaN\n"
        "\n\n# values of A: value, height\n1 1.143606797749979\n3 1.067213595499958\n"
        "\n\n# values of B: value, height\n7 2.143606797749979\n1e+300 2.067213595499958\n");
  CHECK(figure.caption == "b At the right edge: no answer.");
  std::vector<double> many(1000);
  for (std::size_t i = 0; i < many.size(); ++i) many[i] = static_cast<double>(i);
  const Figure thinned = *boxes(error_in("b"), {{.label = "A", .values = many}});
  CHECK(std::ranges::count(thinned.data, '\n') == 2 + 1 + 3 + 200);
  CHECK(contains(thinned.data, "\n0 "));
  CHECK(contains(thinned.data, "\n999 "));
}

TEST_CASE("an axis is as wide for values that differ in their last digit as for equal ones", "[plots]") {
  for (const double value : {1.0, 8.3e-4, 1e300, 5e-324}) {
    CAPTURE(value);
    const auto drawn = [&](double other) { return boxes(error_in("b"), {{.label = "A", .values = {value, other}}}); };
    CHECK(contains(drawn(std::nextafter(value, 2 * value))->settings, "set xrange ["));
    if (std::abs(value) > 1e-300)  // no next one is near the smallest number
      CHECK(drawn(std::nextafter(value, 2 * value))->settings == drawn(value)->settings);
  }
}

TEST_CASE("curves have a row for each x", "[plots]") {
  const Figure figure = *curves(error_in("c"), {.title = "point"}, {{"A", 1, {{1, 0.5, 0.25, 1}, {2, 0.125}}}});
  CHECK(figure.data == "# point; error [cm]; low, high\n# A\n1 0.5 0.25 1\n2 0.125 NaN NaN\n");
}

TEST_CASE("shares rise at the costs of those that succeeded", "[plots]") {
  const Figure figure =
      *shares({.name = "s", .caption = "", .quantity = "evaluations"}, "solved", {{"A", 1, {8, 2, 2}, 4}});
  CHECK(figure.data == "# evaluations, share of all attempts [%]\n# A\n0 0\n2 50\n8 75\n1e+300 75\n");
}

TEST_CASE("the overview begins at 0 and says who is not in it", "[plots]") {
  const Figure figure =
      *overview(error_in("o"), "motion", {{"A", 1, 543, 7}, {"B", 2, 549, 88}, {"C", 3, 1, INFINITY}});
  CHECK(figure.caption == "o Without C.");
  CHECK(contains(figure.settings, "set xrange [0:"));
}

TEST_CASE("differences have their intervals, also open ones", "[plots]") {
  const Figure figure = *differences(error_in("d"), {{"A - B", 1, -2, INFINITY, "not decided"}, {"A - C"}}, false);
  CHECK(contains(figure.plot, "with vectors head "));  // beyond the axis
  CHECK(contains(differences(error_in("r"), {{"A / B", 0.3, 0, 0.5}}, true)->plot, "with vectors backhead "));
  CHECK(contains(differences(error_in("r"), {{"A /\nB", 0.3, 0, 0.5}}, true)->settings, R"(('A /'."\n".'B' 1))"));
  CHECK(figure.data == "# row, difference, low, high\n# A - B\n1 1 -2 1e+300\n# A - C\n2 NaN NaN NaN\n");
}

TEST_CASE("targets side by side are one box, and of many only some are drawn", "[plots]") {
  const About about{.name = "targets", .quantity = "targets"};
  const Figure few =
      solved_rows(about, {{"A", 1, {true, true, false, true}}, {"B", 2, {false, true, false, false}}}, 4);
  CHECK(few.data == "# targets that are solved: after, to\n# A\nNaN NaN\n0 2\n3 4\n\n\n# B\nNaN NaN\n1 2\n");
  CHECK(!contains(few.settings, "rectangle"));
  std::vector<bool> every_second(10'000);
  for (std::size_t i = 0; i < every_second.size(); ++i) every_second[i] = i / 20 % 2 == 0;
  const Figure many = solved_rows(about, {{"A", 1, every_second}}, 9'980);
  CHECK(std::ranges::count(many.data, '\n') == 3 + 250);
  CHECK(contains(many.data, "\n9960 9980\n"));
  CHECK(contains(many.settings, "from 9980, graph 0 to 10000, graph 1"));
  CHECK(many.caption.ends_with("Only 500 targets, at even ranks, are drawn."));
}

TEST_CASE("a path has its targets and what was reached, and the arm follows", "[plots]") {
  const Figure figure = path(error_in("p"), {.targets = {{1, 2, 3}, {4, 5, 6}},
                                             .reached = {{1, 2, 2.5}, {nowhere, nowhere, nowhere}},
                                             .arms = {{"arm", {{0, 0, 0}, {1, 1, 1}}}}});
  CHECK(
      figure.data ==
      "# target x, y, z; reached x, y, z [cm]\n1 2 3 1 2 2.5\n4 5 6 NaN NaN NaN\n\n\n# arm: x, y, z [cm]\n0 0 0\n1 1 1\n");
}

TEST_CASE("each axis of a path has its title and at least two ticks", "[plots]") {
  for (double size = 1; size < 100; size *= 1.07) {
    const double shift = 0.3 * size;
    const Figure figure = path(error_in("p"), {.targets = {{shift, -shift, size}, {size, size / 2, shift}},
                                               .reached = {{0, 0, 0}, {1, 1, 1}}});
    for (const std::string axis : {"x", "y", "z"}) {
      CAPTURE(size, figure.settings);
      const auto number_after = [&](const std::string& words) {
        const std::size_t at = figure.settings.find(words);
        REQUIRE(at != std::string::npos);
        return std::strtod(figure.settings.c_str() + at + words.size(), nullptr);
      };
      const double low = number_after("set " + axis + "range ["), step = number_after("set " + axis + "tics ");
      const std::size_t colon = figure.settings.find(':', figure.settings.find("set " + axis + "range ["));
      const double high = std::strtod(figure.settings.c_str() + colon + 1, nullptr);
      CHECK(std::floor(high / step) - std::ceil(low / step) + 1 >= 2);
      CHECK(contains(figure.settings, "set label '" + axis + " [cm]' at "));
    }
  }
}

TEST_CASE("joints have a panel each, and angles outside the limits are told", "[plots]") {
  const std::vector<JointColumn> columns{{"joint 1", -90, 90}, {"joint 2"}};
  const Figure inside = *joints(error_in("j"), {{{"A", 1, {{10, 200}, {-90, 0}}}}, columns});
  CHECK(inside.data == "# A: point, angle of each joint [deg]\n1 10 200\n2 -90 0\n");
  CHECK_FALSE(contains(inside.caption, "outside"));
  const Figure outside = *joints(error_in("j"), {{{"A", 1, {{91, 0}}}, {"B", 2, {{0, 0}}}}, columns});
  CHECK(contains(outside.caption, "Rings mark angles outside the limits."));
  CHECK(contains(outside.settings, "(b) B"));
  const std::vector<JointRow> nine(9, {"A", 1, {{10, 200}}});
  CHECK(contains(joints(error_in("j"), {nine, columns})->settings, "'7 of 9'"));
}

TEST_CASE("an axis is logarithmic from a factor of 30 on, and says what lies at its edge", "[plots]") {
  const auto axis = [](const std::vector<double>& values) {
    return value_axis('y', values, error_in("a"), Begins::at_zero).settings;
  };
  CHECK_FALSE(contains(axis({1, 30}), "logscale"));
  CHECK_FALSE(contains(axis({-1, 100}), "logscale"));
  CHECK(contains(axis({1, 31}), "set yrange [1:40.3"));
  CHECK_FALSE(contains(axis({1, 31}), "≤"));
  CHECK(contains(axis({1e-9, 1e-5, 1}),
                 "place_y(v) = v < 1.0000000000000002e-06 ? 1.0000000000000002e-06 : v > 1 ? 1 : v"));
  CHECK(contains(axis({1e-9, 1e-5, 1}), "'≤ 10{/*0.7 ^{−7}}' 1.0000000000000002e-06"));
  About near = error_in("a"), share = error_in("a");
  share.is_share = true;
  CHECK_FALSE(contains(value_axis('y', std::vector<double>{3, 73, 100}, share, Begins::at_zero).settings, "logscale"));
  near.floor = 0.1;  // a tolerance, just below the other values
  const std::string at_tolerance = value_axis('x', std::vector<double>{0.1, 0.11, 90}, near, Begins::around).settings;
  CHECK(contains(at_tolerance, "set xtics ('' 0.2 1,"));
  CHECK(contains(at_tolerance, "'≤ 0.1' 0.1"));
  CHECK(contains(axis({0, 2, 10}), "set yrange [0:10.5]"));
  CHECK(contains(axis({1e-9, 1e-5, 1}), "'10{/*0.7 ^{0}}' 1"));  // all of an axis alike
  for (const double odd : {1e-320, 1e300, double{INFINITY}}) CHECK(contains(axis({odd, 1}), "set yrange"));
}
