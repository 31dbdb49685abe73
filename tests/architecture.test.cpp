// The architecture, as the includes build it: which folder may know which.

#include "tests/common.hpp"

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

// Each folder of docs/explanation/architecture.md, and the folders that it may know.
const std::map<std::string, Names>& may_know() {
  static const std::map<std::string, Names> table{
      {"base", {}},
      {"numerics", {"base"}},
      {"robots", {"base", "numerics"}},
      {"solvers", {"base", "numerics", "robots"}},
      {"results", {"base", "numerics"}},
      {"experiments", {"base", "numerics", "robots", "solvers", "results"}},
      {"tests/benchmarks", {"base", "numerics", "robots", "solvers", "results", "experiments"}},
      {"analysis/judge", {"base", "numerics", "results"}},
      {"analysis/csv", {"base", "numerics", "results", "analysis/judge"}},
      {"analysis/figures", {"base", "numerics", "robots", "results", "analysis/judge"}},
      {"analysis/show", {"base", "numerics", "robots", "results", "analysis/judge", "analysis/figures"}},
      {"analysis/papers", {"base", "numerics", "results", "analysis/judge", "analysis/figures", "analysis/show"}},
      {"analysis/slim2023",
       {"base", "numerics", "robots", "results", "analysis/judge", "analysis/figures", "analysis/show",
        "analysis/papers"}},
      {"cli",
       {"base", "numerics", "robots", "solvers", "results", "experiments", "analysis/judge", "analysis/csv",
        "analysis/figures", "analysis/show", "analysis/papers", "analysis/slim2023"}},
  };
  return table;
}

// CMake writes these into the build folder of those that include them.
const Names generated{"arms.inc",        "references.inc", "build_info.hpp",       "multiverse.inc",
                      "paper_files.inc", "studies.inc",    "published_tables.inc", "source_digests.inc",
                      "style.inc",       "styles.inc",     "templates.inc",        "three.inc"};

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
    const std::string type = entry.path().extension().string(), path = entry.path().string();
    if (folder_of(path) != folder_of(folder + '/') || path.starts_with("solvers/programs/") ||
        path.starts_with("solvers/helpers/"))
      continue;
    if (type == ".hpp" || type == ".cpp" || type == ".inc") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> includes_of(const fs::path& file) {
  const std::string text = ikbench::text_in(file), opening = "#include \"";
  std::vector<std::string> found;
  for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
    at += opening.size();
    found.push_back(text.substr(at, text.find('"', at) - at));
  }
  return found;
}

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
      INFO(file.string() << " calls Eigen's dot(), whose order of sums differs between versions; call numerics::dot()");
      CHECK(ikbench::text_in(file).find(".dot(") == std::string::npos);
    }
  }
}
