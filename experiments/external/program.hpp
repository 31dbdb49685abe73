// A program in a study: its command, its identity, and how messages are exchanged with its process. The reader of
// studies probes each program once; external_solver.hpp runs it. Protocol: docs/reference/protocol.md.
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
  double timeout = 0;                // [s] per message; 0: max(5 s, 20 x stop.seconds per problem), without that 60 s
  int batch = 0;                     // most problems in a message; 0: one by one
};

void list_fields(base::Fields& io, ProgramSpec& choice);

// Returns the digest of a file. Throws std::invalid_argument if it cannot be read.
std::string file_digest(const std::filesystem::path& file);

// A program that has been started once and has introduced itself.
struct Program {
  ProgramSpec choice;
  std::filesystem::path folder;  // its working folder
  Hello hello;
  std::string digest;  // hash of its name, its version and its files

  // Returns true if the files are as they were at the hello. Throws std::invalid_argument if one cannot be read.
  bool is_unchanged() const;
};

// Starts a program and reads its hello. Throws std::invalid_argument if the program does not start or breaks the
// protocol, or if a file is missing.
std::shared_ptr<const Program> probe(const ProgramSpec& choice, const std::filesystem::path& folder);

// Returns a new process of a program, and sets its `hello`. Throws ProcessFailure, or std::invalid_argument if the
// program cannot be started.
std::unique_ptr<ChildProcess> launch(const ProgramSpec& choice, const std::filesystem::path& folder, Hello& hello);

// Returns the text of the arm's URDF file; empty for an arm that is not of a URDF file.
std::string urdf_text_for(const Program& program, const std::string& robot);

constexpr double start_timeout = 20;            // [s], for the hello and the first message
Clock::time_point deadline_in(double seconds);  // from now
// Returns the next message. Lines that do not begin with { are noise, which the failure shows if no message follows.
// Throws ProcessFailure.
Message read_message(ChildProcess& child, Clock::time_point deadline);
// Sends a text and returns the next message. Throws ProcessFailure.
Message send_request(ChildProcess& child, const std::string& text, Clock::time_point deadline);
// Waits up to `timeout` [s] for a message that nobody asked for. Returns `timed_out` if none came, which is the good
// case, `crashed` if the process ended, and `protocol_error` for a message.
ProcessFailure unsolicited_message(ChildProcess& child, double timeout);

}  // namespace ikbench::experiments
