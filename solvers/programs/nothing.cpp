// Answers at once with its start: what a call of a program in C++ costs.
#include "ikbench_program.hpp"

int main() {
  ikbench::run(
      "nothing", {}, [](const ikbench::Robot& robot) { return robot; },
      [](const ikbench::Robot&, ikbench::Problem& problem) { return problem.start; }, R"(["pose"])");
}
