// Arm files: the arm is as the file says, and mistakes are reported with their places.
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "numerics/units.hpp"
#include "tests/mutator.hpp"
#include "tests/robots/random_configuration.hpp"
#include "tests/scratch_folder.hpp"

namespace {

Robot read_arm(const std::string& text) { return parse_robot(text, "my_arm.toml"); }

// The complaint about a file, or "" if it is an arm.
std::string said_of_arm(const std::string& text) {
  return complaint<std::invalid_argument>([&] { read_arm(text); });
}

const std::string scara = R"(summary = "SCARA: two turns and a slide"
source = "an example"
links = [
  { a_m = 0.3, d_m = 0.4, limits_deg = [-130, 130] },
  { a_m = 0.2, alpha_deg = 180, offset_deg = 90 },
  { joint = "slides", limits_m = [0, 0.15] },
]
base = { position_m = [0, 0, 1], rpy_deg = [0, 0, 90] }
tool = { position_m = [0, 0, 0.05], rpy_deg = [180, 0, 0] }
)";

}  // namespace

TEST_CASE("an arm file says summary, source, links, limits, base and tool, and its name is the arm's", "[arm]") {
  const Robot arm = read_arm(scara);
  CHECK(arm.name == "my_arm");
  CHECK(arm.summary == "SCARA: two turns and a slide");
  CHECK(arm.source == "an example");
  const std::vector<DhLink>& links = arm.chain.links();
  REQUIRE(links.size() == 3);
  CHECK(links[0].a == 0.3);
  CHECK(links[0].d == 0.4);
  CHECK(links[0].joint == Joint::turns);
  CHECK(links[1].alpha == std::numbers::pi);
  CHECK(links[1].offset == std::numbers::pi / 2);
  CHECK(links[2].joint == Joint::slides);
  CHECK(arm.limits.lower == Eigen::Vector3d(-130 * degree, -180 * degree, 0));  // half a turn if none is given
  CHECK(arm.limits.upper == Eigen::Vector3d(130 * degree, 180 * degree, 0.15));
  CHECK(arm.chain.base() == Frame{{0, 0, 1}, {0, 0, std::numbers::pi / 2}});
  CHECK(arm.chain.tool() == Frame{{0, 0, 0.05}, {std::numbers::pi, 0, 0}});
}

TEST_CASE("an arm may be one link, written as a list or as tables", "[arm]") {
  CHECK(read_arm("links = [{}]").joints() == 1);
  CHECK(read_arm("[[links]]\na_m = 1\n[[links]]\njoint = 'coupled'\n").chain.links()[1].joint == Joint::coupled);
}

