#include "experiments/foreign/protocol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "numerics/json.hpp"
#include "numerics/names.hpp"
#include "numerics/number.hpp"
#include "numerics/toml_table.hpp"
#include "solvers/bounds.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_options = 200, most_choices = 100;
constexpr std::size_t longest_urdf = 900'000;  // bytes; a longer one is left out
constexpr double largest_count = 1e15;
// The keys of an entry of [[solvers]]. Options stand beside them, so that no option may have such a name.
constexpr std::array<std::string_view, 9> keys_of_entries{"solver",     "label",      "process", "files",     "mode",
                                                          "patience_s", "population", "options", "if_missing"};

std::string line_of(const Json& json) { return numerics::text_of(json) + '\n'; }

Json numbers(const Eigen::VectorXd& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(value);  // values that are not finite are dumped as null
  return list;
}

template <class Matrix>
Json row_by_row(const Matrix& matrix) {
  Json list = Json::array();
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) list.push_back(matrix(row, column));
  }
  return list;
}

// The frame as x, y, z, roll, pitch, yaw.
Json frame(const Frame& frame) {
  Json list = numbers(frame.position);
  for (const double angle : frame.rpy) list.push_back(angle);
  return list;
}

// A text that is safe in tables and file names.
std::string text_at(const Json& object, const char* key, std::string_view fallback) {
  const auto found = object.find(key);
  if (found == object.end()) return std::string(fallback);
  if (!found->is_string() || !TomlReader::is_plain(found->get<std::string>()))
    throw Breach(fmt::format("its {} is not {}", key, TomlReader::plain));
  return found->get<std::string>();
}

double number_at(const Json& object, const char* key, double fallback) {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return fallback;
  if (!found->is_number()) throw Breach(fmt::format("its {} is not a number", key));
  return found->get<double>();
}

std::int64_t count_at(const Json& object, const char* key) {
  if (!object.contains(key)) return -1;
  const double number = number_at(object, key, 0);
  if (!(number >= 0 && number <= largest_count) || number != std::floor(number))
    throw Breach(fmt::format("its {} is not a count", key));
  return static_cast<std::int64_t>(number);
}

double as_number(const Json& element) {
  if (element.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (!element.is_number()) throw Breach("a joint's value is not a number");
  return element.get<double>();
}

// Reads one number per joint; a single joint may be a plain number.
Eigen::VectorXd configuration_in(const Json& value, int joints) {
  const bool is_single = joints == 1 && !value.is_array();
  if (!is_single && (!value.is_array() || value.size() != static_cast<std::size_t>(joints)))
    throw Breach(fmt::format("a configuration does not have {} numbers", joints));
  Eigen::VectorXd q(joints);
  if (is_single) q[0] = as_number(value);
  for (int j = 0; !is_single && j < joints; ++j) q[j] = as_number(value[static_cast<std::size_t>(j)]);
  return q;
}

HelloOption option_in(const Json& object) {
  if (!object.is_object()) throw Breach("one of its options is not an object");
  HelloOption option{.name = text_at(object, "name", ""), .meaning = text_at(object, "meaning", ""), .choices = {}};
  if (option.name.empty()) throw Breach("one of its options has no name");
  if (std::ranges::find(keys_of_entries, option.name) != keys_of_entries.end())
    throw Breach(fmt::format("its option {} has the name of a key of [[solvers]]; expected another name", option.name));
  const std::string type = text_at(object, "type", "number");
  const auto wrong = [&](std::string_view what) {
    return Breach(fmt::format("its option {} has {}", option.name, what));
  };
  if (type == "choice" || type == "boolean") {
    option.type = HelloOption::Type::choice;
    const Json choices = type == "boolean" ? Json{"false", "true"} : object.value("choices", Json());
    if (!choices.is_array() || choices.empty() || choices.size() > most_choices) throw wrong("no list of choices");
    for (const Json& choice : choices) {
      if (!choice.is_string() || !TomlReader::is_plain(choice.get<std::string>()))
        throw wrong("a choice that is no text");
      option.choices.push_back(choice.get<std::string>());
    }
    Json preset = object.value("default", choices.front());
    if (preset.is_boolean()) preset = preset.get<bool>() ? "true" : "false";
    const auto place = std::ranges::find(option.choices, preset.is_string() ? preset.get<std::string>() : "");
    if (place == option.choices.end()) throw wrong("a default that is no choice");
    std::rotate(option.choices.begin(), place, place + 1);
    return option;
  }
  if (type != "number" && type != "integer")
    throw wrong("an unknown type; expected number, integer, choice or boolean");
  option.type = type == "integer" ? HelloOption::Type::integer : HelloOption::Type::number;
  const double widest = type == "integer" ? 1e9 : 1e300;
  option.low = number_at(object, "low", -widest);
  option.high = number_at(object, "high", widest);
  option.preset = number_at(object, "default", std::numeric_limits<double>::quiet_NaN());
  if (!(option.low >= -widest && option.high <= widest && option.low <= option.preset && option.preset <= option.high))
    throw wrong("no default between low and high");
  if (type == "integer" && option.preset != std::floor(option.preset)) throw wrong("a default that is no integer");
  return option;
}

// An OptionList and the values behind it.
class HelloOptions {
 public:
  explicit HelloOptions(const Hello& hello) {
    for (const HelloOption& option : hello.options) {
      if (option.type == HelloOption::Type::number) {
        list.number(option.name, numbers_.emplace_back(option.preset), {option.low, option.high}, option.meaning);
      } else if (option.type == HelloOption::Type::integer) {
        list.count(option.name, wholes_.emplace_back(static_cast<int>(option.preset)),
                   {static_cast<int>(std::ceil(option.low)), static_cast<int>(std::floor(option.high))},
                   option.meaning);
      } else {
        std::vector<std::pair<std::string, std::size_t>> choices;
        for (const std::string& choice : option.choices) choices.emplace_back(choice, choices.size());
        list.choice(option.name, chosen_.emplace_back(0), choices, option.meaning);
      }
    }
  }

  OptionList list;

 private:
  std::deque<double> numbers_;
  std::deque<int> wholes_;
  std::deque<std::size_t> chosen_;
};

StopReason reason_of(const std::string& name) {
  const auto* const found = std::ranges::find(stop_reason_names, name);
  return found == stop_reason_names.end() ? StopReason::finished
                                          : static_cast<StopReason>(found - stop_reason_names.begin());
}

}  // namespace

