// SHA-256, against the examples of FIPS 180-4 and what sha256sum says.
#include "base/sha256.hpp"

#include "tests/common.hpp"

namespace {

std::string digest_of(std::string_view text) {
  ikbench::base::Sha256 digest;
  digest.add(text);
  return digest.text();
}

}  // namespace

TEST_CASE("SHA-256 gives the digests of FIPS 180-4", "[sha256]") {
  CHECK(digest_of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(digest_of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(digest_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(digest_of(std::string(1'000'000, 'a')) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("bytes that come in parts have the digest of the whole, at every length about a block", "[sha256]") {
  for (std::size_t length = 0; length <= 200; ++length) {
    std::string text;
    for (std::size_t i = 0; i < length; ++i) text += static_cast<char>(37 * i + 200);
    const std::string whole = digest_of(text);
    for (const std::size_t part : {1u, 7u, 63u, 64u, 65u}) {
      ikbench::base::Sha256 digest;
      for (std::size_t at = 0; at < length; at += part) digest.add(std::string_view(text).substr(at, part));
      CAPTURE(length, part);
      CHECK(digest.text() == whole);
    }
  }
}
