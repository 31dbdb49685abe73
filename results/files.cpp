#include "results/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace ikbench::results {

namespace {

namespace fs = std::filesystem;

std::error_code last_error() { return {errno, std::generic_category()}; }

// Owner and permissions of the file that a new one takes the place of. Where the system does not let us keep the group,
// what it was allowed is not allowed to another.
void pass_on(const struct stat& former, int descriptor) {
  const uid_t same = static_cast<uid_t>(-1);
  mode_t mode = former.st_mode & 07777;
  if (::fchown(descriptor, former.st_uid, former.st_gid) != 0 && ::fchown(descriptor, same, former.st_gid) != 0) {
    mode &= ~static_cast<mode_t>(S_IRWXG);
  }
  ::fchmod(descriptor, mode);
}

std::error_code write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written >= 0)
      text.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      return last_error();
  }
  return {};
}

std::error_code closed(int descriptor, std::error_code error) {
  return ::close(descriptor) != 0 && !error ? last_error() : error;
}

// Writes what is opened by the path: a new file, or whatever is there.
std::error_code write_into(const fs::path& file, std::string_view text) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  return descriptor < 0 ? last_error() : closed(descriptor, write_all(descriptor, text));
}

// Whole or not at all. `former` is the file whose place it takes.
std::error_code replace(const fs::path& file, std::string_view text, const struct stat* former) {
  const fs::path half = file.string() + fmt::format(".half-{}", ::getpid());
  std::error_code ignored;
  fs::remove(half, ignored);  // of a process that had our number
  const int descriptor = ::open(half.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, former == nullptr ? 0666 : 0600);
  if (descriptor < 0) return last_error();
  std::error_code error = write_all(descriptor, text);
  if (former != nullptr) pass_on(*former, descriptor);
  error = closed(descriptor, error);
  if (!error) fs::rename(half, file, error);
  if (error) fs::remove(half, ignored);
  return error;
}

// The descriptor that the shell has opened the file with, for appending perhaps: standard output, or another as in
// `exec 3>>log`, which /dev/fd/3 names.
std::optional<int> open_already(const struct stat& file) {
  constexpr int most = 256;
  for (int descriptor = 0; descriptor < most; ++descriptor) {
    struct stat open {};
    if (::fstat(descriptor, &open) != 0 || open.st_dev != file.st_dev || open.st_ino != file.st_ino) continue;
    if ((::fcntl(descriptor, F_GETFL) & O_ACCMODE) != O_RDONLY) return descriptor;
  }
  return std::nullopt;
}

// A file that has other names, or whose folder takes no new file, stays the file that it is.
bool must_stay(const fs::path& place, const struct stat& file) {
  return file.st_nlink > 1 || ::access(place.parent_path().c_str(), W_OK) != 0;
}

std::error_code write_whole(const fs::path& file, std::string_view text) {
  struct stat there {};
  if (::lstat(file.c_str(), &there) != 0) return replace(file, text, nullptr);
  if (::stat(file.c_str(), &there) != 0 || !S_ISREG(there.st_mode)) return write_into(file, text);
  if (const std::optional<int> descriptor = open_already(there)) {
    std::fflush(nullptr);  // what was printed comes first
    return write_all(*descriptor, text);
  }
  if (::access(file.c_str(), W_OK) != 0) return last_error();
  std::error_code error;
  const fs::path place = fs::canonical(file, error);
  if (error) return error;
  return must_stay(place, there) ? write_into(place, text) : replace(place, text, &there);
}

}  // namespace

void write_file(const fs::path& file, std::string_view text) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (!error) error = write_whole(file, text);
  if (!error) return;
  throw std::invalid_argument(
      fmt::format("cannot write '{}': {}; choose a place that you can write to", file.string(), error.message()));
}

std::optional<std::string> read_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf())) return std::nullopt;
  return text.str();
}

}  // namespace ikbench::results
