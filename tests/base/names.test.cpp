#include "base/names.hpp"

#include "tests/common.hpp"

using namespace ikbench::base;

TEST_CASE("the nearest name is the one with the fewest edits, and none where none is near", "[names]") {
  const std::vector<std::string> names{"bat", "ik_bat", "particle_swarm"};
  CHECK(nearest_name("ik_bta", names) == "ik_bat");
  CHECK(nearest_name("particel_swarm", names) == "particle_swarm");
  CHECK(nearest_name("bat", names) == "bat");
  CHECK(nearest_name("gradient_descent", {"bat", "ik_bat"}).empty());
  CHECK(nearest_name("x", {}).empty());
  CHECK(nearest_name("", {"ik_bat"}).empty());
}

TEST_CASE("a message about an unknown name quotes it, suggests one and lists all", "[names]") {
  CHECK(unknown_name("solver", "ik_bta", {"ik_bat", "bat"}) ==
        "unknown solver \"ik_bta\"; did you mean \"ik_bat\"? There are: ik_bat, bat");
  CHECK(unknown_name("solver", std::string(100000, 'x'), {"bat"}).size() < 200);
  CHECK(unknown_name("key", "then", {"metric", "tie_breakers"}) == "then is now called tie_breakers");
  CHECK(renaming("hot", {"first", "warm"}) == "hot is now called warm");
  CHECK(unknown_name("label", "then", {"A", "tie_breakers"}).starts_with("unknown label"));  // a user's own
  CHECK(did_you_mean("turns", {"rounds"}).empty());                                          // a column, perhaps
  CHECK(contains(unknown_name("key", "turns", {"radius_cm"}), "unknown key"));               // of a circle
}

TEST_CASE("a text is cut between characters", "[names]") {
  CHECK(front("abc", 5) == "abc");
  CHECK(front("abcdef", 5) == "abcde");
  CHECK(front("abcdé", 5) == "abcd");
  CHECK(front("abcd\u20AC", 6) == "abcd");
  CHECK(front("abcd\u20AC", 7) == "abcd\u20AC");
  CHECK(front("\u20AC", 2).empty());
}

TEST_CASE("one has no plural", "[names]") {
  CHECK(counted(1, "runs") == "1 run");
  CHECK(counted(0, "runs") == "0 runs");
}
