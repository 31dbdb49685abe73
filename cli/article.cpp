// ikbench article: the report's article in LaTeX as a PDF.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/collections.hpp"
#include "analysis/figures/process.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/table.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "cli/screen.hpp"
#include "results/files.hpp"

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

// The article and the tables that it takes.
std::string text_of_article(const fs::path& folder) {
  constexpr std::string_view input = "\\input{";
  const std::string article = results::read_file(folder / "article.tex").value_or("");
  std::string text = article;
  for (std::size_t at = article.find(input); at != std::string::npos; at = article.find(input, at + 1)) {
    const std::size_t from = at + input.size();
    text += results::read_file(folder / article.substr(from, article.find('}', from) - from)).value_or("");
  }
  return text;
}

// Returns whether lualatex is there, and what it needs to read a font.
bool has_lualatex(const fs::path& folder) {
  const auto runs = [&](const std::vector<std::string>& words) {
    return figures::run_process(words, folder).succeeded;
  };
  return runs({"lualatex", "--version"}) && runs({"kpsewhich", "luaotfload.sty"});
}

// Warns of letters that no font has; they are left out of the PDF.
void warn_of_missing_letters(const fs::path& folder) {
  constexpr std::string_view words = "Missing character: There is no ";
  const std::string log = results::read_file(folder / "article.log").value_or("");
  std::set<std::string> letters;
  for (std::size_t at = log.find(words); at != std::string::npos; at = log.find(words, at + 1)) {
    const std::size_t from = at + words.size();
    letters.insert(log.substr(from, log.find(' ', from) - from));
  }
  if (letters.empty()) return;
  warn(fmt::format(
      "no font here has {} of the article's letters, such as {}, so the PDF lacks {}; to install fonts: apt-get "
      "install fonts-dejavu fonts-noto-core fonts-noto-cjk",
      letters.size(), *letters.begin(), letters.size() == 1 ? "it" : "them"));
}

// The first error that LaTeX tells, and the line after it.
std::string error_in(const std::string& output) {
  const std::size_t at = output.find("\n!");
  return at == std::string::npos ? output.substr(0, 300) : output.substr(at + 1, 300);
}

}  // namespace

void add_article(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string where;
    OutputArguments output;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("article", "Make the PDF of a report's article.tex, to write a paper from");
  command->add_option("FOLDER", arguments->where, "folder of a report, or a paper that was reproduced")->required();
  add_json_option(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench reproduce slim2023 && ikbench article slim2023\n"
      "  ikbench run my_study.toml --out out/mine && ikbench article out/mine\n\n"
      "Every report writes article.tex: set-up, claims, tables, figures, limitations and data availability. The PDF needs\n"
      "pdflatex (apt-get install texlive-latex-extra), and where a name has letters that pdflatex lacks, such as Hebrew or\n"
      "Japanese ones, lualatex (texlive-luatex). The text has no author: it is yours to write.");
  command->callback([arguments] {
    const fs::path folder = folder_of(arguments->where);
    const bool has_letters = report::needs_another_engine(text_of_article(folder));
    if (has_letters && !has_lualatex(folder)) {
      throw std::runtime_error(
          "the article has letters that pdflatex lacks, and lualatex, which has them, is not installed; to install it: apt-get "
          "install texlive-luatex");
    }
    const std::string engine = has_letters ? "lualatex" : "pdflatex";
    WorkingLine working("Making the PDF ...");
    for (int pass = 1; pass <= 2; ++pass) {  // the second knows the numbers of tables
      const figures::ProcessResult result = figures::run_process(
          {engine, "-no-shell-escape", "-interaction=nonstopmode", "-halt-on-error", "article.tex"}, folder);
      if (result.succeeded) continue;
      if (result.is_missing) {
        throw std::runtime_error("pdflatex is not installed; to install it: apt-get install texlive-latex-extra");
      }
      throw std::runtime_error(fmt::format("{} did not make the article: {}; '{}' has all it says", engine,
                                           printable(one_line(error_in(result.output))),
                                           printable((folder / "article.log").string())));
    }
    working.end();
    const std::string article = (folder / "article.pdf").string();
    if (has_letters) warn_of_missing_letters(folder);
    if (arguments->output.is_json) return show_json({{"article", article}, {"made_by", engine}});
    fmt::print("Article: {}{}\n", printable(article),
               has_letters ? " (by lualatex, because pdflatex lacks some of its letters)" : "");
  });
}

}  // namespace ikbench::cli
