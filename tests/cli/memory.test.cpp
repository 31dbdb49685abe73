// The memory that is left, by /proc and /sys of machines with either version of control groups.
#include "cli/memory.hpp"

#include <filesystem>
#include <fstream>
#include <limits>

#include "tests/catch.hpp"
#include "tests/scratch_folder.hpp"

using namespace ikbench;
using namespace ikbench::cli;

namespace {

namespace fs = std::filesystem;

void say_in(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

constexpr std::int64_t megabyte = 1'000'000;

// A machine that has 8192 kB, i.e. 8 388 608 bytes, left.
void make_machine(const fs::path& root) {
  say_in(root / "proc/meminfo", "MemTotal:  16384 kB\nMemFree:  100 kB\nMemAvailable:  8192 kB\n");
}

}  // namespace

TEST_CASE("without limits the machine's available memory is left", "[memory]") {
  const ScratchFolder folder;
  make_machine(folder.path);
  CHECK(memory_left(folder.path) == 8192 * 1024);
  CHECK(memory_left(folder.path / "nowhere") == std::numeric_limits<std::int64_t>::max());
  CHECK(memory_left() > 0);
}

TEST_CASE("a group of version 2 has what its limit leaves, and files in its cache count as free", "[memory]") {
  const ScratchFolder folder;
  make_machine(folder.path);
  say_in(folder.path / "proc/self/cgroup", "0::/slurm/job_7/step\n");
  const fs::path job = folder.path / "sys/fs/cgroup/slurm/job_7", step = job / "step";
  say_in(step / "memory.max", "max\n");
  say_in(step / "memory.current", "3000000\n");
  CHECK(memory_left(folder.path) == 8192 * 1024);
  say_in(job / "memory.max", "5000000\n");  // of all steps
  say_in(job / "memory.current", "4000000\n");
  CHECK(memory_left(folder.path) == 1 * megabyte);
  say_in(job / "memory.stat", "anon 1000000\nfile 3000000\ninactive_file 2500000\nactive_file 500000\n");
  CHECK(memory_left(folder.path) == 3'500'000);
  say_in(job / "memory.current", "9000000\n");
  CHECK(memory_left(folder.path) == 0);
}

TEST_CASE("in a container the topmost group is the own one, whatever its name is outside", "[memory]") {
  const ScratchFolder folder;
  make_machine(folder.path);
  say_in(folder.path / "proc/self/cgroup", "12:cpu,cpuacct:/docker/1f\n9:memory:/docker/1f\n0::/docker/1f\n");
  const fs::path own = folder.path / "sys/fs/cgroup/memory";
  say_in(own / "memory.limit_in_bytes", "6000000\n");
  say_in(own / "memory.usage_in_bytes", "5000000\n");
  say_in(own / "memory.stat", "inactive_file 1\ntotal_inactive_file 1000000\n");
  CHECK(memory_left(folder.path) == 2 * megabyte);
}
