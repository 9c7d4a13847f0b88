#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/pattern/pattern.h"
#include "tests/support/contours.h"
#include "tests/support/dxf_text.h"
#include "tests/support/random_panes.h"

#include <gtest/gtest.h>

namespace arris::pattern {
namespace {

using geometry::Curve;

/// Rounded to the six decimals that most CAD systems write.
std::string asSixDecimals(std::string_view text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const std::string_view line = text.substr(begin, end - begin);
    const std::optional<double> number = base::parseNumber<double>(line);
    result += number && line.find('.') != std::string_view::npos ? std::to_string(*number) : std::string(line);
    result += '\n';
    begin = end + 1;
  }
  return result;
}

// What a user exports: fillets that are tangential in the CAD and are not any more in the file.
TEST(RoundTrip, FilletsWrittenWithSixDecimalsAreTangentialAgain) {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const std::vector<Curve> outline = test::randomPane(seed).pattern.contours[0].curves;
    for (const std::string& text : {test::DxfText().insUnits(4).add(test::shuffled(outline, seed)).text(),
                                    test::DxfText().insUnits(4).addPolyline(outline).text()}) {
      const Pattern pattern = readDxf(asSixDecimals(text), {});
      ASSERT_EQ(pattern.contours.size(), 1U) << seed;
      EXPECT_FALSE(base::hasErrors(pattern.problems)) << seed;
      const Contour& contour = pattern.contours[0];
      EXPECT_TRUE(test::isWellJoined(contour.curves, 1e-10)) << seed;
      EXPECT_LE(contour.fitDeviation, base::kSmoothDeviation + 1e-6) << seed;
      EXPECT_LT(test::farthest(outline, contour.curves), contour.fitDeviation + 2e-4) << seed;
    }
  }
}

TEST(RoundTrip, AContourIsReadAsItWasWritten) {
  for (std::uint64_t seed = 100; seed < 124; ++seed) {
    const std::vector<Curve> outline = test::randomPane(seed).pattern.contours[0].curves;
    const Pattern expected = test::joined(outline, 0.05);
    for (const std::string& text : {test::DxfText().insUnits(4).add(test::shuffled(outline, seed)).text(),
                                    test::DxfText().insUnits(4).addPolyline(outline).text()}) {
      const Pattern found = readDxf(text, {});
      ASSERT_EQ(found.contours.size(), 1U) << seed;
      EXPECT_FALSE(base::hasErrors(found.problems)) << seed; // notes that some may be chords of curves
      EXPECT_NEAR(geometry::totalLength(found.contours[0].curves), geometry::totalLength(outline), 1e-6) << seed;
      EXPECT_LT(test::farthest(found.contours[0].curves, outline), 1e-6) << seed;
      EXPECT_LT(test::farthest(outline, found.contours[0].curves), 1e-6) << seed;
    }
  }
}

} // namespace
} // namespace arris::pattern
