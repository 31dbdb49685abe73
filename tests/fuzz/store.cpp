// The bytes of a store.
#include "results/store.hpp"

#include <fstream>

#include "tests/fuzz/fuzz.hpp"
#include "tests/scratch_folder.hpp"

using namespace ikbench;
using namespace ikbench::results;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFolder folder;
  const std::filesystem::path file = folder.path / "store.sqlite";
  std::ofstream(file, std::ios::binary) << text_of(data, size);
  read_or_refuse([&] {
    const Store store(file, Store::Mode::read);
    store.sessions();
    for (const StudyEntry& study : store.studies()) store.solves(study.name);
  });
  return 0;
}
