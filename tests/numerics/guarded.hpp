// Memory for tests of kernels, which must touch nothing beyond its ends.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include "tests/common.hpp"

namespace ikbench {

// Numbers with a forbidden page after them (or before them). It also catches reads of masked instructions, which no
// sanitizer sees.
class Guarded {
 public:
  enum class Page { after, before };

  explicit Guarded(std::size_t count, Page page = Page::after) : count_(count) {
    const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    bytes_ = (count * sizeof(double) + size - 1) / size * size + size;
    memory_ = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    REQUIRE(memory_ != MAP_FAILED);
    char* const first = static_cast<char*>(memory_);
    char* const shut = page == Page::after ? first + bytes_ - size : first;
    REQUIRE(mprotect(shut, size, PROT_NONE) == 0);
    numbers_ = reinterpret_cast<double*>(page == Page::after ? shut - count * sizeof(double) : first + size);
  }
  ~Guarded() { munmap(memory_, bytes_); }
  Guarded(const Guarded&) = delete;
  Guarded& operator=(const Guarded&) = delete;

  double* data() { return numbers_; }
  double& operator[](std::size_t i) { return numbers_[i]; }
  std::size_t size() const { return count_; }

 private:
  std::size_t count_, bytes_ = 0;
  void* memory_ = nullptr;
  double* numbers_ = nullptr;
};

// Numbers between a page that must not be touched and, on the other side, some that must not change.
class Row {
 public:
  Row(const std::vector<double>& numbers, Guarded::Page page)
      : memory_(numbers.size() + margin, page),
        first_(page == Guarded::Page::after ? margin : 0),
        count_(numbers.size()) {
    std::fill_n(memory_.data(), memory_.size(), untouched);
    std::copy(numbers.begin(), numbers.end(), data());
  }

  double* data() { return memory_.data() + first_; }
  std::vector<double> numbers() { return {data(), data() + count_}; }
  bool kept_within() {
    return std::count(memory_.data(), data(), untouched) == static_cast<ptrdiff_t>(first_) &&
           std::count(data() + count_, memory_.data() + memory_.size(), untouched) ==
               static_cast<ptrdiff_t>(margin - first_);
  }

 private:
  static constexpr std::size_t margin = 20;
  static constexpr double untouched = -9.25;

  Guarded memory_;
  std::size_t first_, count_;
};

// Of rows of candidates.
inline std::vector<std::size_t> sizes() {
  std::vector<std::size_t> sizes{1000};
  for (std::size_t size = 0; size <= 40; ++size) sizes.push_back(size);
  return sizes;
}

inline bool same_bits(const double* a, const double* b, std::size_t count) {
  return count == 0 || std::memcmp(a, b, count * sizeof(double)) == 0;
}

}  // namespace ikbench
