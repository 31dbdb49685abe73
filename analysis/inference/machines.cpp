#include "analysis/inference/machines.hpp"

namespace ikbench::inference {

using namespace results;

std::set<std::string> machines_of(std::span<const Session> sessions) {
  const auto fact = [](const Session& session, const char* name) {
    const auto found = session.environment.find(name);
    return found == session.environment.end() ? std::string() : found->second;
  };
  std::set<std::string> hosts, boots, machines;
  for (const Session& session : sessions) {
    if (fact(session, "host").empty()) continue;
    hosts.insert(fact(session, "host"));
    boots.insert(fact(session, "boot"));
  }
  const bool are_several = hosts.size() > 1 && boots.size() > 1;
  for (const Session& session : sessions) {
    const std::string cpu = fact(session, "cpu"), host = fact(session, "host");
    if (!cpu.empty()) machines.insert(are_several && !host.empty() ? cpu + " on " + host : cpu);
  }
  return machines;
}

}  // namespace ikbench::inference
