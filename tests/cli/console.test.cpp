// Tests of the terminal: the text of a progress bar and its times, wrapping, folders, and answers to signals.
#include "cli/console.hpp"

#include <signal.h>

#include "tests/base/processes.hpp"

using ikbench::cli::align_columns;
using ikbench::cli::cancelled_exit_code;
using ikbench::cli::CancelOnSignal;
using ikbench::cli::output_folder;
using ikbench::cli::ProgressBar;
using ikbench::cli::SignalWatch;
using ikbench::cli::wrapped;
using namespace std::chrono_literals;

TEST_CASE("in a log a line tells the progress every thirty seconds, with rate and time left", "[console]") {
  const ProgressBar::Clock::time_point start{};
  ProgressBar bar("slim2023", "solves", false, start);
  CHECK(bar.text_at(start, {.done = 100, .total = 2400, .reused = 100}) == "");
  CHECK(bar.text_at(start + 29s, {.done = 200, .total = 2400, .reused = 100}) == "");
  // 600 solves in 30 s are 20 a second; 1700 are left: 85 s.
  CHECK(bar.text_at(start + 30s, {.done = 700, .total = 2400, .reused = 100}) ==
        "slim2023: 700/2400 solves, 20/s, 1:25 left\n");
  CHECK(bar.text_at(start + 31s, {.done = 720, .total = 2400, .reused = 100}) == "");
  CHECK(bar.text_at(start + 59s, {.done = 1280, .total = 2400, .reused = 100}) == "");
  CHECK(bar.text_at(start + 60s, {.done = 1300, .total = 2400, .reused = 100}) ==
        "slim2023: 1300/2400 solves, 20/s, 0:55 left\n");
  // After a long solve, the next line is thirty seconds later.
  CHECK(bar.text_at(start + 100s, {.done = 1301, .total = 2400, .reused = 100}) != "");
  CHECK(bar.text_at(start + 129s, {.done = 1302, .total = 2400, .reused = 100}) == "");
}

TEST_CASE("a slow study has a rate too, and before the first solve there is none", "[console]") {
  const ProgressBar::Clock::time_point start{};
  ProgressBar bar("slow", "stores", false, start);
  CHECK(bar.text_at(start + 30s, {.done = 4, .total = 10, .reused = 4}) == "slow: 4/10 stores\n");
  CHECK(bar.text_at(start + 60s, {.done = 7, .total = 10, .reused = 4}) == "slow: 7/10 stores, 0.1/s, 1:00 left\n");
}

TEST_CASE("on a terminal the progress is a bar, ten times a second, that moves no line on", "[console]") {
  const ProgressBar::Clock::time_point start{};
  ProgressBar bar("a\x1b[2J", "solves", true, start);
  CHECK(bar.text_at(start, {.done = 0, .total = 2}) == "\r\x1b[Ka\\x1b[2J [..............................] 0/2 solves");
  CHECK(bar.text_at(start + 99ms, {.done = 1, .total = 2}) == "");
  CHECK(bar.text_at(start + 1s, {.done = 1, .total = 2}) ==
        "\r\x1b[Ka\\x1b[2J [###############...............] 1/2 solves, 1.0/s, 0:01 left");
}

TEST_CASE("lines break between words, and the further ones are indented", "[console]") {
  CHECK(wrapped("one two three", 100) == "one two three");
  CHECK(wrapped("one two three", 13) == "one two three");
  CHECK(wrapped("one two three", 12) == "one two\n  three");
  CHECK(wrapped("one two three four", 9) == "one two\n  three\n  four");
  CHECK(wrapped("a\nb c", 3) == "a\nb c");
  CHECK(wrapped("\u00e9\u00e9\u00e9 \u00e9\u00e9", 6) == "\u00e9\u00e9\u00e9 \u00e9\u00e9");  // characters, not bytes
  CHECK(wrapped("/a/path/that/is/long is whole", 10) == "/a/path/that/is/long\n  is whole");
  CHECK(wrapped("", 10).empty());
  CHECK(wrapped("a\x1b[2J", 10) == "a\\x1b[2J");
}

TEST_CASE("rows that are too wide wrap the words of their widest columns", "[console]") {
  CHECK(align_columns({{"A", "B"}, {"1", "one two"}}, 100) == "A  B\n1  one two\n");
  CHECK(align_columns({{"A", "B"}, {"1", "one two"}}, 9) == "A  B\n1  one\n   two\n");
  CHECK(align_columns({{"A", "B", "C"}, {"1", "one two", "x"}}, 10) == "A  B     C\n1  one   x\n   two\n");
  CHECK(align_columns({{"A"}, {"longword"}}, 4) == "A\nlongword\n");
  CHECK(align_columns({}, 10).empty());
}

TEST_CASE("a folder has the letters of its study's name", "[console]") {
  CHECK(output_folder("Kurs – Übung 1/2", "") == "out/Kurs_–_Übung_1_2");
  CHECK(output_folder("../a\nb\u202e\xff", "") == "out/_.._a_b_\uFFFD");
  CHECK(output_folder(std::string(99, 'a') + "ü", "") == "out/" + std::string(99, 'a'));
  CHECK(output_folder("a", "b/c") == "b/c");
  CHECK(output_folder("..", "") == "out/_..");
  CHECK(output_folder("/abs", "") == "out/_abs");
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
