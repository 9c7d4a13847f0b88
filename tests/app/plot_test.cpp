#include "core/files/file_hash.h"
#include "core/files/run_record.h"
#include "tests/app/process.h"
#include "tests/support/panes.h"
#include "tests/support/run_rows.h"
#include "tests/support/scratch.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>

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

// The record of a run of the planned pane, held for a while, under a name that does not tell what it is.
std::string recordIn(const Scratch& scratch, std::size_t mostRows) {
  const std::filesystem::path file = scratch / "actual.csv";
  auto writer =
      files::RecordWriter::open(file, {"triangle.dxf", files::fileHash("a pane"), "2031-05-06T07:08:09Z", 1, {}, {}});
  EXPECT_TRUE(writer);
  std::vector<files::RunRow> rows = runOf(job::planJob(triangle600(), {}, {}));
  rows.resize(std::min(rows.size(), mostRows));
  constexpr std::array<std::string_view, 3> kPhasesOfARun{"dwell", "hold", "step"};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i / 100 < kPhasesOfARun.size()) {
      rows[i].row.phase = kPhasesOfARun.at(i / 100);
    }
    EXPECT_TRUE(writer->add(rows[i]));
  }
  EXPECT_TRUE(writer->close());
  return file.string();
}

TEST_F(Plot, DrawsARecordAndLaysItOverThePlan) {
  const std::string record = recordIn(m_scratch, 100'000);
  EXPECT_EQ(arris({"plot", record, "-o", m_picture}).status, 0);
  EXPECT_THAT(contentOf(m_picture), AllOf(HasSubstr("<svg"), HasSubstr("actual.csv")));
  const Outcome outcome = arris({"plot", m_profile, record, "-o", m_picture, "--report", m_report});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(contentOf(m_picture), AllOf(HasSubstr("planned.csv"), HasSubstr("actual.csv"), HasSubstr("limit 20")));
}

TEST_F(Plot, DrawsWhatARecordThatBreaksOffStillHolds) {
  const std::string record = recordIn(m_scratch, 100'000);
  const std::string bytes = contentOf(record);
  writeTo(record, bytes.substr(0, bytes.size() / 2));
  const Outcome outcome = arris({"plot", record, "-o", m_picture});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("warning: "), HasSubstr("breaks off"), HasSubstr("[record-damaged]")));
  EXPECT_THAT(contentOf(m_picture), HasSubstr("<svg"));
  writeTo(record, bytes.substr(0, 100));
  EXPECT_EQ(arris({"plot", record, "-o", m_picture}).status, 2);
}

TEST_F(Plot, RefusesARecordWithoutRows) {
  const Outcome outcome = arris({"plot", recordIn(m_scratch, 0), "-o", m_picture});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("it has no rows"));
  EXPECT_EQ(contentOf(m_picture), "");
}

TEST_F(Plot, RefusesAThirdProfileAndAPictureOverAProfile) {
  EXPECT_EQ(arris({"plot", m_profile, m_profile, m_profile, "-o", m_picture}).status, 2);
  EXPECT_EQ(arris({"plot", m_profile, "-o", m_profile}).status, 2);
  EXPECT_THAT(contentOf(m_profile), testing::StartsWith("t_s,"));
}

} // namespace
} // namespace arris::test
