#include "analysis/figures/dark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

namespace ikbench::figures {

namespace {

using Rgb = std::array<int, 3>;

std::optional<int> number_of(std::string_view text, int base) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole && value >= 0 && value <= 255 ? std::optional(value) : std::nullopt;
}

// Reads "#1a2B3c", "rgb( 26, 43,  60)", "black", "white", as gnuplot writes colours; nothing for anything else.
std::optional<Rgb> rgb_of(std::string_view text) {
  if (text == "black") return Rgb{0, 0, 0};
  if (text == "white") return Rgb{255, 255, 255};
  Rgb rgb{};
  if (text.size() == 7 && text.front() == '#') {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = number_of(text.substr(1 + 2 * i, 2), 16);
      if (!value) return std::nullopt;
      rgb[i] = *value;
    }
    return rgb;
  }
  if (!text.starts_with("rgb(") || !text.ends_with(')')) return std::nullopt;
  text = text.substr(4, text.size() - 5);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto value = number_of(text.substr(0, comma), 10);
    if (!value || (i < 2) == (comma == text.size())) return std::nullopt;
    rgb[i] = *value;
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return rgb;
}

// The dark colour; empty if the colour stays.
std::string dark_of(const Rgb& rgb) {
  for (std::size_t i = 0; i < series_colours.size(); ++i) {
    if (rgb_of(series_colours[i]) == rgb) return std::string(dark_series_colours[i]);
  }
  if (rgb[0] != rgb[1] || rgb[1] != rgb[2]) return "";
  const Rgb black = *rgb_of(dark_series_colours.back()), white = *rgb_of(dark_ground);
  Rgb mixed{};
  for (std::size_t i = 0; i < 3; ++i) {
    mixed[i] = static_cast<int>(std::lround(black[i] + (white[i] - black[i]) * rgb[i] / 255.0));
  }
  return fmt::format("#{:02X}{:02X}{:02X}", mixed[0], mixed[1], mixed[2]);
}

}  // namespace

std::string with_dark_colours(const std::string& svg) {
  const std::size_t place = svg.find("<g id=\"gnuplot_canvas\"");
  if (place == std::string::npos) return svg;
  std::set<std::string> rules;
  for (const std::string_view attribute : {"color", "stroke", "fill"}) {
    const std::string wanted = fmt::format(" {}", attribute);
    for (std::size_t at = svg.find(wanted); at != std::string::npos; at = svg.find(wanted, at)) {
      at = svg.find_first_not_of(" =", at + wanted.size());
      const std::size_t end = at == std::string::npos ? at : svg.find(svg[at], at + 1);
      if (end == std::string::npos) break;
      const std::string value = svg.substr(at + 1, end - at - 1);
      const auto rgb = rgb_of(value);
      const std::string dark = rgb ? dark_of(*rgb) : "";
      if (!dark.empty()) rules.insert(fmt::format("[{0}=\"{1}\"]{{{0}:{2}}}", attribute, value, dark));
    }
  }
  std::string style = "<style>@media (prefers-color-scheme: dark){";
  for (const std::string& rule : rules) style += rule;
  return svg.substr(0, place) + style + "}</style>\n" + svg.substr(place);
}

}  // namespace ikbench::figures
