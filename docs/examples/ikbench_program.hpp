// What a C++ program has to say to ikbench (docs/reference/protocol.md), in C++17 and without a library:
//
//   auto prepare = [](const ikbench::Robot& robot) { return Library(robot.urdf); };         // once
//   auto solve = [](Library& library, ikbench::Problem& problem) { return library.ik(...); };  // joint values, or {}
//   int main() { ikbench::run("library", {}, prepare, solve, R"(["pose"])"); }
//
// It tells ikbench how long `solve` took. ikbench::Declined("why") says that an arm or a target cannot be solved.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace ikbench {

using Values = std::vector<double>;

struct Declined {
  std::string why;
};

// A value of a message. What is not there is null, which is a number that is not finite.
struct Json {
  double number = std::numeric_limits<double>::quiet_NaN();
  std::string text;
  std::vector<Json> list;
  std::map<std::string, Json> members;

  const Json& operator[](const std::string& key) const {
    static const Json null;
    const auto found = members.find(key);
    return found == members.end() ? null : found->second;
  }
  Values numbers() const {
    Values all;
    for (const Json& each : list) all.push_back(each.number);
    return all;
  }
  static Json read(const char*& at) {
    Json json;
    if (*at == '"') {
      json.text = read_text(at);
    } else if (*at == '{' || *at == '[') {
      const bool has_keys = *at++ == '{';
      while (*at != '}' && *at != ']') {
        const std::string key = has_keys ? read_text(at) : "";
        if (has_keys) ++at;  // :
        Json value = read(at);
        has_keys ? void(json.members[key] = std::move(value)) : json.list.push_back(std::move(value));
        if (*at == ',') ++at;
      }
      ++at;
    } else if (*at == 't' || *at == 'f' || *at == 'n') {
      if (*at != 'n') json.number = *at == 't';
      at += *at == 'f' ? 5 : 4;
    } else {
      char* end = nullptr;
      json.number = std::strtod(at, &end);
      at = end;
    }
    return json;
  }

 private:
  static std::string read_text(const char*& at) {
    std::string text;
    for (++at; *at != '"'; ++at) {
      if (*at != '\\') {
        text += *at;
        continue;
      }
      const std::string letters = "ntrbf", meanings = "\n\t\r\b\f";
      const std::size_t place = letters.find(*++at);
      text += place == letters.npos ? *at : meanings[place];
    }
    ++at;
    return text;
  }
};

struct Robot {
  Json message;  // `robot`, whole
  std::string urdf, base_link, tip_link;
  std::vector<std::string> names;  // of the joints
  double option(const std::string& name) const { return message["options"][name].number; }
};

struct Problem {
  Json message;                                  // `solve`, whole
  Values position, rotation;                     // of the target; 3, and of a pose 9, row by row
  Values start, lower, upper;                    // of the joints
  double near = 0, near_angle = 0, seconds = 0;  // tolerances, and the budget; 0: none
  std::mt19937 random;
  bool has_asked = false;

  // Their errors; nothing where the solve is over, so return.
  std::optional<Values> evaluate(const std::vector<Values>& candidates) {
    has_asked = true;
    std::ostringstream text;
    text << std::setprecision(17) << R"({"message":"evaluate","candidates":[)";
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      for (std::size_t j = 0; j < candidates[i].size(); ++j) text << (j ? "," : i ? ",[" : "[") << candidates[i][j];
      text << ']';
    }
    std::cout << text.str() << "]}" << std::endl;
    std::string line;
    if (!std::getline(std::cin, line)) std::exit(0);
    const char* at = line.c_str();
    const Json told = Json::read(at);
    if (told["over"].number == 1) return std::nullopt;
    return told["errors"].numbers();
  }
};

// Says hello and answers until the input ends. `options` and `goals` are JSON as in the message `hello`; empty: none,
// and all. An answer {} is the best candidate that was evaluated.
template <class Prepare, class Solve>
void run(const std::string& name, const std::string& options, Prepare prepare, Solve solve,
         const std::string& goals = {}) {
  std::cout << R"({"message":"hello","ikbench":2,"name":")" << name << '"' << (options.empty() ? "" : ",\"options\":")
            << options << (goals.empty() ? "" : ",\"goals\":") << goals << '}' << std::endl;
  std::unique_ptr<decltype(prepare(Robot()))> prepared;
  std::string why;  // the arm is declined
  const auto decline = [](const std::string& its) {
    std::cout << R"({"message":"declined","why":")" << its << "\"}" << std::endl;
  };
  for (std::string line; std::getline(std::cin, line);) {
    const char* at = line.c_str();
    Json told = Json::read(at);
    const bool is_robot = told["message"].text == "robot";
    try {
      if (is_robot) {
        Robot robot{told, told["urdf"].text, told["base_link"].text, told["tip_link"].text, {}};
        for (const Json& joint : told["joints"].list) robot.names.push_back(joint["name"].text);
        prepared = std::make_unique<decltype(prepare(Robot()))>(prepare(robot));
        continue;
      }
      if (!why.empty()) throw Declined{why};
      const Json &target = told["target"], &tolerance = told["tolerance"];
      Problem problem{told,
                      target["position"].numbers(),
                      target["rotation"].numbers(),
                      told["start"].numbers(),
                      told["lower"].numbers(),
                      told["upper"].numbers(),
                      tolerance["position"].number,
                      tolerance["rotation"].number,
                      told["budget"]["seconds"].number,
                      std::mt19937(static_cast<unsigned>(told["seed"].number))};
      const auto began = std::chrono::steady_clock::now();
      const std::clock_t processor = std::clock();  // who waits for the processor is not slow
      const Values q = solve(*prepared, problem);
      const double used = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
      std::cout << std::setprecision(17) << R"({"message":"solved")";
      if (!problem.has_asked) std::cout << ",\"seconds\":" << std::min(took.count(), used);
      for (std::size_t j = 0; j < q.size(); ++j) std::cout << (j ? "," : ",\"q\":[") << q[j];
      std::cout << (q.empty() ? "}" : "]}") << std::endl;
    } catch (const Declined& declined) {
      is_robot ? void(why = declined.why) : decline(declined.why);
    }
  }
}

}  // namespace ikbench
