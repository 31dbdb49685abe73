// Finds the machines that solved a study. Times of different machines cannot be compared.
#pragma once

#include <set>
#include <span>
#include <string>

#include "results/store.hpp"

namespace ikbench::inference {

// Returns the recorded CPUs, with host names if there are several machines. Two sessions ran on different machines if
// both host name (a machine may reboot) and system start (containers have their own names) differ. So cloud machines
// with one host name count as one, and an unrecorded system start counts as another one.
std::set<std::string> machines_of(std::span<const results::Session> sessions);

}  // namespace ikbench::inference
