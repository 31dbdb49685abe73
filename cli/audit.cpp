// ikbench audit: checks whether a paper's printed numbers agree with each other.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "analysis/collections.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/report.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "experiments/environment.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace results;
using namespace inference;
using namespace report;

namespace {

// Counts the checks by verdict, then lists them, contradictions first; --verbose adds each one's reason.
void show(std::vector<AuditItem> items, const OutputArguments& output) {
  const std::string first = audit_sentence(items);
  std::ranges::stable_sort(items, std::greater(), [](const AuditItem& item) {
    return item.verdict == Verdict::fails     ? (item.is_misprint ? 3 : 4)
           : item.verdict == Verdict::holds   ? 0
           : item.verdict == Verdict::in_part ? 1
                                              : 2;
  });
  constexpr std::array<std::string_view, 5> shown{"verdict", "id", "where", "printed", "follows"};
  Tones tones{.column = 0};
  for (const AuditItem& item : items) tones.of_rows.push_back(tone_of(item.verdict));
  constexpr std::size_t longest = 24;  // all columns fit
  Part rows = table_rows(with_columns(audit_table(items), shown), output, 0, tones, longest);
  if (output.is_verbose) {
    for (std::size_t i = 0; i < items.size(); ++i) rows.items[i] += '\n' + wrapped("  " + items[i].why);
  }
  show_screen({{.items = {wrapped(first)}}, std::move(rows), {}}, output, "");
}

}  // namespace

void add_audit(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string paper, out;
    OutputArguments output;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("audit", "Check whether a paper's printed numbers agree with each other");
  add_paper_option(*command, arguments->paper, [](const Collection& of) { return of.paper && of.paper->audit; });
  command->add_option("--out", arguments->out, "folder for tables/audit.md, .csv and .tex; default: print only");
  add_output_options(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench audit slim2023\n"
      "  ikbench audit slim2023 --verbose         each check with its reason\n"
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
      write_table(audit_table(items), std::filesystem::path(arguments->out) / "tables", experiments::program_name());
    }
    if (arguments->output.is_json) return show_json(rows_json(audit_table(items)));
    show(items, arguments->output);
  });
}

}  // namespace ikbench::cli
