// A study from TOML: every mistake in one sentence with file, line, column, value and what was expected.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

#include "experiments/built_in_studies.hpp"
#include "experiments/study_fields.hpp"
#include "experiments/study_file.hpp"
#include "numerics/toml_table.hpp"
#include "results/published.hpp"
#include "numerics/names.hpp"
#include "robots/spherical_wrist.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

constexpr std::uintmax_t largest_file = 10'000'000;

std::string shown(const toml::node& node) {
  std::ostringstream out;
  out << toml::toml_formatter(node, toml::format_flags::none);
  std::string text = out.str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.size() <= 80 ? text : text.substr(0, 77) + "...";
}

constexpr std::string_view plain = "a text of at most 200 bytes without control characters";

// Reads one table; says where and what is wrong; knows which keys there are once it has read them.
class Reader {
 public:
  Reader(const toml::table& table, std::string_view source, std::string prefix)
      : table_(table), source_(source), prefix_(std::move(prefix)) {}

  void text(std::string_view key, std::string& field, std::string_view) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const toml::value<std::string>* value = node->as_string();
    if (value == nullptr) fail(key, *node, "a text in quotes");
    if (!is_plain(value->get())) fail(key, *node, plain);
    field = value->get();
  }

  template <class Enum>
  void choice(std::string_view key, Enum& field, const Choices<Enum>& choices, std::string_view) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const std::optional<std::string> wanted = node->value<std::string>();
    std::vector<std::string> names;
    for (const auto& [name, value] : choices) {
      if (wanted == name) {
        field = value;
        return;
      }
      names.push_back(name);
    }
    fail(key, *node, fmt::format("one of \"{}\"", fmt::join(names, "\", \"")));
  }

  template <class Whole>
  void whole(std::string_view key, Whole& field, std::pair<std::int64_t, std::int64_t> range, std::string_view) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const toml::value<std::int64_t>* value = node->as_integer();
    if (value == nullptr || value->get() < range.first || value->get() > range.second) {
      fail(key, *node, fmt::format("a whole number from {} to {}", range.first, range.second));
    }
    field = static_cast<Whole>(value->get());
  }

  void number(std::string_view key, double& field, double unit, std::pair<double, double> range, std::string_view) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const std::optional<double> value = as_number(*node);
    if (!value || !(*value >= range.first && *value <= range.second)) {
      fail(key, *node, fmt::format("a number from {} to {}", range.first, range.second));
    }
    field = *value * unit;
  }

  // `size` 0: any number of them.
  template <class Vector>
  void numbers(std::string_view key, Vector& field, double unit, int size, std::string_view) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const toml::array* array = node->as_array();
    const std::string expected = size == 0 ? "a list of numbers" : fmt::format("a list of {} numbers", size);
    if (array == nullptr || (size != 0 && array->size() != static_cast<std::size_t>(size))) fail(key, *node, expected);
    field.resize(static_cast<Eigen::Index>(array->size()));
    Eigen::Index index = 0;
    for (const toml::node& element : *array) {
      const std::optional<double> value = as_number(element);
      if (!value || !(std::abs(*value) <= 1e6)) fail(key, element, expected + " within +-1e6");
      field[index++] = *value * unit;
    }
  }

  // The value of a key, remembered as known; null where it is not given.
  const toml::node* find(std::string_view key) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
    return table_.get(key);
  }

  // To be called when all keys were asked for.
  void refuse_unknown_keys() const {
    for (const auto& [key, node] : table_) {
      if (std::find(known_.begin(), known_.end(), key.str()) == known_.end()) {
        throw std::invalid_argument(where(key.source(), key.str()) + unknown_name("key", key.str(), known_));
      }
    }
  }

  [[noreturn]] void fail(std::string_view key, const toml::node& node, std::string_view expected) const {
    throw std::invalid_argument(
        fmt::format("{}{}{} is {}; expected {}", where(node.source(), key), prefix_, key, shown(node), expected));
  }

  // "study.toml:3:8: ", or for what no file says "--set path.tool: ".
  std::string where(const toml::source_region& region, std::string_view key) const {
    if (region.begin.line == 0 || region.path) return fmt::format("--set {}{}: ", prefix_, key);
    return fmt::format("{}:{}:{}: ", source_, region.begin.line, region.begin.column);
  }

  static bool is_plain(const std::string& text) {
    const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
    return text.size() <= 200 && std::none_of(text.begin(), text.end(), is_control);
  }

  Reader nested(const toml::table& table, std::string prefix) const { return {table, source_, std::move(prefix)}; }
  const toml::table& table() const { return table_; }

 private:
  static std::optional<double> as_number(const toml::node& node) {
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    return value && std::isfinite(*value) ? value : std::nullopt;
  }

  const toml::table& table_;
  std::string source_;
  std::string prefix_;
  std::vector<std::string> known_;
};

