#include "tests/support/scratch.h"
#include "tests/ui/support/locales.h"
#include "ui/text/problem_texts.h"
#include "ui/text/translators.h"

#include <QCoreApplication>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace arris::ui {
namespace {

const QString kRoot = QStringLiteral(ARRIS_SOURCE_DIR "/");

QByteArray bytesOf(const QString& file) {
  QFile opened(file);
  EXPECT_TRUE(opened.open(QIODevice::ReadOnly)) << file.toStdString();
  return opened.readAll();
}

QString listOf(const std::string& language) {
  return kRoot + QString::fromStdString("translations/arris_" + language + ".ts");
}

// What a translation must repeat: places for values, tags, line ends, and the mark of a key.
QStringList marksOf(const QString& text) {
  static const QRegularExpression kMark(QStringLiteral(R"(%\d|\{\w*\}|<[^>]+>|\n|&)"));
  QStringList marks;
  for (auto match = kMark.globalMatch(text); match.hasNext();) {
    marks += match.next().captured();
  }
  marks.sort();
  return marks;
}

class Translation : public testing::TestWithParam<std::string> {};

TEST_P(Translation, IsFinishedAndKeepsThePlaceholders) {
  QXmlStreamReader xml(bytesOf(listOf(GetParam())));
  QString source;
  int count = 0;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) {
      continue;
    }
    if (xml.name() == QStringLiteral("source")) {
      source = xml.readElementText();
    } else if (xml.name() == QStringLiteral("translation")) {
      EXPECT_FALSE(xml.attributes().hasAttribute(QStringLiteral("type"))) << "unfinished: " << source.toStdString();
      const QString text = xml.readElementText();
      EXPECT_FALSE(text.isEmpty()) << source.toStdString();
      EXPECT_EQ(marksOf(text), marksOf(source)) << text.toStdString();
      ++count;
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  EXPECT_GT(count, 200);
}

TEST_P(Translation, ListsTheTextsOfTheSources) {
  const test::Scratch scratch;
  const QString copy = QString::fromStdString((scratch / "copy.ts").string());
  ASSERT_TRUE(QFile::copy(listOf(GetParam()), copy));
  QProcess lupdate;
  lupdate.start(QStringLiteral(ARRIS_LUPDATE),
                {kRoot + "ui", "-I", kRoot, "-no-obsolete", "-locations", "none", "-ts", copy});
  ASSERT_TRUE(lupdate.waitForFinished());
  ASSERT_EQ(lupdate.exitCode(), 0) << lupdate.readAllStandardError().toStdString();
  EXPECT_TRUE(bytesOf(copy) == bytesOf(listOf(GetParam())))
      << "build the target update_translations and translate what it adds:\n"
      << lupdate.readAllStandardOutput().toStdString();
}

INSTANTIATE_TEST_SUITE_P(Languages, Translation, testing::ValuesIn(test::languages()),
                         [](const auto& tested) { return tested.param; });

TEST(Translators, AreThoseOfTheFirstLanguageThatTheWindowSpeaks) {
  const auto wordFor = [](const QStringList& languages) {
    const auto translators = installTranslators(languages);
    return QCoreApplication::translate("Recipe", "Feed");
  };
  EXPECT_EQ(wordFor({"de-DE", "de"}), "Vorschub");
  EXPECT_EQ(wordFor({"fr-FR", "fr", "de-CH"}), "Vorschub");
  EXPECT_EQ(wordFor({"it-IT", "it"}), "Avanzamento");
  EXPECT_EQ(wordFor({"zh-Hans-CN", "zh-CN", "zh"}), QStringLiteral("进给速度"));
  EXPECT_EQ(wordFor({"en-GB", "en", "de"}), "Feed");
  EXPECT_EQ(wordFor({"fr-FR", "fr"}), "Feed");
  EXPECT_EQ(wordFor({"C"}), "Feed");
  EXPECT_EQ(wordFor({}), "Feed");
}

TEST(Translators, SpeakForQtToo) {
  const auto translators = installTranslators({"de"});
  EXPECT_EQ(QCoreApplication::translate("QPlatformTheme", "Cancel"), "Abbrechen");
}

TEST(ProblemTexts, TranslateTheWordsFilledIn) {
  const auto translators = installTranslators({"de"});
  const auto german = [](const base::Problem& problem) { return problemText(problem, test::kGerman).toStdString(); };
  EXPECT_EQ(german(base::Problem(base::Code::OutsideTravel,
                                 {{"what", std::string("the transition at corner 3")}, {"excess_mm", 1.5}})),
            "Die Schleifbahn verlässt den Verfahrbereich der Maschine um 1,5 mm: Übergang an Ecke 3.");
  EXPECT_EQ(german(base::Problem(base::Code::DxfSection,
                                 {{"reason", std::string("the POLYLINE of line 7 has no SEQEND before LINE")}})),
            "Die Abschnitte der Datei sind fehlerhaft: Die POLYLINE von Zeile 7 hat kein SEQEND vor LINE.");
  EXPECT_EQ(german(base::Problem(base::Code::CannotOpen, {{"file", std::string("a.dxf")},
                                                          {"reason", std::string("No such file or directory")}})),
            "a.dxf kann nicht geöffnet werden: Datei oder Ordner nicht gefunden.");
}

// A word that core no longer says would stay English in every language.
TEST(ProblemTexts, KnowTheWordsAsCoreSaysThem) {
  QString core;
  for (QDirIterator files(kRoot + "core", {"*.cpp"}, QDir::Files, QDirIterator::Subdirectories); files.hasNext();) {
    core += QString::fromUtf8(bytesOf(files.next()));
  }
  for (const int error : {ENOENT, EACCES, EISDIR, EIO, EFBIG}) {
    core += QString::fromLatin1(strerrordesc_np(error));
  }
  for (const char* word : problemWords()) {
    for (const QString& part : QString::fromLatin1(word).split(QRegularExpression(R"(\{\}|(?=;)|(?=, and ))"))) {
      EXPECT_TRUE(core.contains(part)) << word;
    }
  }
}

} // namespace
} // namespace arris::ui
