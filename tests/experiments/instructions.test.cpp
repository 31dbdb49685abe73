// The processor's count of instructions, where the machine has one.
#include "experiments/instructions.hpp"

#include <cmath>
#include <thread>

#include "tests/catch.hpp"

using namespace ikbench::experiments;

namespace {

double counted(int additions) {
  const double before = thread_instructions();
  volatile double sum = 0;
  for (int i = 0; i < additions; ++i) sum = sum + 1;
  return thread_instructions() - before;
}

}  // namespace

TEST_CASE("ten times the work takes about ten times the instructions, or none are counted", "[instructions]") {
  counted(1);
  const double once = counted(100'000), tenfold = counted(1'000'000);
  CHECK(std::isnan(once) == std::isnan(tenfold));
  if (std::isnan(once)) return;
  CHECK(once > 100'000);
  CHECK(tenfold / once > 9);
  CHECK(tenfold / once < 11);
}

TEST_CASE("a thread counts its own instructions alone", "[instructions]") {
  double of_other = 0;
  const double before = thread_instructions();
  std::thread([&] { of_other = counted(10'000'000); }).join();
  const double own = thread_instructions() - before;
  CHECK(std::isnan(own) == std::isnan(of_other));
  if (!std::isnan(own)) CHECK(own < of_other);
}
