// The look of figures in a file: what it may say, and what is refused at the door.
#include "results/figure_style.hpp"

#include <stdexcept>

#include "numerics/toml_table.hpp"
#include "tests/catch.hpp"
#include "tests/contains.hpp"

using namespace ikbench;
using namespace ikbench::numerics;
using namespace ikbench::results;

namespace {

FigureStyle style_in(const std::string& text) {
  const toml::table table = parse_toml(text, "look.toml");
  FigureStyle style;
  read_style(TomlReader(table, "look.toml", ""), style);
  return style;
}

std::string refusal(const std::string& text) {
  return complaint<std::invalid_argument>([&] { style_in(text); });
}

}  // namespace

TEST_CASE("a style has the keys that it gives, and the rest as before", "[style]") {
  const FigureStyle style = style_in(
      "width_cm = 12\nfont = \"DejaVu Sans\"\ntext_pt = 10\npalette = [\"#ff0000\", \"#1E8CF8\"]\nformats = [\"pdf\"]\n"
      "solvers = [\"DE\", \"IK-BA\"]\n");
  CHECK(style.width_cm == 12);
  CHECK(style.height_cm == 0);
  CHECK(style.font == "DejaVu Sans");
  CHECK(style.text_pt == 10);
  CHECK(style.palette.size() == 2);
  CHECK(style.formats == std::vector{Picture::pdf});
  CHECK(style.solvers == std::vector<std::string>{"DE", "IK-BA"});
  CHECK(style_in("") == FigureStyle());
}

TEST_CASE("a style with a value that no figure may have is refused with its place", "[style]") {
  for (const std::string text : {"font = \"a', system('touch pwned')\"",
                                 "font = \"a\\\"; !x\"",
                                 "font = \"\"",
                                 "font = \"a,12\"",
                                 "font = \"@svg\"",
                                 "font = \"`x`\"",
                                 "width_cm = 1",
                                 "width_cm = 1e9",
                                 "width_cm = -1",
                                 "width_cm = nan",
                                 "height_cm = 2",
                                 "text_pt = 0",
                                 "text_pt = 1000",
                                 "palette = []",
                                 "palette = [\"#12345\"]",
                                 "palette = [\"#12345g\"]",
                                 "palette = [\"rgb(1,2,3)\"]",
                                 "palette = [\"#1234567\"]",
                                 "palette = 3",
                                 "formats = []",
                                 "formats = [\"exe\"]",
                                 "formats = [\"svg\", \"svg\"]",
                                 "solvers = [\"a\", \"a\"]",
                                 "colour = \"#1E8CF8\"",
                                 "[text_pt]\na = 1"}) {
    CAPTURE(text);
    CHECK(contains(refusal(text), "look.toml:1:"));
  }
  CHECK(contains(refusal("font = \"a;b\""), "letters, digits, blanks and -"));
}

TEST_CASE("a colour is six hexadecimal digits", "[style]") {
  CHECK(hex_colour("#abcdef") == "#ABCDEF");
  for (const char* const none : {"", "#", "red", "#fff", "#GGGGGG", "#ABCDEF'"}) CHECK(!hex_colour(none));
}
