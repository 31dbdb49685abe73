#include "results/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace ikbench::results {

namespace {

namespace fs = std::filesystem;

// A write that the system refused, as opposed to an error of the contents.
struct WriteFailed {
  std::error_code error;
};

// Refuses a write, with the exception by whose fault it is: the system's if its disk is full or fails.
[[noreturn]] void refuse(const std::string& what, const std::string& why, const std::error_code& error) {
  const std::string message = fmt::format("cannot write {}: {}", what, why);
  if (error.value() == ENOSPC || error.value() == EDQUOT || error.value() == EIO) throw std::runtime_error(message);
  throw std::invalid_argument(message + "; choose a place that you can write to");
}

std::error_code last_error() { return {errno, std::generic_category()}; }

// Gives a new file the owner and permissions of the one that it replaces. If the system refuses the group, the new
// group gets no permissions of the old one.
void pass_on(const struct stat& former, int descriptor) {
  const uid_t same = static_cast<uid_t>(-1);
  mode_t mode = former.st_mode & 07777;
  if (::fchown(descriptor, former.st_uid, former.st_gid) != 0 && ::fchown(descriptor, same, former.st_gid) != 0) {
    mode &= ~static_cast<mode_t>(S_IRWXG);
  }
  ::fchmod(descriptor, mode);
}

void write_text(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written >= 0)
      text.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      throw WriteFailed{last_error()};
  }
}

std::error_code write_all(int descriptor, const Contents& contents) {
  try {
    contents([&](std::string_view text) { write_text(descriptor, text); });
    return {};
  } catch (const WriteFailed& failed) {
    return failed.error;
  }
}

std::error_code closed(int descriptor, std::error_code error) {
  return ::close(descriptor) != 0 && !error ? last_error() : error;
}

// Writes into whatever the path opens, or a new file.
std::error_code write_into(const fs::path& file, const Contents& contents) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return last_error();
  try {
    return closed(descriptor, write_all(descriptor, contents));
  } catch (...) {
    ::close(descriptor);
    throw;
  }
}

constexpr std::string_view half_mark = ".half-", scratch_mark = ".drawing-";

fs::path half_of(const fs::path& place) { return fmt::format("{}{}{}", place.string(), half_mark, ::getpid()); }

bool is_half(std::string_view name) {
  const std::size_t mark = name.rfind(half_mark);
  return mark != std::string::npos && mark + half_mark.size() < name.size() &&
         name.find_first_not_of("0123456789", mark + half_mark.size()) == std::string::npos;
}

// Locks the open file of this name. Another process that takes it for litter may hold the lock first (EWOULDBLOCK), or
// have removed it (ENOENT).
bool lock(int descriptor, const fs::path& path, int wait = LOCK_NB) {
  if (::flock(descriptor, LOCK_EX | wait) != 0) return false;
  struct stat open {
  }, there{};
  if (::fstat(descriptor, &open) != 0 || ::lstat(path.c_str(), &there) != 0) return false;
  if (open.st_dev == there.st_dev && open.st_ino == there.st_ino) return true;
  errno = ENOENT;
  return false;
}

bool is_of_others(int why) { return why == EWOULDBLOCK || why == ENOENT; }

// Opens and locks `path`, which must not be a link; negative if another process has the lock, or if it cannot be
// opened.
int locked(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0 || lock(descriptor, path)) return descriptor;
  const int why = errno;
  ::close(descriptor);
  errno = why;
  return -1;
}

// Removes it unless a living process has it.
void remove_unlocked(const fs::path& path) {
  const int descriptor = locked(path);
  if (descriptor < 0) return;
  std::error_code ignored;
  fs::remove_all(path, ignored);
  ::close(descriptor);
}

// Removes the halves of the same file that killed processes left.
void remove_halves_of(const fs::path& place) {
  const fs::path folder = place.has_parent_path() ? place.parent_path() : fs::path(".");
  const std::string begin = place.filename().string() + std::string(half_mark);
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(begin) && is_half(name)) remove_unlocked(entry->path());
  }
}

// Replaces `former`, or writes a new file; whole or not at all.
std::error_code replace(const fs::path& file, const Contents& contents, const struct stat* former) {
  remove_halves_of(file);
  const fs::path half = half_of(file);
  std::error_code ignored;
  // A process that takes it for litter removes it by its name while it holds its lock. So wait for the lock: otherwise
  // that process would remove a new file of that name.
  constexpr int until_free = 0;
  int descriptor = ::open(half.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0 || lock(descriptor, half, until_free) || errno != ENOENT) {
    fs::remove(half, ignored);  // of an earlier process with our number
  }
  do {
    if (descriptor >= 0) ::close(descriptor);
    descriptor = ::open(half.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, former == nullptr ? 0666 : 0600);
    if (descriptor < 0) return last_error();
  } while (!lock(descriptor, half, until_free) && errno == ENOENT);
  const int kept = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);  // stays locked until it has its name
  std::error_code error;
  try {
    error = write_all(descriptor, contents);
  } catch (...) {  // an error of the contents
    ::close(descriptor);
    fs::remove(half, ignored);
    if (kept >= 0) ::close(kept);
    throw;
  }
  if (former != nullptr) pass_on(*former, descriptor);
  error = closed(descriptor, error);
  if (!error) fs::rename(half, file, error);
  if (error) fs::remove(half, ignored);
  if (kept >= 0) ::close(kept);
  return error;
}

