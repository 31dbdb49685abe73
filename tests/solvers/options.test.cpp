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

TEST_CASE("options are set by value and given back", "[options]") {
  Example example;
  CHECK(example.list.values() == Settings{{"alpha", 0.97}, {"archive", 50.0}, {"rule", "greedy"}});
  example.list.set({{"alpha", 0.5}, {"archive", 7.0}, {"rule", "loudness"}});
  CHECK(example.alpha == 0.5);
  CHECK(example.archive == 7);
  CHECK(example.rule == Rule::loudness);
  CHECK(example.list.values() == Settings{{"alpha", 0.5}, {"archive", 7.0}, {"rule", "loudness"}});
}

TEST_CASE("a number that is none, or out of range, is refused and changes nothing", "[options]") {
  Example example;
  for (const Setting& value : {Setting(NAN), Setting(INFINITY), Setting(1.0001), Setting(-1e-300), Setting("0.5")}) {
    CAPTURE(text_of(value));
    CHECK_THROWS_AS(example.list.set("alpha", value), std::invalid_argument);
  }
  for (const Setting& value : {Setting(""), Setting(0.0), Setting(101.0), Setting(7.5), Setting(1e20), Setting(-1.0)}) {
    CAPTURE(text_of(value));
    CHECK_THROWS_AS(example.list.set("archive", value), std::invalid_argument);
  }
  CHECK_THROWS_AS(example.list.set("rule", "Greedy"), std::invalid_argument);
  CHECK(example.list.values() == Example().list.values());
}

TEST_CASE("a refusal says which option, which value and what was expected", "[options]") {
  Example example;
  CHECK_THROWS_WITH(example.list.set("alpha", 2.0), "option alpha is \"2\"; expected a number from 0 to 1");
  CHECK_THROWS_WITH(example.list.set("archive", "x"), "option archive is \"x\"; expected a whole number from 1 to 100");
  CHECK_THROWS_WITH(example.list.set("rule", "best"), "option rule is \"best\"; expected one of greedy, loudness");
  CHECK_THROWS_WITH(example.list.set("alhpa", 1.0),
                    "unknown option \"alhpa\"; did you mean \"alpha\"? There are: alpha, archive, rule");
}
