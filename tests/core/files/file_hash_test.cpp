#include "core/files/file_hash.h"

#include <gtest/gtest.h>

namespace arris::files {
namespace {

// From the list of test vectors of the algorithm's authors (draft-eastlake-fnv).
TEST(FileHash, IsFnv1aOf64Bits) {
  EXPECT_EQ(fileHash(""), "cbf29ce484222325");
  EXPECT_EQ(fileHash("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(fileHash("foobar"), "85944171f73967e8");
}

TEST(FileHash, IsToldFromOtherTexts) {
  EXPECT_TRUE(isFileHash(fileHash("\xFF\0 bytes")));
  for (const char* text : {"", "af63dc4c8601ec8", "af63dc4c8601ec8c0", "AF63DC4C8601EC8C", "af63dc4c8601ec8g"}) {
    EXPECT_FALSE(isFileHash(text)) << text;
  }
}

} // namespace
} // namespace arris::files
