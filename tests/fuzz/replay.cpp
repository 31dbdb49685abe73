// Without a fuzzer: gives a reader the files and folders that are its arguments. It must accept each file, except those
// whose names begin with "refused".
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/fuzz/fuzz.hpp"

namespace {

bool replay(const std::filesystem::path& input) {
  std::printf("%s\n", input.c_str());
  std::fflush(stdout);  // before the reader can end the program
  std::ifstream file(input, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const int taken_before = ikbench::taken;
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  const bool is_to_be_refused = input.filename().string().starts_with("refused");
  if ((ikbench::taken == taken_before) == is_to_be_refused) return true;
  std::printf("%s\n", is_to_be_refused ? "was taken" : "was refused");
  return false;
}

}  // namespace

int main(int count, char** arguments) {
  bool is_right = count > 1;
  for (int i = 1; i < count; ++i) {
    if (!std::filesystem::is_directory(arguments[i]))
      is_right = replay(arguments[i]) && is_right;
    else
      for (const auto& entry : std::filesystem::directory_iterator(arguments[i]))
        is_right = replay(entry.path()) && is_right;
  }
  return is_right ? 0 : 1;
}
