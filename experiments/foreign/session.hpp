// A process of a program, used for solve after solve. It is started and greeted when needed, and given up after three
// deaths in a row.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "experiments/foreign/foreign_solver.hpp"

namespace ikbench::experiments {

// The reason why a solve has no answer.
struct Trouble {
  results::Status status;
  std::string why;
};

// The last line of a text, cut for a message.
std::string last_line(std::string_view text);

class Session {
 public:
  Session(const Program& program, const std::string& robot) : program_(program), robot_(robot) {}
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // All these may throw Trouble.
  // Returns true if the process is new. Throws std::runtime_error if the system can start none any more.
  bool ensure_running();
  void drain();                             // call before a solve: discards noise
  void begin_solve(double budget_seconds);  // starts its patience
  // Sends, and receives the next message that has one of these names and belongs to this solve.
  Message exchange(const std::string& text, std::initializer_list<std::string_view> names);

  std::int64_t new_id();  // larger than the last, and not to be foreseen
  std::int64_t id() const { return id_; }
  double cpu_seconds() const { return child_ ? child_->cpu_seconds() : 0; }

  void note(const Trouble& trouble);
  void forgive() { deaths_in_a_row_ = 0; }
  // Call after Trouble: gives the process a second to end the solve, then ends the process.
  void recover(const Trouble& trouble);
  const ProgramNotes& notes() const { return notes_; }

 private:
  void greet();
  void send(const std::string& text);
  Message receive(std::initializer_list<std::string_view> names, std::int64_t id);
  void die(const Trouble& trouble);
  void ignore(const std::string& line, const std::optional<Message>& message);
  void keep(const std::string& noise);

  const Program& program_;
  const std::string& robot_;
  std::unique_ptr<ChildProcess> child_;
  Clock::time_point deadline_{};
  std::int64_t id_ = 0, last_id_ = 0;  // of the present question and of the one before
  std::string ignored_;                // the last ignored line of this solve, as the end of a sentence
  int deaths_in_a_row_ = 0;
  std::optional<Trouble> refusal_;  // set if it declined the arm or is given up
  ProgramNotes notes_;
};

}  // namespace ikbench::experiments
