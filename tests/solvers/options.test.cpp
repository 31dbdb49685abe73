// Values of options, and messages about wrong ones.
#include "tests/solvers/objectives.hpp"

namespace {

enum class Rule { greedy, loudness };

struct Example {
  double alpha = 0.97;
  int archive = 50;
  Rule rule = Rule::greedy;
  OptionList list;

  Example() {
    list.number("alpha", alpha, {0, 1}, "a factor");
    list.count("archive", archive, {1, 100}, "members");
    list.choice("rule", rule, {{"greedy", Rule::greedy}, {"loudness", Rule::loudness}}, "a rule");
  }
};

}  // namespace

TEST_CASE("options are set from text and written as text", "[options]") {
  Example example;
  CHECK(example.list.values() == Settings{{"alpha", "0.97"}, {"archive", "50"}, {"rule", "greedy"}});
  example.list.set({{"alpha", "5e-1"}, {"archive", "7"}, {"rule", "loudness"}});
  CHECK(example.alpha == 0.5);
  CHECK(example.archive == 7);
  CHECK(example.rule == Rule::loudness);
  CHECK(example.list.values() == Settings{{"alpha", "0.5"}, {"archive", "7"}, {"rule", "loudness"}});
}

TEST_CASE("a number that is none, or out of range, is refused and changes nothing", "[options]") {
  Example example;
  for (const char* text : {"", " ", "nan", "-nan", "inf", "1.0001", "-1e-300", "0.5x", " 0.5", "0.5 ", "0,5", "1e999",
                           "0x1", "half", "--1"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(example.list.set("alpha", text), std::invalid_argument);
  }
  for (const char* text : {"", "0", "101", "7.0", "7.5", "1e1", "99999999999999999999", "-1"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(example.list.set("archive", text), std::invalid_argument);
  }
  CHECK_THROWS_AS(example.list.set("rule", "Greedy"), std::invalid_argument);
  CHECK(example.list.values() == Example().list.values());
}

TEST_CASE("a refusal says which option, which value and what was expected", "[options]") {
  Example example;
  CHECK_THROWS_WITH(example.list.set("alpha", "2"), "option alpha is \"2\"; expected a number from 0 to 1");
  CHECK_THROWS_WITH(example.list.set("archive", "x"), "option archive is \"x\"; expected a whole number from 1 to 100");
  CHECK_THROWS_WITH(example.list.set("rule", "best"), "option rule is \"best\"; expected one of greedy, loudness");
  CHECK_THROWS_WITH(example.list.set("alhpa", "1"),
                    "unknown option \"alhpa\"; did you mean \"alpha\"? There are: alpha, archive, rule");
}
