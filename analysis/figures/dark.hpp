// The colours of series, and pictures that follow a reader's dark screen.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace ikbench::figures {

// In the order of the series. Each has a contrast of at least 3 on its ground, and under protanopia and deuteranopia
// any two of a ground stay as far apart as those of Okabe and Ito's palette (2008), whose yellow and light blue are too
// pale for white. Markers tell the curves apart without colour.
constexpr std::array<std::string_view, 7> series_colours{"#0E65B8", "#FF2E1B", "#0DA170", "#B56496",
                                                         "#789930", "#3793CD", "#000000"};
constexpr std::array<std::string_view, 7> dark_series_colours{"#3E89E2", "#E0753F", "#16A078", "#C8A8C6",
                                                              "#FEB732", "#96BEF6", "#F2F2F2"};
constexpr std::string_view light_ground = "#FFFFFF", dark_ground = "#1E2125";

// A picture of gnuplot's with a style sheet of its own, which a dark screen takes: series have their dark colours, and
// greys go from the dark ground to white. Anything else stays as it is.
std::string with_dark_colours(const std::string& svg);

}  // namespace ikbench::figures
