// Opening and dropping patterns, good and bad ones, beside a job that is planned, loaded or running.

#include "core/files/whole_file.h"
#include "tests/support/dxf_text.h"
#include "tests/ui/support/driven_window.h"

#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

#include <fstream>

namespace arris::ui {
namespace {

namespace fs = std::filesystem;
using control::JobState;
using control::State;

/// Files that are on the disk are read as they are; any other name is that of a pane.
PlannerSteps fromDiskOrPane() {
  PlannerSteps steps = test::paneSteps();
  steps.read = [pane = steps.read](const fs::path& file, const pattern::ImportOptions& options,
                                   const base::Monitor& monitor) {
    return fs::exists(file) ? plannerSteps().read(file, options, monitor) : pane(file, options, monitor);
  };
  return steps;
}

class OpeningBeside : public test::DrivenWindow {
protected:
  OpeningBeside() : DrivenWindow(control::Pace::Simulated, fromDiskOrPane()) {
    m_window.openPattern("triangle.dxf");
    settle();
    m_triangle = m_window.planner().plan();
  }

  // Whether the window takes the drag at all.
  bool drop(const std::vector<fs::path>& files) {
    QMimeData data;
    QList<QUrl> urls;
    for (const fs::path& file : files) {
      urls.push_back(QUrl::fromLocalFile(QString::fromStdString(file.string())));
    }
    data.setUrls(urls);
    return dropData(data);
  }

