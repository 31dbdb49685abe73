// The architecture, as the includes build it: which folder may know which.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/sources.hpp"

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

// Programs within a folder; they may do what the rest of it may not.
const std::string microbenchmarks = "experiments/microbenchmarks";

// The texts between every `opening` and the next of the `closing` characters.
std::vector<std::string> between(const std::string& text, const std::string& opening, const std::string& closing) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
    at += opening.size();
    found.push_back(text.substr(at, text.find_first_of(closing, at) - at));
  }
  return found;
}

// docs/explanation/architecture.md: each folder, and the folders that it may know.
const std::map<std::string, Names>& may_know() {
  static const std::map<std::string, Names> table{
      {"numerics", {}},
      {"robots", {"numerics"}},
      {"solvers", {"numerics", "robots"}},
      {"results", {"numerics"}},
      {"experiments", {"numerics", "robots", "solvers", "results"}},
      {microbenchmarks, {"numerics", "robots", "solvers", "results", "experiments"}},
      {"analysis/compare", {"numerics", "results"}},
      {"analysis/csv", {"numerics", "results", "analysis/compare"}},
      {"analysis/figures", {"numerics", "robots", "results", "analysis/compare"}},
      {"analysis/show", {"numerics", "robots", "results", "analysis/compare", "analysis/figures"}},
      {"analysis/papers", {"numerics", "results", "analysis/compare", "analysis/figures", "analysis/show"}},
      {"analysis/slim2023",
       {"numerics", "robots", "results", "analysis/compare", "analysis/figures", "analysis/show", "analysis/papers"}},
      {"cli",
       {"numerics", "robots", "solvers", "results", "experiments", "analysis/compare", "analysis/csv",
        "analysis/figures", "analysis/show", "analysis/papers", "analysis/slim2023"}},
  };
  return table;
}

// CMake writes these into the build folder of those that include them.
const Names generated{"arms.inc",    "references.inc",       "build_info.hpp",     "multiverse.inc", "paper_files.inc",
                      "studies.inc", "published_tables.inc", "source_digests.inc", "style.inc",      "templates.inc"};

// The folder of the table that contains a path of the repository; else its first part.
std::string folder_of(const std::string& path) {
  std::string found = path.substr(0, path.find('/'));
  for (const auto& [folder, below] : may_know()) {
    if (path.starts_with(folder + '/') && folder.size() > found.size()) found = folder;
  }
  return found;
}

std::vector<fs::path> sources_of(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string type = entry.path().extension().string();
    if (folder_of(entry.path().string()) != folder_of(folder + '/')) continue;
    if (type == ".hpp" || type == ".cpp" || type == ".inc") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// The file without its comments, which are `//` to the end of the line.
std::string code_of(const fs::path& file) {
  std::istringstream text(text_of(file));
  std::string code;
  for (std::string line; std::getline(text, line);) code += line.substr(0, line.find("//")) + '\n';
  return code;
}

struct Word {
  std::string text;
  bool of_std, called;  // after "std::", before "("
};

std::vector<Word> words_of(const std::string& code) {
  const std::string letters = "_0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  std::vector<Word> words;
  for (std::size_t at = 0; (at = code.find_first_of(letters, at)) != std::string::npos;) {
    const std::size_t end = std::min(code.find_first_not_of(letters, at), code.size());
    const std::size_t next = code.find_first_not_of(" \n", end);
    words.push_back({code.substr(at, end - at), at >= 5 && code.compare(at - 5, 5, "std::") == 0,
                     next != std::string::npos && code[next] == '('});
    at = end;
  }
  return words;
}

// The elementary functions of the C library or of Eigen in a code, also as methods or in C's form.
std::vector<std::string> elementary_functions(const std::string& code) {
  static const Names functions{"sin",   "cos",  "tan",    "asin",   "acos",       "atan",      "atan2", "sinh",
                               "cosh",  "tanh", "asinh",  "acosh",  "atanh",      "sincos",    "exp",   "exp2",
                               "expm1", "log",  "log2",   "log10",  "log1p",      "pow",       "hypot", "cbrt",
                               "erf",   "erfc", "tgamma", "lgamma", "stableNorm", "hypotNorm", "lerp",  "blueNorm"};
  static const Names geometry{"AngleAxis", "AngleAxisd", "Rotation2D", "Rotation2Dd", "eulerAngles"};
  std::vector<std::string> found;
  for (const Word& word : words_of(code)) {
    std::string name = word.text;
    if (!functions.contains(name) && (name.ends_with('f') || name.ends_with('l'))) name.pop_back();
    const bool function = functions.contains(name) && (word.of_std || word.called);
    if (function || geometry.contains(name) || name.ends_with("_distribution")) found.push_back(name);
  }
  return found;
}

// The sources that are compiled once for every instruction set, and all of ours that they include.
std::set<fs::path> kernel_sources() {
  std::set<fs::path> sources;
  std::vector<fs::path> next;
  for (const auto& [folder, below] : may_know()) {
    if (fs::exists(folder + "/kernels.cpp")) next.push_back(folder + "/kernels.cpp");
  }
  while (!next.empty()) {
    const fs::path source = next.back();
    next.pop_back();
    if (!sources.insert(source).second) continue;
    for (const std::string& included : between(text_of(source), "#include \"", "\"")) next.push_back(included);
  }
  return sources;
}

std::vector<std::string> includes_of(const fs::path& file) { return between(text_of(file), "#include \"", "\""); }

// True for solvers of libraries and their shared headers.
bool is_of_peers(const fs::path& file) { return file.parent_path() == "solvers/peers"; }

}  // namespace

