#include "base/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/inputs.hpp"

namespace ikbench::base {

namespace fs = std::filesystem;

void refuse_place(std::string_view verb, const fs::path& place, int error) {
  const std::string message =
      fmt::format("cannot {} '{}': {}", verb, place.string(), std::generic_category().message(error));
  constexpr std::array mistakes{EACCES, EPERM, EROFS,        ENOENT, ENOTDIR, EISDIR,
                                EEXIST, ELOOP, ENAMETOOLONG, EINVAL, EBUSY,   ETXTBSY};
  if (std::ranges::find(mistakes, error) != mistakes.end())
    throw std::invalid_argument(fmt::format("{}; choose a place where you can {}", message, verb));
  if (error == EMFILE) throw std::runtime_error(message + "; raise ulimit -n, then try again");
  throw std::runtime_error(
      message + (verb == "read" ? "; try again, or read a copy on another disk"
                                : "; make room there (or raise ulimit -f), choose another place, or try again"));
}

namespace {

std::error_code last_error() { return {errno, std::generic_category()}; }

void write_text(int descriptor, const fs::path& file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written >= 0)
      text.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      refuse_place("write", file, errno);
  }
}

fs::path folder_of(const fs::path& place) { return place.has_parent_path() ? place.parent_path() : fs::path("."); }

// The temporary folders of this process. They must not stay when a signal ends it.
std::mutex temporary_mutex;
std::set<fs::path> temporary_folders;

constexpr std::string_view scratch_name = ".ikbench-scratch-XXXXXX";

// Removes folders that killed processes left: those a day older than the new folder `scratch`, by the clock of the file
// system. Younger ones may belong to another machine or container.
void remove_litter(const fs::path& folder, const fs::path& scratch) {
  std::error_code error, ignored;
  const fs::file_time_type now = fs::last_write_time(scratch, error);
  if (error) return;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.size() != scratch_name.size() || !name.starts_with(scratch_name.substr(0, scratch_name.find('X'))))
      continue;
    const bool is_old = entry->last_write_time(ignored) < now - std::chrono::hours(24) && !ignored;
    if (is_old && entry->symlink_status(ignored).type() == fs::file_type::directory)
      fs::remove_all(entry->path(), ignored);
  }
}

// Writes a new file, or replaces `former`. The file is whole, or stays as it was.
std::error_code replace(const fs::path& file, const Contents& contents, const struct stat* former, bool syncs) {
  const TemporaryFolder scratch(folder_of(file), file);
  const fs::path half = scratch.path() / file.filename();
  const int descriptor = ::open(half.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, former == nullptr ? 0666 : 0600);
  if (descriptor < 0) return last_error();
  try {
    contents([&](std::string_view text) { write_text(descriptor, file, text); });
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  std::error_code error;
  if (former != nullptr) ::fchmod(descriptor, former->st_mode & 07777);
  // Contents first: otherwise the name could survive a power cut, and the contents not.
  if (syncs && ::fsync(descriptor) != 0) error = last_error();
  if (::close(descriptor) != 0 && !error) error = last_error();
  const std::scoped_lock lock(temporary_mutex);
  if (!error) fs::rename(half, file, error);
  if (error || !syncs) return error;
  const int folder = ::open(folder_of(file).c_str(), O_RDONLY | O_CLOEXEC);
  ::fsync(folder);  // not all file systems can do this, so errors are ignored
  ::close(folder);
  return {};
}

void write_whole(const fs::path& file, const Contents& contents, bool syncs) {
  refuse_input(file);
  std::error_code error;
  if (file.has_parent_path()) {
    const std::scoped_lock lock(temporary_mutex);  // do not make a folder again that a signal has removed
    fs::create_directories(file.parent_path(), error);
  }
  struct stat there {};
  const bool is_file = ::lstat(file.c_str(), &there) == 0 && S_ISREG(there.st_mode);
  if (!error && is_file && ::access(file.c_str(), W_OK) != 0) error = last_error();
  if (!error) error = replace(file, contents, is_file ? &there : nullptr, syncs);
  if (error) refuse_place("write", file, error.value());
}

}  // namespace

void write_file(const fs::path& file, std::string_view text) {
  write_file(file, [&](const Write& write) { write(text); });
}

void write_file(const fs::path& file, const Contents& contents) { write_whole(file, contents, false); }

void write_through(const fs::path& file, const Contents& contents) {
  std::error_code none;
  const bool is_there = fs::exists(file, none);
  if (is_there && !fs::is_regular_file(file, none))  // checked first, since the name of a pipe cannot be resolved
    throw std::invalid_argument(
        fmt::format("'{}' is not a regular file; choose one, or redirect the output", file.string()));
  write_whole(is_there ? fs::canonical(file, none) : file, contents, true);
}

bool read_in_parts(const fs::path& file, const std::function<bool(std::string_view)>& take) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  // Any other error means that no such file exists.
  if (error == std::errc::io_error) refuse_place("read", file, error.value());
  if (!fs::is_regular_file(status)) return false;
  const int descriptor =
      ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // O_NONBLOCK: some files, as /proc/kmsg, wait for news
  if (descriptor < 0) refuse_place("read", file, errno);
  std::array<char, 1 << 13> part;
  ssize_t size = 0;
  do {
    size = ::read(descriptor, part.data(), part.size());
    error = last_error();
  } while (size < 0 ? error == std::errc::interrupted
                    : size > 0 && take({part.data(), static_cast<std::size_t>(size)}));
  ::close(descriptor);
  if (size < 0) refuse_place("read", file, error.value());
  return true;
}

std::optional<std::string> read_file(const fs::path& file, std::uintmax_t enough) {
  std::string text;
  std::error_code error;
  if (const std::uintmax_t all = fs::file_size(file, error); !error) text.reserve(std::min(all, enough));
  const bool is_there = read_in_parts(file, [&](std::string_view part) {
    text += part;
    return text.size() <= enough;
  });
  return is_there ? std::optional(std::move(text)) : std::nullopt;
}

TemporaryFolder::TemporaryFolder(const fs::path& parent, const fs::path& result) {
  const std::scoped_lock lock(temporary_mutex);
  std::error_code error;
  fs::create_directories(parent, error);
  std::string name = (parent / scratch_name).string();
  if (!error && ::mkdtemp(name.data()) == nullptr) error = last_error();
  if (error) refuse_place("write", result.empty() ? parent : result, error.value());
  path_ = name;
  remove_litter(parent, path_);
  temporary_folders.insert(path_);
}

TemporaryFolder::~TemporaryFolder() {
  const std::scoped_lock lock(temporary_mutex);
  temporary_folders.erase(path_);
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void remove_temporary_folders() {
  temporary_mutex.lock();  // never unlocked, so that no half-written file gets its name
  for (const fs::path& folder : temporary_folders) {
    std::error_code error;
    fs::remove_all(folder, error);
    for (int more = 0; error && more < 99; ++more) fs::remove_all(folder, error);  // another thread may still write
  }
}

}  // namespace ikbench::base
