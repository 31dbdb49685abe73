// Arms from URDF files: their content, the traps of the format, and the equality of chain and file.
#include "tests/mistakes.hpp"
#include "tests/mutator.hpp"
#include "tests/robots/random_configuration.hpp"

using std::numbers::pi;

namespace {

Robot file(const std::string& name, const UrdfChoice& choice = {}) {
  return load_robot("tests/data/urdf/" + name + ".urdf", choice);
}

// A chain of links l0, l1, ... with these joints between them: type and content of each.
struct Given {
  std::string type, content = "";
};

std::string urdf(const std::vector<Given>& joints) {
  std::string text = "<robot name='r'><link name='l0'/>\n";
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string number = std::to_string(i), next = std::to_string(i + 1);
    text += "<link name='l" + next + "'/><joint name='j" + next + "' type='" + joints[i].type + "'><parent link='l" +
            number + "'/><child link='l" + next + "'/>" + joints[i].content + "</joint>\n";
  }
  return text + "</robot>\n";
}

const std::string limit = "<limit lower='-1' upper='2'/>", about_z = "<axis xyz='0 0 1'/>";
const std::string to_tool = "<origin xyz='0.5 0 0'/>";

Robot read(const std::string& text, const UrdfChoice& choice = {}) { return parse_urdf(text, "my_arm.urdf", choice); }
Robot read(const std::vector<Given>& joints, const UrdfChoice& choice = {}) { return read(urdf(joints), choice); }

// The complaint about a file, or "" if it is an arm.
std::string said_of(const std::string& text, const UrdfChoice& choice = {}) {
  return complaint<std::invalid_argument>([&] { read(text, choice); });
}

// The largest difference of an element of the tool's pose over a thousand configurations.
double difference(const Robot& arm, const JointLimits& limits, auto other_pose) {
  RandomConfigurations random;
  double largest = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::VectorXd q = random(limits);
    largest = std::max(largest, (arm.chain.forward(q).matrix() - other_pose(q).matrix()).cwiseAbs().maxCoeff());
  }
  return largest;
}
double difference(const Robot& arm, const Robot& other) {
  return difference(arm, other.limits, [&](const auto& q) { return other.chain.forward(q); });
}
double difference(const Robot& arm) {
  return difference(arm, arm.limits, [&](const auto& q) { return pose_of(arm.description, q); });
}

// A random arm of up to nine joints of all kinds, with any origins and axes, some of them round numbers.
Description random_description(RandomConfigurations& random) {
  const auto length = [&] { return random.below(2) == 0 ? 0 : random.between(-1, 1); };
  const auto angle = [&] { return random.below(2) == 0 ? (random.below(5) - 2) * pi / 2 : random.between(-pi, pi); };
  Description joints(static_cast<std::size_t>(1 + random.below(9)));
  for (DescribedJoint& joint : joints) {
    joint.motion = static_cast<DescribedJoint::Motion>(random.below(3));
    joint.origin = {{length(), length(), length()}, {angle(), angle(), angle()}};
    const Eigen::Vector3d axis(length(), length(), length());
    joint.axis = random.below(2) == 0 || axis.isZero(0.01) ? Eigen::Vector3d::Unit(random.below(3)) : axis.normalized();
  }
  joints.front().motion = DescribedJoint::Motion::turns;
  return joints;
}

}  // namespace

// ---- the same arm ---------------------------------------------------------------------------------------------------

TEST_CASE("an arm from a URDF file and the same arm of the library agree to the digits of the file", "[urdf]") {
  CHECK(difference(file("iiwa14"), robot("kuka_iiwa14")) < 1e-12);
  CHECK(difference(file("panda"), robot("franka_panda")) < 1e-12);
  CHECK(difference(file("ur5e"), robot("ur5e")) < 2e-9);         // it prints 1.570796327
  CHECK(difference(file("gen3"), robot("kinova_gen3")) > 1e-6);  // the file prints 1.5708, the arm has quarter turns
}

TEST_CASE("any description with any axes has a chain of the same poses", "[urdf]") {
  RandomConfigurations random;
  for (int trial = 0; trial < 500; ++trial) {
    const Description description = random_description(random);
    const Chain chain = chain_of(description);
    Eigen::VectorXd q(chain.joints());
    for (int i = 0; i < 10; ++i) {
      for (double& joint : q) joint = random.between(-3, 3);
      REQUIRE((chain.forward(q).matrix() - pose_of(description, q).matrix()).cwiseAbs().maxCoeff() < 1e-12);
    }
  }
}

