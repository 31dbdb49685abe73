// The colours of series, and pictures that adapt to a reader's dark screen.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace ikbench::figures {

// The colours in the order of the series. Each has a contrast of at least 3 on its ground and on that of the page. Any
// two on a ground are at least 24 apart by CIEDE2000, and 18 under protanopia and deuteranopia (Machado, Oliveira and
// Fernandes 2009), which is more than in Okabe and Ito's palette (2008). Markers distinguish the curves without colour.
constexpr std::array<std::string_view, 7> series_colours{"#1E8CF8", "#8D1804", "#00705B", "#661990",
                                                         "#9C8602", "#F1458D", "#000000"};
constexpr std::array<std::string_view, 7> dark_series_colours{"#2786FF", "#D36332", "#96C595", "#EFB9FF",
                                                              "#EFD511", "#FD009B", "#F2F2F2"};
constexpr std::string_view light_ground = "#FFFFFF", dark_ground = "#1E2125";

// Adds a style sheet for dark screens to a picture of gnuplot: series get their dark colours, and greys go from the
// dark ground to white. Other texts stay as they are.
std::string with_dark_colours(const std::string& svg);

}  // namespace ikbench::figures
