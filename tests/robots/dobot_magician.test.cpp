// The Dobot Magician: its chain against its closed form, bit for bit, and against the angles that the paper prints.
#include "base/csv.hpp"
#include "tests/robots/random_configuration.hpp"

namespace {

// The closed form of docs/papers/slim2023-notes.md 2.11, which made the solves of the first stores.
struct Written {
  static constexpr double upper_arm = 0.135, forearm = 0.147, wrist_to_tool = 0.061, height = 0.058;  // [m]
  double s1, c1, s2, c2, s3, c3;

  explicit Written(const Eigen::Vector3d& q) {
    Eigen::Vector3d sines, cosines;
    sines_and_cosines(q, sines, cosines);
    s1 = sines[0], s2 = sines[1], s3 = sines[2], c1 = cosines[0], c2 = cosines[1], c3 = cosines[2];
  }
  Eigen::Vector3d position() const {
    const double radius = upper_arm * s2 + forearm * c3 + wrist_to_tool;
    return {radius * c1, radius * s1, upper_arm * c2 - forearm * s3 + height};
  }
  double error(const Eigen::Vector3d& target) const {
    const Eigen::Vector3d at = position();
    const double dx = at.x() - target.x(), dy = at.y() - target.y(), dz = at.z() - target.z();
    return std::sqrt(dx * dx + dy * dy + dz * dz);
  }
  Eigen::Matrix3d rotation() const { return Eigen::Matrix3d{{c1, -s1, 0}, {s1, c1, 0}, {0, 0, 1}}; }
  Eigen::Matrix3d jacobian() const {
    return Eigen::Matrix3d{{-position().y(), upper_arm * c2 * c1, -forearm * s3 * c1},
                           {position().x(), upper_arm * c2 * s1, -forearm * s3 * s1},
                           {0, -upper_arm * s2, -forearm * c3}};
  }
};

}  // namespace

TEST_CASE("the Dobot's errors, poses and Jacobians have the bits of its closed form", "[dobot]") {
  const Chain dobot = robot("dobot_magician").chain;
  RandomConfigurations random;
  constexpr Eigen::Index count = 20'003;
  Candidates q(3, count);
  Eigen::VectorXd errors(count);
  for (const double range : {1.6, 7.0, 1e5}) {
    for (double& angle : q.reshaped()) angle = random.between(-range, range);
    const Eigen::Vector3d target(0.2, random.between(-0.1, 0.1), 0.01);
    dobot.position_errors(q, target, errors);
    Eigen::Matrix3Xd jacobian(3, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Written expected(q.col(i));
      REQUIRE(errors[i] == expected.error(target));
      const Pose pose = dobot.forward(q.col(i));
      REQUIRE(pose.translation() == expected.position());
      REQUIRE(pose.linear() == expected.rotation());
      REQUIRE(dobot.position_jacobian(q.col(i), jacobian) == expected.position());
      REQUIRE(jacobian == expected.jacobian());
    }
  }
}

TEST_CASE("the Dobot's printed angles lie on the printed circle, to what a tenth of a degree moves", "[dobot][paper]") {
  const Chain dobot = robot("dobot_magician").chain;
  const std::string text = text_in("results/published/slim2023/table-8.csv");
  const CsvTable table_8 = parse_csv(text, "Table 8");
  for (std::size_t k = 0; k < table_8.rows(); ++k) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(k) / 20;
    const Eigen::Vector3d on_circle(0.16 + 0.07 * std::cos(turn), 0.16 + 0.07 * std::sin(turn), 0);  // Sec. 6
    const auto angle = [&](const char* column) { return table_8.number(k, column); };
    const Eigen::Vector3d q(angle("theta1_deg"), angle("theta2_deg"), angle("theta3_deg"));
    CAPTURE(k);
    // Half a tenth of a degree in each joint: 0.33 m, 0.135 m and 0.147 m off the axes.
    CHECK((dobot.position(q * degree) - on_circle).norm() < 0.05 * degree * (0.33 + 0.135 + 0.147));
  }
}

TEST_CASE("the Dobot stands upright where its links add up", "[dobot]") {
  const Chain dobot = robot("dobot_magician").chain;
  CHECK((dobot.position(Eigen::Vector3d(0, 0, 0)) - Eigen::Vector3d(0.147 + 0.061, 0, 0.135 + 0.058)).norm() < 1e-15);
  const double quarter = std::numbers::pi / 2;
  CHECK((dobot.position(Eigen::Vector3d(quarter, quarter, 0)) - Eigen::Vector3d(0, 0.343, 0.058)).norm() < 1e-15);
}