TEST_CASE("axes that are almost parallel, by any angle, have a chain of the same poses and of near frames", "[urdf]") {
  RandomConfigurations random;
  for (int trial = 0; trial < 500; ++trial) {
    Description description(6);
    for (DescribedJoint& joint : description) {
      const double tilt = std::pow(10, random.between(-13, 0)), turn = random.between(-pi, pi);
      joint.motion = random.below(5) == 0 ? DescribedJoint::Motion::slides : DescribedJoint::Motion::turns;
      joint.origin = {{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)},
                      {tilt + random.below(2) * pi, random.between(-tilt, tilt), turn}};
      joint.axis = Eigen::Vector3d::UnitZ();
    }
    const Chain chain = chain_of(description);
    for (const DhLink& link : chain.links()) REQUIRE(std::abs(link.d) < 100);
    Eigen::VectorXd q(6), error(1);
    for (int i = 0; i < 10; ++i) {
      for (double& joint : q) joint = random.between(-3, 3);
      const Pose pose = pose_of(description, q);
      REQUIRE((chain.forward(q).matrix() - pose.matrix()).cwiseAbs().maxCoeff() < 2e-12);
      chain.pose_errors(q, pose, 0.3, error);
      REQUIRE(error[0] < 2e-12);
      const Chain::Ball ball = chain.reach();
      REQUIRE((pose.translation() - ball.centre).norm() <= ball.radius + 1e-12);
    }
  }
}

TEST_CASE("joints are where a drawing by hand puts them", "[urdf]") {
  // A quarter turn about z lifts a tool half a metre ahead to the side; about x, the default, it stays.
  const auto at = [](const Robot& arm, double q) { return arm.chain.position(Eigen::VectorXd::Constant(1, q)); };
  const Given tool{"fixed", to_tool};
  CHECK((at(read({{"revolute", about_z + limit}, tool}), pi / 2) - Eigen::Vector3d(0, 0.5, 0)).norm() < 1e-15);
  CHECK((at(read({{"revolute", limit}, tool}), pi / 2) - Eigen::Vector3d(0.5, 0, 0)).norm() < 1e-15);
  // A slide along an axis of another length than 1 still moves in metres.
  const Robot slide = read({{"prismatic", "<axis xyz='0 -3 0'/>" + limit}, tool});
  CHECK((at(slide, 0.25) - Eigen::Vector3d(0.5, -0.25, 0)).norm() < 1e-15);
  CHECK(slide.chain.links()[0].joint == Joint::slides);
  // Roll, pitch and yaw are about fixed axes: Rz(yaw) Ry(pitch) Rx(roll).
  const Robot turned = read({{"fixed", "<origin rpy='0.1 0.2 0.3'/>"}, {"revolute", about_z + limit}, tool});
  CHECK((at(turned, 0) - 0.5 * rotation_from_rpy({0.1, 0.2, 0.3}).col(0)).norm() < 1e-15);
}

TEST_CASE("the name, the links, the limits and the joints of an arm are those of its file", "[urdf]") {
  const Robot arm = file("fetch");
  CHECK(arm.name == "fetch");
  CHECK(arm.summary == "fetch from base_link to gripper_link");
  CHECK(arm.source == "fetch.urdf");
  REQUIRE(arm.joints() == 8);
  REQUIRE(arm.description.size() == 9);
  CHECK(arm.description[0].name == "torso_lift");
  CHECK(arm.limits.upper[0] == 0.38615);
  CHECK(std::isinf(arm.limits.upper[3]));
  CHECK(SphericalWrist::fits(arm.chain));
  CHECK(SphericalWrist::fits(file("iiwa14").chain));
  CHECK_FALSE(SphericalWrist::fits(file("ur5e").chain));
}

// ---- the traps ------------------------------------------------------------------------------------------------------

