#include "experiments/external/protocol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "base/json.hpp"
#include "base/names.hpp"
#include "results/export.hpp"
#include "robots/urdf.hpp"
#include "solvers/bounds.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace robots;
using namespace solvers;

namespace {

constexpr std::size_t max_options = 200;
constexpr const char* goal_names[]{"position", "axis", "pose"};  // as GoalKind
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::string line_of(const OrderedJson& json) { return base::text_of(json) + '\n'; }

OrderedJson numbers(const Eigen::VectorXd& values) {
  return std::vector<double>(values.begin(), values.end());  // values that are not finite are dumped as null
}

// Returns the type of a joint as the protocol has it.
const char* type_of(Joint joint) {
  switch (joint) {
    case Joint::turns:
      return "revolute";
    case Joint::slides:
      return "prismatic";
    case Joint::coupled:
      break;
  }
  return "coupled";
}

// Returns the number of a member; `fallback` if the object has none.
double number_in(const Json& object, const char* key, double fallback) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : fallback;
}

}  // namespace

bool Hello::solves(GoalKind goal) const {
  return std::ranges::find(goals, goal_names[static_cast<std::size_t>(goal)]) != goals.end();
}

Settings resolved_options(const Hello& hello, const Settings& settings) {
  OptionList list;  // a list of references
  std::deque<double> numbers;
  std::deque<int> wholes;
  std::deque<std::size_t> chosen;
  for (const OptionSpec& option : hello.options) {
    if (!option.choices.empty()) {
      std::vector<std::pair<std::string, std::size_t>> choices;
      for (const std::string& choice : option.choices) choices.emplace_back(choice, choices.size());
      list.choice(option.name, chosen.emplace_back(0), choices, option.meaning);
    } else if (option.is_whole) {
      list.count(option.name, wholes.emplace_back(static_cast<int>(option.preset)),
                 {static_cast<int>(option.low), static_cast<int>(option.high)}, option.meaning);
    } else {
      list.number(option.name, numbers.emplace_back(option.preset), {option.low, option.high}, option.meaning);
    }
  }
  list.set(settings);
  return list.values();
}

Message::Message(std::string line) : line_(std::move(line)), json_(std::make_shared<Json>(base::parsed_json(line_))) {
  read_name();
}

Message::Message(const Json& object) : json_(std::make_shared<Json>(object)) { read_name(); }

void Message::read_name() {
  if (!json_->is_object()) fail("a JSON object, with null for numbers that are not finite");
  name_ = text(*json_, "message");
  if (name_.empty()) fail("a \"message\"");
}

void Message::fail(const std::string& expected) const {
  const std::string line = line_.empty() ? base::text_of(*json_) : line_;
  throw ProcessFailure{ProcessFailure::Kind::protocol_error,
                       fmt::format("it wrote {}; expected {}", base::one_line(front(line, 200)), expected)};
}

// Returns a text that is safe in tables and file names; fails otherwise.
std::string Message::text(const Json& object, const char* key) const {
  const auto found = object.find(key);
  if (found == object.end()) return {};
  if (!found->is_string() || !is_plain(found->get<std::string>()))
    fail(fmt::format("\"{}\" to be {}", key, plain_text));
  return found->get<std::string>();
}

OptionSpec Message::option(const Json& object) const {
  if (!object.is_object()) fail("options that are objects");
  OptionSpec option{.name = text(object, "name"), .meaning = text(object, "meaning"), .choices = {}};
  for (const char* key : {"", "solver", "label", "process", "files", "memory_mb", "timeout_s", "batch", "population",
                          "options", "colour", "if_missing"}) {
    if (option.name == key) fail("options whose \"name\" is not a key of [[solvers]]");
  }
  if (const auto choices = object.find("choices"); choices != object.end()) {
    for (const Json& choice : *choices) {
      if (!choice.is_string() || !is_plain(choice.get<std::string>())) fail("choices that are texts");
      option.choices.push_back(choice.get<std::string>());
    }
    const auto preset = std::ranges::find(option.choices, text(object, "default"));
    if (preset == option.choices.end()) fail(fmt::format("a \"default\" of {} among its choices", option.name));
    std::rotate(option.choices.begin(), preset, preset + 1);
    return option;
  }
  option.is_whole = text(object, "type") == "integer";
  const double widest = option.is_whole ? 1e9 : 1e300;
  option.low = std::max(-widest, number_in(object, "low", -widest));
  option.high = std::min(widest, number_in(object, "high", widest));
  option.preset = number_in(object, "default", not_a_number);
  if (!(option.low <= option.preset && option.preset <= option.high))
    fail(fmt::format("a number as \"default\" of {}, from \"low\" to \"high\"", option.name));
  for (const double number : {option.low, option.high, option.preset}) {
    if (option.is_whole && number != std::floor(number))
      fail(fmt::format("whole numbers of the integer {}", option.name));
  }
  return option;
}