const toml::table* as_table(Reader& reader, std::string_view key) {
  const toml::node* node = reader.find(key);
  if (node != nullptr && !node->is_table()) reader.fail(key, *node, fmt::format("a table: [{}]", key));
  return node == nullptr ? nullptr : node->as_table();
}

std::vector<Pose> read_poses(Reader& reader) {
  const toml::node* node = reader.find("poses");
  const toml::array* array = node == nullptr ? nullptr : node->as_array();
  const std::string expected =
      "a list of 1 to 100000 poses such as { position_cm = [60, 0, 35], rpy_deg = [180, 0, 180] }";
  if (array == nullptr) {
    throw std::invalid_argument(reader.where(reader.table().source(), "poses") + "path.poses is missing; expected " +
                                expected);
  }
  if (array->empty() || array->size() > 100'000) reader.fail("poses", *node, expected);
  std::vector<Pose> poses;
  for (const toml::node& element : *array) {
    if (!element.is_table()) reader.fail("poses", element, expected);
    Reader pose_reader = reader.nested(*element.as_table(), "path.poses.");
    Eigen::Vector3d position, rpy = Eigen::Vector3d::Zero();
    if (element.as_table()->contains("position_cm") == element.as_table()->contains("position_m")) {
      reader.fail("poses", element, "a pose with either a position_cm or a position_m");
    }
    pose_reader.numbers("position_cm", position, centimetre, 3, "");
    pose_reader.numbers("position_m", position, 1, 3, "");
    pose_reader.numbers("rpy_deg", rpy, degree, 3, "");
    Eigen::VectorXd rotation(9);
    rotation << rotation_from_rpy(rpy).transpose().reshaped();
    pose_reader.numbers("rotation", rotation, 1, 9, "");
    pose_reader.refuse_unknown_keys();
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation.data());
    if (!pose.linear().isUnitary(1e-9) || pose.linear().determinant() < 0) {
      pose_reader.fail("rotation", element, "a rotation matrix, row by row");
    }
    pose.translation() = position;
    poses.push_back(pose);
  }
  return poses;
}

Path read_path(Reader reader) {
  Path path;
  reader.choice("kind", path, path_kinds, "");
  std::visit(
      [&](auto& kind) {
        if constexpr (requires { list_fields(reader, kind); }) {
          list_fields(reader, kind);
        } else {
          kind = read_poses(reader);
        }
      },
      path);
  reader.refuse_unknown_keys();
  return path;
}

Entrant read_entrant(Reader reader) {
  Entrant entrant;
  reader.text("solver", entrant.solver, "");
  entrant.label = entrant.solver;
  reader.text("label", entrant.label, "");
  const toml::node* name = reader.find("solver");
  if (name == nullptr) {
    throw std::invalid_argument(reader.where(reader.table().source(), "solver") +
                                "an entry of [[solvers]] has no `solver`; see: ikbench list solvers");
  }
  SolverInfo info;
  try {
    info = solver(entrant.solver);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(reader.where(name->source(), "solver") + error.what());
  }
  if (entrant.label.empty()) reader.fail("label", *reader.find("label"), "a label that is not empty");
  reader.find("population");
  reader.nested(reader.table(), entrant.label + ".").whole("population", entrant.population, populations, "");
  if (const toml::table* options = as_table(reader, "options")) {
    const Reader option_reader = reader.nested(*options, entrant.label + ".");
    for (const auto& [key, node] : *options) {
      const std::string option(key.str());
      if (const auto text = node.value<std::string>()) {
        if (!Reader::is_plain(*text)) option_reader.fail(option, node, plain);
        entrant.options[option] = *text;
      } else if (node.is_integer()) {
        entrant.options[option] = fmt::format("{}", *node.value<std::int64_t>());
      } else if (node.is_floating_point()) {
        entrant.options[option] = fmt::format("{}", *node.value<double>());
      } else {
        option_reader.fail(option, node, "a number or a text in quotes");
      }
      try {
        info.options({{option, entrant.options[option]}});
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(option_reader.where(node.source(), option) + error.what());
      }
    }
  }
  reader.refuse_unknown_keys();
  return entrant;
}