TEST_CASE("base and tip are links of the user's, or the root and the end with the most moving joints",
          "[urdf][traps]") {
  const std::string text = urdf({{"fixed"}, {"revolute", about_z + limit}, {"revolute", limit}, {"fixed", to_tool}});
  CHECK(read(text).joints() == 2);
  CHECK(read(text).base_link == "l0");
  CHECK(read(text).tip_link == "l4");
  CHECK(read(text, {.base = "l1", .tip = "l2"}).joints() == 1);
  CHECK(
      said_of(text, {.base = "l9"}) ==
      "my_arm.urdf:1: base is \"l9\", which is not a link; did you mean \"l0\"?; to see the links: ikbench robot FILE --links");
  CHECK(said_of(text, {.base = "l3", .tip = "l1"}) == "my_arm.urdf:1: no joints lead from link \"l3\" to link \"l1\"");
  CHECK(said_of(text, {.base = "l3", .tip = "l4"})
            .starts_with(
                "my_arm.urdf:1: no joint moves between links \"l3\" and \"l4\"; choose others with --base LINK"));
  // More joints: of a kind, from a link to another.
  struct More {
    std::string type, from, to, content = "";
  };
  const auto with = [&](const std::vector<More>& more) {
    std::string longer = text;
    for (const auto& [type, from, to, content] : more)
      longer.insert(longer.find("</robot>"), "<link name='" + to + "'/><joint name='j" + to + "' type='" + type +
                                                 "'><parent link='" + from + "'/><child link='" + to + "'/>" + content +
                                                 "</joint>");
    return longer;
  };
  const auto asked = [](const std::string& of) {
    std::string all;
    try {
      return read(of).tip_link + '!';  // not asked
    } catch (const LinkQuestion& question) {
      for (const auto& [option, link, joints] : question.answers)
        all += fmt::format("{} {} {}, ", option, link, joints);
    }
    return all;
  };
  const auto ends_of = [&](const std::vector<More>& more) { return asked(with(more)); };
  const std::vector<More> camera{
      {"fixed", "l1", "c1"}, {"fixed", "c1", "c2"}, {"fixed", "c2", "c3"}, {"fixed", "c3", "c4"}};
  CHECK(read(with(camera)).tip_link == "l4");
  // Of links that move together: the leaf, of several the tool's frame, else the link that carries them.
  CHECK(ends_of({}) == "l4!");
  CHECK(read(text).other_tip == "l3");
  CHECK(ends_of({{"fixed", "l3", "s"}}) == "l3!");
  CHECK(ends_of({{"fixed", "l3", "my_tcp"}, {"fixed", "l3", "camera"}}) == "my_tcp!");
  CHECK(ends_of({{"fixed", "l3", "ee_link"}, {"fixed", "l3", "left_tool0"}}) == "left_tool0!");
  CHECK(read(with({{"fixed", "l3", "s"}}), {.tip = "s"}).joints() == 2);
  const More finger{"prismatic", "l4", "f", limit}, other{"prismatic", "l4", "g", limit + "<mimic joint='jf'/>"};
  CHECK(ends_of({finger, other}) == "l4!");
  CHECK(ends_of({finger, other, {"fixed", "l3", "tool0"}}) == "tool0!");
  CHECK(ends_of({finger, {"prismatic", "l4", "g", limit}}) == "l4!");
  CHECK(ends_of({finger, {"revolute", "l4", "g", limit}}) == "--tip f 3, --tip g 3, --tip l4 2, ");
  CHECK(ends_of({other}) == "l4!");
  CHECK(read(with({finger})).tip_link == "f");
  CHECK(ends_of({{"revolute", "l3", "jaw", limit}}) == "--tip jaw 3, --tip l3 2, ");
  CHECK(ends_of({{"revolute", "l3", "jaw", "<limit lower='0' upper='1'/>"}}) == "l3!");
  CHECK(ends_of({{"revolute", "l0", "r", limit}, {"revolute", "r", "s", limit}}) == "--tip l4 2, --tip s 2, ");
  // A last joint that is called a gripper, or turns one way from closed.
  const auto with_last = [&](const std::string& name, const std::string& its_limit) {
    std::string last = urdf({{"revolute", limit}});
    return last.insert(last.find("</robot>"), "<link name='hand'/><joint name='" + name +
                                                  "' type='revolute'><parent link='l1'/><child link='hand'/>" +
                                                  its_limit + "</joint>");
  };
  CHECK(read(with_last("j2", limit)).joints() == 2);
  CHECK(read(with_last("j2", "<limit lower='0' upper='4'/>")).joints() == 2);
  for (const auto& last : {with_last("jointGripper", limit), with_last("j2", "<limit lower='-0.2' upper='2'/>"),
                           with_last("j2", "<limit lower='-1.5' upper='0'/>")})
    CHECK(asked(last) == "--tip hand 2, --tip l1 1, ");
  // A jaw that is fixed beside one that moves is the tool.
  CHECK(ends_of({{"fixed", "l3", "fixed_jaw"}, {"revolute", "l3", "moving_jaw", limit}}) == "fixed_jaw!");
  CHECK(ends_of({{"fixed", "l3", "camera"}, {"revolute", "l3", "moving_jaw", limit}}) ==
        "--tip moving_jaw 3, --tip l3 2, ");
  // A chain that is longer than another is asked about, unless it is called a tool or twice as long.
  const auto branches = [&](int one, const std::string& its_end, int other) {
    std::vector<More> more;
    for (const auto& [count, prefix, end] :
         {std::tuple{one, "a", its_end}, std::tuple{other, "b", std::string("b_end")}}) {
      std::string from = "l0";
      for (int i = 1; i <= count; ++i)
        from = more.emplace_back(More{"revolute", from, prefix + std::to_string(i), limit}).to;
      more.push_back({"fixed", from, end});
    }
    return ends_of(more);
  };
  CHECK(branches(7, "laser", 6) == "--tip laser 7, --tip b_end 6, --tip l4 2, ");
  CHECK(branches(7, "tool0", 6) == "tool0!");
  CHECK(branches(6, "hand", 3) == "hand!");
  CHECK(branches(5, "hand", 3) == "--tip hand 5, --tip b_end 3, --tip l4 2, ");
  // A joint that floats ends the arm's tree, unless joints move on both sides of it.
  const std::string middle = urdf({{"revolute", limit}, {"planar"}, {"revolute", limit}, {"fixed", to_tool}});
  CHECK(
      said_of(middle) ==
      "my_arm.urdf:3: joint \"j2\": it is planar, and joints move before and after it; to use only those after it, add --base "
      "l2, or base = \"l2\" in [urdf]");
  CHECK(read(middle, {.base = "l2"}).joints() == 1);
  const Robot walker = read(urdf({{"floating"}, {"revolute", limit}, {"fixed", to_tool}}));
  CHECK(walker.base_link == "l1");
  CHECK(walker.joints() == 1);
  std::string apart = text;
  apart.insert(apart.find("</robot>"), "<link name='alone'/>");
  CHECK(read(apart).base_link == "l0");
  apart.insert(apart.find("</robot>"),
               "<link name='two'/><joint name='jt' type='revolute'><parent link='alone'/>"
               "<child link='two'/>" +
                   limit +
                   "</joint><link name='three'/><joint name='jh' type='revolute'><parent link='two'/>"
                   "<child link='three'/>" +
                   limit + "</joint>");
  CHECK(asked(apart) == "--base alone 2, --base l0 2, ");
  CHECK(read(apart, {.tip = "l4"}).joints() == 2);
  CHECK(link_tree(with({other}), "my_arm.urdf") ==
        "l0\n  l1  (fixed j1)\n    l2  (revolute j2)\n      l3  (revolute j3)\n        l4  (fixed j4)\n"
        "          g  (prismatic jg, mimics another)\n");
}

