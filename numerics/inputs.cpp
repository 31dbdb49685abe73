#include "numerics/inputs.hpp"

#include <fmt/format.h>

#include <mutex>
#include <set>
#include <stdexcept>

namespace ikbench::numerics {

namespace {

std::mutex mutex;
std::set<std::filesystem::path> inputs;

}  // namespace

void note_input(const std::filesystem::path& file) {
  const std::scoped_lock lock(mutex);
  inputs.insert(file);
}

void refuse_input(const std::filesystem::path& output) {
  const std::scoped_lock lock(mutex);
  for (const std::filesystem::path& input : inputs) {
    std::error_code none;
    if (std::filesystem::equivalent(output, input, none))
      throw std::invalid_argument(fmt::format("cannot write '{}': it is the input '{}'; choose another place",
                                              output.string(), input.string()));
  }
}

}  // namespace ikbench::numerics
