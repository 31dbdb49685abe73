#include "experiments/foreign/program.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "experiments/foreign/session.hpp"
#include "numerics/names.hpp"

namespace ikbench::experiments {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_noise = 100;
constexpr double hello_patience = 20;  // [s]

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    if (!context_ || EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1)
      throw std::runtime_error("no SHA-256");
  }
  void add(std::string_view bytes) { EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()); }
  std::string text() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
    unsigned int size = 0;
    EVP_DigestFinal_ex(context_.get(), bytes.data(), &size);
    std::string hex;
    for (unsigned int i = 0; i < size; ++i) hex += fmt::format("{:02x}", bytes.at(i));
    return hex;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

}  // namespace

std::string digest_of_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  Sha256 digest;
  std::array<char, 65536> buffer;
  while (in.read(buffer.data(), buffer.size()) || in.gcount() > 0) {
    digest.add({buffer.data(), static_cast<std::size_t>(in.gcount())});
  }
  if (!in.eof()) throw std::invalid_argument(fmt::format("cannot read {}", file.string()));
  return digest.text();
}

namespace {

bool is_file(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error);
}

// The path at which a shell would find it; empty if it would not.
fs::path executable(const std::string& word, const fs::path& folder) {
  if (word.find('/') != std::string::npos) return folder / word;
  const char* const path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "/usr/bin:/bin" : path;
  while (!rest.empty()) {
    const std::string_view place = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(place.size() + 1, rest.size()));
    const fs::path file = fs::path(place) / word;
    if (is_file(file) && ::access(file.c_str(), X_OK) == 0) return file;
  }
  return {};
}

// Digests the name, the version, the executable, every argument that is a file, and the study's `files`.
std::string digest_of(const ProgramChoice& choice, const fs::path& folder, const Hello& hello) {
  Sha256 digest;
  digest.add(hello.name + '\n' + hello.version + '\n');
  const std::vector<std::string>& words = choice.process;
  if (const fs::path file = executable(words[0], folder); is_file(file)) digest.add(digest_of_file(file));
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (const fs::path file = folder / words[i]; is_file(file)) digest.add(digest_of_file(file));
  }
  for (const std::string& name : choice.files) digest.add(name + '\n' + digest_of_file(folder / name));
  return digest.text();
}

}  // namespace

void list_fields(numerics::Fields& io, ProgramChoice& choice) {
  using Talk = ProgramChoice::Talk;
  io.texts("process", choice.process, "a program and its arguments, in the folder of the study");
  io.texts("files", choice.files, "what the program consists of besides; an edited file solves anew");
  io.choice(
      "mode", choice.mode,
      numerics::Choices<Talk>{{"preferred", Talk::preferred}, {"solve", Talk::solve}, {"ask", Talk::ask}},
      "solve: the program has its own kinematics; ask: its candidates are evaluated here; preferred: as it likes");
  io.number("patience_s", choice.patience, 1, {0, 86400},
            "wall time after which a solve is given up; 0: 20 times its budget, at least 5 s");
}

Hello hello_of(ChildProcess& child, const ProgramChoice& choice, std::vector<std::string>& noise) {
  const std::chrono::duration<double> patience(std::max(hello_patience, choice.patience));
  const Clock::time_point deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(patience);
  for (std::string line;;) {
    switch (child.read_line(line, deadline)) {
      case ChildProcess::Outcome::too_late:
        throw std::invalid_argument(
            fmt::format("it says no hello within {:g} s; a larger patience_s waits longer", patience.count()));
      case ChildProcess::Outcome::too_long:
        throw Breach("its first line has more than a million bytes");
      case ChildProcess::Outcome::ended: {
        child.end(std::chrono::seconds(1));
        const std::string errors = last_line(child.last_errors());
        throw std::invalid_argument(fmt::format("it ends before its hello ({}){}", child.how_it_ended(),
                                                errors.empty() ? "" : ", and wrote: " + errors));
      }
      case ChildProcess::Outcome::done:
        break;
    }
    if (const std::optional<Message> message = message_in(line)) return hello_in(*message);
    if (noise.size() < most_noise) noise.push_back(line);
  }
}

Command Program::command() const { return {choice.process, folder}; }

bool Program::is_unchanged() const {
  try {
    return digest_of(choice, folder, hello) == digest;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

std::shared_ptr<const Program> meet(const ProgramChoice& choice, const fs::path& folder) {
  for (const std::string& name : choice.files) {
    if (!is_file(folder / name))
      throw std::invalid_argument(fmt::format("there is no file {}", (folder / name).string()));
  }
  auto program = std::make_shared<Program>(Program{.choice = choice, .folder = folder, .hello = {}, .digest = {}});
  ChildProcess child(program->command());
  std::vector<std::string> noise;
  program->hello = hello_of(child, choice, noise);
  child.write(bye_message(), Clock::now() + std::chrono::seconds(1));
  child.end(std::chrono::seconds(1));
  const std::vector<Mode>& modes = program->hello.modes;
  program->mode = choice.mode == ProgramChoice::Talk::preferred ? modes.front()
                  : choice.mode == ProgramChoice::Talk::solve   ? Mode::solve
                                                                : Mode::ask;
  if (std::ranges::find(modes, program->mode) == modes.end()) {
    throw std::invalid_argument(
        fmt::format("it has no mode \"{}\"; expected \"{}\"", name_of(program->mode), name_of(modes.front())));
  }
  program->digest = digest_of(choice, folder, program->hello);
  return program;
}

}  // namespace ikbench::experiments
