// Poses from CSV files: by hand, and from arbitrary files.
#include "tests/experiments/samples.hpp"
#include "tests/mistakes.hpp"
#include "tests/mutator.hpp"

namespace {

const Eigen::Matrix3d down = Eigen::Vector3d(-1, 1, -1).asDiagonal();

std::vector<Pose> poses_in(const std::string& text) { return poses_from_csv(text, "path.csv"); }

std::string refusal(const std::string& text) {
  return complaint<std::invalid_argument>([&] { poses_in(text); });
}

constexpr const char* quaternions = "x_cm,y_cm,z_cm,qw,qx,qy,qz\n60,0,35,1,0,0,0\n60,-2.5,35,0.7071,0,0,0.7071\n";

std::string study_text(const std::string& file) {
  return "robot = \"kuka_iiwa14\"\n[path]\nkind = \"csv\"\nfile = \"" + file + "\"\n[[solvers]]\nsolver = \"bat\"\n";
}

}  // namespace

TEST_CASE("positions have the unit of their column, and quaternions are made exact", "[csv]") {
  const std::vector<Pose> poses = poses_in(quaternions);
  REQUIRE(poses.size() == 2);
  CHECK((poses[1].translation() - Eigen::Vector3d(0.6, -0.025, 0.35)).norm() < 1e-15);
  CHECK(poses[0].linear() == Eigen::Matrix3d::Identity());
  Eigen::Matrix3d quarter_turn;
  quarter_turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  CHECK((poses[1].linear() - quarter_turn).norm() < 1e-15);
  CHECK((poses_in("z_mm,x_m,y_cm\n350,0.6,-2.5\n")[0].translation() - Eigen::Vector3d(0.6, -0.025, 0.35)).norm() <
        1e-15);
}

TEST_CASE("roll, pitch and yaw turn about x, then y, then z", "[csv]") {
  const double half_pi = std::numbers::pi / 2;
  // Rz(90) Ry(0) Rx(90): x to y, y to z, z to x.
  Eigen::Matrix3d expected;
  expected << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const Eigen::Matrix3d in_degrees = poses_in("x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg\n0,0,0,90,0,90\n")[0].linear();
  CHECK((in_degrees - expected).norm() < 1e-15);
  const std::string text = "x_m,y_m,z_m,roll_rad,pitch_rad,yaw_rad\n0,0,0," + std::to_string(half_pi) + ",0," +
                           std::to_string(half_pi) + "\n";
  CHECK((poses_in(text)[0].linear() - expected).norm() < 1e-6);
}

TEST_CASE("without a rotation the tool points straight down", "[csv]") {
  CHECK(poses_in("x_m,y_m,z_m\n1,2,3\n")[0].linear() == down);
}

TEST_CASE("byte-order mark, carriage returns, blanks, quotes and empty lines change nothing", "[csv]") {
  const std::vector<Pose> plain = poses_in("x_m,y_m,z_m\n1,2,3\n4,5,6\n");
  for (const std::string text :
       {"\xEF\xBB\xBFx_m,y_m,z_m\n1,2,3\n4,5,6", "x_m,y_m,z_m\r\n1,2,3\r\n4,5,6\r\n",
        "\n x_m , y_m,z_m\n\n1, 2,\t3\n\n4,5,6\n\n", "\"x_m\",\"y_m\",\"z_m\"\n\"1\",\"2\",\"3\"\n4,5,6\n"}) {
    CAPTURE(text);
    const std::vector<Pose> poses = poses_in(text);
    REQUIRE(poses.size() == plain.size());
    for (std::size_t i = 0; i < poses.size(); ++i) CHECK(poses[i].matrix() == plain[i].matrix());
  }
}

TEST_CASE("the same poses are read from sheets of spreadsheets and from what robots record", "[csv]") {
  const Eigen::Matrix3d turned = rotation_from_rpy({0.3, -0.2, 1.2});
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator("tests/data/poses")) {
    CAPTURE(entry.path().string());
    const std::vector<Pose> poses = poses_in(text_in(entry.path()));
    REQUIRE(poses.size() == 2);
    for (const Pose& pose : poses) {
      CHECK((pose.translation() - Eigen::Vector3d(0.4, 0.1, 0.3)).norm() < 1e-12);
      CHECK((pose.linear() - turned).norm() < 1e-11);
      CHECK(pose.linear().isUnitary(1e-14));
    }
    ++files;
  }
  CHECK(files == 9);
}

