#include "base/files.hpp"

#include <signal.h>

#include "tests/base/processes.hpp"

namespace ikbench::base {
namespace {

namespace fs = std::filesystem;

TEST_CASE("what a killed process left a day ago is removed by the next write, and nothing else", "[files]") {
  const ScratchFolder folder;
  const fs::path& place = folder.path;
  const auto names = [&] {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(place)) found.insert(entry.path().filename().string());
    return found;
  };
  const auto age = [&](int hours) {
    for (const std::string& name : names())
      if (!fs::is_symlink(place / name))
        fs::last_write_time(place / name, fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  for (const char* name : {"notes.ikbench-2024", ".ikbench-2024", ".ikbench-aBcDeF"}) write_text(place / name, "mine");
  fs::create_directory(place / "ikbench-aBcDeFg");
  fs::create_directory_symlink(place / "ikbench-aBcDeFg", place / ".ikbench-linked");
  std::set<std::string> kept = names();
  age(25);
  const pid_t child = in_a_process([&] {
    write_file(place / "b", [](const Write& write) {
      write("half");
      raise(SIGKILL);
    });
    return false;
  });
  CHECK(exit_code(child) == -1);
  CHECK(names().size() == kept.size() + 1);  // one that works is not told from one that was killed
  write_file(place / "a.csv", "whole");
  CHECK(names().size() == kept.size() + 2);
  age(23);
  write_file(place / "a.csv", "whole");
  CHECK(names().size() == kept.size() + 2);
  age(25);
  write_file(place / "a.csv", "whole");
  kept.insert("a.csv");
  CHECK(names() == kept);
}

TEST_CASE("a process that ends gives no half file its name", "[files]") {
  const ScratchFolder folder;
  const pid_t child = in_a_process([&] {
    std::atomic<bool> is_removed = false;
    std::future<void> ending;
    write_file(folder.path / "a", [&](const Write& write) {
      write("half");
      ending = std::async(std::launch::async, [&] {
        remove_temporary_folders();
        is_removed = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        _exit(3);
      });
      while (!is_removed) std::this_thread::yield();
    });
    return true;
  });
  CHECK(exit_code(child) == 3);
  CHECK_FALSE(fs::exists(folder.path / "a"));
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
  CHECK_THROWS_WITH(write_file(folder.path / "table.md", cannot_read), StartsWith("cannot read the source"));
  CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a file is read in parts, and one that is no file is not", "[files]") {
  const ScratchFolder folder;
  std::string text;
  for (int i = 0; i < 5000; ++i) text += std::to_string(i);
  write_file(folder.path / "long", text);
  std::string parts;
  std::size_t largest = 0;
  read_in_parts(folder.path / "long", [&](std::string_view part) {
    parts += part;
    largest = std::max(largest, part.size());
    return true;
  });
  CHECK(parts == text);
  CHECK(largest < text.size());
  CHECK(read_file(folder.path / "long", 100)->size() < text.size());
  for (const fs::path& none : {folder.path, folder.path / "none"})
    CHECK_FALSE(read_in_parts(none, [](std::string_view) { return true; }));
}

TEST_CASE("a scratch folder that cannot be made is reported with its place", "[files]") {
  const ScratchFolder folder;
  write_file(folder.path / "file", "no folder");
  CHECK_THROWS_WITH(TemporaryFolder(folder.path / "file"), ContainsSubstring("/file'"));
}

TEST_CASE("a file that cannot be read is none without contents", "[files]") {
  const ScratchFolder folder;
  CHECK(read_file(folder.path / "none") == std::nullopt);
  CHECK(read_file("/dev/zero") == std::nullopt);
  write_file(folder.path / "a", std::string(100'000, 'x'));
  CHECK(read_file(folder.path / "a")->size() == 100'000);
  CHECK(read_file(folder.path / "a", 10)->size() < 100'000);
#ifdef __linux__
  CHECK_THAT(complaint<std::runtime_error>([&] { read_file("/proc/self/mem"); }), StartsWith("cannot read '/proc/"));
#endif
  fs::create_symlink("loop", folder.path / "loop");
  CHECK(read_file(folder.path / "loop") == std::nullopt);
}

}  // namespace
}  // namespace ikbench::base