TEST_CASE("a mistake in an arm file is told with file, line, column, value and what was expected", "[arm][mistakes]") {
  struct Mistake {
    std::string text, said;
  };
  std::string many = "links = [";
  for (int i = 0; i < 65; ++i) many += "{},";
  const std::vector<Mistake> mistakes{
      {"", "my_arm.toml:1:1: links is missing; expected a list of 1 to 64 links"},
      {"links = []", "my_arm.toml:1:9: links is []; expected a list of 1 to 64 links"},
      {"links = 3", "my_arm.toml:1:9: links is 3; expected a list of 1 to 64 links"},
      {"links = [{}, 3]", "my_arm.toml:1:14: links is 3"},
      {many + "]", "my_arm.toml:1:9: links is"},
      {"links = = 3", "my_arm.toml:1:9: not TOML"},
      {"links = [{}]\nsummery = 'x'", "my_arm.toml:2:1: unknown key \"summery\"; did you mean \"summary\"?"},
      {"summary = 7\nlinks = [{}]", "my_arm.toml:1:11: summary is 7; expected a quoted string"},
      {"source = \"a\\nb\"\nlinks = [{}]", "my_arm.toml:1:10: source is"},
      {"links = [{ alpha_rad = 1 }]", "my_arm.toml:1:12: unknown key \"alpha_rad\"; did you mean \"alpha_deg\"?"},
      {"links = [{ d_m = 101 }]", "my_arm.toml:1:18: links.d_m is 101; expected a number from -100 to 100"},
      {"links = [{ d_m = nan }]", "my_arm.toml:1:18: links.d_m is nan; expected a number from -100 to 100"},
      {"links = [{ a_m = '1' }]", "my_arm.toml:1:18: links.a_m is \"1\"; expected a number from -100 to 100"},
      {"links = [{ alpha_deg = 1e9 }]", "expected a number from -3600 to 3600"},
      {"links = [\n{ joint = 'turn' }]",
       "my_arm.toml:2:11: links.joint is \"turn\"; expected one of \"turns\", \"slides\", \"coupled\""},
      {"links = [\n{ joint = 'slides' }]",
       "my_arm.toml:2:1: a joint that slides has no limits_m; expected them, such as limits_m = [0, 0.5]"},
      {"links = [{ joint = 'slides', limits_m = [0, 1], limits_deg = [0, 1] }]", "unknown key \"limits_deg\""},
      {"links = [{ limits_m = [0, 1] }]", "unknown key \"limits_m\"; did you mean \"limits_deg\"?"},
      {"links = [{ limits_deg = 'any' }]",
       "my_arm.toml:1:25: links.limits_deg is \"any\"; expected a list of 2 numbers"},
      {"links = [{ joint = 'slides', limits_m = 'none' }]", "links.limits_m is \"none\"; expected a list of 2 numbers"},
      {"links = [{ limits_deg = [-inf, inf] }]", "expected a list of 2 numbers"},
      {"links = [{ limits_deg = [90, -90] }]",
       "my_arm.toml:1:25: links.limits_deg is [ 90, -90 ]; expected the lower limit and then the upper, within +-3600"},
      {"links = [{ limits_deg = [90, 90] }]", "expected the lower limit and then the upper"},
      {"links = [{ limits_deg = [0, 4000] }]", "within +-3600"},
      {"links = [{ joint = 'slides', limits_m = [0, 101] }]", "within +-100"},
      {"links = [{ limits_deg = [90] }]", "my_arm.toml:1:25: links.limits_deg is [ 90 ]; expected a list of 2 numbers"},
      {"links = [{}]\ntool = 3", "my_arm.toml:2:8: tool is 3; expected a table: [tool]"},
      {"links = [{}]\nbase = { position_m = [1, 2] }",
       "my_arm.toml:2:23: base.position_m is [ 1, 2 ]; expected a list of 3 numbers"},
      {"links = [{}]\nbase = { position_m = [1, 2, 300] }",
       "base.position_m is [ 1, 2, 300 ]; expected lengths within"},
      {"links = [{}]\nbase = { position_cm = [1, 2, 3] }",
       "my_arm.toml:2:10: unknown key \"position_cm\"; did you mean \"position_m\"?"},
      {"links = [{}]\ntool = { rpy_deg = [0, inf, 0] }", "tool.rpy_deg is inf; expected a list of 3 numbers"}};
  for (const Mistake& mistake : mistakes) {
    const std::string said = said_of_arm(mistake.text);
    INFO(mistake.text);
    INFO(said);
    CHECK(said.starts_with("my_arm.toml:"));
    CHECK(said.find(mistake.said) != std::string::npos);
    CHECK(said.find('\n') == std::string::npos);
    CHECK(said.size() < 400);
  }
}

TEST_CASE("an arm file is a file of at most 10 MB, with a plain name", "[arm][mistakes]") {
  CHECK_THROWS_WITH(load_robot("none.toml"), "there is no file none.toml");
  CHECK_THROWS_WITH(load_robot("/dev/zero"), "there is no file /dev/zero");
  CHECK_THROWS_AS(parse_robot("links = [{}]", "a\nb.toml"), std::invalid_argument);
  CHECK_THROWS_AS(parse_robot("links = [{}]", std::string(300, 'a') + ".toml"), std::invalid_argument);
  const ScratchFolder folder;
  const auto file = folder.path / "large-arm.toml";
  std::ofstream(file) << scara << "# " << std::string(10'000'000, 'x');
  CHECK_THROWS_AS(load_robot(file), std::invalid_argument);
  std::ofstream(file) << scara;
  CHECK(load_robot(file).name == "large-arm");
}

TEST_CASE("an arm file with up to four random changes is an arm, or refused with its place", "[arm][fuzz]") {
  Mutator mutator(2024);
  int arms = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::string text = mutator.mutated(scara);
    try {
      const Robot arm = read_arm(text);
      ++arms;
      REQUIRE(arm.joints() <= most_joints);
      REQUIRE((arm.limits.lower.array() < arm.limits.upper.array()).all());
      REQUIRE(arm.chain.position(arm.limits.lower).allFinite());
    } catch (const std::invalid_argument& error) {
      INFO(error.what());
      REQUIRE(std::string(error.what()).starts_with("my_arm.toml:"));
    }
  }
  CHECK(arms > 50);  // fewer: the changes test the TOML parser alone
  CHECK(arms < 2900);
}
