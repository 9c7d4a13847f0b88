#include "core/pattern/binary_dxf.h"
#include "core/pattern/pattern.h"
#include "tests/support/binary_dxf.h"
#include "tests/support/dxf_text.h"

#include <gtest/gtest.h>

#include <random>

namespace arris::pattern {
namespace {

using base::Code;
using test::asBinaryDxf;
using test::BinaryCodes;

constexpr auto kBothCodes = {BinaryCodes::OneByte, BinaryCodes::TwoBytes};

std::string drawing() {
  return test::DxfText()
      .insUnits(4)
      .layer("Glass", 7, 0)
      .add(geometry::Line{{0.1, 1.0 / 3}, {100, 1e-7}}, "Glass")
      .add(geometry::arcAbout({12.5, -3}, 7, 0, 6.283185307179586))
      .addGroups("0 LWPOLYLINE\n8 Glass\n90 3\n70 1\n10 1\n20 2\n42 0.1\n10 300\n20 4\n10 5\n20 900\n290 1\n310 ab\n"
                 "1000 extended\n1040 2.5\n1070 7\n1071 70000")
      .text();
}

TEST(BinaryDxf, SaysTheSameGroupsAsTheText) {
  for (const BinaryCodes codes : kBothCodes) {
    const base::Expected<std::string> text = textOfBinaryDxf(asBinaryDxf(drawing(), codes));
    ASSERT_TRUE(text);
    std::string expected = drawing();
    expected.replace(expected.find("\nab\n"), 4, "\n6162\n"); // bytes are told in hexadecimal
    for (std::size_t at = 0; (at = expected.find("\n0.0\n", at)) != std::string::npos;) {
      expected.replace(at, 5, "\n0\n");
    }
    EXPECT_EQ(*text, expected);
  }
}

TEST(BinaryDxf, IsReadAsTheTextIs) {
  const Pattern expected = readDxf(drawing(), {});
  for (const BinaryCodes codes : kBothCodes) {
    const Pattern found = readDxf(asBinaryDxf(drawing(), codes), {});
    EXPECT_EQ(found.layers, expected.layers);
    ASSERT_EQ(found.contours.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(geometry::signedArea(found.contours[i].curves), geometry::signedArea(expected.contours[i].curves));
    }
  }
}

TEST(BinaryDxf, IsToldFromItsFirstGroupWhichCodesItHas) {
  const std::string text = "999\nmade by hand\n" + drawing();
  for (const BinaryCodes codes : kBothCodes) {
    EXPECT_EQ(textOfBinaryDxf(asBinaryDxf(text, codes)).value_or("").substr(0, 17), text.substr(0, 17));
  }
}

TEST(BinaryDxf, CutOffAnywhereIsRefused) {
  for (const BinaryCodes codes : kBothCodes) {
    const std::string bytes = asBinaryDxf(drawing(), codes);
    for (std::size_t size = 18; size < bytes.size(); ++size) {
      const base::Expected<std::string> text = textOfBinaryDxf(std::string_view(bytes).substr(0, size));
      ASSERT_FALSE(text) << size;
      EXPECT_EQ(text.error().code, Code::DxfBinary);
      EXPECT_EQ(base::describe(text.error()).find('{'), std::string::npos);
    }
    EXPECT_TRUE(textOfBinaryDxf(bytes + "rubbish after the end"));
  }
}

TEST(BinaryDxf, LineEndsWithinATextMakeNoGroups) {
  std::string bytes = asBinaryDxf(test::DxfText().addGroups("0 TEXT\n1 one?two").text(), BinaryCodes::TwoBytes);
  bytes[bytes.find('?')] = '\n';
  const Pattern pattern = readDxf(bytes, {});
  EXPECT_EQ(pattern.entities.at("TEXT"), 1);
}

TEST(BinaryDxf, NumbersThatAreNoneAreRefusedAsInText) {
  std::string text = drawing();
  text.replace(text.find("\n100\n"), 5, "\nnan\n");
  const Pattern pattern = readDxf(asBinaryDxf(text, BinaryCodes::TwoBytes), {});
  ASSERT_EQ(pattern.problems.size(), 1U);
  EXPECT_EQ(pattern.problems[0].code, Code::DxfNumber);
}

TEST(BinaryDxf, WithBytesChangedIsReadOrRefused) {
  std::mt19937 random(99);
  for (const BinaryCodes codes : kBothCodes) {
    const std::string bytes = asBinaryDxf(drawing(), codes);
    for (int round = 0; round < 2000; ++round) {
      std::string corrupt = bytes;
      for (unsigned hit = 0; hit < 1 + random() % 4; ++hit) {
        corrupt[22 + random() % (corrupt.size() - 22)] = static_cast<char>(random() % 256);
      }
      for (const base::Problem& problem : readDxf(corrupt, {}).problems) {
        EXPECT_NE(problem.code, Code::NumericalFailure) << base::describe(problem);
      }
    }
  }
}

} // namespace
} // namespace arris::pattern
