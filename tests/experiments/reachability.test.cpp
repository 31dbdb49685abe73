// The interpretations of the paper's helix that the arm can follow at all: docs/papers/slim2023-notes.md 2.2. With the
// wrist decoupled, the shoulder (0, 0, 36) cm must be within 42 + 40 = 82 cm of the wrist's centre, 12.6 cm behind the
// tool.
#include "tests/experiments/samples.hpp"

namespace {

Study with_path(const Path& path) {
  Study study = load_study("slim2023");
  study.path = path;
  return study;
}

// Returns the largest distance [cm] from shoulder to wrist along the path, computed from lengths only.
double largest_distance_cm(const Path& path) {
  double largest = 0;
  for (const Pose& target : poses_of(path)) {
    const Eigen::Vector3d wrist = target.translation() - 0.126 * target.linear().col(2);
    largest = std::max(largest, (wrist - Eigen::Vector3d(0, 0, 0.360)).norm() * 100);
  }
  return largest;
}

double largest_unreachable_cm(const Path& path) {
  double largest = 0;
  for (const UnreachableTarget& target : unreachable_targets(with_path(path)))
    largest = std::max(largest, target.distance * 100);
  return largest;
}

}  // namespace

TEST_CASE("the tool straight down, the helix is fully reachable: 81.53 cm of 82, to its end 81.99",
          "[reachability][paper]") {
  CHECK(unreachable_targets(load_study("slim2023")).empty());
  CHECK(largest_distance_cm(Study{}.path) == Approx(81.53).margin(0.005));
  const Path helix = path_of({"spacing=k_over_n_minus_1"});
  CHECK(unreachable_targets(with_path(helix)).empty());
  CHECK(largest_distance_cm(helix) == Approx(81.99).margin(0.005));
}

TEST_CASE("under Eq. 27 no phase, start and spacing makes the whole helix reachable", "[reachability][paper]") {
  const std::vector<double> printed{85.06, 82.57, 82.15, 83.90};  // slim2023-notes 2.2, for 0, 90, 180, 270 deg
  for (const std::string phase : {"sin_cos", "cos_sin"}) {
    for (const std::string spacing : {"k_over_n", "k_over_n_minus_1"}) {
      for (std::size_t quarter = 0; quarter < 4; ++quarter) {
        const Path helix =
            path_of({"start_deg=" + std::to_string(90 * quarter), "phase=" + phase, "spacing=" + spacing, "tool=eq27"});
        CHECK(largest_unreachable_cm(helix) > 82);
        if (phase == "sin_cos" || spacing == "k_over_n") continue;
        CHECK(largest_unreachable_cm(helix) == Approx(printed[quarter]).margin(0.005));
        CHECK(largest_distance_cm(helix) == Approx(printed[quarter]).margin(0.005));
      }
    }
  }
}

TEST_CASE("an unreachable target is named by its place on the path, with distance and reach", "[reachability]") {
  Pose near = Pose::Identity(), far = Pose::Identity();
  near.translation() << 0.3, 0, 0.5;
  far.translation() << 1.0, 0, 0.486;  // wrist at (1.0, 0, 0.36): 1 m from the shoulder
  const std::vector<UnreachableTarget> found = unreachable_targets(with_path(path_through({near, far, near})));
  REQUIRE(found.size() == 1);
  CHECK(found[0].point == 2);
  CHECK(found[0].distance == Approx(1.0));
  CHECK(found[0].reach == Approx(0.82));
}

TEST_CASE("searching all joints, for a position or a pose, the tool counts, with the wrist's length added to the reach",
          "[reachability]") {
  Pose inside = Pose::Identity(), outside = Pose::Identity();
  inside.translation() << 0.945, 0, 0.36;  // 42 + 40 + 12.6 = 94.6 cm
  outside.translation() << 0.947, 0, 0.36;
  Study study = with_path(path_through({inside, outside}));
  for (const Search search : {Search::all_joints, Search::pose}) {
    study.search = search;
    const std::vector<UnreachableTarget> found = unreachable_targets(study);
    REQUIRE(found.size() == 1);
    CHECK(found[0].point == 2);
    CHECK(found[0].reach == Approx(0.946));
  }
}

TEST_CASE("the Dobot reaches the paper's circle, and random targets are reachable by the way they are made",
          "[reachability][paper]") {
  CHECK(unreachable_targets(load_study("slim2023-dobot")).empty());
  CHECK(unreachable_targets(load_study("slim2023-time")).empty());
  // Shoulder at 5.8 cm, reach 13.5 + 14.7 + 6.1 = 34.3 cm: 33.8 cm from the base's axis at z = 0. The centre is 22.6 cm
  // from it, at 45 deg; with 12 cm the points at 36 and 54 deg are 34.5 cm away, those at 18 and 72 deg 33.76 cm.
  CHECK(unreachable_targets(load_study("slim2023-dobot", {"path.radius_cm=11"})).empty());
  CHECK(unreachable_targets(load_study("slim2023-dobot", {"path.radius_cm=12"})).size() == 2);
}
