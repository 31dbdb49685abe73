// Why a number is not defined.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
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

}  // namespace ikbench::statistics
