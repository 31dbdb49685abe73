#include "experiments/external/program.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "base/inputs.hpp"
#include "base/names.hpp"
#include "numerics/random.hpp"
#include "robots/urdf.hpp"

namespace ikbench::experiments {

namespace fs = std::filesystem;

namespace {

std::string digest_of_text(const std::string& text) {
  return fmt::format("{:016x}", numerics::Key(0).with(text).value());
}

bool is_file(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error);
}

// Returns the path at which a shell would find a command; empty if it would find none.
fs::path executable(const std::string& command, const fs::path& folder) {
  if (command.find('/') != std::string::npos) return folder / command;
  const char* const path = std::getenv("PATH");
  std::istringstream places(path == nullptr ? "/usr/bin:/bin" : path);
  for (std::string place; std::getline(places, place, ':');) {
    const fs::path file = fs::path(place) / command;
    if (is_file(file) && ::access(file.c_str(), X_OK) == 0) return file;
  }
  return {};
}

// Returns the digest of the name, the version, the executable, every argument that is a file, and the study's `files`.
std::string digest_of(const ProgramSpec& choice, const fs::path& folder, const Hello& hello) {
  std::string text = hello.name + '\n' + hello.version + '\n';
  for (std::size_t i = 0; i < choice.process.size(); ++i) {
    const fs::path file = i > 0 ? folder / choice.process[i] : executable(choice.process[0], folder);
    if (is_file(file)) text += file_digest(file);
  }
  for (const std::string& name : choice.files) text += name + '\n' + file_digest(folder / name);
  return digest_of_text(text);
}

// Returns the two pipes that IKBENCH_RELAY names, which programs inherit as descriptors 3 and 4. `ikbench.study` of the
// Python module sets the variable: a function in its process is asked by a relay (solvers/helpers/ikbench_notebook.py),
// which has no other way there. Returns none without the variable. Throws std::invalid_argument if there are no such
// pipes, so that no program gets another file of ours.
std::vector<int> relay_pipes() {
  const char* const text = std::getenv("IKBENCH_RELAY");
  if (text == nullptr) return {};
  std::vector<int> pipes;
  std::istringstream numbers(text);
  for (int number = 0; numbers >> number;) pipes.push_back(number);
  const auto is_pipe = [](int number) {
    struct stat file {};
    return number > STDERR_FILENO + 2 && ::fstat(number, &file) == 0 && S_ISFIFO(file.st_mode);
  };
  if (pipes.size() != 2 || !numbers.eof() || !std::ranges::all_of(pipes, is_pipe))
    throw std::invalid_argument(fmt::format(
        "the variable IKBENCH_RELAY is \"{}\"; expected two pipes, which only ikbench.study of Python opens; unset it",
        base::one_line(base::front(text, 60))));
  return pipes;
}

}  // namespace

std::string file_digest(const fs::path& file) { return digest_of_text(base::text_of_file(file, UINTMAX_MAX)); }

void list_fields(base::Fields& io, ProgramSpec& choice) {
  io.texts("process", choice.process, "a program and its arguments, in the folder of the study");
  io.texts("files", choice.files, "further files of the program; if one is edited, its solves are repeated");
  io.whole("memory_mb", choice.memory_mb, {0, 1'000'000},
           "address space that each process of the program may take, on Linux; 0: no limit");
  io.number("timeout_s", choice.timeout, 1, {0, 86400},
            "wall time after which a solve is given up; 0: 20 times stop.seconds, at least 5 s; without that 60 s");
  io.whole("batch", choice.batch, {0, 1000}, "largest number of problems in one message; 0: one by one");
}

Clock::time_point deadline_in(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

Message read_message(ChildProcess& child, Clock::time_point deadline) {
  std::string noise;
  try {
    for (;;) {
      std::string line = child.read_line(deadline);
      if (line.starts_with('{')) return Message(std::move(line));
      noise = fmt::format("; it wrote a line that is not a message: {}", base::one_line(base::front(line, 200)));
    }
  } catch (const ProcessFailure& failure) {
    throw ProcessFailure{failure.kind, failure.why + noise};
  }
}

Message send_request(ChildProcess& child, const std::string& text, Clock::time_point deadline) {
  child.write(text, deadline);
  return read_message(child, deadline);
}

ProcessFailure unsolicited_message(ChildProcess& child, double timeout) {
  try {
    read_message(child, deadline_in(timeout)).fail("nothing after its answer");
  } catch (const ProcessFailure& failure) {
    return failure;
  }
}

std::unique_ptr<ChildProcess> launch(const ProgramSpec& choice, const fs::path& folder, Hello& hello) {
  std::vector<std::string> arguments = choice.process;
  if (choice.memory_mb > 0)
    arguments.insert(arguments.begin(),
                     {"sh", "-c", fmt::format(R"(ulimit -v {} && exec "$0" "$@")", 1000 * choice.memory_mb)});
  const auto is_relay = [](const std::string& argument) { return argument.ends_with("ikbench_notebook.py"); };
  const std::vector<int> pipes = std::ranges::any_of(choice.process, is_relay) ? relay_pipes() : std::vector<int>();
  auto child = std::make_unique<ChildProcess>(arguments, folder,
                                              std::vector<std::string>{"LC_ALL=C", "OMP_NUM_THREADS=1"}, pipes);
  if (!pipes.empty()) child->set_worker(::getppid());  // opened the pipes, and has the function
  const double timeout = std::max(start_timeout, choice.timeout);
  try {
    hello = read_message(*child, deadline_in(timeout)).hello();
  } catch (const ProcessFailure& failure) {
    const std::string end = child->end_after(failure.kind);
    if (failure.kind != ProcessFailure::Kind::timed_out) throw ProcessFailure{failure.kind, failure.why + end};
    throw ProcessFailure{
        failure.kind,
        fmt::format("it sent no hello within {:g} s ({}); to wait longer, give a longer timeout: timeout_s in a study, "
                    "--timeout of check-solver{}",
                    timeout, failure.why, end)};
  }
  return child;
}

std::string urdf_text_for(const Program& program, const std::string& robot) {
  const fs::path file = program.folder / robot;
  return robots::is_urdf_file(robot) && is_file(file) ? base::text_of_file(file) : "";
}

bool Program::is_unchanged() const { return digest_of(choice, folder, hello) == digest; }

std::shared_ptr<const Program> probe(const ProgramSpec& choice, const fs::path& folder) {
  for (const std::string& name : choice.files) {
    if (!is_file(folder / name))
      throw std::invalid_argument(fmt::format("there is no file {}", (folder / name).string()));
  }
  auto program = std::make_shared<Program>(Program{.choice = choice, .folder = folder, .hello = {}, .digest = {}});
  try {
    launch(choice, folder, program->hello);
  } catch (const ProcessFailure& failure) {
    throw std::invalid_argument(failure.why);
  }
  program->digest = digest_of(choice, folder, program->hello);
  return program;
}

}  // namespace ikbench::experiments
