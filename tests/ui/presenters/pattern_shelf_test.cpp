#include "core/files/whole_file.h"
#include "tests/support/scratch.h"
#include "tests/ui/support/steps.h"
#include "ui/presenters/pattern_shelf.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>

#include <gmock/gmock.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

namespace arris::ui {
namespace {

namespace fs = std::filesystem;

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> entryNames(const ShelfListing& listing) {
  std::vector<std::string> names;
  for (const ShelfEntry& entry : listing.entries) {
    names.push_back(entry.path.filename().string() + (entry.isFolder ? "/" : ""));
  }
  return names;
}

std::string contentOf(const fs::path& file) {
  return files::readFile(file).value_or("");
}

void makeEmpty(const fs::path& file) {
  std::ofstream stream(file);
}

bool isLookDone(const PatternShelf& shelf) {
  return QTest::qWaitFor([&] { return !shelf.isReading(); }, test::kPatience);
}

base::Code onlyProblemOf(const PatternShelf& shelf) {
  EXPECT_EQ(shelf.preview()->drawing.problems.size(), 1U);
  return shelf.preview()->drawing.problems.front().code;
}

class OnTheShelf : public testing::Test {
protected:
  OnTheShelf() : m_state{m_scratch / "state"} {
    fs::create_directory(m_scratch / "drawings");
  }

  fs::path drawing(const char* name) {
    fs::path file = m_scratch / "drawings" / name;
    makeEmpty(file);
    return file;
  }

  static ShelfListing await(PatternShelf& shelf, const std::function<void()>& act) {
    QSignalSpy listed(&shelf, &PatternShelf::listed);
    act();
    EXPECT_TRUE(listed.isEmpty()); // nothing happened in the caller's time
    EXPECT_TRUE(listed.wait(test::kPatience));
    return shelf.listing();
  }

