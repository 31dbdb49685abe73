// What a C++ program has to say to ikbench (docs/reference/protocol.md), in C++17 and without a library:
//
//   auto prepare = [](const ikbench::Robot& robot) { return Library(robot.urdf); };         // once
//   auto solve = [](Library& library, ikbench::Problem& problem) { return library.ik(...); };  // joint values, or {}
//   int main() { ikbench::run("library", {}, prepare, solve, R"(["pose"])"); }
//
// It tells ikbench how long `solve` took and, as an extra, `setup_s`, how long `prepare` did, and turns angles that are
// outside their limits back by whole turns. ikbench::Declined("why") says that an arm or a target cannot be solved.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
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
  // Returns the value of a whole line. Throws std::runtime_error if the line is not JSON.
  static Json of(const std::string& line) {
    const char* at = line.c_str();
    return read(at);
  }

 private:
  static void expect(bool is_right) {
    if (!is_right) throw std::runtime_error("a line that is not JSON");
  }
  // Goes on to the next letter that is no space, and past it if it is `letter`.
  static bool take(const char*& at, char letter) {
    while (*at == ' ' || *at == '\t' || *at == '\r') ++at;
    return *at == letter && ++at;
  }
  static Json read(const char*& at) {
    Json json;
    if (take(at, '"')) {
      json.text = read_text(at);
    } else if (take(at, '[')) {
      for (bool is_end = take(at, ']'); !is_end; expect(is_end || take(at, ','))) {
        json.list.push_back(read(at));
        is_end = take(at, ']');
      }
    } else if (take(at, '{')) {
      for (bool is_end = take(at, '}'); !is_end; expect(is_end || take(at, ','))) {
        expect(take(at, '"'));
        const std::string key = read_text(at);
        expect(take(at, ':'));
        json.members[key] = read(at);
        is_end = take(at, '}');
      }
    } else if (const std::string word(at, std::strspn(at, "aeflnrstu")); !word.empty()) {
      expect(word == "true" || word == "false" || word == "null");
      at += word.size();
      if (word != "null") json.number = word == "true";
    } else {
      char* end = nullptr;
      json.number = std::strtod(at, &end);
      expect(end != at);
      at = end;
    }
    return json;
  }
  static std::string read_text(const char*& at) {
    std::string text;
    for (; *at != '"'; ++at) {
      expect(*at != 0);
      if (*at != '\\') {
        text += *at;
        continue;
      }
      const std::string letters = "ntrbf\"\\/", meanings = "\n\t\r\b\f\"\\/";
      const std::size_t place = letters.find(*++at);
      expect(*at != 0 && (place != letters.npos || (*at == 'u' && std::strspn(at + 1, "0123456789abcdefABCDEF") >= 4)));
      if (place == letters.npos) {  // ikbench writes control characters so, alone
        text += static_cast<char>(std::stoi(std::string(at + 1, 4), nullptr, 16));
        at += 4;
      } else {
        text += meanings[place];
      }
    }
    ++at;
    return text;
  }
};

inline std::string json_of(double value) {
  std::ostringstream text;
  std::isfinite(value) ? text << std::setprecision(17) << value : text << "null";
  return text.str();
}
inline std::string json_of(const Values& values) {
  std::string list;
  for (const double value : values) list += (list.empty() ? "" : ",") + json_of(value);
  return '[' + list + ']';
}
// In quotes, at most 200 characters, of ASCII; others become spaces.
inline std::string json_of(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text.substr(0, 200)) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c >= ' ' && c <= '~' ? c : ' ';
  }
  return quoted + '"';
}

// Writes a line to ikbench. What a library prints goes to the standard error from the first on.
inline void say(const std::string& line) {
  static std::FILE* const out = [] {
    std::FILE* const own = ::fdopen(::dup(1), "w");
    ::dup2(2, 1);
    return own;
  }();
  std::fputs((line + '\n').c_str(), out);
  std::fflush(out);
}

// Seconds since it was made, without those in which its thread waited for a processor that others had (Linux); no fewer
// than the process, its threads and child processes computed, and no more than passed.
class Timer {
 public:
  double wall() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count(); }
  double seconds() const {
    const double passed = wall();
    return std::min(passed, std::max(passed - (waits() - waited_), computes() - computed_));
  }

 private:
  static double waits() {
    double computed = 0, waited = 0;
    std::ifstream("/proc/thread-self/schedstat") >> computed >> waited;
    return 1e-9 * waited;
  }
  static double computes() {
    rusage children{};
    ::getrusage(RUSAGE_CHILDREN, &children);
    double seconds = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    for (const timeval& of : {children.ru_utime, children.ru_stime})
      seconds += static_cast<double>(of.tv_sec) + 1e-6 * static_cast<double>(of.tv_usec);
    return seconds;
  }
  const double waited_ = waits(), computed_ = computes();
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

struct Robot {
  Json message;  // `robot`, whole
  std::string urdf, base_link, tip_link;
  std::vector<std::string> names;  // of the joints
  std::vector<bool> turns;         // a joint that does not slide
  double option(const std::string& name) const { return message["options"][name].number; }
};

struct Problem {
  Json message;                                  // `solve`, whole
  Values position, rotation;                     // of the target; 3, and of a pose 9, row by row
  Values start, lower, upper;                    // of the joints
  double near = 0, near_angle = 0, seconds = 0;  // tolerances, and the budget; 0: none
  std::mt19937 random;
  bool has_asked = false;
  std::string extras = {};
  Timer timer = {};

