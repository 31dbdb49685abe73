#include "base/child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <array>

#include "tests/common.hpp"

using namespace ikbench::base;

TEST_CASE("of a flood of a program's standard error only the end is kept") {
  const auto ran = ChildProcess::run({"sh", "-c", "head -c 1000000 /dev/zero >&2; echo said"}, {}, {});
  CHECK(ran.succeeded);
  CHECK(ran.output.starts_with("said\n"));
  CHECK(ran.output.size() < 100'000);  // a pipe's contents come at the end
}

TEST_CASE("a line ends as Unix or Windows ends it") {
  ChildProcess child({"printf", "a\\r\\nb\\n"}, {}, {});
  const auto deadline = Clock::now() + std::chrono::minutes(1);
  CHECK(child.read_line(deadline) == "a");
  CHECK(child.read_line(deadline) == "b");
}

TEST_CASE("a program has the descriptors that it is given, and no others") {
  std::array<int, 2> given{}, kept{};
  REQUIRE(::pipe(given.data()) == 0);
  REQUIRE(::pipe(kept.data()) == 0);
  const int high = ::fcntl(given[1], F_DUPFD, 20);
  const std::string others =
      "echo given >&3; for i in 4 5 6 7 8 9; do ! true >&$i || echo $i; done 2>/dev/null; echo end";
  ChildProcess child({"bash", "-c", others}, {}, {}, {high});
  CHECK(child.read_line(Clock::now() + std::chrono::minutes(1)) == "end");
  std::string text(6, ' ');
  CHECK(::read(given[0], text.data(), text.size()) == 6);
  CHECK(text == "given\n");
  for (const int descriptor : {given[0], given[1], kept[0], kept[1], high}) ::close(descriptor);
}

TEST_CASE("what a program leaves behind ends with it, also what has a session of its own") {
#ifdef __linux__
  for (const char* leaves : {"sleep 1000 & echo $!", "setsid sleep 1000 & echo $!",
                             "(setsid sh -c 'echo $$; sleep 1000 & exec sleep 1000' &); sleep 0.2"}) {
    const auto ran = ChildProcess::run({"sh", "-c", leaves}, {}, {});
    CHECK(ran.succeeded);
    CHECK(::kill(std::stoi(ran.output), 0) != 0);
  }
#endif
}

TEST_CASE("a program that stops its parent, once or for ever, ends within some seconds") {
#ifdef __linux__
  for (const char* stops :
       {"kill -STOP $PPID; echo $$; exec sleep 1000", "echo $$; while kill -STOP $PPID; do :; done"}) {
    const Clock::time_point began = Clock::now();
    pid_t left = 0;
    {
      ChildProcess child({"sh", "-c", stops}, {}, {});
      left = std::stoi(child.read_line(began + std::chrono::minutes(1)));
      child.end(std::chrono::milliseconds(0));
    }
    CHECK(Clock::now() - began < std::chrono::seconds(60));
    CHECK(::kill(left, 0) != 0);
  }
#endif
}