std::vector<Entrant> read_entrants(Reader& reader) {
  const toml::node* node = reader.find("solvers");
  const toml::array* array = node == nullptr ? nullptr : node->as_array();
  const std::string expected = "at least one [[solvers]] entry with solver = \"...\"";
  if (node == nullptr)
    throw std::invalid_argument(reader.where(reader.table().source(), "solvers") +
                                "the study names no solver; expected " + expected);
  if (array == nullptr || array->empty() || array->size() > 1000 || !array->is_homogeneous<toml::table>()) {
    reader.fail("solvers", *node, expected);
  }
  std::vector<Entrant> entrants;
  std::set<std::string> labels;
  for (const toml::node& element : *array) {
    entrants.push_back(read_entrant(reader.nested(*element.as_table(), "solvers.")));
    if (!labels.insert(entrants.back().label).second) {
      throw std::invalid_argument(
          fmt::format("{}label \"{}\" stands twice; expected one that no other entry of [[solvers]] has",
                      reader.where(element.source(), "solvers"), entrants.back().label));
    }
  }
  return entrants;
}

// `study`: its path, runs and solvers, which the plan is about.
AnalysisPlan read_analysis(Reader reader, const Study& study, PointsAsObservations points_as_observations) {
  AnalysisPlan plan;
  list_fields(reader, plan);
  reader.refuse_unknown_keys();
  std::vector<std::string> labels;
  for (const Entrant& entrant : study.solvers) labels.push_back(entrant.label);
  if (!plan.control.empty() && std::find(labels.begin(), labels.end(), plan.control) == labels.end()) {
    reader.fail("control", *reader.find("control"),
                fmt::format("\"\" or the label of a solver of the study: \"{}\"", fmt::join(labels, "\", \"")));
  }
  if (const std::string reason = why_no_blocks(study); plan.test == DecidingTest::friedman && !reason.empty()) {
    reader.fail(
        "test", *reader.find("test"),
        fmt::format("another test: Friedman's compares the solvers within targets that are the same for all, and {}; "
                    "start = \"initial\" or path.kind = \"random\" with several would give them",
                    reason));
  }
  if (plan.unit == Unit::point && points_as_observations == PointsAsObservations::refused) {
    reader.fail("unit", *reader.find("unit"), fmt::format("\"run\": {}", why_points_are_refused));
  }
  return plan;
}