TEST_CASE("a file that is no URDF, no tree or not expanded is told with its place", "[urdf][traps]") {
  check_mistakes("urdf_file", "my_arm.urdf:", [](const std::string& text) { read(text); });
  const std::string loop =  // to which no root leads
      "<robot name='r'><link name='a'/><link name='b'/><link name='c'/><joint name='x' type='fixed'><parent link='c'/>"
      "<child link='b'/></joint><joint name='y' type='fixed'><parent link='b'/><child link='c'/></joint></robot>";
  CHECK(said_of(loop, {.base = "a", .tip = "c"}) ==
        "my_arm.urdf:1: the joints before link \"c\" form a cycle; expected a tree");
}

TEST_CASE("joints that are not of the four kinds are refused by name, if they are on the way", "[urdf][traps]") {
  for (const std::string type : {"floating", "planar", "ball"}) {
    CHECK(said_of(urdf({{"revolute", limit}, {type}})) ==
          "my_arm.urdf:3: joint \"j2\": its type is " + type + "; expected revolute, continuous, prismatic or fixed");
    CHECK(read({{type}, {"revolute", limit}}, {.base = "l1"}).joints() == 1);
  }
}

TEST_CASE("an element with very many attributes is refused", "[urdf][traps]") {
  std::string many;
  for (int i = 0; i < 40'000; ++i) many += fmt::format(" a{}='<>'", i);
  CHECK(said_of("<!-- it's one '<' -->\n<robot" + many + "/>") ==
        "my_arm.urdf:2: an element has more than 1000 attributes");
}

TEST_CASE("what of a joint would be left out or be misread is told with its line, its name and what is meant",
          "[urdf][traps]") {
  const auto as_joint = [](const std::string& content) { read({{"revolute", content}}); };
  check_mistakes("urdf", "my_arm.urdf:2: joint \"j1\": ", as_joint, limit);
  // What other programs write is theirs.
  CHECK(read({{"revolute",
               limit + "<dynamics damping='1'/><calibration rising='0'/><joint_properties friction='1'/>"
                       "<gazebo/><physics/><motor/><plugin/><drake:gear_ratio value='2'/><hardwareInterface/>"}})
            .joints() == 1);
  CHECK(read({{"revolute", "<origin xyz=' 1\t+2\n 3 '/>" + limit}}).description[0].origin.position ==
        Eigen::Vector3d(1, 2, 3));
  // A velocity that no joint has stands for none.
  for (const char* fastest : {"1000000", "1e308", "inf", "-1"})
    CHECK(read({{"revolute", fmt::format("<limit lower='-1' upper='2' velocity='{}'/>", fastest)}}).velocity.size() ==
          0);
  CHECK(read({{"revolute", "<limit lower='-1' upper='2' velocity='2.5'/>"}}).velocity[0] == 2.5);
  CHECK(read({{"revolute", "<limit command_effort='40' current='10' lower='-1' upper='2' gear_velocity='10'/>"}})
            .limits.upper[0] == 2);
}

TEST_CASE("limits are the hard ones, or the tighter of them and the soft ones", "[urdf][traps]") {
  const Robot hard = file("iiwa14"), soft = file("iiwa14", {.limits = UrdfChoice::Limits::soft});
  CHECK(hard.limits.upper[0] == 2.96706);
  CHECK(soft.limits.upper[0] == Approx(168 * pi / 180).epsilon(1e-6));
  CHECK(soft.limits.lower[6] == Approx(-173 * pi / 180).epsilon(1e-6));
  const Robot wide = read({{"revolute", limit + "<safety_controller soft_lower_limit='-9' soft_upper_limit='1'/>"}},
                          {.limits = UrdfChoice::Limits::soft});
  CHECK(wide.limits.lower[0] == -1);
  CHECK(wide.limits.upper[0] == 1);
}

TEST_CASE("limits of more than a turn are told, and lengths and velocities in other units are doubted",
          "[urdf][traps]") {
  const auto arm = [](const std::string& x, const std::string& content) {
    return read({{"revolute", content}, {"revolute", "<origin xyz='" + x + " 0 0'/>" + limit}});
  };
  const Robot legs = arm("0.3", "<limit lower='-10' upper='10' velocity='12'/>");
  CHECK(legs.limits.upper[0] == 10);
  CHECK(contains(legs.notes.at(0), "more than one turn"));
  CHECK(doubts_of(legs).empty());
  CHECK(contains(size_of(legs), "2 joints, reach 0.3 m"));
  CHECK(contains(doubts_of(arm("42", limit)).at(0), "42 m"));
  CHECK(contains(doubts_of(arm("0.042", limit)).at(0), "0.042 m"));
  CHECK(contains(doubts_of(arm("1", "<limit lower='-1' upper='1' velocity='180'/>")).at(0), "180"));
}

TEST_CASE("a limit with one end has 0 as the other, as the format says", "[urdf][traps]") {
  const Robot arm =
      read({{"prismatic", "<limit upper='0.5'/>"}, {"revolute", "<limit lower='-2'/>"}, {"revolute", limit}});
  CHECK(arm.limits.lower.head<2>() == Eigen::Vector2d(0, -2));
  CHECK(arm.limits.upper.head<2>() == Eigen::Vector2d(0.5, 0));
}

TEST_CASE("a joint that turns without end has no limits, whatever the file says", "[urdf][traps]") {
  const Robot arm = read({{"continuous", about_z + "<limit lower='-6.28' upper='6.28'/>"}, {"fixed", to_tool}});
  CHECK(std::isinf(arm.limits.lower[0]));
  CHECK(arm.notes.empty());
  CHECK(
      said_of(urdf({{"prismatic"}})) ==
      "my_arm.urdf:2: joint \"j1\": it is prismatic and has no <limit>; a prismatic joint needs limits in metres, such as <limit "
      "lower=\"0\" upper=\"0.5\"/>");
  const std::string slide = said_of(urdf({{"prismatic", "<limit lower='-999999' upper='999999'/>"}}));
  CHECK(contains(slide, "are -999999 and 999999"));
  CHECK_FALSE(contains(slide, "continuous"));
}

TEST_CASE("angles that a file prints short stay as they are", "[urdf][traps]") {
  const Robot arm = file("gen3");
  CHECK(arm.notes.empty());
  CHECK(arm.description[1].origin.rpy.x() == 1.5708);
  CHECK(difference(arm) < 1e-14);
  const auto angles = [](const std::string& rpy) {
    return read({{"revolute", "<origin rpy='" + rpy + "'/>" + about_z + limit}}).description[0].origin.rpy;
  };
  CHECK(angles("1.5708 3.14159 0.7854e0") == Eigen::Vector3d(1.5708, 3.14159, 0.7854));
  CHECK(angles("1e-17 3.1415926 1.5e-05") == Eigen::Vector3d(1e-17, 3.1415926, 1.5e-05));
  // So does a tilt of axes.
  const Given joint{"revolute", "<origin xyz='0.4 0 0' rpy='0 1.5e-05 0'/>" + about_z + limit};
  const Robot tilted = read({joint, joint, joint, {"fixed", to_tool}});
  CHECK(tilted.chain.links()[0].beta != 0);
  CHECK(tilted.chain.reach().radius < 1.3001);
  CHECK(difference(tilted) < 1e-15);
  // Axes that are parallel up to the digits of two angles.
  const std::vector<Given> bent{{"revolute", about_z + limit},
                                {"fixed", "<origin xyz='0.4 0 0' rpy='0 0.34906585 0'/>"},
                                {"revolute", "<origin rpy='0 -0.34906586 0'/>" + about_z + limit},
                                {"fixed", to_tool}};
  CHECK(difference(read(bent)) < 1e-15);
}

TEST_CASE("axes that are nearly parallel have a table of near frames, and an arm of its own lengths", "[urdf][traps]") {
  const Robot arm = file("ur5_calibrated");
  double own_lengths = 0;
  for (const DhLink& link : arm.chain.links()) CHECK(std::abs(link.d) < 1);
  for (std::size_t i = 2; i < arm.description.size(); ++i) own_lengths += arm.description[i].origin.position.norm();
  const Chain::Ball ball = arm.chain.reach();
  CHECK(ball.radius <= own_lengths + 1e-9);
  CHECK(ball.radius > 0.9);
  RandomConfigurations random;
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::VectorXd q = random(arm.limits);
    const Eigen::Vector3d expected = pose_of(arm.description, q).translation();
    Eigen::VectorXd error(1);
    arm.chain.position_errors(q, expected, error);
    REQUIRE(error[0] < 1e-9);
    REQUIRE((expected - ball.centre).norm() <= ball.radius + 1e-9);
  }
}

