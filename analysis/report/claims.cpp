#include "analysis/report/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ikbench::report {

std::string_view name_of(Verdict verdict) {
  constexpr std::array<std::string_view, 4> names{"holds", "holds in part", "undecided", "fails"};
  return names[static_cast<std::size_t>(verdict)];
}

std::string tally(const std::vector<Claim>& claims) {
  struct Words {
    Verdict verdict;
    std::string_view one, several;
  };
  constexpr std::array<Words, 4> words{{{Verdict::holds, "holds", "hold"},
                                        {Verdict::in_part, "holds in part", "hold in part"},
                                        {Verdict::fails, "fails", "fail"},
                                        {Verdict::undecided, "is undecided", "are undecided"}}};
  std::vector<std::string> parts;
  for (const auto& [verdict, one, several] : words) {
    const auto count = std::ranges::count(claims, verdict, &Claim::verdict);
    if (count > 0) parts.push_back(fmt::format("{} {}", count, count == 1 ? one : several));
  }
  std::string text = fmt::format("Of {} claim{}", claims.size(), claims.size() == 1 ? "" : "s");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += (i > 0 && i + 1 == parts.size() ? " and " : ", ") + parts[i];
  }
  const auto is_printed = [](const Claim& claim) { return claim.printed.has_value(); };
  if (const auto printed = std::ranges::count_if(claims, is_printed); printed > 0) {
    text += fmt::format(". By the printed numbers, {} of {} hold",
                        std::ranges::count(claims, Verdict::holds, &Claim::printed), printed);
  }
  return text + '.';
}

}  // namespace ikbench::report