Hello Message::hello() const {
  if (name_ != "hello" || number_in(*json_, "ikbench", 0) != protocol_version)
    fail(fmt::format("{{\"message\":\"hello\",\"ikbench\":{},...}}", protocol_version));
  Hello hello{.name = text(*json_, "name"), .version = text(*json_, "version"), .options = {}, .goals = {}};
  if (hello.name.empty()) fail("a \"name\"");
  Json options = json_->value("options", Json::array());
  if (options.is_object()) options = Json::array({options});  // Octave writes a list of one so
  if (options.size() > max_options) fail(fmt::format("at most {} options", max_options));
  for (const Json& object : options) {
    hello.options.push_back(option(object));
    if (std::ranges::count(hello.options, hello.options.back().name, &OptionSpec::name) > 1)
      fail(fmt::format("the option {} once", hello.options.back().name));
  }
  for (const Json& goal : json_->value("goals", Json::array({"position", "axis", "pose"}))) {
    if (std::ranges::none_of(goal_names, [&](const char* name) { return goal == name; }))
      fail("\"goals\" of position, axis and pose");
    hello.goals.push_back(goal.get<std::string>());
  }
  if (hello.goals.empty()) fail("\"goals\" of position, axis and pose");
  hello.takes_batches = json_->value("batch", Json()) == Json(true);
  return hello;
}

std::string Message::decline_reason() const {
  const auto why = json_->find("why");  // a long reason is no mistake
  if (why == json_->end() || !why->is_string() || why->get_ref<const std::string&>().empty())
    return "it gives no reason";
  return std::string(front(base::one_line(why->get<std::string>()), 200));
}

std::string Message::rejection_reason() const {
  const Json valid = json_->value("valid", Json());
  std::string why = valid == false ? std::string(front(text(*json_, "why"), max_name_bytes)) : "";
  if (name_ != "checked" || (valid != true && trimmed(why).empty()))
    fail(R"({"message":"checked","valid":true}, or false and in a few words "why")");
  return why;
}

Configuration Message::configuration(const Json& list, int joints, const std::string& expected) const {
  if (!list.is_array() || list.size() != static_cast<std::size_t>(joints)) fail(expected);
  Configuration q(joints);
  for (int j = 0; j < joints; ++j) {
    const Json& value = list[static_cast<std::size_t>(j)];
    if (!value.is_number() && !value.is_null()) fail(expected);
    q[j] = value.is_null() ? not_a_number : value.get<double>();
  }
  return q;
}

Candidates Message::candidates(int joints, const char* key) const {
  const std::string expected = fmt::format("\"{}\", a list of lists of {}", key, counted(joints, "numbers"));
  Json list = json_->value(key, Json());
  if (!list.is_array() || list.empty()) fail(expected);
  if (!list.front().is_array()) list = Json::array({list});  // Octave writes a list of one so
  Candidates q(joints, static_cast<Eigen::Index>(list.size()));
  for (Eigen::Index i = 0; i < q.cols(); ++i)
    q.col(i) = configuration(list[static_cast<std::size_t>(i)], joints, expected);
  return q;
}

Configuration Message::joints(int joints) const {
  return configuration(json_->value("q", Json()), joints, "\"q\", a list of " + counted(joints, "numbers"));
}

std::map<std::string, double> Message::extras(const char* key) const {
  std::map<std::string, double> extras;
  const Json object = json_->value(key, Json());
  if (!(object.is_object() || object.is_null()) || object.size() > max_extras)
    fail(fmt::format("at most {} numbers by name as \"{}\"", max_extras, key));
  for (const auto& [name, value] : object.items()) {
    for (const std::string_view reserved : {results::refused_prefix, results::check_extra, results::invalid_extra}) {
      if (!is_plain(name) || trimmed(name).empty() || name.starts_with(reserved))
        fail(fmt::format("\"{}\" whose names are texts, not blank and not \"{}...\"", key, reserved));
    }
    if (!(value.is_number() || value.is_null())) fail(fmt::format("numbers by name as \"{}\"", key));
    extras[name] = value.is_null() ? not_a_number : value.get<double>();
  }
  return extras;
}