// The descriptor under which the shell has the file open, perhaps for appending: standard output, or another as in
// `exec 3>>log`, named /dev/fd/3.
std::optional<int> open_already(const struct stat& file) {
  constexpr int most = 256;
  for (int descriptor = 0; descriptor < most; ++descriptor) {
    struct stat open {};
    if (::fstat(descriptor, &open) != 0 || open.st_dev != file.st_dev || open.st_ino != file.st_ino) continue;
    if ((::fcntl(descriptor, F_GETFL) & O_ACCMODE) != O_RDONLY) return descriptor;
  }
  return std::nullopt;
}

// True for a file that must be written in place: it has other names, or its folder takes no new file.
bool must_stay(const fs::path& place, const struct stat& file) {
  return file.st_nlink > 1 || ::access(place.parent_path().c_str(), W_OK) != 0;
}

std::error_code write_whole(const fs::path& file, const Contents& contents) {
  struct stat there {};
  if (::lstat(file.c_str(), &there) != 0) return replace(file, contents, nullptr);
  if (::stat(file.c_str(), &there) != 0 || !S_ISREG(there.st_mode)) return write_into(file, contents);
  if (const std::optional<int> descriptor = open_already(there)) {
    std::fflush(nullptr);  // earlier prints come first
    return write_all(*descriptor, contents);
  }
  if (::access(file.c_str(), W_OK) != 0) return last_error();
  std::error_code error;
  const fs::path place = fs::canonical(file, error);
  if (error) return error;
  return must_stay(place, there) ? write_into(place, contents) : replace(place, contents, &there);
}

template <class Write>
void write_or_refuse(const fs::path& file, Write&& write) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (!error) error = write();
  if (error) refuse(fmt::format("'{}'", file.string()), error.message(), error);
}

}  // namespace

void write_file(const fs::path& file, std::string_view text) {
  write_file(file, [&](const Write& write) { write(text); });
}

void write_file(const fs::path& file, const Contents& contents) {
  write_or_refuse(file, [&] {
    std::error_code error;
    const bool is_link = fs::is_symlink(fs::symlink_status(file, error));
    return is_link ? replace(file, contents, nullptr) : write_whole(file, contents);
  });
}

void write_through(const fs::path& file, std::string_view text) {
  write_through(file, [&](const Write& write) { write(text); });
}

void write_through(const fs::path& file, const Contents& contents) {
  write_or_refuse(file, [&] { return write_whole(file, contents); });
}

std::optional<std::string> read_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf())) return std::nullopt;
  return text.str();
}

namespace {

bool is_litter(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  std::error_code error;
  const fs::file_type type = entry.symlink_status(error).type();
  if (type == fs::file_type::directory) return name.starts_with(scratch_mark);
  return type == fs::file_type::regular && is_half(name);
}

// The folders of this process; they must not stay when a signal ends it.
std::mutex temporary_mutex;
std::set<fs::path> temporary_folders;

}  // namespace

TemporaryFolder::TemporaryFolder(const fs::path& parent) {
  const std::scoped_lock lock(temporary_mutex);
  std::error_code error;
  fs::create_directories(parent, error);
  // Another process may take the folder for litter between its creation and its lock.
  for (int attempt = 0; lock_ < 0 && !error && attempt < 10; ++attempt) {
    std::string name = (parent / fmt::format("{}XXXXXX", scratch_mark)).string();
    if (::mkdtemp(name.data()) == nullptr) {
      error = last_error();
    } else {
      path_ = name;
      temporary_folders.insert(path_);
      lock_ = locked(path_);
      if (lock_ < 0 && !is_of_others(errno)) return;  // a file system without locks
    }
  }
  if (lock_ >= 0) return;
  refuse(fmt::format("into '{}'", parent.string()), error ? error.message() : "no folder stays there", error);
}

TemporaryFolder::~TemporaryFolder() {
  const std::scoped_lock lock(temporary_mutex);
  temporary_folders.erase(path_);
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

void remove_temporary_folders() {
  temporary_mutex.lock();  // to the end of the process: no half folder gets its name meanwhile
  for (const fs::path& folder : temporary_folders) {
    std::error_code error;
    for (int attempt = 0; attempt < 100; ++attempt) {  // another thread may still write into it
      fs::remove_all(folder, error);
      if (!error) break;
    }
  }
}

void remove_litter(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (is_litter(*entry)) remove_unlocked(entry->path());
  }
}

void write_folder(const fs::path& folder, const std::function<void(const fs::path&)>& fill) {
  std::error_code error, ignored;
  fs::path place = folder.has_filename() ? folder : folder.parent_path();
  if (fs::exists(place, ignored)) place = fs::canonical(place, ignored);
  remove_halves_of(place);
  const fs::path half = half_of(place);
  int kept = -1;
  do {
    fs::remove_all(half, ignored);  // of an earlier process with our number
    fs::create_directories(half, error);
    if (error) refuse(fmt::format("'{}'", folder.string()), error.message(), error);
    kept = locked(half);
  } while (kept < 0 && is_of_others(errno));
  const auto note = [&](auto&& action) {
    const std::scoped_lock lock(temporary_mutex);
    action();
  };
  note([&] { temporary_folders.insert(half); });
  const auto end = [&] {
    note([&] { temporary_folders.erase(half); });
    fs::remove_all(half, ignored);
    if (kept >= 0) ::close(kept);
  };
  try {
    fill(half);
    note([&] { fs::rename(half, place, error); });
  } catch (...) {
    end();
    throw;
  }
  end();
  if (error) refuse(fmt::format("'{}'", folder.string()), error.message(), error);
}

}  // namespace ikbench::results
