// A program in a study: its command, its identity, and what of it decides the numbers of its solves.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/foreign/child_process.hpp"
#include "experiments/foreign/protocol.hpp"
#include "numerics/fields.hpp"

namespace ikbench::experiments {

// A program as a study names it.
struct ProgramChoice {
  enum class Talk { preferred, solve, ask };

  std::vector<std::string> process;  // the program and its arguments
  std::vector<std::string> files;    // its further files
  Talk mode = Talk::preferred;
  double patience = 0;  // [s] per solve; 0: max(5 s, 20 x its budget)
};

void list_fields(numerics::Fields& io, ProgramChoice& choice);

// SHA-256 in hexadecimal digits; std::invalid_argument if the file cannot be read.
std::string digest_of_file(const std::filesystem::path& file);

struct Program {
  ProgramChoice choice;
  std::filesystem::path folder;  // its working folder
  Hello hello;
  Mode mode = Mode::solve;
  std::string digest;  // of its name, its version and its files

  Command command() const;
  bool is_unchanged() const;  // true if its files are as they were at its hello; false if one is missing
};

constexpr std::chrono::seconds ready_patience{60};

// Starts the program and reads its hello. std::invalid_argument says what is wrong with it, or which file is missing.
std::shared_ptr<const Program> meet(const ProgramChoice& choice, const std::filesystem::path& folder);

// Reads the first message of a program, within 20 s or its patience, and appends noise before it to `noise`. Throws
// Breach, or std::invalid_argument if the program ends or stays silent.
Hello hello_of(ChildProcess& child, const ProgramChoice& choice, std::vector<std::string>& noise);

}  // namespace ikbench::experiments
