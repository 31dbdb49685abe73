// Arm files: the arm is as the file says, and mistakes are reported with their places.
#include "tests/mistakes.hpp"
#include "tests/mutator.hpp"
#include "tests/robots/random_configuration.hpp"

namespace {

Robot read_arm(const std::string& text) { return parse_robot(text, "my_arm.toml"); }

// The complaint about a file, or "" if it is an arm.
std::string said_of_arm(const std::string& text) {
  return complaint<std::invalid_argument>([&] { read_arm(text); });
}

const std::string scara = text_in("tests/data/arms/scara.toml");

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

TEST_CASE("angles in degrees may be near a quarter turn in radians, if they are no rounding of it", "[arm]") {
  CHECK(read_arm("links = [{ alpha_deg = 1.5723, offset_deg = 1.57080001 }, { alpha_deg = 1.6, offset_deg = 3 }]")
            .joints() == 2);
}

// Rows as printed (Craig's: alpha and a are those before the joint), without what is 0.
TEST_CASE("modified tables are the arms of their URDF files", "[arm]") {
  const std::pair<std::string, double> arms[]{
      {"panda", 1e-12}, {"iiwa14", 1e-12}, {"ur5e", 2e-9}, {"gen3", 2e-5}};  // the last two print rounded angles
  for (const auto& [arm, digits] : arms) {
    CAPTURE(arm);
    const Robot table = load_robot("tests/data/arms/" + arm + ".toml");
    const Robot file = load_robot("tests/data/urdf/" + arm + ".urdf");
    RandomConfigurations random;
    for (int trial = 0; trial < 100; ++trial) {
      const Eigen::VectorXd q = random(file.limits);
      REQUIRE((table.chain.forward(q).matrix() - file.chain.forward(q).matrix()).cwiseAbs().maxCoeff() < digits);
    }
  }
}

TEST_CASE("a mistake in an arm file is told with file, line, column, value and what was expected", "[arm][mistakes]") {
  check_mistakes("arm", "my_arm.toml:", read_arm);
  std::string many = "links = [";
  for (int i = 0; i < 65; ++i) many += "{},";
  CHECK(said_of_arm(many + "]").starts_with("my_arm.toml:1:9: links is"));
  CHECK(said_of_arm(many + "]").size() < 400);
}

TEST_CASE("an arm file is a file of at most 16 MB, with a plain name", "[arm][mistakes]") {
  CHECK_THROWS_WITH(load_robot("none.toml"), "there is no file none.toml");
  CHECK_THROWS_WITH(load_robot("/dev/zero"), "/dev/zero is not a regular file");
  CHECK_THROWS_AS(parse_robot("links = [{}]", "a\nb.toml"), std::invalid_argument);
  CHECK_THROWS_AS(parse_robot("links = [{}]", std::string(300, 'a') + ".toml"), std::invalid_argument);
  const ScratchFolder folder;
  const auto file = folder.path / "large-arm.toml";
  std::ofstream(file) << scara << "# " << std::string(16'000'000, 'x');
  CHECK_THROWS_AS(load_robot(file), std::invalid_argument);
  std::ofstream(file) << scara;
  CHECK(load_robot(file).name == "large-arm");
}

TEST_CASE("an arm file with up to four random changes is an arm, or refused with its place", "[arm][fuzz]") {
  read_mutated(Mutator(2024), scara, 3000, "my_arm.toml:", [](const std::string& text) {
    const Robot arm = read_arm(text);
    REQUIRE(arm.joints() <= max_joints);
    REQUIRE((arm.limits.lower.array() < arm.limits.upper.array()).all());
    REQUIRE(arm.chain.position(arm.limits.lower).allFinite());
  });
}
