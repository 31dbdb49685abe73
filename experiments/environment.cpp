#include "experiments/environment.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>
#include <time.h>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <utility>

#include "build_info.hpp"
#include "numerics/instruction_set.hpp"

namespace ikbench::experiments {

namespace {

#include "source_digests.inc"

#if defined(__clang__)
constexpr const char* compiler = "clang " __clang_version__;
#else
constexpr const char* compiler = "g++ " __VERSION__;
#endif

}  // namespace

std::string cpu_model(std::istream&& info) {
  std::string numbers;
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) continue;
    if (line.starts_with("model name")) return line.substr(colon + 2);
    if (line.starts_with("CPU implementer")) numbers = "ARM " + line.substr(colon + 2);
    if (line.starts_with("CPU part")) return numbers + ' ' + line.substr(colon + 2);
  }
  return "unknown";
}

std::map<std::string, std::string> environment() {
  utsname system{};
  uname(&system);
  std::string boot = "unknown";  // a start of the system; all its containers share this, whatever their host names
  std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), boot);
  return {{"boot", boot},
          {"build_type", build_info::build_type},
          {"commit", build_info::commit},
          {"compiler", compiler},
          {"cpu", cpu_model(std::ifstream("/proc/cpuinfo"))},
          {"cpus", std::to_string(std::thread::hardware_concurrency())},
          {"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now()))},
          {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"flags", build_info::flags},
          {"host", system.nodename},
          {"instruction_set", std::string(name_of(numerics::instruction_set()))},
          {"os", fmt::format("{} {} {}", system.sysname, system.release, system.machine)},
          {"sanitizers", build_info::sanitize},
          {"source", shared_source_digest()},
          {"version", build_info::version}};
}

double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool is_debug_build() {
#ifdef NDEBUG
  return std::string_view(build_info::sanitize) != "none";
#else
  return true;
#endif
}

std::filesystem::path executable_path() {
#ifdef __APPLE__
  std::array<char, 4096> path{};
  auto size = static_cast<std::uint32_t>(path.size());
  if (_NSGetExecutablePath(path.data(), &size) == 0) return path.data();
#endif
  return "/proc/self/exe";
}

std::string program_name() {
  return fmt::format("ikbench {} ({}, source {})", build_info::version, build_info::commit, of_all);
}

std::string shared_source_digest() { return std::string(shared); }

std::string solver_source_digest(std::string_view solver) {
  const auto* const found =
      std::ranges::find(of_solvers, solver, &std::pair<std::string_view, std::string_view>::first);
  if (found == std::end(of_solvers)) throw std::logic_error("a solver without a source");
  return std::string(found->second);
}

}  // namespace ikbench::experiments
