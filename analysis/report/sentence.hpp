// A sentence of a report, with its topic.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <utility>
#include <vector>

namespace ikbench::report {

struct Sentence {
  std::string topic = {};  // "Assumptions"; a page sets it apart; may be empty
  std::string text;
};

inline std::string words_of(const Sentence& sentence) {
  return sentence.topic.empty() || sentence.text.empty() ? sentence.text : sentence.topic + ": " + sentence.text;
}

inline std::vector<std::string> words_of(const std::vector<Sentence>& sentences) {
  std::vector<std::string> all;
  for (const Sentence& sentence : sentences) all.push_back(words_of(sentence));
  return all;
}

inline std::string paragraph_of(const std::vector<Sentence>& sentences) {
  return fmt::format("{}", fmt::join(words_of(sentences), " "));
}

// Adds the sentence unless it is empty.
inline void add(std::vector<Sentence>& sentences, Sentence sentence) {
  if (!sentence.text.empty()) sentences.push_back(std::move(sentence));
}

}  // namespace ikbench::report
