#include "analysis/figures/dark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>

#include "results/figure_style.hpp"

namespace ikbench::figures {

using namespace results;

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

std::string hex_of(const Rgb& rgb) { return fmt::format("#{:02X}{:02X}{:02X}", rgb[0], rgb[1], rgb[2]); }

Rgb mixed(const Rgb& one, const Rgb& other, double share_of_other) {
  Rgb result{};
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = static_cast<unsigned>(std::lround(std::lerp(one[i], other[i], share_of_other)));
  return result;
}

// Relative luminance (WCAG 2.1).
double luminance(const Rgb& rgb) {
  const auto linear = [&](std::size_t i) {
    const double value = rgb[i] / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(0) + 0.7152 * linear(1) + 0.0722 * linear(2);
}

double contrast(const Rgb& one, const Rgb& other) {
  const auto [less, more] = std::minmax(luminance(one), luminance(other));
  return (more + 0.05) / (less + 0.05);
}

constexpr double least_contrast = 3;  // of graphics (WCAG 2.1)

}  // namespace

std::string shade_of(std::string_view colour, std::string_view ground) {
  constexpr double share = 0.42;
  constexpr Rgb black{0, 0, 0}, white{255, 255, 255};
  const Rgb own = *rgb_of(std::string(colour)), behind = *rgb_of(std::string(ground));
  const bool is_dark = luminance(own) < 0.13;
  const Rgb wanted = mixed(own, is_dark ? white : black, share), other = mixed(own, is_dark ? black : white, share);
  return hex_of(contrast(wanted, behind) >= least_contrast ? wanted : other);
}

std::string dark_colour(std::string_view colour) {
  const std::optional<Rgb> rgb = rgb_of(std::string(colour));
  if (!rgb) return "";
  for (std::size_t i = 0; i < named_colours.size(); ++i) {
    const std::string_view light = named_colours[i].second, dark = dark_series_colours[i];
    if (rgb_of(std::string(light)) == rgb) return std::string(dark);
    if (rgb_of(shade_of(light, light_ground)) == rgb) return shade_of(dark, dark_ground);
  }
  const Rgb ground = *rgb_of(std::string(dark_ground)), white = *rgb_of(std::string(dark_series_colours.back()));
  if ((*rgb)[0] == (*rgb)[1] && (*rgb)[1] == (*rgb)[2]) return hex_of(mixed(white, ground, (*rgb)[0] / 255.0));
  Rgb lighter = *rgb;
  while (contrast(lighter, ground) < least_contrast) lighter = mixed(lighter, white, 0.1);
  return lighter == *rgb ? "" : hex_of(lighter);
}

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
      const std::string dark = dark_colour(value);
      if (!dark.empty()) rules.insert(fmt::format("[{0}=\"{1}\"]{{{0}:{2}}}", attribute, value, dark));
    }
  }
  std::string style = "<style>@media (prefers-color-scheme: dark){";
  for (const std::string& rule : rules) style += rule;
  return svg.substr(0, place) + style + "}</style>\n" + svg.substr(place);
}

}  // namespace ikbench::figures
