// A program in a study: how it is started, who it is, and what of it decides the numbers of its solves.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/fields.hpp"
#include "experiments/foreign/child_process.hpp"
#include "experiments/foreign/protocol.hpp"

namespace ikbench::experiments {

// As a study says it.
struct ProgramChoice {
  enum class Talk { preferred, solve, ask };

  std::vector<std::string> process;  // the program and its arguments
  std::string shared_object;         // instead of a program
  std::string solver;                // its name in the shared object; empty: the first
  std::vector<std::string> files;    // what it consists of besides
  Talk mode = Talk::preferred;
  double patience = 0;  // [s] with a solve; 0: max(5 s, 20 x its budget)

  bool is_hosted() const { return !shared_object.empty(); }
  const std::string& name() const { return is_hosted() ? shared_object : process[0]; }
};

void list_fields(Fields& io, ProgramChoice& choice);

// SHA-256 in hexadecimal digits; std::invalid_argument where the file cannot be read.
std::string digest_of_file(const std::filesystem::path& file);
std::string digest_of_text(std::string_view text);

struct Program {
  ProgramChoice choice;
  std::filesystem::path folder;  // that it works in
  Hello hello;
  Mode mode = Mode::solve;
  std::string digest;  // of its name, its version and its files

  Command command() const;
  bool is_unchanged() const;  // its files are what they were at its hello; a missing one is not
};

constexpr std::chrono::seconds ready_patience{60};

// Starts the program for its hello. std::invalid_argument says what is wrong with it; a file that is missing too.
std::shared_ptr<const Program> meet(const ProgramChoice& choice, const std::filesystem::path& folder);

// The first message of a program, within 20 s or its patience; what was noise before it goes to `noise`. Breach, or
// std::invalid_argument where it ends or says nothing in time.
Hello hello_of(ChildProcess& child, const ProgramChoice& choice, std::vector<std::string>& noise);

}  // namespace ikbench::experiments