TEST_CASE("every mistake is told with its line, its column and what was expected", "[csv]") {
  check_mistakes("poses", "path.csv:", poses_in);
  CHECK_THAT(refusal("x_m,y_m,z_m\n1,\x01,3\n"), ContainsSubstring("path.csv:2:2: ' ' in column 'y_m'"));
  // Columns beside a matrix are left out by name.
  std::vector<std::string> names{""};
  for (int i = 1; i <= 12; ++i) names.push_back(std::to_string(i));
  const std::vector<Pose> stamped =
      poses_from_csv("7 1 0 0 .4 0 1 0 .1 0 0 1 .3\n8 1 0 0 .4 0 1 0 .1 0 0 1 .3\n", "path.csv", names);
  CHECK(stamped.at(1).translation() == Eigen::Vector3d(0.4, 0.1, 0.3));
  // A row that was taken out is no header, also after a byte-order mark.
  CHECK(poses_in("\xEF\xBB\xBF# 1 0 0 .9 0 1 0 0 0 0 1 .9\n1 0 0 .4 0 1 0 0 0 0 1 .3\n").at(0).translation().x() ==
        0.4);
  std::string long_file = "x_m,y_m,z_m\n";
  for (int i = 0; i < 100'000; ++i) long_file += "1,2,3\n";
  CHECK(poses_in(long_file).size() == 100'000);
  CHECK_THAT(refusal(long_file + "1,2,3\n"), ContainsSubstring("path.csv: expected at most 100000 poses"));
}

TEST_CASE("random changes and random bytes are read, or refused with their line", "[csv][fuzz]") {
  read_mutated(Mutator(5), quaternions, 1000, "path.csv:", poses_in, 0.2);  // most others have another length
  read_mutated(Mutator(5), "x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg\n0.5,-0.25,0.75,10,20,-30\n0.4,0.3,0.2,0,90,5\n",
               2000, "path.csv:", poses_in);
  std::mt19937 random(6);
  for (int i = 0; i < 300; ++i) {
    std::string bytes(random() % 400, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    CHECK_THAT(refusal(bytes), ContainsSubstring("path.csv:"));
  }
}

TEST_CASE("a study's CSV file is beside it, and what it holds decides the series, not its name", "[csv][series]") {
  const ScratchFolder folder;
  write_text(folder.path / "a.csv", quaternions);
  write_text(folder.path / "b.csv", quaternions);
  write_text(folder.path / "other.csv", "x_m,y_m,z_m\n0.5,0,0.4\n");
  const auto key = [&](const std::string& file) {
    write_text(folder.path / "study.toml", study_text(file));
    const Study study = load_study((folder.path / "study.toml").string());
    return configuration_key(study, study.solvers[0]);
  };
  CHECK(key("a.csv") == key("b.csv"));
  CHECK(key("a.csv") != key("other.csv"));
  key("other.csv");
  const Study written = load_study((folder.path / "study.toml").string());
  CHECK(written.path->points() == 1);
  write_text(folder.path / "study.toml", to_toml(written));
  CHECK(to_toml(load_study((folder.path / "study.toml").string())) == to_toml(written));
}

TEST_CASE("stamps are no part of a pose, wherever they stand", "[csv]") {
  const std::string ros2 =
      "header.stamp.sec,header.stamp.nanosec,header.frame_id,pose.position.x,pose.position.y,pose.position.z,"
      "pose.orientation.x,pose.orientation.y,pose.orientation.z,pose.orientation.w\n"
      "17,999000000,base,0.5,0,0.4,1,0,0,0\n18,4000000,base,0.5,0.1,0.4,1,0,0,0\n";
  REQUIRE(poses_in(ros2).size() == 2);
  CHECK(poses_in(ros2)[1].translation() == Eigen::Vector3d(0.5, 0.1, 0.4));
  for (const std::string stamp : {"timestamp", "time", "t", "secs", "time_s"})
    CHECK(poses_in("x_m,y_m,z_m," + stamp + "\n1,2,3,9\n1,2,4,7\n").size() == 2);
}

TEST_CASE("`columns` says what a file without a header has, or what its header does not", "[csv][series]") {
  const std::string tum = "17.5 0.5 0 0.4 1 0 0 0\n17.4 0.5 0.1 0.4 1 0 0 0\n";
  CHECK(!refusal(tum).empty());
  const std::vector<std::string> columns{"", "x", "y", "z", "qx", "qy", "qz", "qw"};
  CHECK(poses_from_csv(tum, "path.csv", columns)[1].translation() == Eigen::Vector3d(0.5, 0.1, 0.4));
  CHECK_THAT(refusal("i,x,y,z\n1,0.5,0,0.4\n"), ContainsSubstring("name it \"\" in path.columns"));
  CHECK(poses_from_csv("t,a,b,c\n1,500,0,400\n", "path.csv", {"", "x_mm", "y_mm", "z_mm"})[0].translation() ==
        Eigen::Vector3d(0.5, 0, 0.4));
  CHECK_THAT(complaint<std::invalid_argument>([&] {
               poses_from_csv(tum, "path.csv", {"x", "y", "z"});
             }),
             ContainsSubstring("8 columns"));
  const ScratchFolder folder;
  write_text(folder.path / "a.csv", tum);
  std::string text = study_text("a.csv");
  text.insert(text.find("[[solvers]]"), "columns = [\"\", \"x\", \"y\", \"z\", \"qx\", \"qy\", \"qz\", \"qw\"]\n");
  write_text(folder.path / "study.toml", text);
  CHECK(load_study((folder.path / "study.toml").string()).path->points() == 2);
}

TEST_CASE("a CSV file that is missing, elsewhere or too large is refused", "[csv]") {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path / "study");
  write_text(folder.path / "outside.csv", quaternions);
  write_text(folder.path / "study/large.csv", std::string(16'000'001, ' '));
  write_text(folder.path / "study/bad.csv", "x_m,y_m,z_m\n1,two,3\n");
  const auto said = [&](const std::string& file) {
    write_text(folder.path / "study/my.toml", study_text(file));
    return complaint<std::invalid_argument>([&] { load_study((folder.path / "study/my.toml").string()); });
  };
  CHECK_THAT(said("none.csv"), ContainsSubstring("my.toml:4:8: there is no file ") && ContainsSubstring("none.csv"));
  std::filesystem::create_symlink("../outside.csv", folder.path / "study/link.csv");
  CHECK(said((folder.path / "outside.csv").string()).empty());  // by its full path
  for (const std::string file : {"../outside.csv", "link.csv"})
    CHECK_THAT(said(file), StartsWith((folder.path / "study/my.toml").string() + ":4:8: path.file is \"" + file +
                                      "\", which is outside"));
  CHECK_THAT(said(""), ContainsSubstring("is not a regular file"));
  std::filesystem::create_symlink("/dev/zero", folder.path / "study/endless.csv");
  CHECK_THAT(said("endless.csv"), ContainsSubstring("is not a regular file"));
  std::ofstream(folder.path / "study/sparse.csv").close();
  std::filesystem::resize_file(folder.path / "study/sparse.csv", 1ULL << 40);  // 1 TB that takes no room
  CHECK_THAT(said("sparse.csv"), ContainsSubstring("expected a file of at most 16 MB"));
  write_text(folder.path / "study/far.csv", "x_m,y_m,z_m\n40,0,50\n45,10,40\n");
  CHECK_THAT(said("far.csv"), ContainsSubstring("times as far as the arm reaches"));
  write_text(folder.path / "study/good.csv", quaternions);
  std::filesystem::create_symlink("good.csv", folder.path / "study/inside.csv");
  CHECK(said("inside.csv").empty());
  CHECK_THAT(said("large.csv"), ContainsSubstring("expected a file of at most 16 MB"));
  CHECK_THAT(said("bad.csv"), ContainsSubstring("bad.csv:2:2: 'two' in column 'y_m'"));
}
