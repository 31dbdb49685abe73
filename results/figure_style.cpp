#include "results/figure_style.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "base/toml_table.hpp"

namespace ikbench::results {

using namespace base;

namespace {

constexpr std::size_t max_colours = 20, max_font_bytes = 60;

bool is_font(std::string_view font) {
  const auto is_allowed = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) != 0 || c == ' ' || c == '-'); };
  return !font.empty() && font.size() <= max_font_bytes && font.front() != ' ' && std::ranges::all_of(font, is_allowed);
}

}  // namespace

std::optional<std::string> hex_colour(std::string_view colour) {
  if (colour.size() != 7 || colour.front() != '#') return std::nullopt;
  std::string hex = "#";
  for (const char c : colour.substr(1)) {
    if (std::isxdigit(static_cast<unsigned char>(c)) == 0) return std::nullopt;
    hex += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return hex;
}

std::optional<std::pair<std::string, std::string>> style_error(const FigureStyle& style) {
  const auto is_colour = [](const std::string& colour) { return hex_colour(colour).has_value(); };
  const auto is_size = [](double cm, double least) { return cm == 0 || cm >= least; };
  const std::set<std::string> shown(style.solvers.begin(), style.solvers.end()),
      drawn(style.formats.begin(), style.formats.end());
  if (!is_size(style.width_cm, 4)) return {{"width_cm", "0, or from 4 to 60"}};
  if (!is_size(style.height_cm, 3)) return {{"height_cm", "0, or from 3 to 60"}};
  if (!is_font(style.font)) return {{"font", fmt::format("at most {} letters, digits, blanks and -", max_font_bytes)}};
  if (style.palette.empty() || style.palette.size() > max_colours || !std::ranges::all_of(style.palette, is_colour))
    return {{"palette", fmt::format("1 to {} times {}", max_colours, expected_colour)}};
  if (shown.size() < style.solvers.size()) return {{"solvers", "each label once"}};
  const auto is_known = [](const std::string& format) { return std::ranges::count(picture_formats, format) == 1; };
  if (drawn.empty() || drawn.size() < style.formats.size() || !std::ranges::all_of(drawn, is_known))
    return {{"formats", fmt::format("some of {}, each once", fmt::join(picture_formats, ", "))}};
  for (const auto& [label, colour] : style.colours)
    if (!is_colour(colour)) return {{"colour", std::string(expected_colour)}};
  return std::nullopt;
}

void read_style(base::TomlReader reader, FigureStyle& style) {
  list_fields(reader, style);
  reader.refuse_unknown_keys();
  if (const auto mistake = style_error(style)) {
    const toml::node* const node = reader.find(mistake->first);
    if (node == nullptr) throw std::invalid_argument(fmt::format("{}: expected {}", mistake->first, mistake->second));
    reader.fail(mistake->first, *node, mistake->second);
  }
}

void read_style_text(std::string_view toml, std::string_view source, FigureStyle& style) {
  const toml::table table = base::parse_toml(toml, source);
  base::TomlReader reader(table, source, "");
  base::TomlReader words = reader.part("words");
  for (const auto& [name, node] : words.table()) {
    base::TomlReader of_figure = words.part(name.str());
    for (const char* of : {"x", "y", "caption"}) of_figure.text(of, style.words[std::string(name.str())][of]);
    of_figure.refuse_unknown_keys();
  }
  read_style(std::move(reader), style);
}

}  // namespace ikbench::results