  // Whether time is left of its budget; where there is none, always.
  bool is_left() const { return seconds <= 0 || timer.wall() < seconds || timer.seconds() < seconds; }
  // Random values inside the limits, where a library may begin again.
  Values another_start() {
    Values q(lower);
    for (std::size_t j = 0; j < q.size(); ++j) q[j] = std::uniform_real_distribution(lower[j], upper[j])(random);
    return q;
  }
  // Keeps a number of the solver's own beside the answer: extra("restarts", 3).
  void extra(const std::string& name, double value) {
    extras += (extras.empty() ? "" : ",") + json_of(name) + ':' + json_of(value);
  }

  // Their errors; nothing where the solve is over, so return.
  std::optional<Values> evaluate(const std::vector<Values>& candidates) {
    has_asked = true;
    std::string lists;
    for (const Values& q : candidates) lists += (lists.empty() ? "" : ",") + json_of(q);
    say(R"({"message":"evaluate","candidates":[)" + lists + "]}");
    std::string line;
    if (!std::getline(std::cin, line)) std::exit(0);
    const Json reply = Json::of(line);
    if (reply["over"].number == 1) return std::nullopt;
    return reply["errors"].numbers();
  }
};

// Turns angles that are outside the limits by whole turns to where they are nearest to the middle; what is 7e-7
// outside, by single precision or other digits of a limit, comes inside. Values too few or too many stay, for ikbench
// to tell.
inline Values inside(Values q, const std::vector<bool>& turns, const Values& lower, const Values& upper) {
  for (std::size_t j = 0; j < q.size() && q.size() == turns.size(); ++j) {
    const auto is_near = [&] { return lower[j] - 7e-7 <= q[j] && q[j] <= upper[j] + 7e-7; };
    const double middle = (lower[j] + upper[j]) / 2;
    if (turns[j] && !is_near()) q[j] = middle + std::remainder(q[j] - middle, 2 * std::acos(-1.0));
    if (is_near()) q[j] = std::clamp(q[j], lower[j], upper[j]);
  }
  return q;
}

// One solve, and the time that it took [s].
struct Solved {
  Problem problem;
  Values q;
  double seconds = 0;
};

// Solves once, with a problem of its own.
template <class Prepared, class Solve>
Solved solved(Prepared& prepared, Solve& solve, const Json& request) {
  const Json &target = request["target"], &tolerance = request["tolerance"];
  Problem problem{request,
                  target["position"].numbers(),
                  target["rotation"].numbers(),
                  request["start"].numbers(),
                  request["lower"].numbers(),
                  request["upper"].numbers(),
                  tolerance["position"].number,
                  tolerance["rotation"].number,
                  request["budget"]["seconds"].number,
                  std::mt19937(static_cast<unsigned>(request["seed"].number))};
  Values q = solve(prepared, problem);
  const double seconds = problem.timer.seconds();
  return {std::move(problem), std::move(q), seconds};
}

// Says hello and answers until the input ends. In the state "warm" it solves twice, and the second counts. `options`
// and `goals` are JSON as in the message `hello`; empty: none, and all. An answer {} is the best candidate that was
// evaluated, or the start where none was.
template <class Prepare, class Solve>
void run(const std::string& name, const std::string& options, Prepare prepare, Solve solve,
         const std::string& goals = {}) {
  say(R"({"message":"hello","ikbench":2,"name":)" + json_of(name) + (options.empty() ? "" : ",\"options\":" + options) +
      (goals.empty() ? "" : ",\"goals\":" + goals) + '}');
  std::unique_ptr<decltype(prepare(Robot()))> prepared;
  std::string why;  // there is none: the arm is declined
  double setup = 0;
  std::vector<bool> turns;
  for (std::string line; std::getline(std::cin, line);) {
    const Json request = Json::of(line);
    const bool is_robot = request["message"].text == "robot";
    try {
      if (is_robot) {
        prepared.reset();
        Robot robot{request, request["urdf"].text, request["base_link"].text, request["tip_link"].text, {}, {}};
        for (const Json& joint : request["joints"].list) {
          robot.names.push_back(joint["name"].text);
          robot.turns.push_back(joint["type"].text == "revolute");
        }
        turns = robot.turns;
        const Timer timer;
        prepared = std::make_unique<decltype(prepare(Robot()))>(prepare(robot));
        setup = timer.seconds();
        continue;
      }
      if (!prepared) throw Declined{why};
      Solved first = solved(*prepared, solve, request);
      std::optional<Solved> second;
      if (request["state"].text == "warm" && !first.problem.has_asked)
        second.emplace(solved(*prepared, solve, request));
      auto& [problem, answer, seconds] = second ? *second : first;
      const Values q = inside(answer, turns, problem.lower, problem.upper);
      std::string of_second;
      if (second && !problem.has_asked)
        of_second =
            std::string(R"(,"timed":"second","same":)") + (json_of(answer) == json_of(first.q) ? "true" : "false");
      if (!problem.has_asked) problem.extra("setup_s", setup);
      say(R"({"message":"solved","seed":)" + json_of(request["seed"].number) +
          (problem.has_asked ? "" : ",\"seconds\":" + json_of(seconds)) + of_second +
          (problem.extras.empty() ? "" : ",\"extras\":{" + problem.extras + '}') +
          (q.empty() && problem.has_asked ? "" : ",\"q\":" + json_of(q.empty() ? problem.start : q)) + '}');
    } catch (const Declined& declined) {
      why = declined.why;
      if (!is_robot) say(R"({"message":"declined","why":)" + json_of(why) + '}');
    }
  }
}

}  // namespace ikbench
