#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "analysis/figures/box_figure.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/row_figures.hpp"
#include "analysis/inference/text.hpp"
#include "tests/analysis/drawn.hpp"
#include "tests/analysis/folder.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::inference;
using namespace ikbench::figures;
using Values = std::vector<double>;
using Texts = std::vector<std::string>;

namespace {

const Texts hostile_names{"<b>bold</b>", "`touch pwned`", "$(touch pwned)", "two\nlines",
                          "%d {x}^2_y",  "'q\" \\ @svg",  "größe Δ",        ""};

// The lines of a data file's part that begins with the comment, up to the next empty line.
Texts lines_below(const std::string& data, const std::string& comment) {
  std::istringstream stream(data.substr(data.find(comment)));
  Texts lines;
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line) && !line.empty()) {
    if (!line.starts_with('#')) lines.push_back(line);
  }
  return lines;
}

Figure observed(std::vector<Group> groups) {
  return box_figure({.name = "error", .quantity = "position error [cm]", .groups = std::move(groups)},
                    QuantileType::type_7, "rain");
}

Values numbers(std::size_t count) {
  Values values;
  for (std::size_t i = 1; i <= count; ++i) values.push_back(static_cast<double>(i));
  return values;
}

std::vector<Group> groups_named(const Texts& names, const Values& values) {
  std::vector<Group> groups;
  for (const std::string& name : names) groups.push_back({name, values});
  return groups;
}

void check_drawn(const Figure& figure) {
  const ScratchFolder folder;
  CAPTURE(figure.data);
  CHECK(drawn_as_svg({figure}, folder.path) == "");
  CHECK(files_in(folder.path).size() == 4);  // style.gp, script, data, picture: no name ran as a command
}

}  // namespace

TEST_CASE("labels too long keep both of their ends", "[figure]") {
  CHECK(row_label("solver-variant-17", 17) == "solver-variant-17");
  CHECK(row_label("solver-variant-17", 9) == "solv…t-17");
  CHECK(row_label("ééééééé", 5) == "éé…éé");
  CHECK(row_label("", 5) == "(empty)");
}

TEST_CASE("observations are a box and every value of each group", "[figure]") {
  const Figure figure = observed({{"a", numbers(9)}, {"b", {2, 3, 4}}});
  CHECK(lines_below(figure.data, "# row, lower").front() == "1 1 3 5 7 9 9 0");  // R: quantile(1:9)
  CHECK(lines_below(figure.data, "# values of a").size() == 9);
  CHECK(lines_below(figure.data, "# values of b").size() == 3);
  CHECK(contains(figure.caption, "every value"));
  CHECK(!contains(figure.settings, "logscale"));
}

TEST_CASE("of more than 200 values 200 are drawn, the extremes among them, and says so", "[figure]") {
  const Figure figure = observed({{"a", numbers(1000)}});
  const Texts lines = lines_below(figure.data, "# values of a");
  CHECK(lines.size() == 200);
  CHECK(lines.front().starts_with("1 "));
  CHECK(lines.back().starts_with("1000 "));
  CHECK(contains(figure.caption, "of more than 200 in a group, 200 at even ranks"));
}

TEST_CASE("observations that differ by decades are drawn on a logarithmic axis", "[figure]") {
  const Figure figure = observed({{"a", {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}}, {"b", {0, 1, 2, 3, 4}}});
  CHECK(contains(figure.settings, "set logscale x"));
  CHECK(contains(figure.caption, "Values of zero are drawn at the lower edge"));
}

