// Which machines solved a study: times of one are not those of another.
#pragma once

#include <set>
#include <span>
#include <string>

#include "results/store.hpp"

namespace ikbench::inference {

// The CPUs of sessions, as far as these say, and with them the hosts where these are several machines: where neither
// the host is the same (a machine may have started anew) nor the start of the system (containers have names of their
// own). So machines with one host name, as of one image of a cloud, are taken for one, and a session that does not say
// its start counts as another start.
std::set<std::string> machines_of(std::span<const results::Session> sessions);

}  // namespace ikbench::inference
