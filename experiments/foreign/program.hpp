// A program in a study: its command, its identity, and what of it decides the numbers of its solves.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/fields.hpp"
#include "experiments/foreign/protocol.hpp"

namespace ikbench::experiments {

// A program as a study names it.
struct ProgramChoice {
  std::vector<std::string> process;  // the program and its arguments
  std::vector<std::string> files;    // its further files
  int memory_mb = 0;                 // of each of its processes; 0: as much as there is
  double patience = 0;               // [s] per message; 0: max(5 s, 20 x stop.seconds of each), without that 60 s
  int batch = 0;                     // problems in a message; 0: one by one
};

void list_fields(base::Fields& io, ProgramChoice& choice);

// Throws std::invalid_argument if the file cannot be read.
std::string digest_of_file(const std::filesystem::path& file);

struct Program {
  ProgramChoice choice;
  std::filesystem::path folder;  // its working folder
  Hello hello;
  std::string digest;  // of its name, its version and its files

  // Its files are as they were at its hello. Throws std::invalid_argument if one cannot be read.
  bool is_unchanged() const;
};

// Starts the program and reads its hello. std::invalid_argument says what is wrong with it, or which file is missing.
std::shared_ptr<const Program> meet(const ProgramChoice& choice, const std::filesystem::path& folder);

// A fresh process of it, its hello read. Throws Trouble, or std::invalid_argument if it cannot be started.
std::unique_ptr<ChildProcess> started(const ProgramChoice& choice, const std::filesystem::path& folder, Hello& hello);

// The text of the arm's URDF file; empty if it is of none.
std::string own_urdf(const Program& program, const std::string& robot);

constexpr double start_patience = 20;     // [s] with a program that starts
Clock::time_point after(double seconds);  // from now
// The next message; lines that do not begin with { are noise, which is told if no message follows. Throws Trouble.
Message next_message(ChildProcess& child, Clock::time_point deadline);
Message exchange(ChildProcess& child, const std::string& text, Clock::time_point deadline);
// What it does within `patience` though nothing is asked: `timed_out` is silence, `crashed` its end.
Trouble unasked(ChildProcess& child, double patience);  // [s]

}  // namespace ikbench::experiments