  bool dropData(const QMimeData& data) {
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
    enter.setAccepted(false);
    QCoreApplication::sendEvent(&m_window, &enter);
    const bool takes = enter.isAccepted();
    if (takes) { // otherwise nothing is ever dropped
      QDropEvent dropped({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
      QCoreApplication::sendEvent(&m_window, &dropped);
      settle();
    }
    return takes;
  }

  fs::path write(const char* name, const std::string& text) {
    fs::create_directories(m_scratch / "drawings");
    fs::path file = m_scratch / "drawings" / name;
    EXPECT_TRUE(files::writeWholeFile(file, text));
    return file;
  }

  // A pane of 400 mm × 300 mm.
  fs::path writeRectangle() {
    test::DxfText text;
    text.addPolyline({geometry::Line{{0, 0}, {400, 0}}, geometry::Line{{400, 0}, {400, 300}},
                      geometry::Line{{400, 300}, {0, 300}}, geometry::Line{{0, 300}, {0, 0}}});
    return write("rectangle of the disk.dxf", text.text());
  }

  fs::path writeTooLarge() {
    fs::path file = write("huge.dxf", "");
    fs::resize_file(file, files::kLargestFile + 1); // it takes no room
    return file;
  }

  // The page Job says what is wrong with the file and shows the triangle as before.
  void expectTriangle(const fs::path& file) {
    EXPECT_EQ(m_window.planner().plan(), m_triangle) << file;
    EXPECT_EQ(m_window.windowTitle(), QStringLiteral("triangle.dxf – Arris")) << file;
    EXPECT_TRUE(label("state").contains(QString::fromStdString(file.filename().string())))
        << label("state").toStdString();
    EXPECT_TRUE(label("state").contains(QStringLiteral("cannot be"))) << label("state").toStdString();
  }

  void grindSlowly() {
    getReady();
    getOntoGlass();
  }

  PlanPointer m_triangle;
};

TEST_F(OpeningBeside, APatternThatIsDroppedIsRead) {
  EXPECT_TRUE(drop({writeRectangle()}));
  EXPECT_EQ(m_window.planner().plan()->job.toolpath.corners.size(), 4U);
  EXPECT_TRUE(m_window.planner().plan()->job.canBeGround());
}

TEST_F(OpeningBeside, AFolderThatIsDroppedLeavesTheJobAndIsExplained) {
  fs::create_directories(m_scratch / "drawings" / "order 7");
  drop({m_scratch / "drawings" / "order 7"});
  expectTriangle("order 7");
}

TEST_F(OpeningBeside, TwoFilesAreNotTaken) {
  EXPECT_FALSE(drop({writeRectangle(), "many.dxf"}));
  EXPECT_FALSE(drop({}));
  EXPECT_EQ(m_window.planner().plan(), m_triangle);
}

TEST_F(OpeningBeside, WhatIsNoFileOfThisComputerIsNotTaken) {
  QMimeData words;
  words.setText(QStringLiteral("triangle.dxf"));
  EXPECT_FALSE(dropData(words));
  QMimeData far;
  far.setUrls({QUrl(QStringLiteral("https://example.com/rectangle.dxf"))});
  EXPECT_FALSE(dropData(far));
  EXPECT_EQ(m_window.planner().plan(), m_triangle);
}

TEST_F(OpeningBeside, AFileThatCannotBeReadOrIsTooLargeLeavesTheJob) {
  m_window.openPattern("missing.dxf");
  settle();
  expectTriangle("missing.dxf");
  const fs::path huge = writeTooLarge();
  m_window.openPattern(huge);
  settle();
  expectTriangle(huge);
  find<QLineEdit>("depth_mm")->setText(QStringLiteral("0.2")); // goes on with the triangle
  settle();
  EXPECT_DOUBLE_EQ(m_window.planner().plan()->job.recipe.depth, 0.2);
  EXPECT_EQ(m_window.planner().plan()->import, m_triangle->import);
}

class BrokenBeside : public OpeningBeside, public testing::WithParamInterface<const char*> {
protected:
  fs::path broken() {
    const std::string what = GetParam();
    if (what == "empty") {
      return write("broken.dxf", "");
    }
    if (what == "noDxf") {
      return write("broken.dxf", std::string("%PDF-1.4\n\0\xff\xfe", 12));
    }
    test::DxfText text;
    text.add(geometry::Curve(geometry::Line{{0, 0}, {400, 0}}));
    const std::string whole = text.text();
    return write("broken.dxf", whole.substr(0, whole.size() / 2));
  }
};

TEST_P(BrokenBeside, ADroppedFileNeverTouchesTheJobThatRuns) {
  grindSlowly();
  const PlanPointer loaded = m_window.machine().loaded();
  ASSERT_TRUE(loaded != nullptr);
  const PlanPointer planned = m_window.planner().plan();
  drop({broken()});
  EXPECT_EQ(m_window.planner().plan(), planned);
  EXPECT_TRUE(m_window.planner().openProblem()) << "it is told";
  EXPECT_EQ(m_window.machine().loaded(), loaded);
  EXPECT_EQ(m_window.machine().jobState(), JobState::Running);
  m_window.machine().setOverride(1);
  ASSERT_TRUE(becomes(JobState::Ended));
  EXPECT_EQ(m_window.machine().loaded(), loaded);
}

INSTANTIATE_TEST_SUITE_P(Files, BrokenBeside, testing::Values("empty", "noDxf", "cutOff"),
                         [](const auto& row) { return std::string(row.param); });

TEST_F(OpeningBeside, AnotherPatternNeverTouchesTheJobThatRuns) {
  grindSlowly();
  const PlanPointer loaded = m_window.machine().loaded();
  EXPECT_TRUE(drop({writeRectangle()}));
  EXPECT_EQ(m_window.planner().plan()->job.toolpath.corners.size(), 4U);
  EXPECT_EQ(m_window.machine().loaded(), loaded);
  EXPECT_EQ(m_window.machine().jobState(), JobState::Running);
  tap("pageRun");
  EXPECT_FALSE(button("loadJob")->isEnabled());
  EXPECT_TRUE(label("revision").contains(QStringLiteral("stays as it was loaded")));
  m_window.machine().setOverride(1);
  ASSERT_TRUE(becomes(JobState::Ended));
  EXPECT_EQ(loaded->job.toolpath.corners.size(), 3U);
  tap("loadJob");
  EXPECT_EQ(m_window.machine().loaded()->job.toolpath.corners.size(), 4U);
}

TEST_F(OpeningBeside, AValueThatIsTypedNeverTouchesTheJobThatIsLoadedOrRuns) {
  getReady();
  const PlanPointer loaded = m_window.machine().loaded();
  const job::Job before = loaded->job;
  const auto type = [this](const char* field, const char* text) {
    find<QLineEdit>(field)->setText(QString::fromLatin1(text));
    settle();
  };
  type("feed_mm_min", "1800");
  EXPECT_EQ(m_window.machine().loaded(), loaded);
  EXPECT_TRUE(label("revision").contains(QStringLiteral("load the job again")));
  getOntoGlass();
  type("wheel_radius_mm", "60");
  EXPECT_EQ(m_window.machine().loaded(), loaded);
  EXPECT_EQ(m_window.machine().report().feed * 60, 3600) << "mm/min, as loaded";
  m_window.machine().setOverride(1);
  ASSERT_TRUE(becomes(JobState::Ended));
  EXPECT_EQ(loaded->job.recipe, before.recipe);
  EXPECT_DOUBLE_EQ(m_window.planner().plan()->job.recipe.wheelRadius, 60);
}

} // namespace
} // namespace arris::ui
