// The pages on adding things show, word for word, the code that tests/examples builds and runs.
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

const fs::path examples = "tests/examples";

struct Block {
  std::string before;  // the last line before it that is not empty
  std::string kind;
  std::string text;
};

std::vector<Block> blocks_of(const fs::path& page) {
  std::istringstream text(text_of(page));
  std::vector<Block> blocks;
  bool is_inside = false;
  std::string before;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) {
      is_inside = !is_inside;
      if (is_inside) blocks.push_back({before, line.substr(3), {}});
    } else if (is_inside) {
      blocks.back().text += line + '\n';
    } else if (!line.empty()) {
      before = line;
    }
  }
  return blocks;
}

// True if the block is in the file of tests/examples that the line before names, or in a diff of that file.
bool is_in_its_example(const Block& block) {
  const std::regex name("`([^`]+)`");
  for (std::sregex_iterator found(block.before.begin(), block.before.end(), name), end; found != end; ++found) {
    if (block.kind == "diff") {
      for (const auto& entry : fs::directory_iterator(examples)) {
        if (entry.path().extension() != ".diff") continue;
        const std::string diff = text_of(entry.path());
        const std::size_t file = diff.find("\n+++ b/" + (*found)[1].str() + '\n');
        if (file != std::string::npos && diff.find(block.text, file) != std::string::npos) return true;
      }
    } else if (fs::exists(examples / (*found)[1].str())) {
      return text_of(examples / (*found)[1].str()).find(block.text) != std::string::npos;
    }
  }
  return false;
}

std::vector<Block> all_blocks() {
  std::vector<Block> all;
  for (const char* page : {"docs/adding-anything.md", "docs/adding-a-solver.md"}) {
    for (Block& block : blocks_of(page)) {
      if (!block.kind.empty()) all.push_back(std::move(block));  // else they are commands
    }
  }
  return all;
}

}  // namespace

TEST_CASE("whatever the pages on adding things show is part of an example that is built", "[docs]") {
  std::set<std::string> kinds;
  for (const Block& block : all_blocks()) {
    INFO(block.before << '\n' << block.text);
    CHECK(is_in_its_example(block));
    kinds.insert(block.kind);
  }
  CHECK(kinds == std::set<std::string>{"cpp", "csv", "diff", "toml"});
}

TEST_CASE("the pages on adding things leave out no line of what the examples change", "[docs]") {
  std::string shown;
  for (const Block& block : all_blocks()) shown += block.text;
  for (const auto& entry : fs::directory_iterator(examples)) {
    if (entry.path().extension() != ".diff") continue;
    std::istringstream diff(text_of(entry.path()));
    for (std::string line; std::getline(diff, line);) {
      if (!line.starts_with('+') || line.starts_with("+++") || line == "+") continue;
      INFO(entry.path().string() << ": " << line);
      CHECK(shown.find(line + '\n') != std::string::npos);
    }
  }
}
