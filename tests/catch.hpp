// Catch2, version 2 or 3, and what is thrown, as text.
#pragma once

#include <fmt/format.h>  // before any using-directive: its `compare` would be our namespace

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

namespace ikbench {

// The text of the exception that `action` throws; empty if it throws none of that type.
template <class Exception, class Action>
std::string complaint(Action&& action) {
  try {
    action();
  } catch (const Exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace ikbench
