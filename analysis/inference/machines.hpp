// Which machines solved a study: times of one are not those of another.
#pragma once

#include <set>
#include <span>
#include <string>

#include "results/store.hpp"

namespace ikbench::inference {

// The CPUs of sessions, as far as these say, and with them the hosts where these are several machines: where neither
// the host is the same (a machine may have started anew) nor the start of the system (containers have names of their
// own).
std::set<std::string> machines_of(std::span<const results::Session> sessions);

}  // namespace ikbench::inference
