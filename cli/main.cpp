// ikbench: which inverse-kinematics solver is better, and does a published claim hold?
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
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
#define COMMAND(name, use) void add_##name(CLI::App& app, Invocation& invocation);
#include "cli/commands.inc"
#undef COMMAND
}  // namespace ikbench::cli

namespace {

// Its lines are as wide as those of other texts.
class Help : public CLI::Formatter {
 public:
  std::string make_option_desc(const CLI::Option* option) const override {
    const std::size_t width = ikbench::cli::text_width() - get_column_width();
    return fmt::format("{}", fmt::join(ikbench::show::broken(option->get_description(), width, width), "\n"));
  }
  std::string make_footer(const CLI::App* app) const override {
    return ikbench::cli::wrapped("Examples:\n" + app->get_footer()) + '\n';
  }
};

}  // namespace

int main(int argc, char** argv) {
  namespace cli = ikbench::cli;
  using namespace ikbench::base;
  using namespace ikbench::numerics;
  using namespace ikbench::experiments;
  constexpr auto unwritten = "cannot write to standard output; make room on its disk, or do not close it";
  std::vector<std::string> words(argv + 1, argv + argc);
  CLI::App app("Runs inverse-kinematics solvers on studies, stores every solve and says what the numbers mean.",
               "ikbench");
  app.formatter(std::make_shared<Help>());
  app.footer(
      "  ikbench reproduce         repeats Slim et al. 2023: which of its claims hold?\n"
      "  ikbench run my.toml       compares the solvers of a study, and writes a report\n"
      "  ikbench stats my.csv      says which group of your own data is better, or asks\n"
      "  ikbench COMMAND --help    has more");
  app.set_version_flag("--version", program_name());
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return fmt::format("ikbench: {}\n  see --help\n", cli::printable(error.what()));
  });
  cli::Invocation invocation{.command = cli::shell_command("ikbench", {argv + 1, argv + argc})};
#define COMMAND(name, use)          \
  cli::add_##name(app, invocation); \
  app.get_subcommands({}).back()->group(use);
#include "cli/commands.inc"
#undef COMMAND
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
  if (words.empty()) words.emplace_back("--help");
  const std::string first = words.front();
  std::ranges::reverse(words);  // as CLI11 takes them
  // What is opened later must not become a standard stream that the caller has closed; to write to it fails.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
  try {
    const cli::SignalWatch signals;
    static_cast<void>(instruction_set());  // reports a wrong IKBENCH_INSTRUCTION_SET before anything starts
    app.parse(words);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw std::runtime_error(unwritten);
    return invocation.exit_code;
  } catch (const cli::Cancelled&) {
    return cli::cancelled_exit_code();
  } catch (const CLI::RequiredError& error) {
    if (!app.get_subcommands().empty()) return app.exit(error) == 0 ? 0 : 1;
    // CLI11 does not say which word it did not know.
    cli::say_mistake(unknown_name("command", first, commands));
    return 1;
  } catch (const CLI::ExtrasError& error) {  // CLI11 names what it did not expect, but no option that is like it
    const CLI::App& command = app.get_subcommands().empty() ? app : *app.get_subcommands().front();
    std::vector<std::string> options;
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) options.push_back(name);
    for (const std::string& word : command.remaining()) {
      if (!word.starts_with('-')) continue;
      const std::string name = word.substr(0, word.find('='));
      const std::string nearest = nearest_name(name.substr(std::min<std::size_t>(2, name.size())), options);
      cli::say_mistake(fmt::format("{} has no option {}; {}see --help", command.get_name(), front(name, 100),
                                   nearest.empty() ? "" : fmt::format("did you mean --{}? Or ", nearest)));
      return 1;
    }
    app.exit(error);
    return 1;
  } catch (const CLI::ParseError& error) {
    if (app.exit(error) != 0) return 1;
    if (std::cout.flush()) return 0;
    cli::say_mistake(unwritten);
    return 2;
  } catch (const ikbench::robots::LinkQuestion& question) {
    cli::say_mistake(std::string(question.what()) + "; type one of");
    for (const auto& [option, link, joints] : question.answers)
      cli::say_command(
          fmt::format("{}    # {}", cli::shell_command(invocation.command, {option, link}), counted(joints, "joints")));
    return 1;
  } catch (const std::invalid_argument& error) {
    cli::say_mistake(error.what());
    return 1;
  } catch (const std::system_error& error) {
    const bool is_thread = error.code() == std::errc::resource_unavailable_try_again;
    cli::say_mistake(fmt::format("{}{}", error.what(), is_thread ? " for a thread; raise ulimit -v or -u" : ""));
    return 2;
  } catch (const std::runtime_error& error) {  // no space left, a store that another process writes, ...
    cli::say_mistake(error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    cli::say_mistake("there is not enough memory (ulimit -v, or the machine's)");
    return 2;
  } catch (const std::exception& error) {
    cli::say_mistake(fmt::format("internal error: {}", error.what()));
    return 2;
  }
}
