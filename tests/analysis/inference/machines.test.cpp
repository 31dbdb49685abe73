// The machines that solved a study.
#include <vector>

#include "analysis/inference/comparable.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;

namespace {

Session on(const char* cpu, const char* host, const char* boot) {
  return {.environment = {{"cpu", cpu}, {"host", host}, {"boot", boot}}};
}

std::set<std::string> machines(const std::vector<Session>& sessions) { return machines_of(sessions); }

}  // namespace

TEST_CASE("hosts of the same CPU are several machines", "[machines]") {
  CHECK(machines({on("Xeon", "node1", "1"), on("Xeon", "node2", "2")}) ==
        std::set<std::string>{"Xeon on node1", "Xeon on node2"});
}

TEST_CASE("a machine that started anew, or whose containers have names of their own, is one", "[machines]") {
  CHECK(machines({on("Xeon", "node1", "1"), on("Xeon", "node1", "2")}) == std::set<std::string>{"Xeon"});
  CHECK(machines({on("Xeon", "a1b2", "1"), on("Xeon", "c3d4", "1")}) == std::set<std::string>{"Xeon"});
}

TEST_CASE("sessions of older stores name the CPU alone", "[machines]") {
  CHECK(machines({{.environment = {{"cpu", "Xeon"}}}, on("Xeon", "node1", "1")}) == std::set<std::string>{"Xeon"});
  CHECK(machines({{.environment = {}}}).empty());
}
