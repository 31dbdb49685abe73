// A locked file beside a store says that somebody writes to it, and how fast, to every machine that sees the folder.
// SQLite's own locks do not, where there is no log: they are held for moments. No date does: clocks differ, and jump.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace ikbench::results {

// While it lives there is STORE-writer, locked. On a file system without locks, or with another writer, it says
// nothing.
class WriterMark {
 public:
  explicit WriterMark(const std::filesystem::path& store);
  ~WriterMark();
  WriterMark(const WriterMark&) = delete;
  WriterMark& operator=(const WriterMark&) = delete;

  // So many solves more are stored.
  void add(std::int64_t solves);

 private:
  std::filesystem::path file_;
  int descriptor_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::int64_t solves_ = 0;
};

// How many solves a second another process that has such a mark has stored, 0 before the first; none: there is no such
// process.
std::optional<double> writing_rate(const std::filesystem::path& store);

}  // namespace ikbench::results