std::string_view name_of(Mode mode) { return mode == Mode::solve ? "solve" : "ask"; }

Settings options_of(const Hello& hello, const Settings& settings) {
  HelloOptions options(hello);
  options.list.set(settings);
  return options.list.values();
}

std::optional<Message> message_in(const std::string& line) {
  constexpr int deepest = 20;  // copies of deeper values would overflow the stack
  Json json = numerics::parsed_ordered_json(line, deepest);
  if (!json.is_object() || !json.contains("message") || !json["message"].is_string()) return std::nullopt;
  Message message{.name = json["message"].get<std::string>(), .json = std::move(json), .id = std::nullopt};
  if (const auto id = message.json.find("id"); id != message.json.end() && id->is_number()) {
    const auto number = id->get<double>();
    if (number >= 0 && number < 1e9 && number == std::floor(number)) message.id = static_cast<std::int64_t>(number);
  }
  return message;
}

Hello hello_in(const Message& message) {
  const Json& json = message.json;
  if (message.name != "hello") throw Breach(fmt::format("it says \"{}\" before hello", front(message.name, 40)));
  if (number_at(json, "ikbench", 0) != protocol_version)
    throw Breach(fmt::format("its hello lacks \"ikbench\": {}", protocol_version));
  Hello hello{.name = text_at(json, "name", ""), .version = text_at(json, "version", ""), .modes = {}, .options = {}};
  if (hello.name.empty()) throw Breach("its hello has no name");
  const Json modes = json.value("modes", Json::array({"solve"}));
  for (const Json& mode : modes.is_array() ? modes : Json::array({modes})) {
    for (const Mode known : {Mode::solve, Mode::ask}) {
      if (mode == name_of(known)) hello.modes.push_back(known);
    }
  }
  if (hello.modes.empty()) throw Breach("its modes have neither \"solve\" nor \"ask\"");
  const Json options = json.value("options", Json::array());
  if (options.is_object()) hello.options.push_back(option_in(options));  // some languages write a list of one so
  if (options.size() > most_options) throw Breach(fmt::format("it has more than {} options", most_options));
  for (const Json& option : options.is_array() ? options : Json::array()) hello.options.push_back(option_in(option));
  for (const HelloOption& option : hello.options) {
    if (std::ranges::count(hello.options, option.name, &HelloOption::name) > 1)
      throw Breach(fmt::format("it has the option {} twice", option.name));
  }
  const Json deterministic = json.value("deterministic", Json(false));
  hello.is_deterministic = deterministic == true || deterministic == 1;
  return hello;
}

std::string why_in(const Json& declined) {
  const auto why = declined.find("why");
  return std::string(why != declined.end() && why->is_string() ? front(why->get_ref<const std::string&>(), 200)
                                                               : "it does not say why");
}

