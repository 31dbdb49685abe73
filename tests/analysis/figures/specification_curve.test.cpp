#include "analysis/figures/specification_curve.hpp"

#include <cmath>
#include <sstream>

#include "tests/analysis/drawn.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::figures;

namespace {

constexpr double rows = 13;  // of the curve: it is drawn from row 1 to this one

SpecificationCurve curve_of(std::vector<SpecificationCurve::Universe> universes) {
  return {.name = "curve",
          .caption = "A curve.",
          .quantity = "ratio",
          .below = "below",
          .above = "above",
          .groups = {{"one", "other"}},
          .universes = std::move(universes)};
}

struct Place {
  double estimate, low, high;
};

std::vector<Place> places_of(const Figure& figure) {
  std::istringstream lines(figure.data);
  std::string line, skipped;
  std::getline(lines, line);  // the heading
  std::vector<Place> places;
  while (std::getline(lines, line) && !line.empty()) {
    std::istringstream numbers(line);
    Place& place = places.emplace_back();
    numbers >> skipped >> skipped >> skipped >> skipped >> place.estimate >> place.low >> place.high;
  }
  return places;
}

}  // namespace

TEST_CASE("the axis of a specification curve has room for the intervals", "[figure]") {
  const Figure figure = specification_curve(curve_of({{-1, -2, 0, {0}}, {0.5, 0, 2, {1}}}));
  const std::vector<Place> places = places_of(figure);
  REQUIRE(places.size() == 2);
  CHECK(places[0].low == 1);
  CHECK(places[1].high == rows);
  CHECK(places[0].estimate == Approx(1 + 0.25 * (rows - 1)));  // -1 in -2 to 2
  CHECK(!contains(figure.caption, "cut"));
}

TEST_CASE("an interval far beyond the estimates is cut, and the caption says so", "[figure]") {
  const Figure figure =
      specification_curve(curve_of({{-1, -HUGE_VAL, 0, {0}}, {0, -0.5, 300, {0}}, {1, 0, 2, {1}}, {1, NAN, NAN, {1}}}));
  CHECK(contains(figure.caption, "Longer intervals are cut at the edge of the picture."));
  CHECK(contains(figure.data, " NaN NaN 0\n"));
  const std::vector<Place> places = places_of(figure);
  CHECK(places[0].low == 1);  // -3: two decades below the smallest estimate
  CHECK(places[1].high == rows);
  CHECK(places[1].estimate == Approx((1 + rows) / 2));  // 0 in -3 to 3
  const ScratchFolder folder;
  CHECK(drawn_as_svg({figure}, folder.path) == "");
}