  test::Scratch m_scratch;
  files::StateFolder m_state;
};

TEST_F(OnTheShelf, LeavesOutRecentPatternsThatAreGone) {
  PatternShelf shelf(m_state, test::paneSteps().read);
  const fs::path one = drawing("one.dxf");
  const fs::path two = drawing("two.dxf");
  const fs::path three = drawing("three.dxf");
  fs::remove(two);
  const std::vector<std::string> recent{three.string(), two.string(), (m_scratch / "drawings").string(), one.string()};
  EXPECT_THAT(entryNames(await(shelf, [&] { shelf.begin(recent, {}); })), ElementsAre("three.dxf", "one.dxf"));
}

TEST_F(OnTheShelf, ListsFoldersAndDrawingsByNameAndNothingElse) {
  PatternShelf shelf(m_state, test::paneSteps().read);
  for (const char* name : {"b.dxf", "A.DXF", "letter.txt", ".hidden.dxf"}) {
    drawing(name);
  }
  fs::create_directory(m_scratch / "drawings" / "order 7");
  const ShelfListing listing = await(shelf, [&] { shelf.showFolder(m_scratch / "drawings"); });
  EXPECT_THAT(entryNames(listing), ElementsAre("order 7/", "A.DXF", "b.dxf"));
  EXPECT_FALSE(listing.problem);
}

TEST_F(OnTheShelf, GoesUpAndShowsWhereItComesFrom) {
  PatternShelf shelf(m_state, test::paneSteps().read);
  await(shelf, [&] { shelf.showFolder(m_scratch / "drawings"); });
  const ShelfListing listing = await(shelf, [&] { shelf.goUp(); });
  EXPECT_EQ(listing.folder / "drawings", m_scratch / "drawings");
  EXPECT_EQ(listing.chosen, m_scratch / "drawings");
}

TEST_F(OnTheShelf, FindsAFileThatIsTypedWhateverItIsCalled) {
  PatternShelf shelf(m_state, test::paneSteps().read);
  drawing("a.dxf");
  const fs::path typed = drawing("drawing.txt");
  const ShelfListing listing = await(shelf, [&] { shelf.showFolder(typed); });
  EXPECT_EQ(listing.chosen, typed);
  EXPECT_THAT(entryNames(listing), ElementsAre("a.dxf", "drawing.txt"));
}

TEST_F(OnTheShelf, SaysThatAFolderIsNotThereAndBeginsNextTimeWhereOneWas) {
  PatternShelf shelf(m_state, test::paneSteps().read);
  await(shelf, [&] { shelf.showFolder(m_scratch / "drawings"); });
  const ShelfListing listing = await(shelf, [&] { shelf.showFolder(m_scratch / "nowhere"); });
  ASSERT_TRUE(listing.problem);
  EXPECT_EQ(listing.problem->code, base::Code::CannotOpen);
  EXPECT_THAT(listing.entries, IsEmpty());
  EXPECT_EQ(await(shelf, [&] { shelf.begin({}, {}); }).folder, m_scratch / "drawings");
}

TEST_F(OnTheShelf, BeginsInTheFolderOfTheLastPatternUnlessThatIsASample) {
  PatternShelf shelf(m_state, test::paneSteps().read);
  shelf.noteOpened(drawing("a.dxf"));
  shelf.noteOpened(m_state.samples() / "balustrade.dxf");
  EXPECT_EQ(await(shelf, [&] { shelf.showList(ShelfList::Folder); }).folder, m_scratch / "drawings");
}

TEST_F(OnTheShelf, ReadsAPatternInTheBackgroundWithTheOptionsOfTheJob) {
  pattern::ImportOptions seen;
  PatternShelf shelf(m_state,
                     [&](const fs::path& file, const pattern::ImportOptions& options, const base::Monitor& monitor) {
                       seen = options;
                       return test::paneSteps().read(file, options, monitor);
                     });
  pattern::ImportOptions options;
  options.gap = 0.25;
  shelf.begin({}, options);
  shelf.look("triangle.dxf");
  EXPECT_TRUE(shelf.isReading());
  EXPECT_FALSE(shelf.preview());
  ASSERT_TRUE(isLookDone(shelf));
  EXPECT_EQ(seen, options);
  EXPECT_EQ(shelf.preview()->drawing.contours.size(), 1U);
  EXPECT_TRUE(shelf.canChoose());
}

TEST_F(OnTheShelf, LetsTheLatestLookWinAndReadsNothingThatWasOvertaken) {
  QSemaphore mayRead;
  std::atomic<int> readings = 0;
  PatternShelf shelf(m_state,
                     [&](const fs::path& file, const pattern::ImportOptions& options, const base::Monitor& monitor) {
                       ++readings;
                       mayRead.acquire();
                       return test::paneSteps().read(file, options, monitor);
                     });
  QSignalSpy changed(&shelf, &PatternShelf::lookChanged);
  shelf.look("triangle.dxf");
  ASSERT_TRUE(QTest::qWaitFor([&] { return readings == 1; }, test::kPatience));
  shelf.look("outside.dxf");
  shelf.look("rectangle.dxf");
  mayRead.release(10);
  ASSERT_TRUE(isLookDone(shelf));
  EXPECT_EQ(readings, 2);        // the first and the last
  EXPECT_EQ(changed.count(), 4); // three looks, one answer
  EXPECT_EQ(shelf.preview()->import->file, "rectangle.dxf");
}

TEST_F(OnTheShelf, DropsAnAnswerOnceItLooksAway) {
  QSemaphore mayRead;
  std::atomic<int> readings = 0;
  PatternShelf shelf(m_state,
                     [&](const fs::path& file, const pattern::ImportOptions& options, const base::Monitor& monitor) {
                       ++readings;
                       mayRead.acquire();
                       return test::paneSteps().read(file, options, monitor);
                     });
  QSignalSpy chosen(&shelf, &PatternShelf::chosen);
  shelf.look("triangle.dxf");
  shelf.choose();
  ASSERT_TRUE(QTest::qWaitFor([&] { return readings == 1; }, test::kPatience));
  shelf.lookAway();
  shelf.look("rectangle.dxf");
  mayRead.release(10);
  ASSERT_TRUE(isLookDone(shelf));
  EXPECT_TRUE(chosen.isEmpty());
}

TEST_F(OnTheShelf, ChoosesWhatIsStillBeingReadOnceItIsSeenThatItCanBeOpened) {
  PatternShelf shelf(m_state, test::paneSteps().read);
  QSignalSpy chosen(&shelf, &PatternShelf::chosen);
  shelf.look("missing.dxf");
  shelf.choose();
  ASSERT_TRUE(isLookDone(shelf));
  EXPECT_TRUE(chosen.isEmpty());
  shelf.look("triangle.dxf");
  shelf.choose();
  EXPECT_TRUE(chosen.isEmpty());
  ASSERT_TRUE(isLookDone(shelf));
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].value<fs::path>(), "triangle.dxf");
}

TEST_F(OnTheShelf, SaysWhatIsWrongWithAFileAndDoesNotOpenIt) {
  std::ofstream(drawing("binary.dxf")) << std::string(5000, '\x07') + std::string(5000, '\0');
  std::ofstream(drawing("letter.dxf")) << "Dear customer,\nthe panes are ready.\n";
  fs::create_directory(m_scratch / "drawings" / "folder.dxf");
  const fs::path huge = drawing("huge.dxf");
  fs::resize_file(huge, files::kLargestFile + 1); // takes no room on the disk
  const std::vector<std::pair<fs::path, base::Code>> cases{
      {drawing("empty.dxf"), base::Code::DxfEmpty},
      {m_scratch / "drawings" / "binary.dxf", base::Code::DxfNotDxf},
      {m_scratch / "drawings" / "letter.dxf", base::Code::DxfNotDxf},
      {m_scratch / "drawings" / "folder.dxf", base::Code::CannotRead},
      {m_scratch / "drawings" / "missing.dxf", base::Code::CannotOpen},
      {huge, base::Code::CannotRead}};
  PatternShelf shelf(m_state);
  QSignalSpy chosen(&shelf, &PatternShelf::chosen);
  for (const auto& [file, code] : cases) {
    shelf.look(file);
    ASSERT_TRUE(isLookDone(shelf));
    EXPECT_EQ(onlyProblemOf(shelf), code) << file;
    EXPECT_FALSE(shelf.canChoose()) << file;
    shelf.choose();
  }
  EXPECT_TRUE(chosen.isEmpty());
}

