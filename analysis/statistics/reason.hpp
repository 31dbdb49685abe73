// Reasons why numbers are not defined.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace ikbench::statistics {

// Empty if the number is defined. In the reason of a group "{}" stands for the group.
struct Reason : std::string {
  Reason() = default;
  Reason(std::string words) : std::string(std::move(words)) {}
  Reason(const char* words) : std::string(words) {}
  Reason(std::size_t of_group, std::string words) : std::string(std::move(words)), group(of_group) {}

  std::optional<std::size_t> group = std::nullopt;  // in the given order, from 0
};

// The words with the name of the group.
inline std::string named(const Reason& reason, std::string_view group) {
  return reason.group ? fmt::format(fmt::runtime(std::string_view(reason)), group) : std::string(reason);
}

}  // namespace ikbench::statistics
