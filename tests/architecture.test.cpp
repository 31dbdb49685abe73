// The architecture, as the includes build it: which folder may know which. A solver is one file and one line.
#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
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

// The names in the lines of a list; none is there twice.
Names names_in(const std::string& list, const std::string& macro) {
  const std::vector<std::string> lines = between("\n" + text_of(list), "\n" + macro, ",)");
  const Names names(lines.begin(), lines.end());
  CHECK(names.size() == lines.size());
  return names;
}

std::vector<std::string> papers() { return between(text_of("analysis/papers.inc"), "PAPER(", ")"); }

// docs/architecture.md: each folder, and the folders that it may know.
std::map<std::string, Names> folders_and_papers() {
  std::map<std::string, Names> table{
      {"numerics", {}},
      {"robots", {"numerics"}},
      {"solvers", {"numerics", "robots", "solvers/peers/modules"}},
      {"solvers/peers/modules", {}},
      {"results", {"numerics"}},
      {"experiments", {"numerics", "robots", "solvers", "results"}},
      {"analysis/statistics", {}},
      {"analysis/inference", {"numerics", "results", "analysis/statistics"}},
      {"analysis/figures", {"numerics", "robots", "results", "analysis/statistics", "analysis/inference"}},
      {"analysis/report",
       {"numerics", "robots", "results", "analysis/statistics", "analysis/inference", "analysis/figures"}},
      {"analysis/claims",
       {"numerics", "results", "analysis/statistics", "analysis/inference", "analysis/figures", "analysis/report"}},
      // the registry of the collections, which alone knows the folders of papers
      {"analysis", {"numerics", "analysis/report", "analysis/claims"}},
      {"cli",
       {"numerics", "robots", "solvers", "results", "experiments", "analysis/statistics", "analysis/inference",
        "analysis/figures", "analysis/report", "analysis"}},
      // tests, for its count of allocations
      {microbenchmarks, {"numerics", "robots", "solvers", "results", "experiments", "tests"}},
  };
  for (const std::string& paper : papers()) {
    table["analysis"].insert("analysis/" + paper);
    table["analysis/" + paper] = table.at("analysis/claims");
    table["analysis/" + paper].insert({"robots", "analysis/claims"});
  }
  return table;
}

const std::map<std::string, Names>& may_know() {
  static const std::map<std::string, Names> table = folders_and_papers();
  return table;
}

// CMake writes these into the build folder of those that include them.
const Names generated{"arms.inc",   "build_info.hpp",       "collections.inc",    "multiverse.inc",
                      "papers.inc", "published_tables.inc", "source_digests.inc", "studies.inc",
                      "style.inc",  "templates.inc"};

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

