// The look of figures in a file: what it may say, and what is refused at the door.
#include "tests/mistakes.hpp"
#include "tests/results/samples.hpp"

namespace {

FigureStyle style_in(const std::string& text) {
  const toml::table table = parse_toml(text, "look.toml");
  FigureStyle style;
  read_style(TomlReader(table, "look.toml", ""), style);
  return style;
}

}  // namespace

TEST_CASE("a style with a value that no figure may have is refused with its place", "[style]") {
  check_mistakes("style", "look.toml:", style_in);
}

TEST_CASE("a style file has words of figures, and the last file counts", "[style]") {
  FigureStyle style;
  const auto read = [&](const std::string& text) { read_style_text(text, "look.toml", style); };
  read("text_pt = 10\n[words.error-boxes]\nx = 'Fehler [mm]'\ny = 'y'\n");
  read("[words.error-boxes]\ny = 'Löser'\ncaption = 'Der Fehler.'\n");
  CHECK(style.text_pt == 10);
  CHECK(style.words.at("error-boxes") ==
        std::map<std::string, std::string>{{"caption", "Der Fehler."}, {"x", "Fehler [mm]"}, {"y", "Löser"}});
  CHECK_THROWS_AS(read("[words.error-boxes]\nz = 'a'\n"), std::invalid_argument);
  CHECK_THROWS_AS(read("[words]\nx = 'a'\n"), std::invalid_argument);
}

TEST_CASE("a colour is six hexadecimal digits", "[style]") {
  CHECK(hex_colour("#abcdef") == "#ABCDEF");
  for (const char* const none : {"", "#", "red", "#fff", "#GGGGGG", "#ABCDEF'"}) CHECK(!hex_colour(none));
}
