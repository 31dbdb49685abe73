#include "base/inputs.hpp"

#include <fmt/format.h>

#include <mutex>
#include <set>
#include <stdexcept>

#include "base/files.hpp"

namespace ikbench::base {

namespace {

std::mutex mutex;
std::set<std::filesystem::path> inputs;

}  // namespace

void note_input(const std::filesystem::path& file) {
  const std::scoped_lock lock(mutex);
  inputs.insert(file);
}

std::string text_of_file(const std::filesystem::path& file, std::uintmax_t max_bytes) {
  note_input(file);
  const std::optional<std::string> text = read_file(file, max_bytes);  // the size of a file may be unknown
  std::error_code none;
  if (!text && std::filesystem::exists(file, none))
    throw std::invalid_argument(fmt::format("{} is not a regular file", file.string()));
  if (!text) throw std::invalid_argument(fmt::format("there is no file {}", file.string()));
  if (text->size() > max_bytes)
    throw std::invalid_argument(fmt::format("{} is too large; expected a file of at most {:g} MB", file.string(),
                                            static_cast<double>(max_bytes) / 1e6));
  return *text;
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
