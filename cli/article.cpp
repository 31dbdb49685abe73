// ikbench article: the report's article in LaTeX as a PDF.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "analysis/collections.hpp"
#include "analysis/figures/process.hpp"
#include "analysis/inference/text.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"

namespace ikbench::cli {

using namespace inference;

namespace {

namespace fs = std::filesystem;

// A folder with a report, or a paper whose report is in the folder where `ikbench reproduce` puts it.
fs::path folder_of(const std::string& named) {
  const bool is_paper =
      std::ranges::find(analysis::collections(), named, &report::Collection::name) != analysis::collections().end();
  const fs::path folder = is_paper && !fs::is_directory(named) ? default_folder(named) : fs::path(named);
  if (!fs::is_regular_file(folder / "article.tex")) {
    throw std::invalid_argument(
        fmt::format("'{}' has no article.tex; write a report into it first: ikbench {}", printable(folder.string()),
                    is_paper ? "reproduce " + named : fmt::format("report {}/store.sqlite", printable(named))));
  }
  return folder;
}

// The first error that pdflatex tells, and the line after it.
std::string error_in(const std::string& output) {
  const std::size_t at = output.find("\n!");
  return at == std::string::npos ? output.substr(0, 300) : output.substr(at + 1, 300);
}

}  // namespace

void add_article(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string where;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("article", "Make the PDF of a report's article.tex, to write a paper from");
  command->add_option("FOLDER", arguments->where, "folder of a report, or a paper that was reproduced")->required();
  command->footer(
      "Examples:\n"
      "  ikbench reproduce slim2023 && ikbench article slim2023\n"
      "  ikbench run my_study.toml --out out/mine && ikbench article out/mine\n\n"
      "Every report writes article.tex: set-up, claims, tables, figures, limitations and data availability. The PDF needs\n"
      "pdflatex (apt-get install texlive-latex-extra). The text has no author: it is yours to write.");
  command->callback([arguments] {
    const fs::path folder = folder_of(arguments->where);
    WorkingLine working("Making the PDF ...");
    for (int pass = 1; pass <= 2; ++pass) {  // the second knows the numbers of tables
      const figures::ProcessResult result = figures::run_process(
          {"pdflatex", "-no-shell-escape", "-interaction=nonstopmode", "-halt-on-error", "article.tex"}, folder);
      if (result.succeeded) continue;
      if (result.is_missing) {
        throw std::runtime_error("pdflatex is not installed; to install it: apt-get install texlive-latex-extra");
      }
      throw std::runtime_error(fmt::format("pdflatex did not make the article: {}; '{}' has all it says",
                                           printable(one_line(error_in(result.output))),
                                           printable((folder / "article.log").string())));
    }
    working.end();
    fmt::print("Article: {}\n", printable((folder / "article.pdf").string()));
  });
}

}  // namespace ikbench::cli
