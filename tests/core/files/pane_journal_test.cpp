#include "core/files/pane_journal.h"
#include "core/files/whole_file.h"
#include "tests/support/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace arris::files {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

PaneEntry paneNumber(int pane, Verdict verdict = Verdict::Good) {
  return {"2031-05-06T07:08:09", "door \"3\".dxf", "0123456789abcdef", pane, verdict, 12.5};
}

std::vector<PaneEntry> panesIn(const std::filesystem::path& journal) {
  const auto panes = readPanes(journal);
  EXPECT_TRUE(panes) << describe(panes.error());
  return panes.value_or(std::vector<PaneEntry>());
}

TEST(PaneJournal, GivesBackWhatWasAppendedInItsOrder) {
  const test::Scratch scratch;
  EXPECT_THAT(panesIn(scratch / "panes.jsonl"), IsEmpty());
  for (const PaneEntry& entry : {paneNumber(1), paneNumber(2, Verdict::Reject), paneNumber(3, Verdict::Unjudged)}) {
    ASSERT_TRUE(appendPane(scratch / "panes.jsonl", entry));
  }
  EXPECT_THAT(panesIn(scratch / "panes.jsonl"),
              ElementsAre(paneNumber(1), paneNumber(2, Verdict::Reject), paneNumber(3, Verdict::Unjudged)));
}

TEST(PaneJournal, PassesOverDamagedLinesAndGoesOnAfterHalfALine) {
  const test::Scratch scratch;
  ASSERT_TRUE(appendPane(scratch / "panes.jsonl", paneNumber(1)));
  std::ofstream(scratch / "panes.jsonl", std::ios::app)
      << "no JSON\n{\"pane\":2}\n\n"
      << R"({"time":"t","pattern":"p","hash":"0123456789abcdef","pane":3,"verdict":"pretty","duration_s":1})" << '\n'
      << R"({"time":"t","pattern":"p","ha)"; // the power failed
  ASSERT_TRUE(appendPane(scratch / "panes.jsonl", paneNumber(4)));
  EXPECT_THAT(panesIn(scratch / "panes.jsonl"), ElementsAre(paneNumber(1), paneNumber(4)));
}

TEST(PaneJournal, ThatCannotBeWrittenSaysSo) {
  const test::Scratch scratch;
  const auto appended = appendPane(scratch / "absent/panes.jsonl", paneNumber(1));
  ASSERT_FALSE(appended);
  EXPECT_EQ(appended.error().code, base::Code::CannotWrite);
}

TEST(PaneJournal, CountsTheEarlierPanesOfAnOrder) {
  const std::string hash = "0123456789abcdef";
  PaneEntry other = paneNumber(2);
  other.patternHash = "fedcba9876543210";
  const std::vector<PaneEntry> journal{paneNumber(1), paneNumber(2), // an order before
                                       paneNumber(1), paneNumber(2, Verdict::Reject), paneNumber(3)};
  EXPECT_EQ(countBefore(4, hash, journal), (PaneCounts{2, 1}));
  EXPECT_EQ(countBefore(1, hash, journal), (PaneCounts{}));
  EXPECT_EQ(countBefore(3, hash, journal), (PaneCounts{})); // the last is not the one before
  EXPECT_EQ(countBefore(3, hash, {paneNumber(1), other}), (PaneCounts{}));
  EXPECT_EQ(countBefore(7, hash, {}), (PaneCounts{}));
}

} // namespace
} // namespace arris::files
