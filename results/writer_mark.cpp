#include "results/writer_mark.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>

#include "numerics/number.hpp"

namespace ikbench::results {
namespace {

constexpr std::size_t rate_length = 20;  // fixed, so that a rate overwrites the one before

std::filesystem::path mark_of(const std::filesystem::path& store) { return store.string() + "-writer"; }

struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

}  // namespace

WriterMark::WriterMark(const std::filesystem::path& store)
    : file_(mark_of(store)), descriptor_(::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666)) {
  struct flock lock = whole_file();
  if (descriptor_ < 0) return;
  if (::fcntl(descriptor_, F_SETLK, &lock) == 0) {
    static_cast<void>(!::ftruncate(descriptor_, 0));  // the rest of a killed writer
    return;
  }
  ::close(descriptor_);  // the mark belongs to another writer
  descriptor_ = -1;
}

WriterMark::~WriterMark() {
  if (descriptor_ < 0) return;
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
  ::close(descriptor_);
}

void WriterMark::add(std::int64_t solves) {
  solves_ += solves;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - began_;
  const std::string rate = fmt::format("{:<{}.6e}", static_cast<double>(solves_) / seconds.count(), rate_length);
  static_cast<void>(!::pwrite(descriptor_, rate.data(), rate.size(), 0));  // the store reports a full disk
}

std::optional<double> writing_rate(const std::filesystem::path& store) {
  const int descriptor = ::open(mark_of(store).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  struct flock lock = whole_file();
  const bool is_locked = ::fcntl(descriptor, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  std::string text(rate_length, ' ');
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(::pread(descriptor, text.data(), text.size(), 0), 0)));
  ::close(descriptor);
  if (!is_locked) return std::nullopt;
  const double rate = numerics::number_from(text.substr(0, text.find(' '))).value_or(0);
  return std::isfinite(rate) && rate > 0 ? rate : 0;
}

}  // namespace ikbench::results