Study read_study(const toml::table& table, std::string_view source, PointsAsObservations points_as_observations) {
  Reader reader(table, source, "");
  Study study;
  list_fields(reader, study);
  if (study.name.empty()) reader.fail("name", *table.get("name"), "a name that is not empty");
  if (const toml::table* path = as_table(reader, "path")) study.path = read_path(reader.nested(*path, "path."));
  if (const toml::table* stop = as_table(reader, "stop")) {
    Reader stop_reader = reader.nested(*stop, "stop.");
    list_fields(stop_reader, study.stop);
    stop_reader.refuse_unknown_keys();
  }
  study.solvers = read_entrants(reader);
  if (const toml::table* analysis = as_table(reader, "analysis")) {
    study.analysis = read_analysis(reader.nested(*analysis, "analysis."), study, points_as_observations);
  }
  reader.refuse_unknown_keys();

  // What fields ask of each other.
  const auto at_node = [&](const toml::node* node, std::string_view key, std::string_view message) {
    return std::invalid_argument(reader.where(node == nullptr ? table.source() : node->source(), key) +
                                 std::string(message));
  };
  const auto at = [&](std::string_view key, std::string_view message) { return at_node(table.get(key), key, message); };
  const auto papers = published::papers();
  if (!study.published.empty() && std::find(papers.begin(), papers.end(), study.published) == papers.end()) {
    throw at("published", unknown_name("paper", study.published, {papers.begin(), papers.end()}));
  }
  const Robot arm = [&] {
    try {
      return robot(study.robot);
    } catch (const std::invalid_argument& error) {
      throw at("robot", error.what());
    }
  }();
  if (study.initial.size() == 0) study.initial = Eigen::VectorXd::Zero(arm.joints());
  if (study.initial.size() != arm.joints()) {
    throw at("initial_deg", fmt::format("initial_deg has {} angles; expected {}, the joints of {}",
                                        study.initial.size(), arm.joints(), arm.name));
  }
  constexpr double most_solves = 1e8;
  if (static_cast<double>(study.solvers.size()) * study.runs * points(study.path) > most_solves) {
    throw at("runs", "solvers, runs and points make more than 100 000 000 solves; expected fewer");
  }
  if (study.trace == Trace::best_error && study.stop.iterations > 1'000'000) {
    throw at("trace", "a trace of more than 1 000 000 iterations was asked for; expected stop.iterations below that");
  }
  const bool is_enforced = study.limits == Limits::enforced;
  constexpr std::string_view not_enforced =
      "bounds is \"initial\", but limits is \"enforced\"; expected bounds that keep candidates inside";
  if (is_enforced && study.bounds == StudyBounds::initial) throw at("bounds", not_enforced);
  for (std::size_t i = 0; i < study.solvers.size(); ++i) {
    const Entrant& entrant = study.solvers[i];
    const auto own = table["solvers"][i];
    const int population = effective_population(study, entrant);
    if (const int least = solver(entrant.solver).least_population; population < least) {
      const std::string message =
          fmt::format("population is {}, but {} needs at least {}", population, entrant.solver, least);
      throw entrant.population > 0 ? at_node(own["population"].node(), entrant.label + ".population", message)
                                   : at("population", message);
    }
    const auto bounds = entrant.options.find("bounds");
    if (is_enforced && bounds != entrant.options.end() && bounds->second == "initial") {
      throw at_node(own["options"]["bounds"].node(), entrant.label + ".bounds", not_enforced);
    }
  }
  if (const double outside = arm.limits.violation(study.initial) / degree; is_enforced && outside > 0) {
    throw at("initial_deg",
             fmt::format("initial_deg is {:g} deg outside the limits of a joint, but limits is \"enforced\"; see: "
                         "ikbench list robots {}",
                         outside, arm.name));
  }
  if (study.search == Search::wrist && (arm.chain() == nullptr || !SphericalWrist::fits(*arm.chain()))) {
    throw at("search",
             fmt::format("search is \"wrist\", but {} has no spherical wrist; expected \"all_joints\"", arm.name));
  }
  return study;
}

}  // namespace

Study parse_study(std::string_view toml_text, std::string_view source, const Overrides& overrides,
                  PointsAsObservations points_as_observations) {
  toml::table table = parse_toml(toml_text, source);
  for (const std::string& text : overrides) override_one(table, text);
  return read_study(table, source, points_as_observations);
}

std::vector<Study> studies() {
  std::vector<Study> all;
  for (const auto& [name, toml] : built_in_studies()) all.push_back(parse_study(toml, "built-in study " + name));
  return all;
}

Study load_study(const std::string& name_or_file, const Overrides& overrides,
                 PointsAsObservations points_as_observations) {
  std::vector<std::string> names;
  for (const auto& [name, toml] : built_in_studies()) {
    if (name == name_or_file) return parse_study(toml, "built-in study " + name, overrides, points_as_observations);
    names.push_back(name);
  }
  std::error_code error;
  const std::filesystem::path file = name_or_file;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw std::invalid_argument("no such file, and " + unknown_name("built-in study", name_or_file, names));
  }
  if (std::filesystem::file_size(file, error) > largest_file) {
    throw std::invalid_argument(fmt::format("{}: expected a study file of at most 10 MB", name_or_file));
  }
  std::ifstream in(file, std::ios::binary);
  std::ostringstream content;
  content << in.rdbuf();
  if (!in) throw std::invalid_argument(fmt::format("{}: cannot be read", name_or_file));
  return parse_study(content.str(), name_or_file, overrides, points_as_observations);
}

}  // namespace ikbench::experiments
