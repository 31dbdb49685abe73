#include "analysis/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace ikbench {

void write_file(const std::filesystem::path& file, std::string_view text) {
  const auto fail = [&](const std::error_code& error) {
    throw std::invalid_argument(
        fmt::format("cannot write '{}': {}; expected a folder that can be written to", file.string(), error.message()));
  };
  std::error_code error;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
  if (error) fail(error);
  const std::filesystem::path half = file.string() + fmt::format(".half-{}", ::getpid());
  {
    std::ofstream stream(half, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.flush();
    if (!stream) error.assign(errno, std::generic_category());
  }
  if (!error) std::filesystem::rename(half, file, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(half, ignored);
  fail(error);
}

std::optional<std::string> read_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf())) return std::nullopt;
  return text.str();
}

}  // namespace ikbench
