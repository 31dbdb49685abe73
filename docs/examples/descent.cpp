// Cyclic coordinate descent for ikbench in C++ with nlohmann/json; it solves with kinematics of its own.
// g++ -std=c++17 -O2 -I/usr/include/eigen3 -o descent descent.cpp
#include <Eigen/Geometry>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;
using Eigen::AngleAxisd, Eigen::Isometry3d, Eigen::Vector3d;

Isometry3d pose_of(const Json& numbers) {
  const auto m = numbers.get<std::vector<double>>();
  return Isometry3d(Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(m.data()).matrix());
}
// The frames before each joint, and that of the tool.
std::vector<Isometry3d> frames(const Json& arm, const std::vector<double>& q) {
  std::vector<Isometry3d> all{pose_of(arm["base"])};
  for (std::size_t j = 0; j < q.size(); ++j) {
    const Json& joint = arm["joints"][j];
    all.push_back(all.back() * AngleAxisd(joint["theta"].get<double>() + q[j], Vector3d::UnitZ()) *
                  Eigen::Translation3d(joint["a"], 0, joint["d"]) * AngleAxisd(joint["alpha"], Vector3d::UnitX()));
  }
  all.back() = all.back() * pose_of(arm["tool"]);
  return all;
}

Json solved(const Json& arm, const Json& problem) {
  const auto position = problem["target"]["position"].get<std::vector<double>>();
  const Vector3d target(position.data());
  auto q = problem["start"].get<std::vector<double>>();
  int iteration = 0;
  const auto error = [&] { return (frames(arm, q).back().translation() - target).norm(); };
  const auto end = Clock::now() + std::chrono::duration<double>(problem["budget"]["seconds"].get<double>());
  for (; iteration < problem["budget"]["iterations"] && error() > problem["tolerance"]["position"]; ++iteration) {
    if (problem["budget"]["seconds"] > 0 && Clock::now() >= end) break;
    for (std::size_t j = q.size(); j-- > 0;) {  // the turn about each axis that brings the tool nearest
      const auto all = frames(arm, q);
      const Vector3d axis = all[j].linear().col(2), tool = all.back().translation() - all[j].translation(),
                     goal = target - all[j].translation();
      const double turn = std::atan2(axis.dot(tool.cross(goal)), tool.dot(goal) - axis.dot(tool) * axis.dot(goal));
      q[j] = std::clamp(q[j] + turn, problem["lower"][j].get<double>(), problem["upper"][j].get<double>());
    }
  }
  return {{"message", "solved"}, {"id", problem["id"]}, {"q", q}, {"error", error()}, {"iterations", iteration}};
}
int main() {
  std::cout << R"({"ikbench":1,"message":"hello","name":"cpp_descent","version":"1.2","modes":["solve"],)"
            << R"("deterministic":true})" << std::endl;
  Json arm;
  for (std::string line; std::getline(std::cin, line);) {
    const Json told = Json::parse(line);
    const bool can = line.find("\"prismatic\"") == line.npos && line.find("\"coupled\"") == line.npos;
    if (told["message"] == "robot") arm = told, std::cout << Json{{"message", can ? "ready" : "declined"}} << std::endl;
    if (told["message"] == "solve") std::cout << solved(arm, told) << std::endl;
    if (told["message"] == "bye") break;
  }
}
