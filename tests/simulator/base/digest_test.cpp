#include "simulator/base/digest.h"

#include <gtest/gtest.h>

#include <array>

namespace hallux {
namespace {

/// BLAKE2b with 32 bytes of output of nothing at all (b2sum -l 256 < /dev/null).
TEST(Digest, OfNothingIsThatOfBlake2b) {
  EXPECT_EQ(hex_from_digest(digest_of({})),
            "0e5751c026e543b2e8ab2eb06099daa1d1e5df47778f7787faab45cdf12fe3a8");
}

TEST(Digest, GoesThroughHexAndBack) {
  const Digest digest = digest_of(std::as_bytes(std::span{"bone", 4}));
  EXPECT_EQ(digest_from_hex(hex_from_digest(digest)), digest);
}

TEST(Digest, RefusesWhatIsNotHex) {
  const std::string hex = hex_from_digest(digest_of({}));
  EXPECT_FALSE(digest_from_hex(hex.substr(1)));
  EXPECT_FALSE(digest_from_hex(hex + "0"));
  EXPECT_FALSE(digest_from_hex("g" + hex.substr(1)));
  EXPECT_FALSE(digest_from_hex("A" + hex.substr(1)));
}

TEST(Digest, TellsTextsApartWhereverTheyAreDivided) {
  Digester one;
  one.add_text("a");
  one.add_text("bc");
  Digester other;
  other.add_text("ab");
  other.add_text("c");
  EXPECT_NE(one.finish(), other.finish());
}

TEST(Digest, WritesIntegersLittleEndian) {
  Digester number;
  number.add_int(0x0807060504030201);
  const std::array<std::byte, 8> bytes{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{4},
                                       std::byte{5}, std::byte{6}, std::byte{7}, std::byte{8}};
  EXPECT_EQ(number.finish(), digest_of(bytes));
}

TEST(Digest, TellsZeroFromMinusZero) {
  Digester plus;
  plus.add_double(0.0);
  Digester minus;
  minus.add_double(-0.0);
  EXPECT_NE(plus.finish(), minus.finish());
}

}  // namespace
}  // namespace hallux
