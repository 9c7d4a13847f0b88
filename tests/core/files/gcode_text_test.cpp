#include "core/base/numbers.h"
#include "core/files/gcode_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace arris::files {
namespace {

using geometry::Arc;
using geometry::Point;

// A block as a controller sees it.
struct Block {
  std::string word; ///< G1, G2 …
  Point from{0, 0};
  Point to{0, 0};
  Point center{0, 0};
};

std::vector<Block> blocksOf(const std::string& text) {
  std::vector<Block> result;
  Point at(0, 0);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Block block;
    words >> block.word;
    block.from = block.to = block.center = at;
    for (std::string word; words >> word;) {
      const double value = base::parseNumber<double>(word.substr(1)).value();
      switch (word[0]) {
      case 'X':
        block.to.x() = value;
        break;
      case 'Y':
        block.to.y() = value;
        break;
      case 'I':
        block.center.x() = at.x() + value;
        break;
      case 'J':
        block.center.y() = at.y() + value;
        break;
      default:
        break;
      }
    }
    at = block.to;
    result.push_back(block);
  }
  return result;
}

TEST(GCodeText, NumbersAreRoundedToSixDecimalsAndWrittenWithoutIdleZeros) {
  GCodeText text;
  text.rapidToHeight(120);
  text.rapidTo({-0.0000001, 12.5});
  text.lineTo({-0.000001, 100}, 3600);
  text.lineTo({1234.5678904, -0.0625}, 1200.0000000001);
  text.lineTo({1234.5678901, -0.0625}, 1200); // the same place
  EXPECT_EQ(text.take(), "G0 Z120\nG0 X0 Y12.5\nG1 X-0.000001 Y100 F3600\nG1 X1234.56789 Y-0.0625 F1200\n");
}

TEST(GCodeText, QuarterArcsKeepTheirTurn) {
  GCodeText text;
  text.rapidTo({10, 10});
  text.arc(geometry::arcBetween({10, 10}, {30, 30}, base::kPi / 2), 600);
  text.arc(geometry::arcBetween({30, 30}, {50, 10}, -base::kPi / 2), 600);
  EXPECT_EQ(text.take(), "G0 X10 Y10\nG3 X30 Y30 I0 J20 F600\nG2 X50 Y10 I0 J-20 F600\n");
}

// Over twelve decades of radius and sweep: every arc block is one that no controller can take for a full circle or for
// none, and the blocks together turn by what the arc turns and end where it ends.
TEST(GCodeText, NoArcCanBeTakenForAFullCircleOrForNone) {
  constexpr double kControllersFullCircle = 1e-6; // LinuxCNC takes smaller sweeps for one, rad
  for (double radius = 1e-3; radius < 2e9; radius *= 10) {
    for (double sweep = 1e-12; sweep < 2 * base::kPi; sweep *= 3.7) {
      for (const double turn : {sweep, -sweep, 2 * base::kPi - sweep, sweep - 2 * base::kPi}) {
        const double heading = 0.3 + 1e3 * sweep;
        const Arc arc{{500.1234565, 700.00000049},
                      {std::cos(heading), std::sin(heading)},
                      (turn > 0 ? 1 : -1) / radius,
                      radius * std::abs(turn)};
        if (arc.length > 4000) {
          continue; // on no machine
        }
        SCOPED_TRACE(fmt::format("radius {} turn {}", radius, turn));
        GCodeText text;
        text.rapidTo(arc.start);
        text.arc(arc, 3600);
        Point at = arc.start;
        double turned = 0;
        for (const Block& block : blocksOf(text.take())) {
          if (block.word == "G2" || block.word == "G3") {
            const double swept = geometry::turn(block.from - block.center, block.to - block.center);
            const double full = (block.word == "G3") == (swept > 0) ? swept : swept + (swept > 0 ? -2 : 2) * base::kPi;
            EXPECT_GT(std::abs(full), kControllersFullCircle);
            EXPECT_LT(std::abs(full), 1.6 * base::kPi);
            EXPECT_NEAR((block.from - block.center).norm(), (block.to - block.center).norm(), 3e-6);
            turned += full;
          }
          at = block.to;
        }
        EXPECT_LT((at - geometry::endPoint(arc)).norm(), 1e-6);
        if (turned != 0) {
          EXPECT_NEAR(turned, turn, 5e-6 / radius + 1e-9);
        } else {
          EXPECT_TRUE(radius > 1e5 || radius * (1 - std::cos(turn / 2)) < 1.1e-4); // cut into chords, or flat
        }
      }
    }
  }
}

TEST(GCodeText, AnArcOfHugeRadiusStaysWithinAFractionOfAMicrometreAsLines) {
  const Arc arc = geometry::arcBetween({0, 0}, {1500, 0}, 1e-2); // 150 m of radius
  GCodeText text;
  text.rapidTo(arc.start);
  text.arc(arc, 3600);
  const std::vector<Block> blocks = blocksOf(text.take());
  EXPECT_GT(blocks.size(), 10U);
  for (const Block& block : blocks) {
    EXPECT_LT(geometry::nearest(arc, (block.from + block.to) / 2).distance, 3e-4);
  }
}

TEST(GCodeText, CommentsAreAsciiWithoutParenthesesInside) {
  GCodeText text;
  text.comment("a (b) 玻璃\n");
  EXPECT_EQ(text.take(), "(a [b] ??"
                         "?)\n");
}

} // namespace
} // namespace arris::files
