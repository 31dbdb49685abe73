// A process of a program while it is used for solve after solve: started and greeted when it is needed, and given up
// after three deaths in a row.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "experiments/foreign/foreign_solver.hpp"

namespace ikbench::experiments {

// Why a solve has no answer.
struct Trouble {
  results::Status status;
  std::string why;
};

// The last line of a text, to stand in a message.
std::string last_line(std::string_view text);

class Session {
 public:
  Session(const Program& program, const std::string& robot) : program_(program), robot_(robot) {}
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // All may throw Trouble.
  // Says whether the process is a new one. std::runtime_error where the system starts none any more.
  bool ensure_running();
  void drain();                                          // before a solve: nothing may wait to be read but noise
  void begin_solve(double budget_seconds, int repeats);  // its patience begins
  void send(const std::string& text);
  // The next message that is one of these and of this solve.
  Message receive(std::initializer_list<std::string_view> names, std::int64_t id);
  // As send and receive, counted as a round trip.
  Message exchange(const std::string& text, std::initializer_list<std::string_view> names, std::int64_t id);

  std::int64_t new_id() { return ++id_; }
  std::int64_t id() const { return id_; }
  double cpu_seconds() const { return child_ ? child_->cpu_seconds() : 0; }
  // For a processor, by the process and by this thread.
  double waited_seconds() const;
  double resident_bytes() const { return child_ ? child_->resident_bytes() : 0; }
  double transport_seconds() const { return transport_seconds_; }
  int round_trips() const { return round_trips_; }

  void note(const Trouble& trouble);
  void forgive() { deaths_in_a_row_ = 0; }
  // After Trouble: gives the process a second to end the solve, else ends it.
  void recover(const Trouble& trouble);
  const ProgramNotes& notes() const { return notes_; }

 private:
  void greet();
  void measure_transport();
  void die(const Trouble& trouble);
  void ignore(const std::string& line, const std::optional<Message>& message);
  void keep(const std::string& noise);

  const Program& program_;
  const std::string& robot_;
  std::unique_ptr<ChildProcess> child_;
  Clock::time_point deadline_{};
  std::int64_t id_ = 0;
  int round_trips_ = 0;
  std::string ignored_;  // the last line of this solve that was not taken, as the end of a sentence
  int deaths_in_a_row_ = 0;
  double transport_seconds_ = std::numeric_limits<double>::quiet_NaN();
  std::optional<Trouble> refusal_;  // it declined, or is given up
  ProgramNotes notes_;
};

}  // namespace ikbench::experiments
