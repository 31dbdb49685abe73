#include "experiments/environment.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

#include <Eigen/Core>
#include <chrono>
#include <fstream>
#include <limits>
#include <string_view>
#include <thread>

#include "experiments/source_digest.hpp"
#include "numerics/instruction_set.hpp"

namespace ikbench::experiments {

using namespace numerics;

namespace {

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string operating_system() {
  utsname name{};
  return uname(&name) == 0 ? fmt::format("{} {} {}", name.sysname, name.release, name.machine) : "unknown";
}

// Identifies one start of the system: all its containers share it, whatever their host names.
std::string boot() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  return std::getline(file, id) ? id : "unknown";
}

std::string host() {
  utsname name{};
  return uname(&name) == 0 ? name.nodename : "unknown";
}

}  // namespace

std::map<std::string, std::string> environment() {
  std::map<std::string, std::string> facts = build_facts();
  facts.insert({{"boot", boot()},
                {"compiler", compiler()},
                {"cpu", cpu_model()},
                {"cpus", std::to_string(std::thread::hardware_concurrency())},
                {"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now()))},
                {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
                {"host", host()},
                {"instruction_set", std::string(name_of(instruction_set()))},
                {"os", operating_system()}});
  return facts;
}

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double stolen_seconds() {
  std::ifstream stat("/proc/stat");
  std::string cpu;
  double user = 0, nice = 0, system = 0, idle = 0, waiting = 0, interrupts = 0, soft_interrupts = 0, stolen = 0;
  stat >> cpu >> user >> nice >> system >> idle >> waiting >> interrupts >> soft_interrupts >> stolen;
  if (!stat || cpu != "cpu") return std::numeric_limits<double>::quiet_NaN();
  return stolen / static_cast<double>(sysconf(_SC_CLK_TCK));
}

bool is_debug_build() {
#ifdef NDEBUG
  return build_facts().at("sanitizers") != "none";
#else
  return true;
#endif
}

std::string version() {
  const std::map<std::string, std::string> facts = build_facts();
  return fmt::format("{} ({}, source {})", facts.at("version"), facts.at("commit"), source_digest());
}

std::string program_name() { return "ikbench " + version(); }

}  // namespace ikbench::experiments
