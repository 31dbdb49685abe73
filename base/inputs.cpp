#include "base/inputs.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>

namespace ikbench::base {

namespace {

std::mutex mutex;
std::set<std::filesystem::path> inputs;

}  // namespace

void note_input(const std::filesystem::path& file) {
  const std::scoped_lock lock(mutex);
  inputs.insert(file);
}

std::string text_of_file(const std::filesystem::path& file, std::uintmax_t largest) {
  note_input(file);
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw std::invalid_argument(fmt::format("{} is no regular file", file.string()));
  std::ifstream in(file, std::ios::binary);
  std::string text;
  std::array<char, 1 << 13> part;
  while (in.read(part.data(), part.size()) || in.gcount() > 0) {  // the size of a file may be unknown
    text.append(part.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > largest) {
      throw std::invalid_argument(
          fmt::format("{}: expected a file of at most {:g} MB", file.string(), static_cast<double>(largest) / 1e6));
    }
  }
  if (!in.is_open() || in.bad()) throw std::invalid_argument(fmt::format("cannot read {}", file.string()));
  return text;
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

}  // namespace ikbench::base
