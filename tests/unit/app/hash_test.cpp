// SPDX-License-Identifier: Apache-2.0
#include "app/hash.hpp"

#include <gtest/gtest.h>

namespace epura::test::hash_test {
namespace {

// FIPS 180-2, appendix B, and the NIST example of the empty text.
TEST(Hash, DigestsTheExamplesOfTheStandard) {
  EXPECT_EQ(hash_of_bytes(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hash_of_bytes("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hash_of_bytes("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hash_of_bytes(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// RFC 9562, appendix A.4: in the namespace of domains. The others are those of Python's uuid5.
TEST(Hash, NamesHaveTheirUuid) {
  EXPECT_EQ(uuid_of("www.example.com", "6ba7b810-9dad-11d1-80b4-00c04fd430c8"), "2ed6657d-e927-568b-95e1-2665a8aea6a2");
  EXPECT_EQ(uuid_of("urn:epura:qif"), "744dabd7-553f-57de-a831-2fcb5ca6a86b");
  EXPECT_EQ(uuid_of(""), "1b4db7eb-4057-5ddf-91e0-36dec72071f5");
}

}  // namespace
}  // namespace epura::test::hash_test
