#include "report/page_arrays.h"

#include <gtest/gtest.h>

#include <cstring>

namespace partwise::report {
namespace {

TEST(PageArrays, PlacesAreWhereTheNumbersAre) {
  PageArrays arrays;
  const io::Json bytes = arrays.add(std::vector<std::uint8_t>{1, 2, 3});
  const io::Json points = arrays.add(Points{Vec3(0.5, -1, 2)});
  const io::Json facets = arrays.add(Facets{{7, 8, 9}});
  EXPECT_EQ(bytes, io::Json({{"type", "u8"}, {"offset", 0}, {"count", 3}}));
  EXPECT_EQ(points, io::Json({{"type", "f32"}, {"offset", 4}, {"count", 3}}));
  EXPECT_EQ(facets, io::Json({{"type", "u32"}, {"offset", 16}, {"count", 3}}));
  float y = 0;
  std::memcpy(&y, arrays.bytes().data() + 8, sizeof y);
  EXPECT_EQ(y, -1);
  std::uint32_t last = 0;
  std::memcpy(&last, arrays.bytes().data() + 24, sizeof last);
  EXPECT_EQ(last, 9U);
}

// The examples of RFC 4648, section 10, and bytes above 127.
TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

}  // namespace
}  // namespace partwise::report
