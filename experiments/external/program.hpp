// A program in a study: its command, its identity, and what of it decides the numbers of its solves.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/fields.hpp"
#include "experiments/external/protocol.hpp"

namespace ikbench::experiments {

// A program as a study names it.
struct ProgramSpec {
  std::vector<std::string> process;  // the program and its arguments
  std::vector<std::string> files;    // further files on which it depends
  int memory_mb = 0;                 // per process; 0: no limit
  double timeout = 0;                // [s] per message; 0: max(5 s, 20 x stop.seconds of each), without that 60 s
  int batch = 0;                     // problems in a message; 0: one by one
};

void list_fields(base::Fields& io, ProgramSpec& choice);

// Returns the digest of a file. Throws std::invalid_argument if it cannot be read.
std::string file_digest(const std::filesystem::path& file);

// A program that was started once and introduced itself.
struct Program {
  ProgramSpec choice;
  std::filesystem::path folder;  // its working folder
  Hello hello;
  std::string digest;  // hash of its name, its version and its files

  // Returns true if its files are as they were at its hello. Throws std::invalid_argument if one cannot be read.
  bool is_unchanged() const;
};

// Starts the program and reads its hello. Throws std::invalid_argument, which says what is wrong with it, or which file
// is missing.
std::shared_ptr<const Program> probe(const ProgramSpec& choice, const std::filesystem::path& folder);

// Returns a new process of the program, after its hello. Throws Trouble, or std::invalid_argument if it cannot be
// started.
std::unique_ptr<ChildProcess> launch(const ProgramSpec& choice, const std::filesystem::path& folder, Hello& hello);

// Returns the text of the arm's URDF file; empty if the arm is of no such file.
std::string urdf_text_for(const Program& program, const std::string& robot);

constexpr double start_timeout = 20;            // [s] with a program that starts
Clock::time_point deadline_in(double seconds);  // from now
// Returns the next message. Lines that do not begin with { are noise, which the error shows if no message follows.
// Throws Trouble.
Message read_message(ChildProcess& child, Clock::time_point deadline);
Message send_request(ChildProcess& child, const std::string& text, Clock::time_point deadline);
// Waits up to `patience` [s] for a message that was not asked for. Returns `timed_out` if none came, which is the good
// case, and `crashed` if the process ended.
ProcessFailure unsolicited_message(ChildProcess& child, double patience);  // [s]

}  // namespace ikbench::experiments
