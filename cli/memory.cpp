#include "cli/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

namespace ikbench::cli {
namespace {

constexpr std::int64_t no_limit_known = std::numeric_limits<std::int64_t>::max();

// The number that a file begins with; one that is not there, or says "max", limits nothing.
std::int64_t number_in(const char* file) {
  std::ifstream stream(file);
  std::int64_t number = 0;
  return stream >> number ? number : no_limit_known;
}

std::int64_t left_on_machine() {
  std::ifstream info("/proc/meminfo");
  for (std::string name, unit; info >> name;) {
    std::int64_t kilobytes = 0;
    info >> kilobytes;
    if (name == "MemAvailable:") return kilobytes * 1024;
    std::getline(info, unit);
  }
  return no_limit_known;
}

std::int64_t left_in_control_group() {
  const std::int64_t most = number_in("/sys/fs/cgroup/memory.max");
  const std::int64_t used = number_in("/sys/fs/cgroup/memory.current");
  return most == no_limit_known || used == no_limit_known ? no_limit_known : most - used;
}

std::int64_t left_of_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return no_limit_known;
  return static_cast<std::int64_t>(limit.rlim_cur) - number_in("/proc/self/statm") * sysconf(_SC_PAGESIZE);
}

}  // namespace

void expect_memory(std::int64_t bytes, std::string_view what) {
  const std::int64_t left =
      std::max(std::int64_t{0}, std::min({left_on_machine(), left_in_control_group(), left_of_address_space()}));
  if (bytes <= left) return;
  constexpr double megabyte = 1e6;
  throw std::runtime_error(fmt::format("{} takes about {:.0f} MB of memory, and {:.0f} MB are left; nothing was begun",
                                       what, static_cast<double>(bytes) / megabyte,
                                       static_cast<double>(left) / megabyte));
}

}  // namespace ikbench::cli
