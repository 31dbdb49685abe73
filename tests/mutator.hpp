// Random changes of a text, as by somebody who edits it in haste, and worse ones.
#pragma once

#include "tests/common.hpp"

namespace ikbench {

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string mutated(std::string text) {
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }

  void change(std::string& text) {
    static const std::vector<std::string> pieces = [] {
      std::istringstream words(
          "[ ] { } [[ ]] \" ' \"\"\" = , . # - + nan inf 1e9 true solvers path limits_m slides 0x _ \\ 1979-05-27 \xff "
          "99999999999999999999 {a={b=1}} [[[[1]]]] é 1e308 -Inf NA 5e-324 0.30000000000000004 1e999");
      std::vector<std::string> all{std::istream_iterator<std::string>(words), {}};
      all.insert(all.end(), {"\n", "\r"});
      return all;
    }();
    const std::size_t place = below(text.size() + 1), length = std::min(text.size() - place, below(12));
    switch (below(5)) {
      case 0:
        text.erase(place, length);
        break;
      case 1:
        text.insert(place, pieces[below(pieces.size())]);
        break;
      case 2:  // a piece of the file somewhere else
        text.insert(below(text.size() + 1), text.substr(place, below(80)));
        break;
      case 3:
        if (place < text.size()) text[place] = static_cast<char>(below(256));
        break;
      default:
        text.replace(place, length, pieces[below(pieces.size())]);
    }
  }

  std::mt19937 random_;
};

// Reads texts with random changes: each is read, or refused in one sentence that begins with the place. Returns how
// many were read; where hardly any is, the changes test the parser alone.
template <class Read>
int read_mutated(Mutator mutator, const std::string& whole, int times, const std::string& place, Read read) {
  int count = 0;
  for (int i = 0; i < times; ++i) {
    const std::string text = mutator.mutated(whole);
    CAPTURE(text);
    try {
      read(text);
      ++count;
    } catch (const std::invalid_argument& refused) {
      const std::string said = refused.what();
      CAPTURE(said);
      REQUIRE(said.starts_with(place));
      REQUIRE_FALSE(contains(said, "\n"));
    }
  }
  return count;
}

}  // namespace ikbench
