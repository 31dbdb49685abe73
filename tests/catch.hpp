// Catch2, version 2 or 3.
#pragma once

#include <fmt/format.h>  // before any using-directive: its `compare` would be our namespace

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
