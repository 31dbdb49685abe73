// SHA-256 (FIPS 180-4): a digest that nobody can forge, the same as `sha256sum` prints.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace ikbench::base {

// Computes the digest of bytes that come in parts of any size.
class Sha256 {
 public:
  void add(std::string_view bytes);
  // Returns 64 hexadecimal digits for all bytes so far. Nothing may be added afterwards.
  std::string text();

 private:
  static constexpr std::size_t block_bytes = 64;

  void digest_block(const char* block);

  std::array<std::uint32_t, 8> state_{0x6A09E667, 0xBB67AE85, 0x3C6EF372, 0xA54FF53A,
                                      0x510E527F, 0x9B05688C, 0x1F83D9AB, 0x5BE0CD19};
  std::string rest_;         // bytes of the last block, which is not full
  std::uint64_t bytes_ = 0;  // number of all bytes
};

}  // namespace ikbench::base
