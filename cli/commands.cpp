#include "cli/commands.hpp"

namespace ikbench::cli {

#define COMMAND(name) void add_##name(CLI::App& app, Invocation& invocation);
#include "cli/commands.inc"
#undef COMMAND

void add_commands(CLI::App& app, Invocation& invocation) {
#define COMMAND(name) add_##name(app, invocation);
#include "cli/commands.inc"
#undef COMMAND
}

}  // namespace ikbench::cli
