// A locked file beside a store says that somebody writes to it, to every machine that sees the folder. SQLite's own
// locks do not, where there is no log: they are held for moments.
#pragma once

#include <filesystem>

namespace ikbench::results {

// While it lives there is STORE-writer, locked. On a file system without locks, or with another writer, it says
// nothing.
class WriterMark {
 public:
  explicit WriterMark(const std::filesystem::path& store);
  ~WriterMark();
  WriterMark(const WriterMark&) = delete;
  WriterMark& operator=(const WriterMark&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_;
};

// Whether another process has such a mark.
bool is_being_written(const std::filesystem::path& store);

}  // namespace ikbench::results
