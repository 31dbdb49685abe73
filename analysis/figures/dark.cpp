#include "analysis/figures/dark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>

namespace ikbench::figures {

namespace {

using Rgb = std::array<unsigned, 3>;

// Reads "#1a2B3c", "rgb( 26, 43,  60)", "black", "white", as gnuplot writes colours; nothing for anything else.
std::optional<Rgb> rgb_of(const std::string& text) {
  if (text == "black") return Rgb{0, 0, 0};
  if (text == "white") return Rgb{255, 255, 255};
  for (const char* const form : {"#%2x%2x%2x%n", "rgb(%3u,%3u,%3u)%n"}) {
    unsigned r = 0, g = 0, b = 0;
    int length = 0;
    std::sscanf(text.c_str(), form, &r, &g, &b, &length);  // NOLINT(cert-err34-c): `length` says whether all was read
    if (length > 0 && text.substr(static_cast<std::size_t>(length)).empty() && std::max({r, g, b}) <= 255)
      return Rgb{r, g, b};
  }
  return std::nullopt;
}

// The dark colour; empty if the colour stays.
std::string dark_of(const Rgb& rgb) {
  for (std::size_t i = 0; i < series_colours.size(); ++i) {
    if (rgb_of(std::string(series_colours[i])) == rgb) return std::string(dark_series_colours[i]);
  }
  if (rgb[0] != rgb[1] || rgb[1] != rgb[2]) return "";
  const Rgb black = *rgb_of(std::string(dark_series_colours.back())), white = *rgb_of(std::string(dark_ground));
  const auto mixed = [&](std::size_t i) { return std::lround(std::lerp(black[i], white[i], rgb[i] / 255.0)); };
  return fmt::format("#{:02X}{:02X}{:02X}", mixed(0), mixed(1), mixed(2));
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
