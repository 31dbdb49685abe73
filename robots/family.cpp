#include "robots/family.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "numerics/functions.hpp"

namespace ikbench::robots {

using namespace numerics;

namespace {

using Links = std::span<const DhLink>;

constexpr double nothing = 1e-9;

bool is_near_zero(double value) { return std::abs(value) <= nothing; }

// A joint's axis and the next one.
bool are_parallel(const DhLink& link) { return is_near_zero(sin_cos(link.alpha).sine); }

bool all_turn(Links links) {
  return std::ranges::all_of(links, [](const DhLink& link) { return link.joint == Joint::turns; });
}

// Axes of three successive links: the first two meet, the last two meet, and nothing is between these points.
bool meet(Links three) {
  return all_turn(three) && !are_parallel(three[0]) && !are_parallel(three[1]) && is_near_zero(three[0].a) &&
         is_near_zero(three[1].a) && is_near_zero(three[1].d);
}

bool are_three_parallel(Links three) { return all_turn(three) && are_parallel(three[0]) && are_parallel(three[1]); }

// The first links, from 1, of three successive ones for which it is true.
std::vector<std::size_t> threes(Links links, bool (*is_true)(Links)) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i + 3 <= links.size(); ++i) {
    if (is_true(links.subspan(i, 3))) found.push_back(i + 1);
  }
  return found;
}

Family of_parallel_axes(Links links) {
  const auto turns = std::ranges::count(links, Joint::turns, &DhLink::joint);
  const auto slides = static_cast<std::ptrdiff_t>(links.size()) - turns;
  Family family{.name = slides == 0 ? "planar: all axes are parallel" : "SCARA: all axes are parallel"};
  family.has_closed_form = turns >= 2 && turns <= 3 && slides <= 1;
  family.closed_form = family.has_closed_form ? "known, at most 2 configurations (Craig 2005)"
                                              : "known only for 2 or 3 joints that turn and one that slides";
  return family;
}

}  // namespace

Family family_of(const Chain& arm) {
  const Links links = arm.links();
  const std::size_t joints = links.size();
  if (std::ranges::find(links, Joint::coupled, &DhLink::joint) != links.end())
    return {.name = "linkage: joints are coupled", .closed_form = "not looked for"};
  if (joints >= 2 && std::ranges::all_of(links.first(joints - 1), &are_parallel)) return of_parallel_axes(links);

  const std::vector<std::size_t> meeting = threes(links, &meet), parallel = threes(links, &are_three_parallel);
  const bool has_shoulder = !meeting.empty() && meeting.front() == 1;
  const bool has_wrist = !meeting.empty() && meeting.back() + 2 == joints;
  std::vector<std::string> parts;
  for (const std::size_t first : meeting) {
    parts.push_back(fmt::format("{} ({} to {})",
                                first + 2 == joints ? "spherical wrist"
                                : first == 1        ? "spherical shoulder"
                                                    : "three axes that meet",
                                first, first + 2));
  }
  for (const std::size_t first : parallel)
    parts.push_back(fmt::format("three parallel axes ({} to {})", first, first + 2));
  const bool is_wrist =
      joints >= 6 && all_turn(links.last(3)) && !are_parallel(links[joints - 3]) && !are_parallel(links[joints - 2]);
  if (is_wrist && !has_wrist) parts.emplace_back("offset wrist");
  if (parts.empty()) parts.emplace_back("no three axes that meet or are parallel");
  Family family{.name = fmt::format("{}", fmt::join(parts, ", "))};

  if (joints < 6) {
    family.closed_form = "not looked for: fewer than six joints reach no arbitrary pose";
    return family;
  }
  family.has_closed_form = !meeting.empty() || !parallel.empty();
  const std::string of_others = joints == 6   ? ""
                                : joints == 7 ? " for every value of one other joint"
                                              : fmt::format(" for every value of {} other joints", joints - 6);
  if (joints == 7 && has_shoulder && has_wrist) {
    family.closed_form =
        "known for every turn of the elbow about the line from shoulder to wrist (Shimizu et al. 2008)";
  } else if (!meeting.empty()) {
    const bool is_counted = joints == 6 && all_turn(links);
    family.closed_form =
        fmt::format("known{}{} (Pieper 1968)", of_others, is_counted ? ", at most 8 configurations of a pose" : "");
  } else if (!parallel.empty()) {
    family.closed_form = fmt::format("known{} (Pieper 1968; Hawkins 2013 for Universal Robots)", of_others);
  } else {
    family.closed_form =
        all_turn(links)
            ? fmt::format(
                  "none is known; the roots of a polynomial of degree 16 give all configurations{} (Raghavan "
                  "and Roth 1993)",
                  of_others)
            : "none is known";
  }
  return family;
}

}  // namespace ikbench::robots
