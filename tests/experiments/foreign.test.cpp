#include <sched.h>

#include <fstream>
#include <thread>
#include <vector>

#include "experiments/foreign/foreign_solver.hpp"
#include "tests/catch.hpp"
#include "tests/scratch_folder.hpp"

using namespace ikbench;
using namespace ikbench::experiments;

namespace {

// It computes for some milliseconds, then answers with the start.
constexpr const char* busy = R"(echo '{"ikbench":1,"message":"hello","name":"busy","version":"1","modes":["solve"]}'
while read -r line; do
  id=${line#*'"id":'} id=${id%%[,\}]*} i=0
  case $line in
    *'"message":"robot"'*) echo '{"message":"ready"}' ;;
    *'"message":"solve"'*)
      while [ $i -lt 2000 ]; do i=$((i + 1)); done
      echo "{\"message\":\"solved\",\"id\":$id,\"q\":[0.1,0.1]}" ;;
    *'"message":"bye"'*) exit ;;
  esac
done
)";

// Keeps this thread, and processes that it starts, on one processor.
void stay_on_one_processor() {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(::sched_getcpu(), &one);
  ::sched_setaffinity(0, sizeof(one), &one);
}

// From here on every other process that wants the processor of this thread gets it.
void give_way() {
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_IDLE, &none);
}

std::vector<Account> accounts_of_busy(const ScratchFolder& folder) {
  std::ofstream(folder.path / "busy.sh") << busy;
  const auto program = meet({.process = {"sh", "busy.sh"}, .patience = 100}, folder.path);
  const robots::Chain arm({{.a = 0.5}, {.a = 0.5}});
  const robots::JointLimits limits{robots::Configuration::Constant(2, -3), robots::Configuration::Constant(2, 3)};
  Sessions sessions(program, robot_message({.name = "two", .arm = arm, .limits = limits, .joint_names = {"a", "b"}},
                                           program->hello, {}));
  const solvers::StopRule stop{.iterations = 1};
  const solvers::Problem problem{
      .start = robots::Configuration::Constant(2, 0.1), .lower = limits.lower, .upper = limits.upper};
  solvers::Objective objective(arm, Eigen::Vector3d(0.3, 0.4, 0));
  numerics::Random random{numerics::Key(1)};
  ForeignSolver solver(sessions, stop);
  std::vector<Account> accounts;
  for (int i = 0; i < 10; ++i) {
    solver.prepare(problem, objective);
    give_way();
    solver.start(problem, objective, random);
    solver.conclude();
    accounts.push_back(solver.account());
  }
  return accounts;
}

}  // namespace

TEST_CASE("the clock of a program's solve runs before the program does", "[foreign]") {
  const ScratchFolder folder;
  std::vector<Account> accounts;
  // As soon as the program can read its message, it has the processor, and we do not.
  std::thread([&] {
    stay_on_one_processor();
    accounts = accounts_of_busy(folder);
  }).join();
  CHECK(accounts.size() == 10);
  for (const Account& account : accounts) {
    CHECK_FALSE(account.failure);
    CHECK(account.cpu_seconds > 1e-4);
    CHECK(account.seconds >= account.cpu_seconds);
  }
}
