#include "tests/solvers/allocations.hpp"

#include <atomic>
#include <cstddef>

// Counts calls of malloc: Eigen takes its memory by malloc, and the standard library by operator new, which calls
// malloc.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define IKBENCH_SANITIZED 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define IKBENCH_SANITIZED 1
#endif

namespace {
std::atomic<long> count{0};
}

#ifdef IKBENCH_SANITIZED

extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*malloc_hook)(const volatile void*, std::size_t),
                                                         void (*free_hook)(const volatile void*));

namespace {
[[maybe_unused]] const int installed = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { ++count; }, [](const volatile void*) {});
}

#else

extern "C" void* __libc_malloc(std::size_t size);  // glibc's own
extern "C" void* __libc_calloc(std::size_t number, std::size_t size);

extern "C" void* malloc(std::size_t size) {
  ++count;
  return __libc_malloc(size);
}

extern "C" void* calloc(std::size_t number, std::size_t size) {  // compilers replace malloc and zeros by it
  ++count;
  return __libc_calloc(number, size);
}

#endif

long ikbench::allocations() { return count; }
