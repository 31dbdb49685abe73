// Mistakes of users as data: tests/data/mistakes/NAME has one a line, "TEXT => WORDS => WORDS", and comments after #.
#pragma once

#include "tests/common.hpp"

namespace ikbench {

// Reads each text, in which | ends a line and @ is `at`. It has to be refused in one sentence, which begins with
// `place` and the first of the words, and has the others.
template <class Read>
void check_mistakes(const std::string& name, const std::string& place, Read read, const std::string& at = "@") {
  std::istringstream table(text_in("tests/data/mistakes/" + name));
  int count = 0;
  for (std::string line; std::getline(table, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    std::vector<std::string> parts;
    for (std::size_t end = 0; end != std::string::npos; line.erase(0, end + 4)) {
      end = line.find(" => ");
      parts.push_back(line.substr(0, end));
      if (end == std::string::npos) break;
    }
    REQUIRE(parts.size() >= 2);
    std::string text;
    for (const char c : parts[0]) text += c == '|' ? "\n" : c == '@' ? at : std::string(1, c);
    const std::string said = complaint<std::invalid_argument>([&] { read(text); });
    CAPTURE(text, said);
    CHECK(said.starts_with(place + parts[1]));
    for (const std::string& words : parts) CHECK((&words <= &parts[1] || contains(said, words)));
    CHECK_FALSE(contains(said, "\n"));
    ++count;
  }
  CHECK(count > 0);
}

}  // namespace ikbench