TEST_CASE("the reach is no longer than the arm's own lengths, however nearly parallel its axes are", "[urdf][traps]") {
  const Robot arm = read({{"revolute", about_z + limit},
                          {"revolute", "<origin xyz='0.3 0 0.1' rpy='0 3.14 0'/>" + about_z + limit},
                          {"revolute", "<origin xyz='-0.3 0 0' rpy='1.5708 0 0'/>" + about_z + limit},
                          {"fixed", "<origin xyz='0.2 0 0'/>"}});
  CHECK(arm.chain.reach().radius < 0.8);
  RandomConfigurations random;
  for (int trial = 0; trial < 1000; ++trial) {
    Description description = random_description(random);
    double lengths = 0;
    for (DescribedJoint& joint : description) {
      if (joint.motion == DescribedJoint::Motion::slides) joint.motion = DescribedJoint::Motion::turns;
      joint.origin.rpy = joint.origin.rpy.unaryExpr([&](double angle) {
        return std::round(2 * angle / pi) * pi / 2 + std::pow(10, random.between(-5, -1)) * random.between(-1, 1);
      });
      joint.axis = Eigen::Vector3d::UnitZ();
      if (&joint != &description.front()) lengths += joint.origin.position.norm();
    }
    const Chain chain = chain_of(description);
    const Chain::Ball ball = chain.reach();
    REQUIRE(ball.radius <= 1.005 * lengths + 1e-9);
    Eigen::VectorXd q(chain.joints());
    for (double& joint : q) joint = random.between(-3, 3);
    REQUIRE((chain.position(q) - ball.centre).norm() <= ball.radius + 1e-9);
  }
}

