// A locked file beside a store tells every machine that sees the folder that somebody writes to the store, and how
// fast. SQLite's own locks do not tell without a log: they last moments. Dates do not tell either: clocks differ, and
// jump.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace ikbench::results {

// While it lives, STORE-writer exists and is locked. It does nothing on a file system without locks, or if another
// writer has it.
class WriterMark {
 public:
  explicit WriterMark(const std::filesystem::path& store);
  ~WriterMark();
  WriterMark(const WriterMark&) = delete;
  WriterMark& operator=(const WriterMark&) = delete;

  // Adds newly stored solves.
  void add(std::int64_t solves);

 private:
  std::filesystem::path file_;
  int descriptor_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::int64_t solves_ = 0;
};

// The solves per second that another process with such a mark has stored, 0 before the first; nothing if there is no
// such process.
std::optional<double> writing_rate(const std::filesystem::path& store);

}  // namespace ikbench::results
