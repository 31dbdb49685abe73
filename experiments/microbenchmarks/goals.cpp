// goals FILE...: the table of goals from what benchmark programs have written.
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "experiments/microbenchmarks/goal_table.hpp"
#include "numerics/instruction_set.hpp"

using namespace ikbench::numerics;
using namespace ikbench::microbenchmarks;

namespace {

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::invalid_argument(path + ": cannot read this file");
  return {std::istreambuf_iterator<char>(in), {}};
}

Measurements read(const std::vector<std::string>& paths) {
  Measurements measurements;
  for (const std::string& path : paths) {
    try {
      measurements.add(nlohmann::json::parse(text_of(path)));
    } catch (const nlohmann::json::exception& fault) {
      throw std::invalid_argument(path + ": " + fault.what());
    }
  }
  return measurements;
}

// What stands between the markers of a run of this instruction set gives way to `tables`.
void replace_run(const std::string& path, const std::string& instruction_set, const std::string& tables) {
  std::string text = text_of(path);
  const std::string opening = "<!-- run " + instruction_set + " -->\n", closing = "<!-- end of run -->";
  const std::size_t from = text.find(opening);
  const std::size_t to = from == std::string::npos ? from : text.find(closing, from);
  if (to == std::string::npos) throw std::invalid_argument(path + ": has no markers for a run of " + instruction_set);
  text.replace(from + opening.size(), to - from - opening.size(), tables);
  std::ofstream(path, std::ios::binary) << text;
}

int run(int argc, char** argv) {
  CLI::App app{"Print the table of goals from the output of the benchmark programs."};
  std::vector<std::string> files;
  std::string docs;
  bool markdown = false, in_use = false, all = false;
  app.add_option("files", files, "JSON files of one run");
  app.add_flag("--markdown", markdown, "print Markdown, with the machine and the median times");
  app.add_option("--docs", docs, "write the Markdown into this document, between its markers");
  app.add_flag("--instruction-set", in_use, "print only the instruction set in use");
  app.add_flag("--instruction-sets", all, "print only the instruction sets that this machine supports");
  CLI11_PARSE(app, argc, argv);

  if (in_use) std::cout << name_of(instruction_set()) << '\n';
  if (all) {
    for (const InstructionSet set : instruction_sets()) std::cout << name_of(set) << '\n';
  }
  if (in_use || all) return 0;

  const Measurements measurements = read(files);
  const std::string set = measurements.context("instruction_set");
  const std::vector<Row> rows = goal_rows(measurements, set);
  const auto tables = [&] {
    return machine(measurements) + "\n\n" + as_markdown(rows) + '\n' + times_as_markdown(measurements);
  };
  if (!docs.empty()) replace_run(docs, set, tables());
  if (markdown) {
    std::cout << tables();
  } else {
    std::cout << machine(measurements) << "\n\n" << as_text(rows);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::invalid_argument& mistake) {
    std::cerr << "goals: " << mistake.what() << '\n';
    return 1;
  }
}