TEST_CASE("values that cannot be drawn are counted beside their row", "[figure]") {
  const Figure figure = observed({{"some", {1, 2, NAN, HUGE_VAL, 3}}, {"huge", {1e305}}, {"none", {}}});
  CHECK(contains(figure.settings, "\"2 not\\ndrawn\" at graph 1, first 1 "));
  CHECK(contains(figure.settings, "\"1 not\\ndrawn\" at graph 1, first 2 "));
  CHECK(contains(figure.settings, "\"no\\nvalues\" at graph 1, first 3 "));
  CHECK(contains(figure.caption, "not finite are not drawn"));
  // Ranked 1 2 3 Inf Inf, the upper quartile is infinite: no box, rather than one that ends at 3.
  CHECK(lines_below(figure.data, "# row, lower").front() == "1 NaN NaN NaN NaN NaN 5 2");
}

TEST_CASE("of more than 200 groups the first 200 are shown", "[figure]") {
  Texts names;
  for (int i = 0; i < 201; ++i) names.push_back(fmt::format("s{}", i));
  CHECK(contains(observed(groups_named(names, {1})).caption, "the first 200 of 201 groups"));
}

TEST_CASE("observations that are no replicates say so under their picture", "[figure]") {
  const Figure figure = box_figure({.quantity = "x",
                                    .groups = {{"a", {1, 2}}},
                                    .flaws = {{.kind = DoubtKind::rows_share_a_run, .what = "20 rows share run 1"}}},
                                   QuantileType::type_7, "rain");
  CHECK(contains(figure.caption, "Flawed: 20 rows share run 1"));
}

TEST_CASE("intervals are marked where they exclude zero, and in words where there are none", "[figure]") {
  const Figure figure = differences_figure({{"above", "x", 1, 0.5, 1.5},
                                            {"below", "x", -1, -1.5, -0.5},
                                            {"around", "x", 0.1, -1, 1},
                                            {"touching", "x", 1, 0, 2},
                                            {"nothing", "x"},
                                            {"unbounded", "x", 1, -HUGE_VAL, 2}},
                                           {"differences", {"difference", "cm"}, 0.95, "Tamhane"});
  CHECK(lines_below(figure.data, "# row") ==
        Texts{"1 1 0.5 1.5 1", "2 -1 -1.5 -0.5 1", "3 0.1 -1 1 0", "4 1 0 2 0", "5 NaN NaN NaN -1", "6 1 NaN 2 -1"});
  CHECK(contains(figure.settings, "'not defined' at 0, first 5"));
  CHECK(contains(figure.settings, "'unbounded' at 0, first 6"));
  CHECK(contains(figure.caption, "simultaneous 95 % intervals (Tamhane)"));
}

TEST_CASE("differences say who is better on which side, and small times are in ms", "[figure]") {
  const std::vector<DifferenceRow> rows{{"IK-BA", "DE", -0.002, -0.003, -0.001},
                                        {"IK-BA", "PSO", 0.001, -0.001, 0.002}};
  DifferencesWords words{.name = "differences", .quantity = {"difference: time", "s"}, .method = "bootstrap"};
  const Figure smaller = differences_figure(rows, words);
  CHECK(contains(smaller.settings, "'← IK-BA better' at graph 0,"));
  CHECK(contains(smaller.settings, "'second better →' at graph 1,"));  // of each row, another
  CHECK(contains(smaller.settings, "'difference: time [ms]'"));
  CHECK(contains(smaller.caption, "Left of zero, the first of a row is better."));
  check_drawn(smaller);
  words.larger_is_better = true;
  const Figure larger = differences_figure({rows.front()}, words);
  CHECK(contains(larger.settings, "'← DE better' at graph 0,"));
  CHECK(contains(larger.settings, "'IK-BA better →' at graph 1,"));
}

