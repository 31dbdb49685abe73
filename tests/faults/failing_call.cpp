// Loaded before everything else (LD_PRELOAD), this counts the calls for files that the process makes. The call with the
// number IKBENCH_FAILS fails, and its name is written to the file IKBENCH_CALLS. If none failed, the number of calls
// is. IKBENCH_HOW says how it fails:
//   once         as on a disk that is worn out (also if it is not set).
//   lasting      with all later calls of its name, as where no fsync or no rename is possible.
//   quota        with all later calls that need room on the disk, by EDQUOT.
//   interrupted  by a signal (EINTR).
// Where a call of its name cannot fail so, it does not, and the file has 0.
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <utility>

namespace {

std::atomic<long> calls{0};

void tell(const char* what) {
  const auto file = syscall(SYS_openat, AT_FDCWD, getenv("IKBENCH_CALLS"), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  syscall(SYS_write, file, what, strlen(what));
  syscall(SYS_close, file);
}

// Its own process alone: what it starts has other calls.
struct Which {
  Which() : number(getenv("IKBENCH_FAILS") == nullptr ? -1 : atol(getenv("IKBENCH_FAILS"))) {
    unsetenv("LD_PRELOAD");
    calls = 0;
  }
  ~Which() {
    char text[32];
    snprintf(text, sizeof(text), "%ld", calls.load());
    if (number >= 0 && (number == 0 || number > calls)) tell(text);
  }
  const long number;
};
const Which which;

// Calls that need room on the disk, and calls that a signal can end.
constexpr const char* growing[]{"write", "writev", "pwrite64", "mkdir", "mkdtemp"};
constexpr const char* interruptible[]{"open",     "open64", "openat",    "fopen64", "fcntl",
                                      "fcntl64",  "read",   "pread64",   "write",   "writev",
                                      "pwrite64", "fsync",  "fdatasync", "close",   "ftruncate64"};

template <std::size_t count>
bool is_in(const char* const (&names)[count], const char* name) {
  for (const char* const each : names)
    if (strcmp(each, name) == 0) return true;
  return false;
}

bool is(const char* how) { return getenv("IKBENCH_HOW") != nullptr && strcmp(getenv("IKBENCH_HOW"), how) == 0; }

bool can_fail(const char* call) {
  if (is("quota")) return is_in(growing, call);
  return !is("interrupted") || is_in(interruptible, call);
}

// Returns whether a call fails after that which failed first.
bool fails_again(const char* call, const char* first) {
  if (is("quota")) return is_in(growing, call);
  return is("lasting") && strcmp(first, call) == 0;
}

int error_number() {
  if (is("quota")) return EDQUOT;
  return is("interrupted") ? EINTR : EIO;
}

// Returns whether the call fails, and sets errno if it does.
bool fails(const char* call) {
  static std::atomic<const char*> first{nullptr};
  const long number = ++calls;
  if (first != nullptr) {
    if (!fails_again(call, first)) return false;
  } else {
    if (number != which.number) return false;
    if (!can_fail(call)) {
      tell("0");
      return false;
    }
    tell(call);
    first = call;
  }
  errno = error_number();
  return true;
}

}  // namespace

// A function of that name, which calls the next one; under a name of its own to the compiler, since headers declare it
// otherwise.
#define CALL(Result, name, failed, parameters, ...)                                           \
  extern "C" Result failing_##name parameters __asm__(#name);                                 \
  extern "C" Result failing_##name parameters {                                               \
    static const auto next = reinterpret_cast<Result(*) parameters>(dlsym(RTLD_NEXT, #name)); \
    return fails(#name) ? (failed) : next(__VA_ARGS__);                                       \
  }

CALL(int, open, -1, (const char* file, int flags, mode_t mode), file, flags, mode)
CALL(int, open64, -1, (const char* file, int flags, mode_t mode), file, flags, mode)
CALL(int, openat, -1, (int folder, const char* file, int flags, mode_t mode), folder, file, flags, mode)
CALL(FILE*, fopen64, nullptr, (const char* file, const char* mode), file, mode)
CALL(DIR*, opendir, nullptr, (const char* folder), folder)
CALL(DIR*, fdopendir, nullptr, (int folder), folder)
CALL(int, stat, -1, (const char* file, struct stat* status), file, status)
CALL(int, lstat, -1, (const char* file, struct stat* status), file, status)
CALL(int, stat64, -1, (const char* file, struct stat64* status), file, status)
CALL(int, lstat64, -1, (const char* file, struct stat64* status), file, status)
CALL(int, fstat64, -1, (int file, struct stat64* status), file, status)
CALL(int, access, -1, (const char* file, int how), file, how)
CALL(int, fcntl, -1, (int file, int what, void* with), file, what, with)
CALL(int, fcntl64, -1, (int file, int what, void* with), file, what, with)
CALL(ssize_t, read, -1, (int file, void* into, size_t size), file, into, size)
CALL(ssize_t, pread64, -1, (int file, void* into, size_t size, off64_t at), file, into, size, at)
CALL(ssize_t, write, -1, (int file, const void* of, size_t size), file, of, size)
CALL(ssize_t, writev, -1, (int file, const iovec* of, int count), file, of, count)
CALL(ssize_t, pwrite64, -1, (int file, const void* of, size_t size, off64_t at), file, of, size, at)
CALL(void*, mmap64, reinterpret_cast<void*>(-1),
     (void* at, size_t size, int protection, int flags, int file, off64_t from), at, size, protection, flags, file,
     from)
CALL(int, fsync, -1, (int file), file)
CALL(int, fdatasync, -1, (int file), file)
CALL(int, ftruncate64, -1, (int file, off64_t size), file, size)
CALL(int, fchmod, -1, (int file, mode_t mode), file, mode)
CALL(int, rename, -1, (const char* file, const char* name), file, name)
CALL(int, unlink, -1, (const char* file), file)
CALL(int, unlinkat, -1, (int folder, const char* file, int flags), folder, file, flags)
CALL(int, rmdir, -1, (const char* folder), folder)
CALL(int, mkdir, -1, (const char* folder, mode_t mode), folder, mode)
CALL(char*, mkdtemp, nullptr, (char* folder), folder)
// It is closed all the same, as on Linux.
CALL(int, close, (static_cast<void>(next(file)), errno = error_number(), -1), (int file), file)
