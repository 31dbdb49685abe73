#include "analysis/report/encoding.hpp"

#include <openssl/evp.h>
#include <openssl/sha.h>

#include <array>

namespace ikbench::report {
namespace {

const unsigned char* bytes_of(std::string_view text) { return reinterpret_cast<const unsigned char*>(text.data()); }

}  // namespace

std::string base64(std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // plus a terminating zero
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), bytes_of(bytes), static_cast<int>(bytes.size()));
  text.pop_back();
  return text;
}

std::string sha256_in_base64(std::string_view bytes) {
  std::array<char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(bytes_of(bytes), bytes.size(), reinterpret_cast<unsigned char*>(digest.data()));
  return base64({digest.data(), digest.size()});
}

}  // namespace ikbench::report
