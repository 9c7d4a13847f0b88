#include "core/base/problem.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

namespace arris::base {
namespace {

TEST(ProblemTable, HasOneRowPerCodeInTheOrderOfTheEnumeration) {
  for (std::size_t i = 0; i < allCodes().size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(allCodes()[i].code), i) << allCodes()[i].name;
  }
  EXPECT_EQ(static_cast<std::size_t>(Code::DriverNotAvailable) + 1, allCodes().size());
}

TEST(ProblemTable, NamesAreKebabCaseAndUsedOnce) {
  std::set<std::string> seen;
  for (const CodeInfo& row : allCodes()) {
    const std::string name(row.name);
    EXPECT_TRUE(std::regex_match(name, std::regex("[a-z]+(-[a-z0-9]+)*"))) << name;
    EXPECT_TRUE(seen.insert(name).second) << name;
  }
}

TEST(Problem, IsDescribedWithItsValuesAndPlace) {
  const Problem gap = Problem(Code::OpenChain, {{"gap_mm", 0.25}, {"tolerance_mm", 0.05}}).at({10.5, 20}).onLine(12);
  EXPECT_EQ(describeWithPlace(gap),
            "error: line 12: at (10.500, 20.000) mm in the drawing: The contour is open here: the next free end is "
            "0.25 mm away (up to 0.05 mm are joined). [open-chain]");
}

TEST(Problem, OfOneCodeTwentyAreListedAndTheRestCounted) {
  Problems problems(50, Problem(Code::OpenChain));
  problems.emplace_back(Code::NoContour);
  keepFirstOfEachCode(problems);
  ASSERT_EQ(problems.size(), 22U);
  EXPECT_EQ(problems.back().code, Code::MoreNotListed);
  EXPECT_NE(describe(problems.back()).find("30"), std::string::npos);
}

TEST(Problem, ANameWithoutAValueStaysVisible) {
  EXPECT_EQ(fillIn("a {b} c", Problem(Code::NoContour)), "a {b} c");
  EXPECT_EQ(fillIn("a {b", Problem(Code::NoContour)), "a {b");
}

} // namespace
} // namespace arris::base
