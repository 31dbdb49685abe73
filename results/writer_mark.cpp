#include "results/writer_mark.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <system_error>

namespace ikbench::results {
namespace {

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
  if (descriptor_ < 0 || ::fcntl(descriptor_, F_SETLK, &lock) == 0) return;
  ::close(descriptor_);  // another program writes: the mark is its own
  descriptor_ = -1;
}

WriterMark::~WriterMark() {
  if (descriptor_ < 0) return;
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
  ::close(descriptor_);
}

bool is_being_written(const std::filesystem::path& store) {
  const int descriptor = ::open(mark_of(store).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return false;
  struct flock lock = whole_file();
  const bool is_locked = ::fcntl(descriptor, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  ::close(descriptor);
  return is_locked;
}

}  // namespace ikbench::results
