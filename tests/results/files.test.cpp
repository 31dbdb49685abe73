#include "results/files.hpp"

#include <signal.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <set>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "tests/catch.hpp"
#include "tests/results/processes.hpp"
#include "tests/results/samples.hpp"

namespace ikbench::results {
namespace {

namespace fs = std::filesystem;

TEST_CASE("what killed processes left is removed, and nothing else", "[files]") {
  const ScratchFolder folder;
  const fs::path& place = folder.path;
  const fs::path elsewhere = place / "elsewhere";
  const pid_t dead = in_a_process([] { return true; });
  exit_code(dead);
  const std::string number = std::to_string(dead), alive = std::to_string(getpid());
  const fs::path drawing = place / (".ikbench-" + number + "-aBcDeF"), half = place / ("table.md.ikbench-" + number);
  write_file(elsewhere / "kept.txt", "kept");
  fs::create_directories(drawing / "deep");
  write_text(drawing / "deep" / "figure.gp", "plot");
  write_text(half, "| a");
  std::set<fs::path> kept{place / "table.md.ikbench-x", place / ("ikbench-" + number), place / (half.string() + "x"),
                          place / ("table.md.ikbench-" + alive)};
  for (const fs::path& file : kept) write_text(file, "of somebody else");
  fs::create_directory_symlink(elsewhere, place / (".ikbench-" + number));
  fs::create_symlink(elsewhere / "kept.txt", place / ("link.ikbench-" + number));
  const TemporaryFolder scratch(place);

  remove_litter(place);

  CHECK_FALSE(fs::exists(drawing));
  CHECK_FALSE(fs::exists(half));
  kept.insert(
      {elsewhere / "kept.txt", place / (".ikbench-" + number), place / ("link.ikbench-" + number), scratch.path()});
  for (const fs::path& each : kept) CHECK(fs::exists(each));
}

TEST_CASE("a scratch folder is litter as soon as its process is killed", "[files]") {
  const ScratchFolder folder;
  const pid_t child = in_a_process([&] {
    const TemporaryFolder scratch(folder.path);
    write_file(scratch.path() / "figure.gp", "plot");
    return raise(SIGKILL) == 0;
  });
  CHECK(exit_code(child) == -1);
  REQUIRE_FALSE(fs::is_empty(folder.path));
  remove_litter(folder.path);
  CHECK(fs::is_empty(folder.path));
}

TEST_CASE("who removes litter takes nothing from those who write meanwhile", "[files]") {
  const ScratchFolder folder;
  const pid_t sweeper = in_a_process([&] {
    for (;;) remove_litter(folder.path);
    return true;
  });
  int failures = 0;
  for (int i = 0; i < 2000; ++i) {
    try {
      write_file(folder.path / "solves.csv", "whole");
    } catch (const std::exception&) {
      ++failures;
    }
  }
  kill(sweeper, SIGKILL);
  CHECK(exit_code(sweeper) == -1);
  CHECK(failures == 0);
}

TEST_CASE("who writes a file or folder again removes what a killed process left of it, and nothing else", "[files]") {
  const ScratchFolder folder;
  const auto killed = [](const std::function<void()>& action) {
    CHECK(exit_code(in_a_process([&] {
            action();
            return false;
          })) == -1);
  };
  const auto names = [&] {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder.path)) found.insert(entry.path().filename().string());
    return found;
  };
  write_text(folder.path / "other.csv.ikbench-1", "of a process that lives");
  killed([&] {
    write_file(folder.path / "a.csv", [](const Write& write) {
      write("half");
      raise(SIGKILL);
    });
  });
  killed([&] {
    write_folder(folder.path / "b", [](const fs::path& place) {
      write_file(place / "c", "half");
      raise(SIGKILL);
    });
  });
  CHECK(names().size() == 2);  // the second write removed what the first left
  CHECK_FALSE(fs::exists(folder.path / "a.csv"));
  CHECK_FALSE(fs::exists(folder.path / "b"));
  write_file(folder.path / "a.csv", "whole");
  write_folder(folder.path / "b", [](const fs::path& place) { write_file(place / "c", "whole"); });
  CHECK(names() == std::set<std::string>{"a.csv", "b", "other.csv.ikbench-1"});
  CHECK(text_in(folder.path / "b" / "c") == "whole");
}

TEST_CASE("a folder is whole or not there, and takes the place of an empty one alone", "[files]") {
  const ScratchFolder folder;
  CHECK_THROWS_AS(write_folder(folder.path / "a", [](const fs::path&) { throw std::logic_error("no"); }),
                  std::logic_error);
  CHECK(fs::is_empty(folder.path));
  fs::create_directory(folder.path / "empty");
  write_folder(folder.path / "empty/", [](const fs::path& place) { write_file(place / "c", "whole"); });
  CHECK(text_in(folder.path / "empty" / "c") == "whole");
  CHECK_THAT(complaint<std::invalid_argument>([&] { write_folder(folder.path / "empty", [](const fs::path&) {}); }),
             ContainsSubstring("cannot write " + quoted(folder.path / "empty")));
  CHECK(text_in(folder.path / "empty" / "c") == "whole");
}

TEST_CASE("a process that ends gives no half folder its name", "[files]") {
  const ScratchFolder folder;
  const pid_t child = in_a_process([&] {
    std::atomic<bool> is_removed = false;
    std::jthread ending;
    write_folder(folder.path / "a", [&](const fs::path& place) {
      write_file(place / "b" / "c", "half");
      ending = std::jthread([&] {
        remove_temporary_folders();
        is_removed = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        _exit(3);
      });
      while (!is_removed) std::this_thread::yield();
      write_file(place / "d" / "e", "half");
    });
    return true;
  });
  CHECK(exit_code(child) == 3);
  CHECK_FALSE(fs::exists(folder.path / "a"));
}

TEST_CASE("litter in a folder that does not exist is none", "[files]") {
  CHECK_NOTHROW(remove_litter(ScratchFolder().path / "missing"));
}

TEST_CASE("a scratch folder is its owner's alone and gone at the end", "[files]") {
  const ScratchFolder folder;
  fs::path first;
  {
    const TemporaryFolder scratch(folder.path), other(folder.path);
    first = scratch.path();
    CHECK(first != other.path());
    CHECK(fs::status(first).permissions() == fs::perms::owner_all);
    write_file(first / "figure.gp", "plot");
  }
  CHECK(fs::is_empty(folder.path));
}

TEST_CASE("what the contents throw is told as it is, not as a failure to write", "[files]") {
  const ScratchFolder folder;
  const auto cannot_read = [](const Write& write) {
    write("half");
    throw std::system_error(std::make_error_code(std::errc::io_error), "cannot read the source");
  };
  CHECK_THROWS_WITH(write_file(folder.path / "table.md", cannot_read),
                    Catch::Matchers::StartsWith("cannot read the source"));
  CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a scratch folder that cannot be made is reported with its place", "[files]") {
  const ScratchFolder folder;
  write_file(folder.path / "file", "no folder");
  CHECK_THROWS_WITH(TemporaryFolder(folder.path / "file"), ContainsSubstring("/file'"));
}

}  // namespace
}  // namespace ikbench::results
