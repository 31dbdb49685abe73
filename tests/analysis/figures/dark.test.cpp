// The colours of series on the grounds of paper and of a dark screen, and a picture that has both.
#include "analysis/figures/dark.hpp"

#include <cmath>
#include <string>

#include "analysis/figures/figure.hpp"
#include "tests/catch.hpp"

using namespace ikbench::figures;

namespace {

// WCAG 2.1, "relative luminance" and "contrast ratio".
double luminance(std::string_view colour) {
  double sum = 0;
  constexpr double weights[]{0.2126, 0.7152, 0.0722};
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = std::stoi(std::string(colour.substr(1 + 2 * i, 2)), nullptr, 16) / 255.0;
    sum += weights[i] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return sum;
}

double contrast(std::string_view a, std::string_view b) {
  const double one = luminance(a), other = luminance(b);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

}  // namespace

TEST_CASE("every series has a contrast of at least 3 on its ground", "[figure]") {
  CHECK(contrast("#FFFFFF", "#000000") == Approx(21));
  CHECK(contrast("#777777", "#FFFFFF") == Approx(4.48).margin(0.005));  // WebAIM's contrast checker
  CHECK(contrast("#E69F00", light_ground) < 3);                         // what was too pale
  for (const std::string_view colour : series_colours) {
    CAPTURE(colour);
    CHECK(contrast(colour, light_ground) >= 3);
  }
  for (const std::string_view colour : dark_series_colours) {
    CAPTURE(colour);
    CHECK(contrast(colour, dark_ground) >= 3);
  }
}

TEST_CASE("the style of the figures has the colours of the series", "[figure]") {
  std::string colours;
  for (const std::string_view colour : series_colours) colours += (colours.empty() ? "" : " ") + std::string(colour);
  CHECK(figure_style().find("colours = \"" + colours + '"') != std::string_view::npos);
}

TEST_CASE("a picture has the dark colours beside its own, and nothing that its labels say", "[figure]") {
  const std::string svg =
      "<svg><defs/><g id=\"gnuplot_canvas\"><rect fill=\"#ffffff\"/><path stroke='rgb( 14, 101, 184)'/>"
      "<polygon fill = 'rgb(221, 221, 221)'/><g color=\"black\"/><path stroke='rgb(1, 2, 3)'/>"
      "<text> fill='url(x)}</style><script>' color='rgb(0,0,0' stroke='rgb(0,0,999)'</text></g></svg>";
  const std::string both = with_dark_colours(svg);
  const std::string style =
      "<style>@media (prefers-color-scheme: dark){[color=\"black\"]{color:#F2F2F2}"
      "[fill=\"#ffffff\"]{fill:#1E2125}[fill=\"rgb(221, 221, 221)\"]{fill:#3A3D40}"
      "[stroke=\"rgb( 14, 101, 184)\"]{stroke:#3E89E2}}</style>\n";
  CHECK(both == "<svg><defs/>" + style + svg.substr(12));
  CHECK(with_dark_colours("<svg><script>x</script></svg>") == "<svg><script>x</script></svg>");  // of somebody else
}
