#include "experiments/foreign/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <utility>

#include "numerics/names.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace results;

namespace {

constexpr int most_deaths_in_a_row = 3;
constexpr std::size_t kept_noise = 100, longest_kept_noise = 200;
constexpr std::chrono::seconds farewell{1};

}  // namespace

std::string last_line(std::string_view text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.remove_suffix(1);
  const std::size_t before = text.find_last_of('\n');
  return std::string(front(text.substr(before == std::string_view::npos ? 0 : before + 1), 200));
}

Session::~Session() {
  if (!child_) return;
  child_->write(bye_message(), Clock::now() + farewell);
  child_->end(farewell);
}

bool Session::ensure_running() {
  if (refusal_) throw Trouble(*refusal_);
  if (child_ && child_->is_running()) return false;
  if (child_) die({Status::crashed, "it ended between two solves"});
  if (refusal_) throw Trouble(*refusal_);
  if (!program_.is_unchanged()) {
    refusal_ = Trouble{Status::crashed, "its files changed while it ran; run the study again"};
    throw Trouble(*refusal_);
  }
  try {
    child_ = std::make_unique<ChildProcess>(program_.command());
  } catch (const std::invalid_argument& error) {  // it started before, so this is no result of the program
    throw std::runtime_error(
        fmt::format("{}, which it could before; run the study again, and it goes on", error.what()));
  }
  try {
    greet();
  } catch (const std::invalid_argument& error) {
    throw Trouble{Status::crashed, error.what()};
  } catch (const Breach& breach) {
    throw Trouble{Status::broke_protocol, breach.what()};
  }
  return true;
}

void Session::greet() {
  std::vector<std::string> noise;
  const Hello hello = hello_of(*child_, program_.choice, noise);
  notes_.noise += static_cast<std::int64_t>(noise.size());
  for (const std::string& line : noise) keep(line);
  if (hello.name != program_.hello.name || hello.version != program_.hello.version) {
    throw Breach(fmt::format("it is {} {} now, and was {} {}", hello.name, hello.version, program_.hello.name,
                             program_.hello.version));
  }
  deadline_ = Clock::now() + ready_patience;
  send(robot_);
  const Message message = receive({"ready", "declined"}, 0);
  if (message.name == "declined") {
    refusal_ = Trouble{Status::declined, why_in(message.json)};
    throw Trouble(*refusal_);
  }
}

void Session::begin_solve(double budget_seconds) {
  const double patience =
      program_.choice.patience > 0 ? program_.choice.patience : std::clamp(20 * budget_seconds, 5.0, 1e6);
  deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience));
}

void Session::drain() {
  const Clock::time_point until = Clock::now() + farewell;
  ignored_.clear();
  for (std::string line; child_->has_line() && child_->read_line(line, until) == ChildProcess::Outcome::done;) {
    const std::optional<Message> message = message_in(line);
    if (message && message->id && *message->id > id_)
      throw Trouble{Status::broke_protocol, "it answers before it is asked"};
    ignore(line, message);
    if (Clock::now() >= until) throw Trouble{Status::broke_protocol, "it does not stop writing"};
  }
}

// A program that could foresee the next id could answer before it is asked.
std::int64_t Session::new_id() {
  static thread_local std::minstd_rand random(std::random_device{}());
  last_id_ = id_;
  return id_ += 1 + static_cast<std::int64_t>(random() % 1000);
}

// Ignores noise and messages of a solve that is over.
void Session::ignore(const std::string& line, const std::optional<Message>& message) {
  if (message && message->id && *message->id > last_id_ && *message->id < id_)
    throw Trouble{Status::broke_protocol, "it answers before it is asked"};
  if (message && message->id && *message->id <= id_) {
    ignored_ = fmt::format("; it sent {} with the id {}, and was asked with {}", message->name, *message->id, id_);
    return;
  }
  ++notes_.noise;
  keep(line);
  ignored_ = fmt::format("; it wrote what is no message: {}", front(line, longest_kept_noise));
}

void Session::send(const std::string& text) {
  switch (child_->write(text, deadline_)) {
    case ChildProcess::Outcome::done:
      return;
    case ChildProcess::Outcome::too_late:
      throw Trouble{Status::timed_out, "it does not read what it is told"};
    default:
      throw Trouble{Status::crashed, "it closed its standard input"};
  }
}

Message Session::receive(std::initializer_list<std::string_view> names, std::int64_t id) {
  for (std::string line;;) {
    switch (child_->read_line(line, deadline_)) {
      case ChildProcess::Outcome::too_late:
        throw Trouble{Status::timed_out, "it did not answer in time" + ignored_};
      case ChildProcess::Outcome::too_long:
        throw Trouble{Status::broke_protocol, "a line has more than a million bytes"};
      case ChildProcess::Outcome::ended:
        throw Trouble{Status::crashed, "it ended"};
      case ChildProcess::Outcome::done:
        break;
    }
    std::optional<Message> message = message_in(line);
    const bool is_known = message && std::ranges::find(names, message->name) != names.end();
    if (is_known && (message->id == id || (!message->id && id == 0))) return std::move(*message);
    if (is_known && (!message->id || *message->id > id))
      throw Trouble{Status::broke_protocol, fmt::format("its {} does not have the id {}", message->name, id)};
    ignore(line, message);
  }
}

void Session::keep(const std::string& noise) {
  if (notes_.examples.size() < kept_noise) notes_.examples.emplace_back(front(noise, longest_kept_noise));
}

Message Session::exchange(const std::string& text, std::initializer_list<std::string_view> names) {
  send(text);
  return receive(names, id_);
}

void Session::note(const Trouble& trouble) {
  if (notes_.is_given_up) return;  // the reason is noted already
  notes_.last_failure = fmt::format("{}: {}", name_of(trouble.status), trouble.why);
}

void Session::recover(const Trouble& trouble) {
  if (!child_ || refusal_) return;
  if (trouble.status == Status::declined) return;
  if (trouble.status == Status::timed_out) {
    deadline_ = Clock::now() + farewell;
    try {
      exchange(tell_message(id_, Eigen::VectorXd(), std::numeric_limits<double>::quiet_NaN(), Over::yes), {"solved"});
      return;
    } catch (const Trouble&) {
    }
  }
  die(trouble);
}

void Session::die(const Trouble& trouble) {
  child_->end(trouble.status == Status::crashed ? farewell : std::chrono::seconds(0));
  const std::string wrote = last_line(child_->last_errors());
  notes_.last_failure = fmt::format("{}: {} ({}){}{}", name_of(trouble.status), trouble.why, child_->how_it_ended(),
                                    wrote.empty() ? "" : "; its last words: ", wrote);
  child_.reset();
  ++notes_.deaths;
  if (++deaths_in_a_row_ < most_deaths_in_a_row) return;
  notes_.is_given_up = true;
  refusal_ = Trouble{trouble.status, "it is given up after three deaths in a row"};
}

}  // namespace ikbench::experiments
