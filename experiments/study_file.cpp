#include "experiments/study_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <sstream>
#include <stdexcept>

#include "results/number.hpp"
#include "results/published.hpp"
#include "robots/names.hpp"
#include "robots/spherical_wrist.hpp"
#include "solvers/registry.hpp"

namespace ikbench {

namespace {

constexpr double centimetre = 0.01;
constexpr double degree = std::numbers::pi / 180;
constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();
constexpr std::uintmax_t largest_file = 10'000'000;

template <class Enum>
using Choices = std::vector<std::pair<std::string, Enum>>;

// ---- the fields of a study, said once; read and written by the three classes below --------------------------------

template <class Io>
void list_fields(Io& io, StopRule& stop) {
  io.whole("iterations", stop.iterations, {0, 1'000'000'000}, "iterations at most");
  io.number("tolerance_cm", stop.tolerance, centimetre, {0, 1e6}, "position error at which a solve ends; 0: none");
  io.whole("evaluations", stop.evaluations, {0, no_limit}, "evaluations after which a solve ends; 0: no such rule");
  io.number("seconds", stop.seconds, 1, {0, 1e6},
            "wall time after which a solve ends, and numbers depend on the machine; 0: no such rule");
}

template <class Io>
void list_circle_fields(Io& io, Helix& helix) {
  io.numbers("centre_cm", helix.centre, centimetre, 3, "centre of the bottom");
  io.number("radius_cm", helix.radius, centimetre, {0, 1e6}, "");
  io.number("start_deg", helix.start, degree, {-1e5, 1e5}, "angle t of the first point");
  io.whole("points", helix.points, {1, 100'000}, "");
  io.choice("phase", helix.phase, Choices<Phase>{{"sin_cos", Phase::sin_cos}, {"cos_sin", Phase::cos_sin}},
            "(x, y) from the centre: radius (sin t, cos t), or radius (cos t, sin t)");
  io.choice("spacing", helix.spacing,
            Choices<Spacing>{{"k_over_n", Spacing::k_over_n}, {"k_over_n_minus_1", Spacing::k_over_n_minus_1}},
            "point k = 0 ... n - 1 lies at this fraction of the path");
  io.choice("tool", helix.tool, Choices<Tool>{{"down", Tool::down}, {"eq27", Tool::eq27}},
            "how the tool is held: straight down, or as Eq. 27 prints it (horizontal)");
}

template <class Io>
void list_helix_fields(Io& io, Helix& helix) {
  io.number("length_cm", helix.length, centimetre, {-1e6, 1e6}, "rise along z");
  io.number("turns", helix.turns, 1, {-1e3, 1e3}, "");
  list_circle_fields(io, helix);
}

template <class Io>
void list_fields(Io& io, Study& study) {
  io.text("name", study.name, "folder of its results: out/<name>/");
  io.text("title", study.title, "");
  io.text("published", study.published, "paper whose printed tables are set beside the results; \"\": none");
  io.text("robot", study.robot, "see: ikbench list robots");
  io.choice("search", study.search, Choices<Search>{{"wrist", Search::wrist}, {"all_joints", Search::all_joints}},
            "wrist: the joints before a spherical wrist, which follows in closed form; all_joints: position only");
  io.choice(
      "bounds", study.bounds,
      Choices<StudyBounds>{
          {"per_solver", StudyBounds::per_solver}, {"initial", StudyBounds::initial}, {"clamp", StudyBounds::clamp}},
      "joint limits of candidates: each solver's own option, or one reading for all that have it");
  io.choice("wrist_branch", study.wrist_branch,
            Choices<WristBranch>{{"nearest", WristBranch::nearest},
                                 {"positive", WristBranch::positive},
                                 {"negative", WristBranch::negative},
                                 {"inside", WristBranch::inside}},
            "which of the wrist's two branches completes an answer");
  io.numbers("initial_deg", study.initial, degree, 0, "configuration before the first point of a run");
  io.whole("population", study.population, {1, 100'000}, "candidates an iteration");
  io.whole("runs", study.runs, {1, 1'000'000}, "independent repetitions");
  io.whole("seed", study.seed, {0, no_limit}, "");
  io.choice("trace", study.trace, Choices<Trace>{{"none", Trace::none}, {"best_error", Trace::best_error}},
            "best error after every iteration, kept in the store");
}

// ---- writing ------------------------------------------------------------------------------------------------------

// The number x for which x * unit is `value` again, bit for bit, where there is one near.
double in_unit(double value, double unit) {
  const double guess = value / unit;
  for (const double x :
       {std::round(guess * 1e9) / 1e9, guess, std::nextafter(guess, 0), std::nextafter(guess, 2 * guess)}) {
    if (x * unit == value) return x;
  }
  return guess;
}

std::vector<double> in_unit(const Eigen::VectorXd& values, double unit) {
  std::vector<double> result;
  for (const double value : values) result.push_back(in_unit(value, unit));
  return result;
}

bool is_exact(const Eigen::VectorXd& values, double unit) {
  return std::all_of(values.begin(), values.end(), [&](double value) { return in_unit(value, unit) * unit == value; });
}

// "-0" would be read as the integer 0.
std::string numeral(double value) { return value == 0 && std::signbit(value) ? "-0.0" : fmt::format("{}", value); }

std::string numerals(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(numeral(value));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

template <class Enum>
const std::string& name_in(const Choices<Enum>& choices, Enum value) {
  return std::find_if(choices.begin(), choices.end(), [&](const auto& choice) { return choice.second == value; })
      ->first;
}

std::string toml_string(std::string_view text) {
  std::ostringstream out;
  out << toml::value<std::string>(text);
  return out.str();
}

class TomlWriter {
 public:
  void text(std::string_view key, const std::string& field, std::string_view meaning) {
    line(key, toml_string(field), meaning);
  }
  template <class Enum>
  void choice(std::string_view key, Enum field, const Choices<Enum>& choices, std::string_view meaning) {
    std::vector<std::string> names;
    for (const auto& choice : choices) names.push_back(choice.first);
    line(key, toml_string(name_in(choices, field)), fmt::format("{}: {}", fmt::join(names, " | "), meaning));
  }
  template <class Whole>
  void whole(std::string_view key, Whole field, std::pair<std::int64_t, std::int64_t>, std::string_view meaning) {
    line(key, fmt::format("{}", field), meaning);
  }
  void number(std::string_view key, double field, double unit, std::pair<double, double>, std::string_view meaning) {
    line(key, numeral(in_unit(field, unit)), meaning);
  }
  void numbers(std::string_view key, const Eigen::VectorXd& field, double unit, int, std::string_view meaning) {
    line(key, numerals(in_unit(field, unit)), meaning);
  }
  void line(std::string_view key, std::string_view value, std::string_view meaning) {
    out += meaning.empty() ? fmt::format("{} = {}\n", key, value) : fmt::format("{} = {}  # {}\n", key, value, meaning);
  }

  std::string out;
};

class JsonWriter {
 public:
  void text(const std::string& key, const std::string& field, std::string_view) { out[key] = field; }
  template <class Enum>
  void choice(const std::string& key, Enum field, const Choices<Enum>& choices, std::string_view) {
    out[key] = name_in(choices, field);
  }
  template <class Whole>
  void whole(const std::string& key, Whole field, std::pair<std::int64_t, std::int64_t>, std::string_view) {
    out[key] = field;
  }
  void number(const std::string& key, double field, double unit, std::pair<double, double>, std::string_view) {
    out[key] = in_unit(field, unit);
  }
  void numbers(const std::string& key, const Eigen::VectorXd& field, double unit, int, std::string_view) {
    out[key] = in_unit(field, unit);
  }

  nlohmann::ordered_json out;
};

std::vector<double> by_rows(const Eigen::Matrix3d& R) {
  std::vector<double> elements;
  for (int row = 0; row < 3; ++row) elements.insert(elements.end(), {R(row, 0), R(row, 1), R(row, 2)});
  return elements;
}

// ---- reading ------------------------------------------------------------------------------------------------------

std::string shown(const toml::node& node) {
  std::ostringstream out;
  out << toml::toml_formatter(node, toml::format_flags::none);
  std::string text = out.str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.size() <= 80 ? text : text.substr(0, 77) + "...";
}

constexpr std::string_view override_source = "--set";  // the `path` of nodes that come from there; others have none
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
  enum class Kind { helix, circle, poses };
  Kind kind = Kind::helix;
  reader.choice("kind", kind, {{"helix", Kind::helix}, {"circle", Kind::circle}, {"poses", Kind::poses}}, "");
  Path path;
  if (kind == Kind::poses) {
    path = read_poses(reader);
  } else if (kind == Kind::circle) {
    Helix circle{.length = 0, .turns = 1};
    list_circle_fields(reader, circle);
    path = circle;
  } else {
    Helix helix;
    list_helix_fields(reader, helix);
    path = helix;
  }
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

Study read_study(const toml::table& table, std::string_view source) {
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
  reader.refuse_unknown_keys();

  // What fields ask of each other.
  const auto at = [&](std::string_view key, std::string_view message) {
    const toml::node* node = table.get(key);
    return std::invalid_argument(reader.where(node == nullptr ? table.source() : node->source(), key) +
                                 std::string(message));
  };
  const auto papers = published::papers();
  if (!study.published.empty() && std::find(papers.begin(), papers.end(), study.published) == papers.end()) {
    throw at("published", unknown_name("paper", study.published, {papers.begin(), papers.end()}));
  }
  std::vector<std::string> robot_names;
  for (const Robot& known : robots()) robot_names.push_back(known.name);
  if (std::find(robot_names.begin(), robot_names.end(), study.robot) == robot_names.end()) {
    throw at("robot", unknown_name("robot", study.robot, robot_names));
  }
  const Robot arm = robot(study.robot);
  if (study.initial.size() == 0) study.initial = Eigen::VectorXd::Zero(arm.chain.joints());
  if (study.initial.size() != arm.chain.joints()) {
    throw at("initial_deg", fmt::format("initial_deg has {} angles; expected {}, the joints of {}",
                                        study.initial.size(), arm.chain.joints(), arm.name));
  }
  constexpr double most_solves = 1e8;
  if (static_cast<double>(study.solvers.size()) * study.runs * static_cast<double>(targets(study.path).size()) >
      most_solves) {
    throw at("runs", "solvers, runs and points make more than 100 000 000 solves; expected fewer");
  }
  if (study.trace == Trace::best_error && study.stop.iterations > 1'000'000) {
    throw at("trace", "a trace of more than 1 000 000 iterations was asked for; expected stop.iterations below that");
  }
  for (const Entrant& entrant : study.solvers) {
    if (const int least = solver(entrant.solver).least_population; study.population < least) {
      throw at("population",
               fmt::format("population is {}, but {} needs at least {}", study.population, entrant.solver, least));
    }
  }
  if (study.search == Search::wrist && !SphericalWrist::fits(arm.chain)) {
    throw at("search",
             fmt::format("search is \"wrist\", but {} has no spherical wrist; expected \"all_joints\"", arm.name));
  }
  return study;
}

// ---- text to table ------------------------------------------------------------------------------------------------

// A key such as a.a.a.a is a table in a table in a table; toml++ bounds the depth of brackets, not of these, and a
// hundred thousand of them exhaust the stack.
void refuse_deep_keys(std::string_view text, std::string_view source) {
  constexpr int most_dots = 500;
  int line = 1, column = 0, dots = 0;
  for (const char c : text) {
    ++column;
    if (c == '\n' || c == ',') dots = 0;
    if (c == '.' && ++dots > most_dots) {
      throw std::invalid_argument(
          fmt::format("{}:{}:{}: not TOML that can be read: {} dots in a row; expected keys nested less deeply", source,
                      line, column, dots));
    }
    if (c == '\n') {
      ++line;
      column = 0;
    }
  }
}

// ---- overrides ----------------------------------------------------------------------------------------------------

// The text as a TOML value, or else as a string: both `runs=5` and `path.tool=eq27` are what people type.
void insert(toml::table& table, std::string_view key, const std::string& text) {
  refuse_deep_keys(text, "--set");
  try {
    toml::table parsed = toml::parse(std::string_view("value = " + text), override_source);
    if (parsed.size() == 1) {
      parsed.get("value")->visit([&](auto& value) { table.insert_or_assign(key, std::move(value)); });
      return;
    }
  } catch (const toml::parse_error&) {
  }
  table.insert_or_assign(key, text);
}

toml::table& subtable(toml::table& table, std::string_view key) {
  if (!table.contains(key)) table.insert(key, toml::table{});
  toml::table* found = table.get(key)->as_table();
  if (found == nullptr) throw std::invalid_argument(fmt::format("--set {}: {} of the study is not a table", key, key));
  return *found;
}

void override_one(toml::table& study, const std::string& text) {
  const std::size_t equals = text.find('=');
  constexpr std::size_t longest_key = 300;
  if (equals == std::string::npos || equals == 0 || equals > longest_key) {
    throw std::invalid_argument(
        fmt::format("--set {}: expected key=value, such as runs=5 or ik_bat.bounds=clamp", text.substr(0, 100)));
  }
  const std::string key = text.substr(0, equals), value = text.substr(equals + 1);
  const std::size_t dot = key.rfind('.');
  if (dot == std::string::npos) {
    insert(study, key, value);
    return;
  }
  const std::string owner = key.substr(0, dot), field = key.substr(dot + 1);
  if (owner.empty() || field.empty()) {
    throw std::invalid_argument(fmt::format("--set {}: expected a name on both sides of the dot", text.substr(0, 100)));
  }
  if (owner == "path" || owner == "stop") {
    insert(subtable(study, owner), field, value);
    return;
  }
  std::vector<std::string> owners{"path", "stop"};
  bool found = false;
  if (toml::array* entrants = study["solvers"].as_array()) {
    for (toml::node& element : *entrants) {
      toml::table* entrant = element.as_table();
      if (entrant == nullptr) continue;
      const std::string label = (*entrant)["label"].value_or(std::string());
      const std::string name = (*entrant)["solver"].value_or(std::string());
      if (owner == label || owner == name) {
        insert(subtable(*entrant, "options"), field, value);
        found = true;
      }
      for (const std::string& known : {label, name}) {
        if (!known.empty() && std::find(owners.begin(), owners.end(), known) == owners.end()) owners.push_back(known);
      }
    }
  }
  if (!found) throw std::invalid_argument(fmt::format("--set {}: {}", key, unknown_name("solver", owner, owners)));
}

}  // namespace

Study parse_study(std::string_view toml_text, std::string_view source, const Overrides& overrides) {
  refuse_deep_keys(toml_text, source);
  toml::table table;
  try {
    table = toml::parse(toml_text);
  } catch (const toml::parse_error& error) {
    const toml::source_position& begin = error.source().begin;
    throw std::invalid_argument(
        fmt::format("{}:{}:{}: not TOML: {}", source, begin.line, begin.column, error.description()));
  }
  for (const std::string& text : overrides) override_one(table, text);
  return read_study(table, source);
}

Study load_study(const std::string& name_or_file, const Overrides& overrides) {
  std::vector<std::string> names;
  for (const Study& study : studies()) {
    if (study.name == name_or_file) {
      return parse_study(to_toml(study), "built-in study " + name_or_file, overrides);
    }
    names.push_back(study.name);
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
  return parse_study(content.str(), name_or_file, overrides);
}

std::string to_toml(const Study& study) {
  Study fields = study;  // list_fields serves readers too
  TomlWriter writer;
  list_fields(writer, fields);
  writer.out += "\n[stop]\n";
  list_fields(writer, fields.stop);
  writer.out += "\n[path]\n";
  if (auto* helix = std::get_if<Helix>(&fields.path)) {
    writer.line("kind", "\"helix\"", "helix | circle | poses: a list of { position_cm = [...], rpy_deg = [...] }");
    list_helix_fields(writer, *helix);
  } else {
    writer.out += "kind = \"poses\"\nposes = [\n";
    for (const Pose& pose : std::get<std::vector<Pose>>(fields.path)) {
      const Eigen::VectorXd position = pose.translation();
      const bool in_cm = is_exact(position, centimetre);
      writer.out += fmt::format("  {{ {} = {}, rotation = {} }},\n", in_cm ? "position_cm" : "position_m",
                                numerals(in_unit(position, in_cm ? centimetre : 1)), numerals(by_rows(pose.linear())));
    }
    writer.out += "]\n";
  }
  for (const Entrant& entrant : study.solvers) {
    writer.out += "\n[[solvers]]\n";
    writer.line("label", toml_string(entrant.label), "");
    writer.line("solver", toml_string(entrant.solver),
                "options and their ranges: ikbench list solvers " + entrant.solver);
    std::vector<std::string> options;
    for (const auto& [name, value] : entrant.options)
      options.push_back(name + " = " + (number_from(value) ? value : toml_string(value)));
    if (!options.empty()) writer.line("options", fmt::format("{{ {} }}", fmt::join(options, ", ")), "");
  }
  return writer.out;
}

namespace {

nlohmann::ordered_json definition(const Study& study) {
  Study fields = study;
  JsonWriter writer, stop, path;
  list_fields(writer, fields);
  list_fields(stop, fields.stop);
  writer.out["stop"] = stop.out;
  if (auto* helix = std::get_if<Helix>(&fields.path)) {
    path.out["kind"] = "helix";
    list_helix_fields(path, *helix);
  } else {
    path.out["kind"] = "poses";
  }
  writer.out["path"] = path.out;
  return writer.out;
}

// The settings in which a study differs from the built-in one that claims to be of the same paper. A name, a title, a
// seed and a trace make no difference to that claim; further solvers neither.
std::vector<std::string> departures(const Study& study) {
  const std::vector<Study> known = studies();
  const auto original = std::find_if(known.begin(), known.end(), [&](const Study& candidate) {
    return !study.published.empty() && candidate.published == study.published;
  });
  std::vector<std::string> found;
  if (original == known.end()) return found;
  const auto ours = definition(study).flatten(), theirs = definition(*original).flatten();
  for (const auto& [pointer, value] : theirs.items()) {
    const bool is_free = pointer == "/name" || pointer == "/title" || pointer == "/seed" || pointer == "/trace";
    if (is_free || (ours.contains(pointer) && ours[pointer] == value)) continue;
    std::string key = pointer.substr(1);
    std::replace(key.begin(), key.end(), '/', '.');
    found.push_back(key);
  }
  for (const Entrant& entrant : original->solvers) {
    const auto same = std::find_if(study.solvers.begin(), study.solvers.end(),
                                   [&](const Entrant& ours_too) { return ours_too.label == entrant.label; });
    if (same == study.solvers.end()) {
      found.push_back("no " + entrant.label);
    } else if (same->solver != entrant.solver ||
               effective_options(study, *same) != effective_options(*original, entrant)) {
      found.push_back("options of " + entrant.label);
    }
  }
  return found;
}

}  // namespace

std::string to_json(const Study& study) {
  nlohmann::ordered_json json = definition(study);
  json["points"] = targets(study.path).size();
  json["departures"] = departures(study);
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace ikbench
