// The colours of series on the grounds of paper and of a dark screen, and a picture that has both.
#include "analysis/figures/dark.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "results/figure_style.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::figures;
using namespace ikbench::results;

namespace {

// WCAG 2.1, "relative luminance" and "contrast ratio".
double linear(std::string_view colour, std::size_t i) {
  const double c = std::stoi(std::string(colour.substr(1 + 2 * i, 2)), nullptr, 16) / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(std::string_view colour) {
  return 0.2126 * linear(colour, 0) + 0.7152 * linear(colour, 1) + 0.0722 * linear(colour, 2);
}

double contrast(std::string_view a, std::string_view b) {
  const double one = luminance(a), other = luminance(b);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

// CIE 1976 L*a*b* of an sRGB colour, white D65.
std::array<double, 3> lab(std::string_view colour) {
  std::array<double, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i) rgb[i] = linear(colour, i);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f((0.4124564 * rgb[0] + 0.3575761 * rgb[1] + 0.1804375 * rgb[2]) / 0.95047),
               y = f(0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2]),
               z = f((0.0193339 * rgb[0] + 0.1191920 * rgb[1] + 0.9503041 * rgb[2]) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double distance(std::string_view a, std::string_view b) {
  const auto one = lab(a), other = lab(b);
  return std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}

}  // namespace

TEST_CASE("every series has a contrast of at least 3 on its ground", "[figure]") {
  CHECK(contrast("#FFFFFF", "#000000") == Approx(21));
  CHECK(contrast("#777777", "#FFFFFF") == Approx(4.48).margin(0.005));  // WebAIM's contrast checker
  CHECK(contrast("#E69F00", light_ground) < 3);                         // what was too pale
  for (const auto& [name, colour] : named_colours) {
    CAPTURE(colour);
    CHECK(contrast(colour, light_ground) >= 3);
    CHECK(contrast(shade_of(colour, light_ground), light_ground) >= 3);
    CHECK(contrast(dark_colour(colour), dark_ground) >= 3);
    CHECK(contrast(dark_colour(shade_of(colour, light_ground)), dark_ground) >= 3);
    CHECK(distance(colour, shade_of(colour, light_ground)) > 18);
    CHECK(distance(dark_colour(colour), dark_colour(shade_of(colour, light_ground))) > 18);
  }
  CHECK(contrast(dark_colour("#10203F"), dark_ground) >= 3);  // a colour of a study
  CHECK(dark_colour("#FFEE00").empty());                      // stands out as it is
}

TEST_CASE("any two series are farther apart than two blues were that readers took for one", "[figure]") {
  CHECK(lab("#FF0000")[0] == Approx(53.24).margin(0.01));  // Lindbloom's calculator: 53.24, 80.09, 67.20
  CHECK(lab("#FF0000")[1] == Approx(80.09).margin(0.01));
  CHECK(lab("#FF0000")[2] == Approx(67.20).margin(0.01));
  CHECK(distance("#0E65B8", "#3793CD") == Approx(25.8).margin(0.01));
  std::array<std::string_view, 7> light{};
  std::ranges::transform(named_colours, light.begin(), [](const auto& named) { return named.second; });
  for (const auto& colours : {light, dark_series_colours}) {
    for (std::size_t i = 0; i < colours.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        CAPTURE(colours[i], colours[j]);
        CHECK(distance(colours[i], colours[j]) > 35);
      }
    }
  }
}

TEST_CASE("a picture has the dark colours beside its own, and nothing that its labels say", "[figure]") {
  const std::string svg =
      "<svg><defs/><g id=\"gnuplot_canvas\"><rect fill=\"#ffffff\"/><path stroke='rgb( 30, 140, 248)'/>"
      "<polygon fill = 'rgb(221, 221, 221)'/><g color=\"black\"/><path stroke='rgb(1, 2, 3)'/>"
      "<text> fill='url(x)}</style><script>' color='rgb(0,0,0' stroke='rgb(0,0,999)'</text></g></svg>";
  const std::string both = with_dark_colours(svg);
  const std::string style =
      "<style>@media (prefers-color-scheme: dark){[color=\"black\"]{color:#F2F2F2}"
      "[fill=\"#ffffff\"]{fill:#1E2125}[fill=\"rgb(221, 221, 221)\"]{fill:#3A3D40}"
      "[stroke=\"rgb( 30, 140, 248)\"]{stroke:#2786FF}[stroke=\"rgb(1, 2, 3)\"]{stroke:#737373}}</style>\n";
  CHECK(both == "<svg><defs/>" + style + svg.substr(12));
  CHECK(with_dark_colours("<svg><script>x</script></svg>") == "<svg><script>x</script></svg>");  // of somebody else
}