TEST_CASE("in a narrow figure of differences the words on both sides stand on two lines", "[figure]") {
  const ScratchFolder folder;
  const std::string long_name = "a_solver_with_a_long_name";
  const Figure figure = differences_figure({{long_name, long_name + "_2", -1, -2, 0.5}, {"B", long_name, 1, -1, 2}},
                                           {"differences", {"difference: position error", "cm"}, 0.95, "bootstrap"});
  const auto height_of = [&](std::string_view words, double width_cm) {
    const auto written = write_figures({figure}, folder.path, {.style = {.width_cm = width_cm}});
    REQUIRE(written.front().error == "");
    const std::string svg = text_of_file(folder.path / "differences.svg");
    const std::size_t text = svg.find(words), place = svg.rfind("translate(", text);
    return std::stod(svg.substr(svg.find(',', place) + 1));
  };
  CHECK(height_of("first better", 17) == height_of("second better", 17));
  CHECK(height_of("first better", 8.9) < height_of("second better", 8.9));
}

TEST_CASE("ratios have a logarithmic axis around 1", "[figure]") {
  const auto drawn = [](double factor) {
    return differences_figure({{"A", "B", 2, 1.5, 2 * factor}, {"B", "C", 0.9, 0.5, 1.2}, {"C", "D", 1, 0, 2}},
                              {"differences", {"ratio: time", ""}, 0.95, "bootstrap", true});
  };
  const Figure figure = drawn(1.25), wide = drawn(1e4);
  CHECK(lines_below(figure.data, "# row") == Texts{"1 2 1.5 2.5 1", "2 0.9 0.5 1.2 0", "3 1 0 2 -1"});
  CHECK(contains(figure.settings, "set logscale x"));
  CHECK(contains(figure.settings, "'0.5' 0.5, '1' 1, '2' 2"));
  CHECK(contains(figure.settings, "set arrow from 1, graph 0 to 1"));
  CHECK(contains(figure.settings, "'not defined' at 1, first 3"));
  CHECK(contains(figure.caption, "the interval excludes 1"));
  CHECK(contains(wide.settings, "'1' 1, '10^{1}' 10, '10^{2}' 100"));
  check_drawn(figure);
  check_drawn(wide);
  check_drawn(differences_figure({{"A", "B", 1e-200, 1e-300, 1e300}, {"B", "C", 1e-310, 1e-320, 1}},
                                 {"differences", {"ratio: time", ""}, 0.95, "bootstrap", true}));
}

TEST_CASE("figures of a statistical analysis are drawn whatever the names and numbers", "[figure]") {
  check_drawn(observed(groups_named(hostile_names, numbers(8))));
  for (const Values& values : std::vector<Values>{{},
                                                  {1},
                                                  {0, 0},
                                                  {NAN},
                                                  {5, 5, 5, 5, 5},
                                                  {1e308, -1e308},
                                                  {1e300, 1, 0, -1e300},
                                                  {1e-310, 2e-310},
                                                  {1e-320, 1e300},
                                                  {1e-50, 1e50},  // gnuplot did not end
                                                  {1e9 + 0.1, 1e9 + 0.2, 1e9 + 0.3}}) {
    check_drawn(observed({{"a", values}, {"b", values}}));
  }
  check_drawn(observed({}));
  check_drawn(differences_figure({}, {.name = "differences"}));
  check_drawn(differences_figure({{"nothing", ""}, {"huge", "", 1e308, -1e308, 1e308}}, {.name = "differences"}));
  check_drawn(
      differences_figure({{hostile_names[5], hostile_names[2], 1e-12, -1e-12, 3e-12}},
                         {.name = "differences", .quantity = {hostile_names[4], "s"}, .method = hostile_names[1]}));
}

TEST_CASE("names stand in the figures of an analysis as they are", "[figure]") {
  const ScratchFolder folder;
  const Figure figure = observed(groups_named(hostile_names, numbers(8)));
  REQUIRE(drawn_as_svg({figure}, folder.path) == "");
  const std::string svg = text_of_file(folder.path / "rain.svg");
  for (const char* shown :
       {"&lt;b>bold&lt;/b>", "`touch pwned`", "$(touch pwned)", "two lines", "%d {x}^2_y", "größe Δ", "(empty)"}) {
    CAPTURE(shown);
    CHECK(contains(svg, "<text>" + std::string(shown) + "</text>"));
  }
}
