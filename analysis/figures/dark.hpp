// The colours of series, and pictures that adapt to a reader's dark screen.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace ikbench::figures {

// The named colours (results/figure_style.hpp) on a dark ground, as far apart there. Markers distinguish the curves
// without colour.
constexpr std::array<std::string_view, 7> dark_series_colours{"#2786FF", "#D36332", "#96C595", "#EFB9FF",
                                                              "#EFD511", "#FD009B", "#F2F2F2"};
constexpr std::string_view light_ground = "#FFFFFF", dark_ground = "#1E2125";

// A lighter or darker colour that stands out from the ground.
std::string shade_of(std::string_view colour, std::string_view ground);
// The colour on a dark screen: of a named colour or its shade the one made for it, of a grey one between ground and
// white, of another a lighter one if it needs to be. Empty if it stays, or if the text is no colour.
std::string dark_colour(std::string_view colour);

// Adds a style sheet for dark screens to a picture of gnuplot. Other texts stay as they are.
std::string with_dark_colours(const std::string& svg);

}  // namespace ikbench::figures
