// The look of a study's figures. It comes from `[figures]` of a study, from a file of its own (`--style`), and from the
// colours of the study's solvers. It decides no number.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/fields.hpp"

namespace ikbench::base {
class TomlReader;
}

namespace ikbench::results {

// The default colours. Each has a contrast of at least 3 on white, and a grey of its own, about 8 of CIE's L* from the
// next. Any two are at least 24 apart by CIEDE2000, and 18 under protanopia and deuteranopia (Machado, Oliveira and
// Fernandes 2009), which is more than in Okabe and Ito's palette (2008).
inline const std::vector<std::string> default_palette{"#267195", "#9A3409", "#573B4B", "#1803A2",
                                                      "#EB365A", "#9B80FF", "#000000"};

inline const std::vector<std::string> picture_formats{"svg", "pdf", "png"};

struct FigureStyle {
  double width_cm = 0, height_cm = 0;  // size of every figure; 0: each figure has its own
  std::string font = "Liberation Sans";
  double text_pt = 8;
  std::vector<std::string> palette = default_palette;
  std::vector<std::string> solvers = {};  // labels to draw, in this order; empty: all, as in the study
  std::vector<std::string> formats = {"svg", "pdf"};
  enum class Background { white, dark } background = Background::white;
  std::map<std::string, std::string> colours = {};  // by label: `colour` of a solver entry
  // Words in place of a figure's own ("x", "y", "caption"), by the figure's name or the beginning of it. Only a style
  // file has them.
  std::map<std::string, std::map<std::string, std::string>> words = {};

  bool operator==(const FigureStyle&) const = default;
};

constexpr std::string_view expected_colour = "a colour such as \"#1E8CF8\"";

inline void list_fields(base::Fields& io, FigureStyle& style) {
  io.number("width_cm", style.width_cm, 1, {0, 60}, "width of every figure, at least 4; 0: each its own");
  io.number("height_cm", style.height_cm, 1, {0, 60},
            "height of every figure, or more where its rows need it, at least 3; 0: each its own");
  io.text("font", style.font, "a font of this machine (letters, digits, blanks and -)");
  io.number("text_pt", style.text_pt, 1, {4, 24}, "size of text; heights and margins follow it");
  io.texts("palette", style.palette, "colours of solvers, in the order in which they are given out: \"#RRGGBB\"");
  io.choice("background", style.background, {"white", "dark"}, "dark: with light text, which wants a light palette");
  io.texts("solvers", style.solvers, "only these labels in figures, in this order; []: all");
  io.texts("formats", style.formats, "pictures of each figure: svg, pdf, png; the page shows svg");
}

// Returns "#1E8CF8" for "#1e8cf8", and nothing for text that is no colour.
std::optional<std::string> hex_colour(std::string_view colour);

// Returns the key of the first value that no figure may have, with what is expected there; nothing if all values are
// allowed.
std::optional<std::pair<std::string, std::string>> style_error(const FigureStyle& style);

// Sets the keys that the table has and keeps the others. Throws std::invalid_argument with the place of a mistake
// (base/toml_table.hpp).
void read_style(base::TomlReader reader, FigureStyle& style);
// Does the same with a text, whose keys are those of `[figures]`, and `[words.NAME]` for the words of a figure.
void read_style_text(std::string_view toml, std::string_view source, FigureStyle& style);

}  // namespace ikbench::results
