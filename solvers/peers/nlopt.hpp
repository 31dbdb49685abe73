// What the solvers by NLopt share.
#pragma once

#include <fmt/core.h>
#include <nlopt.h>

#include <memory>
#include <string>

namespace ikbench::solvers {

using NloptHandle = std::unique_ptr<nlopt_opt_s, decltype([](nlopt_opt opt) { nlopt_destroy(opt); })>;

inline std::string nlopt_version_text() {
  int major = 0, minor = 0, fix = 0;
  nlopt_version(&major, &minor, &fix);
  return fmt::format("NLopt {}.{}.{}", major, minor, fix);
}

}  // namespace ikbench::solvers
