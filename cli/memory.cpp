#include "cli/memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

namespace ikbench::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t no_limit_known = std::numeric_limits<std::int64_t>::max();

// The number at the begin of a file; nothing if there is no file, or if it says "max".
std::optional<std::int64_t> number_in(const fs::path& file) {
  std::ifstream stream(file);
  std::int64_t number = 0;
  return stream >> number ? std::optional(number) : std::nullopt;
}

// The number in the line "name number" or "name: number".
std::optional<std::int64_t> number_in(const fs::path& file, const std::string& name) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string word;
    std::int64_t number = 0;
    if (words >> word >> number && word == name) return number;
  }
  return std::nullopt;
}

// The file names of a version of control groups.
struct GroupFiles {
  const char *limit, *used, *inactive;
};
constexpr GroupFiles version_1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"};
constexpr GroupFiles version_2{"memory.max", "memory.current", "inactive_file"};

std::int64_t left_in_group(const fs::path& group, const GroupFiles& files) {
  const auto limit = number_in(group / files.limit), used = number_in(group / files.used);
  if (!limit || !used) return no_limit_known;
  return *limit - *used + number_in(group / "memory.stat", files.inactive).value_or(0);
}

// The memory left in the process's group and all above it. In a container the group may have another name outside,
// under which nothing is mounted; then the container's own group is the topmost.
std::int64_t left_in_groups(const fs::path& mount, fs::path group, const GroupFiles& files) {
  std::int64_t left = left_in_group(mount, files);
  for (group = group.relative_path(); !group.empty(); group = group.parent_path())
    left = std::min(left, left_in_group(mount / group, files));
  return left;
}

// Reads lines "id:controllers:group"; version 2 has the id 0 and no controllers (cgroups(7)).
std::int64_t left_in_control_groups(const fs::path& root) {
  std::int64_t left = no_limit_known;
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = ',' + line.substr(first + 1, second - first - 1) + ',';
    const fs::path group = line.substr(second + 1), mounts = root / "sys/fs/cgroup";
    if (controllers == ",,") left = std::min(left, left_in_groups(mounts, group, version_2));
    if (controllers.find(",memory,") != std::string::npos)
      left = std::min(left, left_in_groups(mounts / "memory", group, version_1));
  }
  return left;
}

std::int64_t left_of_address_space(const fs::path& root) {
  rlimit limit{};
  const auto pages = number_in(root / "proc/self/statm");
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || !pages) return no_limit_known;
  return static_cast<std::int64_t>(limit.rlim_cur) - *pages * sysconf(_SC_PAGESIZE);
}

}  // namespace

std::int64_t memory_left(const fs::path& root) {
  constexpr std::int64_t kilobyte = 1024;
  const auto available = number_in(root / "proc/meminfo", "MemAvailable:");
  return std::max(std::int64_t{0}, std::min({available ? *available * kilobyte : no_limit_known,
                                             left_in_control_groups(root), left_of_address_space(root)}));
}

}  // namespace ikbench::cli
