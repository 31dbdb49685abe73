#include "analysis/figures/edited.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <system_error>

#include "results/files.hpp"

namespace ikbench::figures {

namespace {

std::string first_line(std::string_view script) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (const char c : script) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return fmt::format("# Written by ikbench ({:016x}). Edit it: the next report keeps it and draws with it.\n", hash);
}

}  // namespace

std::string with_digest(std::string_view script) { return first_line(script).append(script); }

std::optional<std::string> edited_script(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, ignored))) return std::nullopt;
  std::optional<std::string> text = results::read_file(file);
  if (!text || text->empty()) return std::nullopt;
  const std::string_view all = *text;
  const std::string_view rest = all.substr(std::min(all.find('\n'), all.size() - 1) + 1);
  if (all == with_digest(rest)) return std::nullopt;
  return text;
}

}  // namespace ikbench::figures
