// The text of a progress and its times; answers to signals.
#include "cli/console.hpp"

#include <signal.h>
#include <unistd.h>

#include "tests/catch.hpp"
#include "tests/results/processes.hpp"

using ikbench::cli::cancelled_exit_code;
using ikbench::cli::CancelOnSignal;
using ikbench::cli::ProgressText;
using ikbench::cli::SignalWatch;
using namespace std::chrono_literals;

TEST_CASE("in a log a line tells the progress every thirty seconds, with rate and time left", "[console]") {
  const ProgressText::Clock::time_point start{};
  ProgressText text("slim2023", ProgressText::Medium::log, start);
  CHECK(text.at(start, {.done = 100, .total = 2400, .reused = 100}) == "");
  CHECK(text.at(start + 29s, {.done = 200, .total = 2400, .reused = 100}) == "");
  // 600 solves in 30 s are 20 a second; 1700 are left: 85 s.
  CHECK(text.at(start + 30s, {.done = 700, .total = 2400, .reused = 100}) ==
        "slim2023: 700/2400 solves, 20/s, 1:25 left\n");
  CHECK(text.at(start + 31s, {.done = 720, .total = 2400, .reused = 100}) == "");
  CHECK(text.at(start + 59s, {.done = 1280, .total = 2400, .reused = 100}) == "");
  CHECK(text.at(start + 60s, {.done = 1300, .total = 2400, .reused = 100}) ==
        "slim2023: 1300/2400 solves, 20/s, 0:55 left\n");
  // After a long solve, the next line is thirty seconds later.
  CHECK(text.at(start + 100s, {.done = 1301, .total = 2400, .reused = 100}) != "");
  CHECK(text.at(start + 129s, {.done = 1302, .total = 2400, .reused = 100}) == "");
}

TEST_CASE("a slow study has a rate too, and before the first solve there is none", "[console]") {
  const ProgressText::Clock::time_point start{};
  ProgressText text("slow", ProgressText::Medium::log, start);
  CHECK(text.at(start + 30s, {.done = 4, .total = 10, .reused = 4}) == "slow: 4/10 solves\n");
  CHECK(text.at(start + 60s, {.done = 7, .total = 10, .reused = 4}) == "slow: 7/10 solves, 0.1/s, 1:00 left\n");
}

TEST_CASE("on a terminal the progress is a bar, ten times a second, that moves no line on", "[console]") {
  const ProgressText::Clock::time_point start{};
  ProgressText text("a\x1b[2J", ProgressText::Medium::terminal, start);
  CHECK(text.at(start, {.done = 0, .total = 2}) == "\r\x1b[Ka\\x1b[2J [..............................] 0/2 solves");
  CHECK(text.at(start + 99ms, {.done = 1, .total = 2}) == "");
  CHECK(text.at(start + 1s, {.done = 1, .total = 2}) ==
        "\r\x1b[Ka\\x1b[2J [###############...............] 1/2 solves, 1.0/s, 0:01 left");
}

TEST_CASE("a signal that was answered is told at the end, and after the end one ends the program",
          "[console][signals]") {
  const pid_t answered = ikbench::in_a_process([] {
    const SignalWatch watch;
    CancelOnSignal signals;
    kill(getpid(), SIGTERM);
    while (!signals.requested()) usleep(1000);
    return signals.end() && cancelled_exit_code() == 128 + SIGTERM;
  });
  CHECK(ikbench::exit_code(answered) == 0);
  const pid_t ended = ikbench::in_a_process([] {
    const SignalWatch watch;
    CancelOnSignal signals;
    if (signals.end()) return false;
    kill(getpid(), SIGTERM);
    for (;;) usleep(1000);
  });
  CHECK(ikbench::exit_code(ended) == 128 + SIGTERM);
}
