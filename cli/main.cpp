// ikbench, the program: reads the command line, runs one command and turns exceptions into messages and exit codes.
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cfenv>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "analysis/show/text.hpp"
#include "base/names.hpp"
#include "cli/console.hpp"
#include "cli/options.hpp"
#include "experiments/environment.hpp"
#include "numerics/instruction_set.hpp"
#include "robots/urdf.hpp"

namespace ikbench::cli {
#define COMMAND(name, word, use, meaning) void add_##name(const Command& command, Invocation& invocation);
#include "cli/commands.inc"
#undef COMMAND
}  // namespace ikbench::cli

namespace {

namespace cli = ikbench::cli;
using namespace ikbench::base;

// Formats --help in lines as wide as those of other texts.
class Help : public CLI::Formatter {
 public:
  std::string make_option_desc(const CLI::Option* option) const override {
    const std::size_t width = cli::terminal_width() - get_column_width();
    return fmt::format("{}", fmt::join(ikbench::show::wrap_words(option->get_description(), width, width), "\n"));
  }
  std::string make_footer(const CLI::App* app) const override {
    return cli::wrapped("Examples:\n" + app->get_footer()) + '\n';
  }
};

constexpr auto cannot_write = "cannot write to standard output; make room on its disk, or keep it open";

// Returns "ikbench compare A B", or "ikbench" without a command.
std::string usage_of(const CLI::App& command) {
  std::string text = command.get_parent() == nullptr ? "ikbench" : "ikbench " + command.get_name();
  for (const CLI::Option* option : command.get_options([](const CLI::Option* each) { return each->get_positional(); }))
    text += option->get_required() ? ' ' + option->get_name(true) : " [" + option->get_name(true) + ']';
  return text;
}

// Returns what CLI11 says of a mistake, in plain words and with what is expected.
std::string mistake_text(const CLI::App& command, const CLI::ParseError& error) {
  const std::string text = error.what();
  const std::string first = text.substr(0, text.find_first_of(": "));  // the option or argument
  const std::string last = text.substr(text.rfind(' ') + 1);
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)
    return fmt::format("{} is missing; expected {}", first, usage_of(command));
  if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr)
    return fmt::format("{} needs {}; add it", first, last);
  if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr)
    return fmt::format("{} and {} exclude each other; leave one out", first, last);
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) return "a value does not fit its option: " + text;
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    return fmt::format("too many arguments, {}; expected {}", fmt::join(command.remaining(), " "), usage_of(command));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return text;
  return text.ends_with("missing") ? first + " needs a value" : first + " is given too often; expected it once";
}

// Prints a mistake on the command line, or the help that was asked for, and returns the exit code. CLI11 does not say
// which word is unknown, and names no similar option, so this function does.
int report_parse_error(const CLI::App& app, const CLI::ParseError& error, const std::string& first) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  std::vector<std::string> names;
  if (chosen.empty() && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
    cli::print_error(unknown_name("command", first, names));
    return 1;
  }
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const std::vector<std::string> rest = command.remaining();
  const auto option = std::ranges::find_if(rest, [](const std::string& word) { return word.starts_with('-'); });
  if (option != rest.end() && dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    for (const CLI::Option* known : command.get_options())
      for (const std::string& name : known->get_lnames()) names.push_back("--" + name);
    cli::print_error(unknown_name("option of " + command.get_name(), option->substr(0, option->find('=')), names));
    return 1;
  }
  if (error.get_exit_code() != 0) {
    const std::string name = chosen.empty() ? "" : ' ' + command.get_name();
    cli::print_error(fmt::format("{}\n  all options: ikbench{} --help", mistake_text(command, error), name));
    return 1;
  }
  app.exit(error);  // prints the help or the version
  if (std::cout.flush()) return 0;
  cli::print_error(cannot_write);
  return 2;
}

// Returns whether an exception is an invalid argument, which means a user's mistake.
bool is_mistake(const std::exception& error) { return dynamic_cast<const std::invalid_argument*>(&error) != nullptr; }

std::string error_text(const std::exception& error) {
  const auto* const of_system = dynamic_cast<const std::system_error*>(&error);
  if (of_system != nullptr && std::ferror(stdout) != 0) return cannot_write;
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "there is not enough memory; raise ulimit -v, or use a machine with more";
  // A runtime_error comes from the system: no space is left, another process writes the store, ...
  const bool is_expected = is_mistake(error) || dynamic_cast<const std::runtime_error*>(&error) != nullptr;
  const bool is_thread = of_system != nullptr && of_system->code() == std::errc::resource_unavailable_try_again;
  return fmt::format("{}{}{}", is_expected ? "" : "internal error: ", error.what(),
                     is_thread ? " for a thread; raise ulimit -v or -u" : "");
}

}  // namespace

int main(int argc, char** argv) {
  std::fesetenv(FE_DFL_ENV);  // a library that is compiled with -ffast-math flushes subnormal numbers when it is loaded
  CLI::App app("Runs inverse-kinematics solvers on studies, stores every solve and shows what the numbers mean.",
               "ikbench");
  app.formatter(std::make_shared<Help>());
  app.footer(
      "  ikbench reproduce         repeats Slim et al. 2023 and shows which claims hold\n"
      "  ikbench run my.toml       compares the solvers of a study and writes a report\n"
      "  ikbench stats my.csv      shows which group in your own data is better\n"
      "  ikbench COMMAND --help    shows all options of a command");
  app.set_version_flag("--version", ikbench::experiments::program_name());
  app.require_subcommand(1);
  std::vector<std::string> words(argv + 1, argv + argc);
  cli::Invocation invocation{.command = cli::shell_command("ikbench", words)};
#define COMMAND(name, word, use, meaning) cli::add_##name({app.add_subcommand(word, meaning)->group(use)}, invocation);
#include "cli/commands.inc"
#undef COMMAND
  if (words.empty()) words.emplace_back("--help");
  const std::string first = words.front();
  std::ranges::reverse(words);  // CLI11 takes the words from the back
  // A file that is opened later must not become a standard stream that the caller has closed. Writing to /dev/null,
  // opened for reading, fails as writing to a closed stream does.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
  try {
    const cli::SignalWatch signals;
    static_cast<void>(ikbench::numerics::instruction_set());  // refuses a wrong IKBENCH_INSTRUCTION_SET first
    app.parse(words);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw std::runtime_error(cannot_write);
    return invocation.exit_code;
  } catch (const cli::Cancelled&) {
    return cli::cancelled_exit_code();
  } catch (const CLI::ParseError& error) {
    return report_parse_error(app, error, first);
  } catch (const ikbench::robots::LinkQuestion& question) {
    cli::print_error(std::string(question.what()) + "; type one of");
    for (const auto& [option, link, joints] : question.answers)
      cli::print_command(
          fmt::format("{}    # {}", cli::shell_command(invocation.command, {option, link}), counted(joints, "joints")));
    return 1;
  } catch (const std::exception& error) {
    cli::print_error(error_text(error));
    return is_mistake(error) ? 1 : 2;
  }
}
