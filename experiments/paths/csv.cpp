// Poses from a CSV file beside the study.
#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include "experiments/path.hpp"
#include "experiments/pose_csv.hpp"
#include "numerics/inputs.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

class CsvPath final : public PathKind {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<CsvPath>(*this); }

  std::string_view name() const override { return "csv"; }
  std::string_view summary() const override { return "poses from a CSV file: x_cm, y_cm, z_cm, qw, qx, qy, qz"; }

  // The key has the poses, so the file's name does not matter.
  void list_fields(Fields& io) override {
    io.text("file", file_,
            "beside the study. Columns: x, y, z in _m, _cm or _mm; then qw, qx, qy, qz, or roll, pitch, yaw in _deg or "
            "_rad, or r11, r12 ... r33; without these the tool points straight down",
            InKey::no);
  }

  void load(const std::filesystem::path& folder) override {
    const std::filesystem::path named = file_;
    const bool leaves = named.is_absolute() || named.lexically_normal().string().starts_with("..");
    if (file_.empty() || leaves) {
      throw std::invalid_argument(
          fmt::format("path.file is \"{}\"; expected a CSV file in the study's folder, such as \"path.csv\"", file_));
    }
    const std::filesystem::path file = folder / named;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
      throw std::invalid_argument(
          fmt::format("there is no file {}; expected a CSV file of poses in the study's folder", file.string()));
    }
    const std::filesystem::path home = std::filesystem::canonical(folder.empty() ? "." : folder),
                                meant = std::filesystem::canonical(file);
    if (std::mismatch(home.begin(), home.end(), meant.begin(), meant.end()).first != home.end()) {
      throw std::invalid_argument(fmt::format(
          "path.file is \"{}\", a link that leads out of the study's folder; expected a file in it", file_));
    }
    constexpr std::uintmax_t most_bytes = 16'000'000;
    poses_ = poses_from_csv(text_of_file(file, most_bytes), file.string());
  }

  bool is_drawn() const override { return false; }
  int points() const override { return static_cast<int>(poses_.size()); }
  std::vector<Pose> poses(const Robot&, Random&) const override { return poses_; }

 private:
  std::string file_;
  std::vector<Pose> poses_;
};

}  // namespace

std::unique_ptr<PathKind> csv_path() { return std::make_unique<CsvPath>(); }

}  // namespace ikbench::experiments
