// ikbench cite: what a paper has to cite that uses this program.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/collections.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "experiments/collection.hpp"
#include "experiments/environment.hpp"
#include "experiments/study_reader.hpp"
#include "numerics/embedded_file.hpp"
#include "results/store.hpp"
#include "solvers/registry.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace results;
using namespace experiments;

namespace {

constexpr EmbeddedFile embedded_papers[] = {
#include "papers.inc"
};

struct Work {
  std::string_view entry;                  // BibTeX
  std::vector<std::string_view> keywords;  // solvers and papers that it is about
};

// An entry begins at an '@' and ends at the first line that is "}".
std::vector<Work> works() {
  std::vector<Work> all;
  for (std::string_view rest = embedded_papers[0].text;;) {
    const std::size_t begin = rest.find("\n@"), end = rest.find("\n}\n", begin);
    if (begin == std::string_view::npos || end == std::string_view::npos) return all;
    Work work{.entry = rest.substr(begin + 1, end + 2 - begin)};
    const std::size_t list = work.entry.find("keywords = {") + std::string_view("keywords = {").size();
    std::string_view words = work.entry.substr(list, work.entry.find('}', list) - list);
    while (!words.empty()) {
      const std::size_t comma = std::min(words.find(", "), words.size());
      work.keywords.push_back(words.substr(0, comma));
      words.remove_prefix(std::min(comma + 2, words.size()));
    }
    all.push_back(std::move(work));
    rest.remove_prefix(end + 2);
  }
}

// Studies and their solvers.
struct Used {
  std::vector<std::string> studies, solvers;
};

Used used_in(const std::string& name) {
  if (std::filesystem::path(name).extension() == ".sqlite") {
    Used used;
    for (const StudyEntry& study : Store(name, Store::Mode::read).studies()) {
      used.studies.push_back(study.name);
      for (const Series& series : study.series) used.solvers.push_back(series.algorithm);
    }
    return used;
  }
  const std::optional<StudyCollection> collection = load_collection(name);
  Used used;
  for (const Study& study : collection ? collection->studies : std::vector{load_study(name)}) {
    used.studies.push_back(study.name);
    for (const SolverEntry& entry : study.solvers) used.solvers.push_back(entry.solver);
  }
  return used;
}

std::string program_entry() {
  const std::string words = version();
  return fmt::format(
      "@misc{{ikbench,\n  author = {{{{the ikbench authors}}}},\n  title = {{ikbench: which inverse-kinematics solver is "
      "better, and does a published claim hold?}},\n  version = {{{}}},\n  year = {{2026}}\n}}\n",
      words);
}

struct Cited {
  std::vector<std::string> entries;               // BibTeX, the program first
  report::Json sources = report::Json::object();  // of solvers without an entry
};

Cited cited(const std::string& name) {
  std::set<std::string, std::less<>> wanted;
  if (!name.empty()) {
    const Used used = used_in(name);
    wanted.insert(used.solvers.begin(), used.solvers.end());
    for (const report::Collection& collection : analysis::collections()) {
      const bool is_of = std::ranges::any_of(collection.studies, [&](const report::CollectedStudy& study) {
        return std::ranges::count(used.studies, study.name) > 0;
      });
      if (is_of) wanted.insert(collection.name);
    }
  }
  Cited found{.entries = {program_entry()}};
  std::set<std::string_view> told;
  for (const Work& work : works()) {
    bool is_wanted = false;
    for (const std::string_view keyword : work.keywords) {
      if (!wanted.contains(keyword)) continue;
      is_wanted = true;
      told.insert(keyword);
    }
    if (is_wanted) found.entries.emplace_back(work.entry);
  }
  for (const solvers::SolverInfo& info : solvers::all_solvers()) {
    if (wanted.contains(info.name) && !told.contains(info.name)) found.sources[std::string(info.name)] = info.source;
  }
  return found;
}

}  // namespace

void add_cite(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string study;
    OutputArguments output = {};
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("cite", "Print what to cite: the program, a study's paper, and the papers of its solvers");
  command->add_option(
      "STUDY", arguments->study,
      "name of a built-in study, the TOML file of a study or a collection, or a store.sqlite; default: the "
      "program alone");
  add_json_option(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  ikbench cite slim2023 > references.bib\n"
      "  ikbench cite out/my/store.sqlite");
  command->callback([arguments] {
    const Cited found = cited(arguments->study);
    if (arguments->output.is_json) return show_json({{"bibtex", found.entries}, {"sources", found.sources}});
    std::vector<std::string> paragraphs = found.entries;
    for (const auto& [solver, source] : found.sources.items())
      paragraphs.push_back(fmt::format("% {}: {}\n", solver, source.get<std::string>()));
    fmt::print("{}", printable(fmt::format("{}", fmt::join(paragraphs, "\n"))));
  });
}

}  // namespace ikbench::cli
