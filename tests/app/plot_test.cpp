#include "tests/app/process.h"
#include "tests/support/scratch.h"

#include <gmock/gmock.h>

namespace arris::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Plot : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_EQ(arris({"plan", sample("triangle.dxf"), "--profile", m_profile, "--report", m_report}).status, 0);
  }

  Scratch m_scratch;
  std::string m_profile = (m_scratch / "planned.csv").string();
  std::string m_report = (m_scratch / "report.json").string();
  std::string m_picture = (m_scratch / "plot.svg").string();
};

TEST_F(Plot, DrawsAProfile) {
  EXPECT_EQ(arris({"plot", m_profile, "-o", m_picture}).status, 0);
  EXPECT_THAT(contentOf(m_picture), AllOf(HasSubstr("<svg"), HasSubstr("planned.csv")));
}

TEST_F(Plot, TakesLimitsAndAnglesFromTheReport) {
  EXPECT_EQ(arris({"plot", m_profile, "-o", m_picture}).status, 0);
  EXPECT_THAT(contentOf(m_picture), testing::Not(HasSubstr("60°")));
  EXPECT_EQ(arris({"plot", m_profile, "-o", m_picture, "--report", m_report}).status, 0);
  EXPECT_THAT(contentOf(m_picture), AllOf(HasSubstr("60°"), HasSubstr("limit 20")));
}

TEST_F(Plot, LaysASecondProfileOverTheFirst) {
  const std::string slower = (m_scratch / "slower.csv").string();
  ASSERT_EQ(arris({"plan", sample("triangle.dxf"), "--feed", "1200", "--profile", slower}).status, 0);
  EXPECT_EQ(arris({"plot", m_profile, slower, "-o", m_picture}).status, 0);
  EXPECT_THAT(contentOf(m_picture), AllOf(HasSubstr("planned.csv"), HasSubstr("slower.csv")));
}

TEST_F(Plot, RefusesWhatIsNoProfileAndNamesIt) {
  const Outcome outcome = arris({"plot", m_report, "-o", m_picture});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("report.json"));
  EXPECT_EQ(contentOf(m_picture), "");
}

TEST_F(Plot, RefusesWhatIsNoReportAndNamesIt) {
  const Outcome outcome = arris({"plot", m_profile, "-o", m_picture, "--report", m_profile});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("planned.csv"));
  EXPECT_EQ(contentOf(m_picture), "");
}

TEST_F(Plot, RefusesAThirdProfileAndAPictureOverAProfile) {
  EXPECT_EQ(arris({"plot", m_profile, m_profile, m_profile, "-o", m_picture}).status, 2);
  EXPECT_EQ(arris({"plot", m_profile, "-o", m_profile}).status, 2);
  EXPECT_THAT(contentOf(m_profile), testing::StartsWith("t_s,"));
}

} // namespace
} // namespace arris::test