std::map<std::string, std::optional<Message>> Message::answers(const std::vector<SolveQuestion>& questions) const {
  const Json list = json_->value("answers", Json());
  if (!list.is_array() || list.size() != questions.size())
    fail(fmt::format("\"answers\", a list of {}", questions.size()));
  std::map<std::string, std::optional<Message>> by_question;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const auto& [text, seed] = questions[i];
    const Message answer(list[i]);
    const bool is_in_order = answer.has("seed") ? answer.number("seed") == seed : answer.name() == "declined";
    if (!is_in_order) answer.fail(fmt::format("\"seed\" {}, in the order of the problems", seed));
    by_question[text] = answer;
  }
  return by_question;
}

bool Message::is_of_second_solve() const { return json_->value("timed", Json()) == "second"; }

bool Message::differs_from_first() const { return json_->value("same", Json()) == false; }

bool Message::has(const char* key) const { return json_->contains(key); }

double Message::number(const char* key) const {
  const auto found = json_->find(key);
  if (found == json_->end() || found->is_null()) return not_a_number;
  if (!found->is_number()) fail(fmt::format("a number as \"{}\"", key));
  return found->get<double>();
}

std::int64_t Message::count(const char* key) const {
  if (!has(key)) return -1;
  const double value = number(key);
  if (!(value >= 0 && value <= 1e15)) fail(fmt::format("a count as \"{}\"", key));
  return static_cast<std::int64_t>(value);
}

std::string robot_message(const SolveSetup& setup) {
  const auto& [arm, searched, goal, urdf, hello, options] = setup;
  OrderedJson values = OrderedJson::object();
  OrderedJson joints = OrderedJson::array();
  for (const OptionSpec& option : hello.options) {
    const std::string text = text_of(options.at(option.name));
    values[option.name] = option.choices.empty() ? base::parsed_ordered_json(text) : OrderedJson(text);
  }
  const std::vector<std::string> names = joint_names(arm);
  for (const DhLink& link : searched.links()) {
    const auto index = static_cast<Eigen::Index>(joints.size());
    joints.push_back({{"name", names[joints.size()]},
                      {"type", type_of(link.joint)},
                      {"theta", link.offset},
                      {"d", link.d},
                      {"a", link.a},
                      {"alpha", link.alpha},
                      {"beta", link.beta},
                      {"lower", arm.limits.lower[index]},
                      {"upper", arm.limits.upper[index]}});
  }
  return line_of({{"message", "robot"},
                  {"name", arm.name},
                  {"options", values},
                  {"goal", goal_names[static_cast<std::size_t>(goal.kind)]},
                  {"rotation_weight", goal.rotation_weight},
                  {"joints", joints},
                  {"base_link", base_link_of(arm)},
                  {"base", numbers(searched.base().pose().matrix().transpose().reshaped())},
                  {"tip_link", tip_link_of(arm)},
                  {"tool", numbers(searched.tool().pose().matrix().transpose().reshaped())},
                  {"urdf", urdf.empty() ? urdf_of(arm, searched) : urdf}});
}

std::string solve_message(const Problem& problem, const Goal& goal, const StopRule& stop, std::uint32_t seed,
                          results::CacheState state) {
  const JointLimits limits = finite_limits(problem);
  OrderedJson target{{"position", numbers(goal.target.translation())}};
  if (goal.kind == GoalKind::pose) target["rotation"] = numbers(goal.target.linear().transpose().reshaped());
  if (goal.kind == GoalKind::axis) target["axis"] = numbers(goal.target.linear().col(2));
  OrderedJson message{
      {"message", "solve"},
      {"target", target},
      {"start", numbers(problem.start)},
      {"lower", numbers(limits.lower)},
      {"upper", numbers(limits.upper)},
      {"tolerance", {{"position", stop.tolerance}, {"rotation", stop.angle_tolerance}}},
      {"budget", {{"iterations", stop.iterations}, {"evaluations", stop.evaluations}, {"seconds", stop.seconds}}},
      {"population", problem.population},
      {"seed", seed}};
  if (state == results::CacheState::warm) message["state"] = "warm";
  return base::text_of(message);
}

std::string errors_message(const Eigen::VectorXd& errors, bool is_over) {
  std::string text = R"({"message":"errors","errors":[)";
  for (const double error : errors) text += (std::isfinite(error) ? base::text_of(error) : "null") + ',';
  text.back() = ']';  // replaces the last comma; at least one problem is there
  return text + fmt::format(",\"over\":{}}}\n", is_over);
}

}  // namespace ikbench::experiments
