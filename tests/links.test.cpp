// Every link of the documentation to a file of the repository, or to a heading in it, leads somewhere.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/sources.hpp"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> pages() {
  std::vector<fs::path> files;
  for (const char* folder : {".", "docs"}) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".md") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Lines outside of blocks of code.
std::vector<std::string> lines_of(const fs::path& page) {
  std::istringstream text(text_of(page));
  std::vector<std::string> lines;
  bool in_code = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) in_code = !in_code;
    if (!in_code) lines.push_back(line);
  }
  return lines;
}

// The anchor of a heading on the repository's web page.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading.substr(heading.find(' ') + 1)) {
    if (c == ' ') anchor += '-';
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c < 0)
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return anchor;
}

std::set<std::string> anchors_in(const fs::path& page) {
  std::set<std::string> anchors;
  for (const std::string& line : lines_of(page)) {
    if (line.starts_with('#')) anchors.insert(anchor_of(line));
  }
  return anchors;
}

}  // namespace

TEST_CASE("every link in the documentation leads to a file, and to a heading in it", "[docs]") {
  const std::regex link(R"(\]\(([^)\s]+)\))");
  std::size_t links = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& line : lines_of(page)) {
      for (std::sregex_iterator found(line.begin(), line.end(), link), end; found != end; ++found) {
        const std::string target = (*found)[1];
        if (target.find("://") != std::string::npos) continue;
        INFO(page.string() << " links " << target);
        const std::size_t mark = std::min(target.find('#'), target.size());
        const fs::path file = mark == 0 ? page : page.parent_path() / target.substr(0, mark);
        CHECK(fs::exists(file));
        if (mark < target.size()) CHECK(anchors_in(file).contains(target.substr(mark + 1)));
        ++links;
      }
    }
  }
  CHECK(links > 20);  // or the search itself is broken
}
