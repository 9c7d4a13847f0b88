#include "tests/support/panes.h"
#include "tests/ui/support/recorded_runs.h"
#include "tests/ui/support/steps.h"
#include "ui/presenters/profile_files.h"

#include <QFile>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>

namespace arris::ui {
namespace {

bool comesToRest(const ProfileFiles& files) {
  return QTest::qWaitFor([&] { return !files.isBusy(); }, test::kPatience);
}

CurvesPointer lastOpened(const QSignalSpy& opened) {
  return opened.isEmpty() ? nullptr : opened.last().front().value<CurvesPointer>();
}

// Curves that bear the name of the file and nothing else; the first waits until it may go on.
class SlowReader {
public:
  ReadProfileFile reader() {
    return [this](const std::filesystem::path& file, const std::function<bool()>&) {
      ++readings;
      mayRead.acquire();
      ProfileCurves curves;
      curves.name = QString::fromStdString(file.string());
      return ProfileReading{curves, {}};
    };
  }

  QSemaphore mayRead;
  std::atomic<int> readings = 0;
};

TEST(ProfileFiles, AreOpenedInTheBackground) {
  const test::Scratch scratch;
  const job::Job job = job::planJob(test::triangle600(), {}, {});
  for (const std::filesystem::path& file : {test::profileOf(job, scratch), test::recordOf(job, scratch)}) {
    ProfileFiles files;
    QSignalSpy opened(&files, &ProfileFiles::opened);
    QSignalSpy busy(&files, &ProfileFiles::busyChanged);
    files.open(file);
    EXPECT_TRUE(files.isBusy());
    EXPECT_TRUE(opened.isEmpty()); // nothing happened in the caller's time
    ASSERT_TRUE(comesToRest(files));
    ASSERT_EQ(opened.count(), 1);
    EXPECT_EQ(lastOpened(opened)->name.toStdString(), file.filename());
    EXPECT_NEAR(lastOpened(opened)->duration, job.duration, 0.01);
    EXPECT_TRUE(opened[0][1].value<base::Problems>().empty());
    ASSERT_EQ(busy.count(), 2);
    EXPECT_TRUE(busy[0][0].toBool());
    EXPECT_FALSE(busy[1][0].toBool());
  }
}

TEST(ProfileFiles, AreOpenedAsFarAsTheyAreWholeAndSaySo) {
  const test::Scratch scratch;
  const job::Job job = job::planJob(test::triangle600(), {}, {});
  ProfileFiles files;
  QSignalSpy opened(&files, &ProfileFiles::opened);
  files.open(test::cutAt(0.5, test::recordOf(job, scratch), scratch));
  ASSERT_TRUE(comesToRest(files));
  ASSERT_EQ(opened.count(), 1);
  EXPECT_EQ(opened[0][1].value<base::Problems>().size(), 1U);
}

TEST(ProfileFiles, SayWhyTheyCannotBeOpened) {
  const test::Scratch scratch;
  const job::Job job = job::planJob(test::triangle600(), {}, {});
  std::ofstream(scratch / "empty.csv");
  std::ofstream(scratch / "letter.csv") << "Dear customer,\nthe panes are ready.\n";
  std::ofstream(scratch / "binary.arrisrun") << std::string(5000, '\0');
  std::filesystem::create_directory(scratch / "folder");
  const std::vector<std::pair<std::filesystem::path, base::Code>> cases{
      {scratch / "missing.csv", base::Code::CannotOpen},
      {scratch / "folder", base::Code::CannotRead},
      {scratch / "empty.csv", base::Code::CsvMalformed},
      {scratch / "letter.csv", base::Code::CsvMalformed},
      {scratch / "binary.arrisrun", base::Code::CsvMalformed},
      {test::cutAt(0.0001, test::recordOf(job, scratch), scratch), base::Code::RecordMalformed}};
  for (const auto& [file, code] : cases) {
    ProfileFiles files;
    QSignalSpy opened(&files, &ProfileFiles::opened);
    QSignalSpy failed(&files, &ProfileFiles::failed);
    files.open(file);
    ASSERT_TRUE(comesToRest(files));
    EXPECT_TRUE(opened.isEmpty()) << file;
    ASSERT_EQ(failed.count(), 1) << file;
    EXPECT_EQ(failed[0][0].value<base::Problem>().code, code) << file;
  }
}

TEST(ProfileFiles, LetTheLatestOpeningWinAndReadNothingThatWasOvertaken) {
  SlowReader slow;
  ProfileFiles files(slow.reader());
  QSignalSpy opened(&files, &ProfileFiles::opened);
  files.open("first");
  ASSERT_TRUE(QTest::qWaitFor([&] { return slow.readings == 1; }, test::kPatience));
  files.open("second");
  files.open("third");
  slow.mayRead.release(10);
  ASSERT_TRUE(comesToRest(files));
  EXPECT_EQ(slow.readings, 2); // the first and the last
  ASSERT_EQ(opened.count(), 1);
  EXPECT_EQ(lastOpened(opened)->name, "third");
}

TEST(ProfileFiles, DropWhatWasAbandoned) {
  SlowReader slow;
  ProfileFiles files(slow.reader());
  QSignalSpy opened(&files, &ProfileFiles::opened);
  files.open("first");
  files.abandon();
  slow.mayRead.release();
  ASSERT_TRUE(comesToRest(files));
  EXPECT_TRUE(opened.isEmpty());
}

TEST(ProfileFiles, CanGoAwayWhileTheyAreRead) {
  SlowReader slow;
  {
    ProfileFiles files(slow.reader());
    files.open("first");
    ASSERT_TRUE(QTest::qWaitFor([&] { return slow.readings == 1; }, test::kPatience));
    slow.mayRead.release();
  }
  QTest::qWait(1); // what was delivered to them is gone
}

TEST(ProfileFiles, AreWrittenEvenWhenAnotherIsOpened) {
  const test::Scratch scratch;
  const std::filesystem::path file = scratch / "picture.svg";
  ProfileFiles files;
  QSignalSpy saved(&files, &ProfileFiles::saved);
  files.save(file, "a picture");
  files.open(scratch / "missing.csv");
  ASSERT_TRUE(comesToRest(files));
  ASSERT_EQ(saved.count(), 1);
  QFile read(QString::fromStdString(file.string()));
  ASSERT_TRUE(read.open(QIODevice::ReadOnly));
  EXPECT_EQ(read.readAll(), "a picture");
}

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(ProfileFiles, ExportThePlannedProfileAsThePlanCallDoes) {
  const test::Scratch scratch;
  auto plan = std::make_shared<Plan>();
  plan->job = job::planJob(test::triangle600(), {}, {});
  ProfileFiles files;
  QSignalSpy saved(&files, &ProfileFiles::saved);
  files.exportPlanned(plan, scratch / "exported.csv");
  ASSERT_TRUE(comesToRest(files));
  ASSERT_EQ(saved.count(), 1);
  const std::string exported = bytesOf(scratch / "exported.csv");
  EXPECT_GT(exported.size(), 1'000'000U);
  EXPECT_TRUE(exported == bytesOf(test::profileOf(plan->job, scratch)));
}

TEST(ProfileFiles, ExportTheProfileOfARecord) {
  const test::Scratch scratch;
  const job::Job job = job::planJob(test::triangle600(), {}, {});
  ProfileFiles files;
  QSignalSpy saved(&files, &ProfileFiles::saved);
  QSignalSpy opened(&files, &ProfileFiles::opened);
  files.exportRecord(test::recordOf(job, scratch), scratch / "run.csv");
  files.open(scratch / "run.csv");
  ASSERT_TRUE(comesToRest(files));
  ASSERT_EQ(saved.count(), 1);
  ASSERT_EQ(opened.count(), 1);
  EXPECT_NEAR(lastOpened(opened)->duration, job.duration, 0.01);
  EXPECT_NE(bytesOf(scratch / "run.csv").find("vx_meas_mm_s"), std::string::npos);
}

TEST(ProfileFiles, WriteNothingForARecordThatIsNone) {
  const test::Scratch scratch;
  std::ofstream(scratch / "letter.csv") << "Dear customer,\n";
  ProfileFiles files;
  QSignalSpy failed(&files, &ProfileFiles::failed);
  files.exportRecord(scratch / "letter.csv", scratch / "run.csv");
  ASSERT_TRUE(comesToRest(files));
  ASSERT_EQ(failed.count(), 1);
  EXPECT_EQ(failed[0][0].value<base::Problem>().code, base::Code::RecordMalformed);
  EXPECT_FALSE(std::filesystem::exists(scratch / "run.csv"));
}

TEST(ProfileFiles, KeepWhatWasOpenedLast) {
  const test::Scratch scratch;
  const job::Job job = job::planJob(test::triangle600(), {}, {});
  const auto record = test::cutAt(0.5, test::recordOf(job, scratch), scratch);
  ProfileFiles files;
  EXPECT_FALSE(files.lastOpened());
  files.open(record);
  ASSERT_TRUE(comesToRest(files));
  files.open(scratch / "missing.csv"); // changes nothing
  ASSERT_TRUE(comesToRest(files));
  ASSERT_TRUE(files.lastOpened());
  EXPECT_EQ(files.lastOpened()->file, record);
  EXPECT_EQ(files.lastOpened()->curves->name.toStdString(), record.filename());
  EXPECT_EQ(files.lastOpened()->damage.size(), 1U);
  files.close();
  EXPECT_FALSE(files.lastOpened());
}

TEST(ProfileFiles, SayWhyTheyCannotBeWritten) {
  const test::Scratch scratch;
  ProfileFiles files;
  QSignalSpy failed(&files, &ProfileFiles::failed);
  files.save(scratch / "no folder" / "picture.svg", "a picture");
  ASSERT_TRUE(comesToRest(files));
  ASSERT_EQ(failed.count(), 1);
  EXPECT_EQ(failed[0][0].value<base::Problem>().code, base::Code::CannotWrite);
}

} // namespace
} // namespace arris::ui