TEST_F(OnTheShelf, SaysThatAFileMayNotBeRead) {
  if (geteuid() == 0) {
    GTEST_SKIP() << "the superuser may read every file";
  }
  const fs::path file = drawing("locked.dxf");
  fs::permissions(file, fs::perms::none);
  PatternShelf shelf(m_state);
  shelf.look(file);
  ASSERT_TRUE(isLookDone(shelf));
  EXPECT_EQ(onlyProblemOf(shelf), base::Code::CannotOpen);
}

// A large file would keep the next one waiting.
TEST_F(OnTheShelf, BreaksOffTheReadingThatWasOvertaken) {
  std::atomic<bool> begun = false;
  PatternShelf shelf(m_state,
                     [&](const fs::path& file, const pattern::ImportOptions& options, const base::Monitor& monitor) {
                       begun = true;
                       while (file.stem() == "triangle" && !monitor.stop.stop_requested()) { // read for ever otherwise
                         std::this_thread::yield();
                       }
                       return test::paneSteps().read(file, options, monitor);
                     });
  shelf.look("triangle.dxf");
  ASSERT_TRUE(QTest::qWaitFor([&] { return begun.load(); }, test::kPatience));
  shelf.look("rectangle.dxf");
  ASSERT_TRUE(isLookDone(shelf));
  EXPECT_EQ(shelf.preview()->import->file, "rectangle.dxf");
}

TEST_F(OnTheShelf, UnpacksTheSamplesOnceAndKeepsWhatTheOperatorChanged) {
  PatternShelf shelf(m_state, test::paneSteps().read);
  EXPECT_FALSE(fs::exists(m_state.samples())); // not before they are asked for
  const auto ask = [&] { return entryNames(await(shelf, [&] { shelf.showList(ShelfList::Samples); })); };
  const auto all = ElementsAre("arcs.dxf", "balustrade.dxf", "rectangle.dxf", "splashback.dxf", "triangle.dxf");
  EXPECT_THAT(ask(), all);
  const fs::path source(ARRIS_SOURCE_DIR "/resources/samples");
  for (const fs::directory_entry& sample : fs::directory_iterator(m_state.samples())) {
    EXPECT_EQ(contentOf(sample), contentOf(source / sample.path().filename())) << sample.path();
  }
  std::ofstream(m_state.samples() / "arcs.dxf") << "changed";
  fs::remove(m_state.samples() / "triangle.dxf");
  EXPECT_THAT(ask(), all);
  EXPECT_EQ(contentOf(m_state.samples() / "arcs.dxf"), "changed");
  EXPECT_EQ(contentOf(m_state.samples() / "triangle.dxf"), contentOf(source / "triangle.dxf"));
}

TEST_F(OnTheShelf, SaysThatSamplesCannotBeWritten) {
  makeEmpty(m_state.root); // a file where the folder should be
  PatternShelf shelf(m_state, test::paneSteps().read);
  const ShelfListing listing = await(shelf, [&] { shelf.showList(ShelfList::Samples); });
  ASSERT_TRUE(listing.problem);
  EXPECT_EQ(listing.problem->code, base::Code::CannotWrite);
  EXPECT_THAT(listing.entries, IsEmpty());
  EXPECT_FALSE(firstSample(m_state));
}

TEST_F(OnTheShelf, CanReadEverySampleAndGrindTheFirstAsAProgramBegins) {
  const ShelfListing samples = listSamples(m_state);
  ASSERT_FALSE(samples.entries.empty());
  for (const ShelfEntry& sample : samples.entries) {
    const auto import = plannerSteps().read(sample.path, pattern::importOptions({}), {});
    ASSERT_TRUE(import) << sample.path;
    EXPECT_FALSE(base::hasErrors(import->pattern.problems)) << sample.path;
    EXPECT_FALSE(import->pattern.contours.empty()) << sample.path;
  }
  const auto first = plannerSteps().read(firstSample(m_state).value(), pattern::importOptions({}), {});
  ASSERT_TRUE(first);
  EXPECT_TRUE(plannerSteps().plan(first->pattern, {}, {}, {}).canBeGround());
}

} // namespace
} // namespace arris::ui