TEST_CASE("what the arm needs of xacro is told with the command that expands it; the rest is ignored",
          "[urdf][traps]") {
  CHECK_THROWS_WITH(parse_urdf("<robot name='r'><xacro:ur/></robot>", "ur.urdf.xacro", {}),
                    "ur.urdf.xacro:1: this is xacro; expand it first: xacro ur.urdf.xacro > expanded.urdf");
  std::string leftover = urdf({{"revolute", limit}});
  leftover.insert(leftover.find(" name"), " xmlns:xacro='http://www.ros.org/wiki/xacro'");
  leftover.insert(leftover.find("</robot>"),
                  "<xacro:property name='w' value='${2 * x}'/><xacro:macro name='m'><link name='${p}l'/></xacro:macro>"
                  "<link name='l0'><visual><mesh filename='$(find r)/${m}.stl'/></visual></link>");
  leftover.erase(leftover.find("<link name='l0'/>"), 17);
  CHECK(read(leftover).joints() == 1);
  leftover.insert(leftover.find("</robot>"), "<xacro:include filename='a'/>");
  CHECK(contains(said_of(leftover), "this is xacro"));  // it may bring the arm's links
  CHECK(read(leftover, {.base = "l0", .tip = "l1"}).joints() == 1);
}

TEST_CASE("a file that is too large is refused with its place", "[urdf][mistakes]") {
  CHECK(said_of("<robot name='r'><link name='" + std::string(300, 'a') + "'/></robot>")
            .starts_with("my_arm.urdf:1: a name is not a text of at most 200 bytes"));
  CHECK(said_of(urdf(std::vector<Given>(65, {"revolute", limit}))) ==
        "my_arm.urdf:1: 65 joints move between base and tip; expected 1 to 64");
  CHECK_THROWS_WITH(load_robot("tests"), "tests is not a regular file");
  for (const std::string name : {"tests", "meshes/arm.stl", "arm.dae"})
    CHECK_THROWS_WITH(robot(name), StartsWith("unknown robot \"" + name) && ContainsSubstring(".urdf or .toml"));
  CHECK(read(std::vector<Given>(64, {"continuous", to_tool})).joints() == 64);
  std::string deep = "<robot name='r'>";
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  CHECK(said_of(deep).starts_with("my_arm.urdf:1: not well-formed XML: "));
  const ScratchFolder folder;
  const auto large = folder.path / "large.urdf";
  std::ofstream(folder.path / "A.URDF") << urdf({{"revolute", limit}});
  CHECK(load_robot(folder.path / "A.URDF").name == "A");
  std::ofstream(large) << urdf({{"revolute", limit}}) << "<!-- " << std::string(16'000'000, 'x') << "-->";
  CHECK_THROWS_AS(load_robot(large), std::invalid_argument);
}

TEST_CASE("a URDF file with up to four random changes is an arm, or refused with its place", "[urdf][fuzz]") {
  read_mutated(Mutator(2026), text_in("tests/data/urdf/fetch.urdf"), 1000, "my_arm.urdf:", [](const std::string& text) {
    const Robot arm = read(text);
    REQUIRE(arm.joints() <= max_joints);
    REQUIRE((arm.limits.lower.array() < arm.limits.upper.array()).all());
    REQUIRE(arm.chain.position(Eigen::VectorXd::Zero(arm.joints())).allFinite());
  });
}