TEST_CASE("no folder includes another that is not below it", "[architecture]") {
  for (const auto& [folder, below] : may_know()) {
    const std::vector<fs::path> files = sources_of(folder);
    CHECK(files.size() >= 2);  // or the search itself is broken
    for (const fs::path& file : files) {
      for (const std::string& included : includes_of(file)) {
        INFO(file.string() << " includes \"" << included << '"');
        if (generated.contains(included)) continue;
        const std::string other = folder_of(included);
        CHECK((other == folder || below.contains(other)));
        CHECK(fs::exists(included));  // an include path is the path in the repository
      }
    }
  }
}

// The results of these differ in their last bits between C libraries and processors, and so would a study's;
// numerics/functions.hpp has ours. Square roots are exact everywhere.
TEST_CASE("nothing that decides a number calls the C library's elementary functions", "[architecture]") {
  CHECK(elementary_functions("std::sin(x); ::atan2f (y, x); x.array().log(); f(std::pow); AngleAxisd(a, b);").size() ==
        5);
  CHECK(elementary_functions("sin_cos(x); power(x, 2); double log = 0; sines(3); std::sqrt(x);").empty());
  for (const std::string folder : {"numerics", "robots", "solvers", "experiments"}) {
    for (const fs::path& file : sources_of(folder)) {
      if (is_of_peers(file)) continue;  // their libraries calculate as they like
      INFO(file.string());
      // The verifier compares our functions with the C library, and refuses an answer if they differ; no number of a
      // record comes from the C library.
      const bool witness = file == "experiments/verifier.cpp";
      CHECK(elementary_functions(code_of(file)) ==
            (witness ? std::vector<std::string>{"sin", "cos"} : std::vector<std::string>{}));
    }
  }
}

// The linker may keep an inline function of another header that was compiled for a newer processor.
TEST_CASE("kernels include kernels and C headers alone, and have nothing of std", "[architecture]") {
  const Names c_headers{"stddef.h", "stdint.h", "immintrin.h"};
  const std::set<fs::path> sources = kernel_sources();
  CHECK(sources.contains("numerics/kernels.cpp"));
  CHECK(sources.contains("robots/kernels.cpp"));
  CHECK(sources.contains("solvers/kernels.cpp"));
  CHECK(sources.size() >= 6);
  for (const fs::path& source : sources) {
    INFO(source.string());
    const std::string stem = source.stem().string();
    CHECK((stem == "lanes" || stem == "elementary" || stem == "kernels"));
    CHECK(code_of(source).find("std::") == std::string::npos);
    for (const std::string& included : between(text_of(source), "#include <", ">")) CHECK(c_headers.contains(included));
  }
}
