// ikbench audit: checks whether a paper's printed numbers agree with each other.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>

#include "analysis/collections.hpp"
#include "analysis/report/report.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace results;
using namespace inference;
using namespace report;

namespace {

// One line per check, and the reasons below.
std::string shown(const std::vector<AuditItem>& items) {
  std::vector<std::vector<std::string>> rows{{"ID", "VERDICT", "WHERE", "PRINTED", "FOLLOWS"}};
  for (const AuditItem& item : items) {
    rows.push_back({item.id, std::string(words_of(item)), item.where, item.printed, item.follows});
  }
  const std::string lines = aligned(rows);
  std::string text;
  std::size_t row = 0, begin = 0;
  for (std::size_t end = lines.find('\n'); end != std::string::npos; end = lines.find('\n', begin)) {
    text += lines.substr(begin, end + 1 - begin);
    if (row > 0) text += fmt::format("      {}\n", printable(items[row - 1].why));
    begin = end + 1;
    ++row;
  }
  return text;
}

}  // namespace

void add_audit(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string paper, out;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("audit", "Check whether a paper's printed numbers agree with each other");
  add_paper_option(*command, arguments->paper, [](const Collection& of) { return of.paper && of.paper->audit; });
  command->add_option("--out", arguments->out, "folder for tables/audit.md, .csv and .tex; default: print only");
  command->footer(
      "Examples:\n"
      "  ikbench audit slim2023\n"
      "  ikbench audit slim2023 --out out/audit\n\n"
      "Verdicts:\n"
      "  consistent      the numbers agree to the last printed digit\n"
      "  rounding        they agree within the rounding of the printed digits\n"
      "  misprint        a number is wrong, and other numbers of the paper show the right one\n"
      "  not supported   the numbers do not show a claim or an assumption, or only with something that is not printed\n"
      "  contradiction   two printed things cannot both be true");
  command->callback([arguments] {
    const auto& audit = analysis::paper(arguments->paper).audit;
    if (!audit) throw std::invalid_argument(fmt::format("the program has no audit of the paper {}", arguments->paper));
    const std::vector<AuditItem> items = audit();
    if (!arguments->out.empty()) {
      write_table(audit_table(items), std::filesystem::path(arguments->out) / "tables");
    }
    fmt::print("{}\n{}\n", shown(items), audit_sentence(items));
  });
}

}  // namespace ikbench::cli
