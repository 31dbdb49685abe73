// Gives a reader the files and those of the folders that are its arguments, where there is no fuzzer.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/fuzz/fuzz.hpp"

namespace {

void replay(const std::filesystem::path& input) {
  std::printf("%s\n", input.c_str());
  std::fflush(stdout);  // before the reader can end the program
  std::ifstream file(input, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int count, char** arguments) {
  for (int i = 1; i < count; ++i) {
    if (!std::filesystem::is_directory(arguments[i]))
      replay(arguments[i]);
    else
      for (const auto& entry : std::filesystem::directory_iterator(arguments[i])) replay(entry.path());
  }
  return count > 1 ? 0 : 1;
}