// The replacement for each, one per line.
std::string instead_of(const std::vector<std::string>& functions) {
  static const std::map<std::string, std::string> ours{
      {"sin", "sin_cos"},       {"cos", "sin_cos"},     {"sincos", "sin_cos"}, {"atan", "arc_tangent"},
      {"atan2", "arc_tangent"}, {"exp", "exponential"}, {"log", "logarithm"},  {"pow", "power"}};
  std::string text;
  for (const std::string& name : functions) {
    const auto found = ours.find(name);
    text += "instead of " + name + ' ' +
            (found == ours.end() ? "make it of those of numerics/functions.hpp, or add it there"
                                 : "use " + found->second + " of numerics/functions.hpp") +
            '\n';
  }
  return text;
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

Names registered_solvers() {
  const std::vector<std::string> names = between(text_of("solvers/registry.inc"), "SOLVER(", ")");
  CHECK(Names(names.begin(), names.end()).size() == names.size());  // none twice
  return {names.begin(), names.end()};
}

// Solvers of libraries: PEER(name, library, package...).
Names registered_peers() {
  Names names;
  for (const std::string& line : between(text_of("solvers/registry.inc"), "\nPEER(", ")")) {
    CHECK(names.insert(line.substr(0, line.find(','))).second);  // none twice
  }
  return names;
}

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

TEST_CASE("no folder of ours is included as a system header, past the table", "[architecture]") {
  for (const auto& [folder, below] : may_know()) {
    for (const fs::path& file : sources_of(folder)) {
      for (const std::string& included : between(text_of(file), "#include <", "/>")) {
        INFO(file.string() << " includes <" << included << "/...>");
        CHECK_FALSE(may_know().contains(included));
      }
    }
  }
}

TEST_CASE("no target links a folder that its sources may not know", "[architecture]") {
  for (const auto& [folder, below] : may_know()) {
    for (const std::string& linked : between(text_of(folder + "/CMakeLists.txt"), "ikbench::", " )\n")) {
      INFO(folder << "/CMakeLists.txt links ikbench::" << linked);
      CHECK(std::any_of(below.begin(), below.end(),
                        [&](const std::string& other) { return fs::path(other).filename() == linked; }));
    }
  }
}

TEST_CASE("every folder with sources is in the table", "[architecture]") {
  const Names others{"tests", "setup", "docs", "bench", "benchmarks"};
  for (const auto& entry : fs::directory_iterator(".")) {
    const std::string folder = entry.path().filename().string();
    if (!entry.is_directory() || folder.starts_with('.') || others.contains(folder)) continue;
    if (!fs::exists(entry.path() / "CMakeLists.txt") || folder == "build") continue;
    INFO(folder);
    CHECK(may_know().contains(folder));
  }
}

TEST_CASE("a solver is one line in the registry and one file of that name, which defines it", "[architecture]") {
  const Names solvers = registered_solvers();
  CHECK(solvers.size() >= 8);  // six of the paper, and two to compare them with
  for (const std::string& name : solvers) {
    INFO(name);
    REQUIRE(fs::exists("solvers/" + name + ".cpp"));
    CHECK(text_of("solvers/" + name + ".cpp").find("SolverInfo " + name + "()") != std::string::npos);
    CHECK_FALSE(fs::exists("solvers/" + name + ".hpp"));
  }
}

TEST_CASE("every file in solvers/ is a registered solver or part of the frame around them", "[architecture]") {
  const Names solvers = registered_solvers(), frame{"damped_step", "kernels", "options", "registry", "solve"};
  for (const fs::path& file : sources_of("solvers")) {
    if (file.extension() != ".cpp") continue;
    INFO(file.string());
    CHECK((is_of_peers(file) || solvers.contains(file.stem().string()) || frame.contains(file.stem().string())));
  }
}

TEST_CASE("a peer is one line in the registry and one file in peers, which defines it", "[architecture]") {
  const Names peers = registered_peers();
  CHECK(peers.size() >= 4);
  Names files;
  for (const fs::path& file : sources_of("solvers")) {
    if (is_of_peers(file) && file.extension() == ".cpp") files.insert(file.stem().string());
  }
  CHECK(files == peers);
  for (const std::string& name : peers) {
    INFO(name);
    const std::string text = text_of("solvers/peers/" + name + ".cpp");
    CHECK(text.find("SolverInfo " + name + "()") != std::string::npos);
    // The series' key contains the library's version; kdl.hpp has it for both of KDL.
    CHECK((text.find("info.library = ") != std::string::npos || text.find("return kdl_info<") != std::string::npos));
  }
}

TEST_CASE("what peers share is known to peers alone", "[architecture]") {
  for (const auto& [folder, below] : may_know()) {
    for (const fs::path& file : sources_of(folder)) {
      if (is_of_peers(file)) continue;
      INFO(file.string());
      for (const std::string& included : includes_of(file)) CHECK_FALSE(is_of_peers(included));
    }
  }
}

TEST_CASE("no solver is named by CMake, and none knows another", "[architecture]") {
  const Names solvers = registered_solvers();
  const std::string cmake = text_of("solvers/CMakeLists.txt");
  for (const std::string& name : solvers) {
    INFO(name);
    CHECK(cmake.find(name) == std::string::npos);
    for (const std::string& included : includes_of("solvers/" + name + ".cpp")) {
      const fs::path file = included;
      CHECK_FALSE((file.parent_path() == "solvers" && solvers.contains(file.stem().string())));
    }
  }
}

TEST_CASE("a kind of path is one line in paths.inc and one file of that name, which defines it", "[architecture]") {
  const Names kinds = names_in("experiments/paths.inc", "PATH(");
  Names files;
  for (const auto& entry : fs::directory_iterator("experiments/paths")) {
    INFO(entry.path().string());
    CHECK(entry.path().extension() == ".cpp");
    files.insert(entry.path().stem().string());
  }
  CHECK(files == kinds);
  for (const std::string& name : kinds) {
    INFO(name);
    CHECK(text_of("experiments/paths/" + name + ".cpp").find("PathKind> " + name + "_path()") != std::string::npos);
    CHECK(text_of("experiments/CMakeLists.txt").find("/" + name + ".cpp") == std::string::npos);
    for (const fs::path& file : sources_of("experiments")) {
      if (file.parent_path() == "experiments/paths") continue;
      if (name == "random" && file == "experiments/study_fields.hpp") continue;  // a start has that name too
      INFO(file.string());
      CHECK(code_of(file).find('"' + name + '"') == std::string::npos);  // nothing else knows the kinds
    }
  }
}

TEST_CASE("every part of a kind of path is pure virtual, so one that forgets a part does not compile",
          "[architecture]") {
  const std::vector<std::string> parts = between(code_of("experiments/path.hpp"), "  virtual ", ";");
  CHECK(parts.size() >= 8);
  for (const std::string& part : parts) {
    INFO(part);
    // Most kinds do not have these: files, fields that must fit each other, configurations behind the targets.
    const bool is_of_few = part.starts_with("void load(") || part.starts_with("void check(") ||
                           part.find(" solutions(") != std::string::npos;
    CHECK((part.ends_with(" = 0") || part == "~PathKind() = default" || is_of_few));
  }
}

TEST_CASE("a command is one line in commands.inc and one file of that name, which defines it", "[architecture]") {
  for (const std::string& name : names_in("cli/commands.inc", "COMMAND(")) {
    INFO(name);
    CHECK(text_of("cli/" + name + ".cpp").find("\nvoid add_" + name + "(CLI::App& app, Invocation&") !=
          std::string::npos);
  }
}

TEST_CASE("an export format is one line in export_formats.inc and one file of that name, which defines it",
          "[architecture]") {
  Names files;
  for (const auto& entry : fs::directory_iterator("results/formats")) files.insert(entry.path().stem().string());
  const Names texts = names_in("results/export_formats.inc", "EXPORT_TEXT("),
              folders = names_in("results/export_formats.inc", "EXPORT_FOLDER(");
  Names all = texts;
  all.insert(folders.begin(), folders.end());
  CHECK(files == all);
  for (const std::string& name : all) {
    INFO(name);
    const std::string function = texts.contains(name) ? name + "_text(" : "write_" + name + "(";
    CHECK(text_of("results/formats/" + name + ".cpp").find(' ' + function) != std::string::npos);
  }
  const std::string of_means = text_of("analysis/report/benchmark_json.cpp");
  for (const std::string& name : names_in("results/export_formats.inc", "EXPORT_MEANS(")) {
    INFO(name);
    CHECK(of_means.find("\nstd::string " + name + "(const JudgedStudy& study)") != std::string::npos);
  }
}

TEST_CASE("a table or figure of every study is one line in study_pieces.inc and one function in pieces/",
          "[architecture]") {
  std::string code;
  for (const auto& entry : fs::directory_iterator("analysis/report/pieces")) code += code_of(entry.path());
  std::size_t lines = 0;
  for (const char* kind : {"Table", "Figure"}) {
    const std::string type = kind, upper = type == "Table" ? "TABLE(" : "FIGURE(",
                      ending = type == "Table" ? "_tables" : "_figures";
    for (const std::string& name : names_in("analysis/report/study_pieces.inc", upper)) {
      INFO(name);
      ++lines;
      CHECK(code.find("\nstd::vector<" + type + "> " + name + ending + "(const StudyResults&") != std::string::npos);
    }
  }
  CHECK(between(code, "\nstd::vector<", "{").size() == lines);  // and nothing else
}

// A source begins with the header of its name, so that this header includes what it needs. A source without one shares
// a header of its folder. A source that defines one thing of a list (a solver, a kind of path, a command) needs none,
// nor does a program.
TEST_CASE("every source begins with the header of its name, or shares one of its folder", "[architecture]") {
  const Names solvers = registered_solvers(), commands = names_in("cli/commands.inc", "COMMAND(");
  for (const auto& [folder, below] : may_know()) {
    for (const fs::path& file : sources_of(folder)) {
      const std::string name = file.stem().string();
      const Names lists{"experiments/paths", "results/formats", "analysis/inference/methods", "analysis/report/pieces"};
      const bool listed = (folder == "solvers" && solvers.contains(name)) || is_of_peers(file) ||
                          lists.contains(file.parent_path().string()) || (folder == "cli" && commands.contains(name));
      if (file.extension() != ".cpp" || listed || file == "cli/main.cpp" || folder == microbenchmarks) continue;
      INFO(file.string());
      const std::vector<std::string> includes = includes_of(file);
      const fs::path header = fs::path(file).replace_extension(".hpp");
      const auto is_of_folder = [&](const std::string& each) {
        return fs::path(each).parent_path() == file.parent_path();
      };
      CHECK((fs::exists(header) ? !includes.empty() && includes.front() == header.string()
                                : std::ranges::any_of(includes, is_of_folder)));
    }
  }
}

TEST_CASE("a paper's C++ is one line in papers.inc and one folder of that name, which defines it", "[architecture]") {
  CHECK_FALSE(papers().empty());
  for (const std::string& name : papers()) {
    INFO(name);
    REQUIRE(fs::exists("analysis/" + name + "/paper.cpp"));
    CHECK(text_of("analysis/" + name + "/paper.cpp").find("\nvoid complete(Paper& paper) {") != std::string::npos);
    CHECK(text_of("analysis/CMakeLists.txt").find(name) == std::string::npos);
  }
}

namespace {

// The words in code that give a paper away: its name, its solvers' names, and its tables and figures.
std::vector<std::string> words_of_slim2023(const fs::path& file) {
  // Places, by the beginning of the path, where they stand for a reason.
  static const std::map<std::string, Names> allowed{
      {"solvers/", {"Slim", "IK-BA", "K-ABC", "MO-PSO", "Table 1"}},  // names of algorithms, and where they come from
      {"experiments/microbenchmarks/", {"IK-BA", "slim2023"}},        // the algorithm and the study that are measured
  };
  std::istringstream text(code_of(file));
  std::vector<std::string> found;
  for (std::string line; std::getline(text, line);) {
    if (file.string().starts_with("cli/") && line.find("\"  ikbench ") != std::string::npos) continue;  // an example
    for (const std::string word :
         {"slim2023", "Slim", "IK-BA", "K-ABC", "MO-PSO", "table-", "figure-", "Table ", "Figure "}) {
      std::size_t at = line.find(word);
      if (at == std::string::npos) continue;
      at += word.size();
      const bool is_numbered = word.back() == '-' || word.back() == ' ';
      if (is_numbered && (at == line.size() || line[at] < '0' || line[at] > '9')) continue;
      const std::string whole = is_numbered ? word + line[at] : word;
      const bool is_allowed = std::any_of(allowed.begin(), allowed.end(), [&](const auto& place) {
        return file.string().starts_with(place.first) && place.second.contains(whole);
      });
      if (!is_allowed) found.push_back(whole + " in: " + line);
    }
  }
  return found;
}

}  // namespace

TEST_CASE("nothing outside its folder knows the paper", "[architecture]") {
  CHECK_FALSE(words_of_slim2023("analysis/slim2023/paper.cpp").empty());  // or the search itself is broken
  for (const auto& [folder, below] : may_know()) {
    if (fs::exists(folder + "/paper.cpp")) continue;  // any paper has a Table 1
    for (const fs::path& file : sources_of(folder)) {
      if (file.extension() == ".inc") continue;  // data: the registry, the fingerprints
      for (const std::string& found : words_of_slim2023(file)) {
        INFO(file.string() << " has " << found);
        CHECK(false);
      }
    }
  }
}

TEST_CASE("libraries never print, only programs do", "[architecture]") {
  for (const auto& [folder, below] : may_know()) {
    if (folder == "cli" || folder == microbenchmarks) continue;
    for (const fs::path& file : sources_of(folder)) {
      const std::string text = text_of(file);
      for (const char* printer : {"std::cout", "std::cerr", "std::clog", "std::printf", "fprintf(", "fmt::print(",
                                  "std::puts", "stdout", "stderr"}) {
        INFO(file.string() << " has " << printer);
        CHECK(text.find(printer) == std::string::npos);
      }
    }
  }
}

// clang++ 14 cannot compile the ranges algorithms of this library that return a subrange, nor its split; the preset
// release-clang++ is its.
TEST_CASE("no source calls what clang++ cannot compile", "[architecture]") {
  for (const auto& [folder, below] : may_know()) {
    for (const fs::path& file : sources_of(folder)) {
      const std::string text = text_of(file);
      for (const char* name :
           {"unique", "stable_partition", "partition", "equal_range", "remove", "remove_if", "rotate"}) {
        INFO(file.string() << " has std::ranges::" << name);
        CHECK(text.find(std::string("std::ranges::") + name + "(") == std::string::npos);
      }
      INFO(file.string() << " has std::views::split");
      CHECK(text.find("std::views::split(") == std::string::npos);
    }
  }
}

// The results of these differ in their last bits between C libraries and processors, and so would a study's;
// numerics/functions.hpp has ours. Square roots are exact everywhere.
TEST_CASE("nothing that decides a number calls the C library's elementary functions", "[architecture]") {
  CHECK(elementary_functions("std::sin(x); ::atan2f (y, x); x.array().log(); f(std::pow); AngleAxisd(a, b);").size() ==
        5);
  CHECK(instead_of(elementary_functions("u.array().pow(y); std::tgamma(x)")) ==
        "instead of pow use power of numerics/functions.hpp\n"
        "instead of tgamma make it of those of numerics/functions.hpp, or add it there\n");
  CHECK(elementary_functions("sin_cos(x); power(x, 2); double log = 0; sines(3); std::sqrt(x);").empty());
  for (const std::string folder : {"numerics", "robots", "solvers", "experiments"}) {
    for (const fs::path& file : sources_of(folder)) {
      if (is_of_peers(file)) continue;  // their libraries calculate as they like
      INFO(file.string());
      // The verifier compares our functions with the C library, and refuses an answer if they differ; no number of a
      // record comes from the C library.
      const bool witness = file == "experiments/verifier.cpp";
      const std::vector<std::string> found = elementary_functions(code_of(file));
      INFO(instead_of(found));
      CHECK(found == (witness ? std::vector<std::string>{"sin", "cos"} : std::vector<std::string>{}));
    }
  }
}

// Eigen adds in another order if it vectorizes or aligns; the program turns that off in one place.
TEST_CASE("no source and no folder of its own says how Eigen or the compiler calculates", "[architecture]") {
  for (const auto& [folder, below] : may_know()) {
    std::vector<fs::path> files = sources_of(folder);
    files.emplace_back(folder + "/CMakeLists.txt");
    for (const fs::path& file : files) {
      INFO(file.string());
      const std::string code = code_of(file);
      for (const Word& word : words_of(code)) {
        CHECK((!word.text.starts_with("EIGEN_") || word.text.ends_with("_VERSION")));
      }
      for (const char* rule :
           {"fast-math", "Ofast", "-march", "-mtune", "-ffp-contract=fast", "FP_CONTRACT", "float_control"}) {
        INFO(rule);
        CHECK(code.find(rule) == std::string::npos);
      }
    }
  }
  const std::string house = text_of("CMakeLists.txt");
  CHECK(house.find("INTERFACE EIGEN_DONT_VECTORIZE") != std::string::npos);
  CHECK(house.find("-ffp-contract=off") != std::string::npos);
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

// catch_discover_tests passes the names as a CMake list: with one of these characters ctest silently runs fewer.
TEST_CASE("no test has a name that CMake takes apart", "[architecture]") {
  for (const fs::path& file : sources_of("tests")) {
    for (const std::string& name : between(text_of(file), "\nTEST_CASE(\"", "\"")) {
      INFO(file.string() << ": " << name);
      CHECK(name.find_first_of("[];\\") == std::string::npos);
    }
  }
}

namespace {

// What a code looks for in a text, where that is a part of a sentence and no character or name.
std::vector<std::string> words_looked_for(const std::string& code) {
  static const std::regex search(R"re(\b(?:r?find|starts_with|ends_with|contains)\(\s*"((?:[^"\\]|\\.)*)")re"),
      of_sentence(R"re([A-Za-z] |[:.;,] | [A-Za-z(]|\[)re");
  std::vector<std::string> found;
  for (std::sregex_iterator at(code.begin(), code.end(), search), end; at != end; ++at) {
    if (std::regex_search((*at)[1].str(), of_sentence)) found.push_back((*at)[1].str());
  }
  return found;
}

}  // namespace

TEST_CASE("no C++ of the analysis looks into a sentence", "[architecture]") {
  using Words = std::vector<std::string>;
  CHECK(words_looked_for(R"(if (cell.starts_with("in our range")) return;)") == Words{"in our range"});
  CHECK(words_looked_for(R"(note.substr(0, note.find(": ")))") == Words{": "});
  CHECK(words_looked_for(R"(name.ends_with("_cm") || svg.find("</g>"))").empty());
  const Names of_gnuplot{"analysis/figures/dark.cpp", "analysis/figures/figure.cpp"};  // they read what it wrote
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator("analysis")) {
    const fs::path& file = entry.path();
    if ((file.extension() != ".cpp" && file.extension() != ".hpp") || of_gnuplot.contains(file.string())) continue;
    ++files;
    CAPTURE(file);
    CHECK(words_looked_for(code_of(file)) == Words{});
  }
  CHECK(files > 200);
}
