// Doubts: kinds with their numbers, and the words that one file has for each.
#include "analysis/inference/doubt.hpp"

#include <set>
#include <string>

#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::inference;

TEST_CASE("every kind of doubt has a title, and words that its fields fill", "[doubt]") {
  std::set<std::string> texts;
  for (int i = 0; i <= static_cast<int>(DoubtKind::figure_not_drawn); ++i) {
    const Doubt doubt{.kind = static_cast<DoubtKind>(i), .who = {"A", "B"}, .count = 3, .of = 20, .what = "this"};
    const std::string text = words_of(doubt);
    CAPTURE(i, text);
    CHECK_FALSE(title_of(doubt.kind).empty());
    CHECK(text.find_first_of("{}") == std::string::npos);
    CHECK(texts.insert(text).second);
  }
}

TEST_CASE("times that are not compared say whose, and other studies in which it is so", "[doubt]") {
  Doubt doubt{.kind = DoubtKind::times_disturbed, .who = {"A"}, .count = 3, .of = 20};
  CHECK(title_of(doubt) == "Times of A are not comparable");
  CHECK(title_of(Doubt{.kind = DoubtKind::several_machines, .who = {"here"}}) == "Times are not comparable");
  CHECK(left_out_words({doubt, {.kind = DoubtKind::evaluations_uncounted, .who = {"B", "C"}}}) ==
        "A (other programs ran), B, C (nobody counted)");
  CHECK(
      words_of(doubt) ==
      "Times of A are not compared, because 3 of 20 solves took more than 1.1 times their CPU time, so other programs were running.");
  doubt.study = "of-another";
  CHECK(words_of(doubt).starts_with("of-another: Times of A are not compared, because 3 of 20"));
  doubt.study = "";
  doubt.is_of_all = true;
  doubt.studies = {"s", "t"};
  CHECK(
      words_of(Doubts{doubt, {.kind = DoubtKind::no_plan}}) ==
      "Times are not comparable: of A, 3 of 20 solves took more than 1.1 times their CPU time, so other programs were running. The same holds for s, t. The "
      "study has no analysis plan; this is the default plan.");
}