Candidates candidates_in(const Message& ask, int joints) {
  const Json& json = ask.json;
  Json list = json.value("candidates", Json());
  if (list.is_number()) list = Json::array({list});
  if (!list.is_array() || list.empty()) throw Breach("its ask has no candidates");
  const bool is_flat = std::ranges::none_of(list, [](const Json& element) { return element.is_array(); });
  if (is_flat && joints > 1) list = Json::array({list});
  Candidates q(joints, static_cast<Eigen::Index>(list.size()));
  Eigen::Index i = 0;
  for (const Json& candidate : list) q.col(i++) = configuration_in(candidate, joints);
  return q;
}

Solved solved_in(const Message& message, int joints) {
  const Json& json = message.json;
  if (!json.contains("q")) throw Breach("its answer has no q");
  Solved solved{.q = configuration_in(json["q"], joints)};
  solved.error = number_at(json, "error", solved.error);
  solved.seconds = number_at(json, "seconds", solved.seconds);
  if (solved.seconds < 0) throw Breach("its seconds are negative");
  solved.evaluations = count_at(json, "evaluations");
  solved.iterations = count_at(json, "iterations");
  if (json.contains("reason")) solved.reason = reason_of(text_at(json, "reason", ""));
  return solved;
}

std::string robot_message(const ArmToSearch& arm, const Hello& hello, const Settings& options) {
  Json json{{"ikbench", protocol_version}, {"message", "robot"}, {"name", arm.name}};
  Json values = Json::object();
  for (const HelloOption& option : hello.options) {
    const std::string& text = options.at(option.name);
    const auto number = number_from(text);
    if (option.type == HelloOption::Type::choice || !number) {
      values[option.name] = text;
    } else if (option.type == HelloOption::Type::integer) {
      values[option.name] = static_cast<std::int64_t>(*number);
    } else {
      values[option.name] = *number;
    }
  }
  json["options"] = values;
  json["goal"] = arm.is_pose ? "pose" : "position";
  json["rotation_weight"] = arm.rotation_weight;
  for (std::size_t j = 0; j < arm.arm.links().size(); ++j) {
    const DhLink& link = arm.arm.links()[j];
    const auto index = static_cast<Eigen::Index>(j);
    const char* const type = link.joint == Joint::turns    ? "revolute"
                             : link.joint == Joint::slides ? "prismatic"
                                                           : "coupled";
    json["joints"].push_back({{"name", arm.joint_names.at(j)},
                              {"type", type},
                              {"theta", link.offset},
                              {"d", link.d},
                              {"a", link.a},
                              {"alpha", link.alpha},
                              {"lower", arm.limits.lower[index]},
                              {"upper", arm.limits.upper[index]}});
  }
  json["base_frame"] = frame(arm.arm.base());
  json["tool_frame"] = frame(arm.arm.tool());
  json["base"] = row_by_row(arm.arm.base().pose().matrix());
  json["tool"] = row_by_row(arm.arm.tool().pose().matrix());
  if (!arm.urdf.empty() && arm.urdf.size() <= longest_urdf) {
    json["urdf"] = arm.urdf;
    json["base_link"] = arm.base_link;
    json["tip_link"] = arm.tip_link;
  }
  return line_of(json);
}

std::string solve_message(Mode mode, const SolveRequest& asked) {
  const Problem& problem = asked.problem;
  const JointLimits limits = finite_limits(problem);
  Json target{{"position", numbers(asked.goal.target.translation())}};
  if (asked.goal.is_pose()) target["rotation"] = row_by_row(asked.goal.target.linear());
  return line_of({{"message", mode == Mode::solve ? "solve" : "start"},
                  {"id", asked.id},
                  {"target", target},
                  {"start", numbers(problem.start)},
                  {"lower", numbers(limits.lower)},
                  {"upper", numbers(limits.upper)},
                  {"tolerance", {{"position", asked.stop.tolerance}, {"rotation", asked.stop.angle_tolerance}}},
                  {"budget",
                   {{"iterations", asked.stop.iterations},
                    {"evaluations", asked.stop.evaluations},
                    {"seconds", asked.stop.seconds}}},
                  {"population", problem.population},
                  {"planned_iterations", problem.iterations},
                  {"seed", asked.seed}});
}

std::string tell_message(std::int64_t id, const Eigen::VectorXd& errors, double best, Over over) {
  return line_of(
      {{"message", "tell"}, {"id", id}, {"errors", numbers(errors)}, {"best", best}, {"over", over == Over::yes}});
}

std::string bye_message() { return line_of({{"message", "bye"}}); }

}  // namespace ikbench::experiments
