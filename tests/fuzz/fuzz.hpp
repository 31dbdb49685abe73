// Shared by all fuzzed inputs: an input is accepted, or a std::invalid_argument says why not. Anything else ends the
// program, and the fuzzer keeps the input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

// libFuzzer calls it with every input; replay.cpp with those of a folder.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace ikbench {

inline int taken = 0;  // accepted inputs so far

template <class Reader>
void read_or_refuse(Reader&& reader) {
  try {
    reader();
    ++taken;
  } catch (const std::invalid_argument&) {
    return;
  }
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace ikbench
