#include "core/pattern/dxf_gate.h"
#include "core/pattern/pattern.h"
#include "tests/support/dxf_text.h"

#include <gtest/gtest.h>

#include <random>

namespace arris::pattern {
namespace {

using base::Code;
using test::asGroups;
using test::DxfText;
using test::lineOf;

/// A square of 100 mm as text; `extra` goes in before its last line.
std::string square(std::string_view extra = "") {
  return DxfText()
      .insUnits(4)
      .add(geometry::Line{{0, 0}, {100, 0}})
      .add(geometry::Line{{100, 0}, {100, 100}})
      .add(geometry::Line{{100, 100}, {0, 100}})
      .addGroups(extra)
      .add(geometry::Line{{0, 100}, {0, 0}})
      .text();
}

/// `text` with the first `from` replaced by `to`.
std::string with(std::string text, std::string_view from, std::string_view to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

struct Refused {
  std::string name;
  std::string text;
  Code code;
  std::optional<std::int64_t> line;
};

/// A square with one more entity that is wrong; the error is on the line where `place` stands.
Refused wrongEntity(std::string name, std::string_view groups, Code code, std::string_view place) {
  const std::string text = square(groups);
  return {std::move(name), text, code, lineOf(text, place)};
}

std::vector<Refused> notEvenDxf() {
  std::string carriageReturns = square();
  std::replace(carriageReturns.begin(), carriageReturns.end(), '\n', '\r');
  std::string nul = square("0 TEXT\n1 NUL?");
  nul[nul.find('?')] = '\0';
  return {
      {"nothing", "", Code::DxfEmpty, {}},
      {"blanks", " \n\r\n\t\n", Code::DxfEmpty, {}},
      {"binary cut off", "AutoCAD Binary DXF\r\n\x1a", Code::DxfBinary, {}},
      {"dwg", "AC1027 and so on", Code::DxfNotDxf, {}},
      {"utf16",
       std::string("\xFF\xFE"
                   "0\0\n\0",
                   6),
       Code::DxfNotDxf,
       {}},
      {"prose", "Dear Sir,\nplease find\n", Code::DxfNotDxf, 1},
      {"carriage returns alone", carriageReturns, Code::DxfLineEnds, 1},
      {"nul byte", nul, Code::DxfNotDxf, lineOf(nul, "NUL")},
  };
}

std::vector<Refused> brokenGroups() {
  const std::string text = square();
  const std::string blankBefore = with(text, "11\n100", "\n11\n100");
  const std::string blankAfter = with(text, "11\n100", "11\n\n100");
  return {
      {"blank line before a code", blankBefore, Code::DxfGroupCode, lineOf(text, "11\n100")},
      {"blank line before a value", blankAfter, Code::DxfNumber, lineOf(text, "11\n100") + 1},
      {"code out of range", with(text, "11\n100", "1072\n100"), Code::DxfGroupCode, lineOf(text, "11\n100")},
      {"word for a code", with(text, "11\n100", "eleven\n100"), Code::DxfGroupCode, lineOf(text, "11\n100")},
      {"line lost", with(text, "11\n100\n", "11\n"), Code::DxfEntityIncomplete, lineOf(text, "LINE")},
      {"code without value", "0\nSECTION\n2\nENTITIES\n0\n", Code::DxfTruncated, 5},
      {"comma for a point", with(text, "11\n100", "11\n100,5"), Code::DxfNumber, lineOf(text, "11\n100") + 1},
      {"not a number", with(text, "11\n100", "11\nnan"), Code::DxfNumber, lineOf(text, "11\n100") + 1},
      {"infinite", with(text, "11\n100", "11\n-inf"), Code::DxfNumber, lineOf(text, "11\n100") + 1},
      {"too large for a double", with(text, "11\n100", "11\n1e999"), Code::DxfNumber, lineOf(text, "11\n100") + 1},
      {"garbage after a number", with(text, "11\n100", "11\n100mm"), Code::DxfNumber, lineOf(text, "11\n100") + 1},
      {"absurd coordinate", with(text, "11\n100", "11\n1.1e7"), Code::DxfCoordinateAbsurd, lineOf(text, "11\n100") + 1},
      {"unit that is no number", with(text, "70\n4", "70\nmm"), Code::DxfNumber, lineOf(text, "70\n4") + 1},
  };
}

std::vector<Refused> brokenSections() {
  const std::string text = square();
  const std::string noEndsec = with(text, "0\nENDSEC\n0\nEOF\n", "0\nEOF\n");
  const std::string twoSections = with(text, "0\nENDSEC\n0\nSECTION\n2\nENTITIES", "0\nSECTION\n2\nENTITIES");
  const std::string noName = with(text, "2\nENTITIES\n", "");
  return {
      {"no EOF", with(text, "0\nEOF\n", ""), Code::DxfTruncated, lineOf(text, "0\nEOF") - 1},
      {"no ENDSEC before EOF", noEndsec, Code::DxfSection, lineOf(noEndsec, "EOF")},
      {"no ENDSEC before SECTION", twoSections, Code::DxfSection, lineOf(twoSections, "SECTION\n2\nENTITIES")},
      {"section without a name", noName, Code::DxfSection, lineOf(text, "2\nENTITIES") + 1},
      {"ENDSEC without SECTION", with(text, "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n", ""), Code::DxfSection, 2},
      {"group outside of sections", "9\n$ACADVER\n" + text, Code::DxfSection, 2},
      {"entity outside of sections", with(text, "0\nEOF", "0\nLINE\n0\nEOF"), Code::DxfSection,
       lineOf(text, "0\nEOF") + 1},
      {"group before the first entity", with(text, "2\nENTITIES\n", "2\nENTITIES\n8\nA\n"), Code::DxfSection,
       lineOf(text, "2\nENTITIES") + 3},
  };
}

std::vector<Refused> brokenBlocks() {
  const auto withBlocks = [](std::string name, std::string_view groups, std::string_view place) {
    const std::string text = asGroups("0 SECTION\n2 BLOCKS\n" + std::string(groups) + "\n0 ENDSEC") + square();
    return Refused{std::move(name), text, Code::DxfSection, lineOf(text, place)};
  };
  return {
      withBlocks("block without an end", "0 BLOCK\n2 A\n0 BLOCK\n2 B\n0 ENDBLK", "BLOCK\n2\nB"),
      withBlocks("last block without an end", "0 BLOCK\n2 A", "ENDSEC"),
      withBlocks("end without a block", "0 ENDBLK", "ENDBLK"),
      withBlocks("entity outside of blocks", "0 CIRCLE\n10 0\n20 0\n40 1", "CIRCLE"),
      withBlocks("polyline without an end in a block", "0 BLOCK\n2 A\n0 POLYLINE\n0 VERTEX\n10 1\n20 2\n0 ENDBLK",
                 "ENDBLK"),
  };
}

std::vector<Refused> brokenEntities() {
  return {
      wrongEntity("line without its end", "0 LINE\n8 BAD\n10 1\n20 2\n11 3", Code::DxfEntityIncomplete, "LINE\n8\nBAD"),
      wrongEntity("arc without an angle", "0 ARC\n8 BAD\n10 1\n20 2\n40 3\n50 0", Code::DxfEntityIncomplete,
                  "ARC\n8\nBAD"),
      wrongEntity("circle without a radius", "0 CIRCLE\n8 BAD\n10 1\n20 2", Code::DxfEntityIncomplete,
                  "CIRCLE\n8\nBAD"),
      wrongEntity("circle of radius 0", "0 CIRCLE\n10 1\n20 2\n40 0.00", Code::DxfEntityValue, "0.00\n"),
      wrongEntity("arc of negative radius", "0 ARC\n10 1\n20 2\n40 -7\n50 0\n51 90", Code::DxfEntityValue, "-7\n"),
      wrongEntity("two entities run into one", "0 LINE\n10 1\n20 2\n11 3\n21 4\n10 777\n20 6\n11 7\n21 8",
                  Code::DxfEntityValue, "777"),
      wrongEntity("fewer vertices than announced", "0 LWPOLYLINE\n8 BAD\n90 3\n10 1\n20 2\n10 3\n20 4",
                  Code::DxfVertexCount, "LWPOLYLINE\n8\nBAD"),
      wrongEntity("a hundred million vertices announced", "0 LWPOLYLINE\n8 BAD\n90 100000000\n10 1\n20 2",
                  Code::DxfVertexCount, "LWPOLYLINE\n8\nBAD"),
      wrongEntity("two thousand million vertices announced", "0 LWPOLYLINE\n8 BAD\n90 2147483647\n10 1\n20 2",
                  Code::DxfVertexCount, "LWPOLYLINE\n8\nBAD"),
      wrongEntity("vertices announced as a negative number", "0 LWPOLYLINE\n8 BAD\n90 -1\n10 1\n20 2",
                  Code::DxfVertexCount, "LWPOLYLINE\n8\nBAD"),
      wrongEntity("vertices announced as a word", "0 LWPOLYLINE\n90 many\n10 1\n20 2", Code::DxfNumber, "many"),
      wrongEntity("vertex without Y", "0 LWPOLYLINE\n90 2\n10 1\n10 888\n20 4", Code::DxfEntityIncomplete, "888"),
      wrongEntity("last vertex without Y", "0 LWPOLYLINE\n8 BAD\n90 2\n10 1\n20 2\n10 3", Code::DxfEntityIncomplete,
                  "LWPOLYLINE\n8\nBAD"),
      wrongEntity("polyline without vertices", "0 LWPOLYLINE\n8 BAD\n90 0", Code::DxfEntityIncomplete,
                  "LWPOLYLINE\n8\nBAD"),
      wrongEntity("old polyline without vertices", "0 POLYLINE\n8 BAD\n66 1\n0 SEQEND", Code::DxfEntityIncomplete,
                  "POLYLINE\n8\nBAD"),
      wrongEntity("old polyline without an end", "0 POLYLINE\n66 1\n0 VERTEX\n10 1\n20 2\n0 CIRCLE\n10 0\n20 0\n40 1",
                  Code::DxfSection, "CIRCLE"),
      wrongEntity("vertex without a polyline", "0 VERTEX\n10 1\n20 2", Code::DxfSection, "VERTEX"),
      wrongEntity("end without a polyline", "0 SEQEND", Code::DxfSection, "SEQEND"),
      wrongEntity("number for a name", "0 123", Code::DxfSection, "123"),
      wrongEntity("spline without points", "0 SPLINE\n8 BAD\n71 3", Code::DxfEntityIncomplete, "SPLINE\n8\nBAD"),
      wrongEntity("spline with a point without Y", "0 SPLINE\n10 1\n10 888\n20 4", Code::DxfEntityIncomplete, "888"),
      wrongEntity("spline with fewer knots than announced", "0 SPLINE\n8 BAD\n72 3\n73 1\n40 0\n40 1\n10 1\n20 1",
                  Code::DxfVertexCount, "SPLINE\n8\nBAD"),
      wrongEntity("spline with fewer control points than announced", "0 SPLINE\n8 BAD\n73 2\n10 1\n20 1",
                  Code::DxfVertexCount, "SPLINE\n8\nBAD"),
      wrongEntity("spline with a thousand million fit points announced", "0 SPLINE\n8 BAD\n74 1000000000\n11 1\n21 1",
                  Code::DxfVertexCount, "SPLINE\n8\nBAD"),
      wrongEntity("ellipse without a major axis", "0 ELLIPSE\n8 BAD\n10 0\n20 0\n40 0.5", Code::DxfEntityIncomplete,
                  "ELLIPSE\n8\nBAD"),
      wrongEntity("ellipse of ratio 0", "0 ELLIPSE\n10 0\n20 0\n11 1\n21 0\n40 0.00", Code::DxfEntityValue, "0.00\n"),
      wrongEntity("insert without a name", "0 INSERT\n8 BAD\n10 0\n20 0", Code::DxfEntityIncomplete, "INSERT\n8\nBAD"),
      wrongEntity("spline with a number that is none", "0 SPLINE\n40 0.x5", Code::DxfNumber, "0.x5"),
  };
}

class Gate : public testing::TestWithParam<Refused> {};

std::string nameOf(const testing::TestParamInfo<Refused>& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(RefusesWhatIsNoDxf, Gate, testing::ValuesIn(notEvenDxf()), nameOf);
INSTANTIATE_TEST_SUITE_P(RefusesBrokenGroups, Gate, testing::ValuesIn(brokenGroups()), nameOf);
INSTANTIATE_TEST_SUITE_P(RefusesBrokenSections, Gate, testing::ValuesIn(brokenSections()), nameOf);
INSTANTIATE_TEST_SUITE_P(RefusesBrokenBlocks, Gate, testing::ValuesIn(brokenBlocks()), nameOf);
INSTANTIATE_TEST_SUITE_P(RefusesBrokenEntities, Gate, testing::ValuesIn(brokenEntities()), nameOf);

TEST_P(Gate, NamesWhatIsWrongAndItsLine) {
  const base::Expected<Inventory> found = inspectDxf(GetParam().text, std::nullopt);
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(base::info(found.error().code).name, base::info(GetParam().code).name);
  EXPECT_EQ(found.error().line, GetParam().line) << base::describeWithPlace(found.error());
  EXPECT_EQ(base::describe(found.error()).find('{'), std::string::npos) << base::describe(found.error());

  const Pattern pattern = readDxf(GetParam().text, {});
  ASSERT_EQ(pattern.problems.size(), 1U);
  EXPECT_TRUE(pattern.contours.empty());
}

bool isReadWhole(const std::string& text) {
  const Pattern pattern = readDxf(text, {});
  return !base::hasErrors(pattern.problems) && pattern.contours.size() == 1 && pattern.contours[0].curves.size() == 4;
}

std::string withCarriageReturns(std::string text) {
  for (std::size_t place = 0; (place = text.find('\n', place)) != std::string::npos; place += 2) {
    text.insert(place, "\r");
  }
  return text;
}

TEST(GateLetsThrough, WhatCadSystemsWrite) {
  const std::string text = square();
  EXPECT_TRUE(isReadWhole(text));
  EXPECT_TRUE(isReadWhole(withCarriageReturns(text))) << "CR LF";
  EXPECT_TRUE(isReadWhole("\xEF\xBB\xBF" + text)) << "byte order mark";
  EXPECT_TRUE(isReadWhole("999\nwritten by hand\n" + text)) << "comment";
  EXPECT_TRUE(isReadWhole(text + "rubbish after the end\n\n\n17")) << "rubbish after EOF";
  EXPECT_TRUE(isReadWhole(text.substr(0, text.size() - 1))) << "no line end at the end";
  EXPECT_TRUE(isReadWhole(with(text, "11\n100", " 11\n+100.0  "))) << "blanks round code and number, plus sign";
  EXPECT_TRUE(isReadWhole(with(text, "11\n100", "11\n1.0E+002"))) << "exponent";
  EXPECT_TRUE(isReadWhole(with(text, "0\nLINE\n8", "0\nLINE\n5\n\n8"))) << "empty handle";
  EXPECT_TRUE(isReadWhole(with(text, "0\nENDSEC\n0\nEOF",
                               "0\nENDSEC\n0\nSECTION\n2\nOBJECTS\n0\nX\n40\nno number\n0\n"
                               "ENDSEC\n0\nEOF")))
      << "sections that are not used are not judged";
  EXPECT_TRUE(isReadWhole(square("0 TEXT\n8 0\n40 1.#QNAN\n1 a text whose height is no number")))
      << "numbers of what is passed over are not judged";
}

TEST(GateLetsThrough, ADrawingOfEntitiesAlone) {
  const std::string text = square();
  EXPECT_TRUE(isReadWhole(text.substr(text.find("0\nSECTION\n2\nENTITIES"))));
}

TEST(GateLetsThrough, EveryEncodingOfAText) {
  const Pattern pattern = readDxf(square("0 TEXT\n8 Ma\xDF"
                                         "e\n1 Z\xFCrich"),
                                  {});
  EXPECT_FALSE(base::hasErrors(pattern.problems));
  EXPECT_TRUE(pattern.layers.contains("Maße")) << "Windows' western code page becomes UTF-8";
  EXPECT_TRUE(readDxf(square("0 TEXT\n8 图层"), {}).layers.contains("图层")) << "UTF-8 stays";
}

// A drawing cut off anywhere is never taken for the whole.
TEST(CutOffFile, IsRefusedAtEveryByteUpToItsEnd) {
  const std::string text = square("0 LWPOLYLINE\n90 2\n10 1\n20 2\n10 3\n20 4\n0 POLYLINE\n66 1\n0 VERTEX\n10 5\n20 6\n"
                                  "0 VERTEX\n10 7\n20 8\n0 SEQEND");
  ASSERT_TRUE(inspectDxf(text, std::nullopt).has_value());
  for (std::size_t size = 0; size < text.size() - 1; ++size) {
    const base::Expected<Inventory> found = inspectDxf(std::string_view(text).substr(0, size), std::nullopt);
    ASSERT_FALSE(found.has_value()) << size << ": " << text.substr(0, size);
    if (size > 0) {
      const auto lines = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size), '\n');
      ASSERT_TRUE(found.error().line.has_value()) << size;
      EXPECT_LE(*found.error().line, lines);
    }
  }
}

TEST(LostLine, NeverGoesUnnoticedInAnEntity) {
  const std::string text = square();
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin) + 1;
    lines.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  const auto first = static_cast<std::size_t>(lineOf(text, "LINE")) - 2;
  for (std::size_t lost = first; lost < lines.size(); ++lost) {
    std::string rest;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      rest += i == lost ? "" : lines[i];
    }
    EXPECT_TRUE(base::hasErrors(readDxf(rest, {}).problems)) << "line " << lost + 1 << " lost: " << lines[lost];
  }
}

TEST(CorruptFile, NeverDoesMoreThanGetRefused) {
  const std::string text = DxfText()
                               .insUnits(4)
                               .layer("OFF", -7, 0)
                               .add(geometry::Line{{0, 0}, {100, 0}})
                               .add(geometry::arcAbout({100, 50}, 50, -1.5, 3))
                               .add(geometry::arcAbout({30, 30}, 10, 0, 6.283185307179586))
                               .addGroups("0 LWPOLYLINE\n90 3\n70 1\n10 1\n20 2\n42 0.5\n10 3\n20 4\n10 5\n20 9")
                               .addGroups("0 POLYLINE\n66 1\n70 1\n0 VERTEX\n10 5\n20 6\n42 1\n0 VERTEX\n10 7\n20 8\n"
                                          "0 SEQEND\n0 TEXT\n1 text\n0 ELLIPSE\n10 0\n20 5\n11 9\n21 3\n40 0.4")
                               .addGroups("0 SPLINE\n71 2\n72 6\n73 3\n40 0\n40 0\n40 0\n40 1\n40 1\n40 1\n10 0\n"
                                          "20 0\n41 1\n10 9\n20 5\n41 2\n10 20\n20 0\n41 1")
                               .addBlock("B", {1, 2}, "0 ARC\n10 1\n20 2\n40 3\n50 4\n51 99\n0 INSERT\n2 C\n10 1\n20 1")
                               .addBlock("C", {0, 0}, "0 SPLINE\n74 3\n11 0\n21 0\n11 9\n21 5\n11 20\n21 0")
                               .addGroups("0 INSERT\n2 B\n10 5\n20 6\n41 2\n42 1\n50 30\n70 2\n44 9")
                               .text();
  std::mt19937 random(20240607);
  const std::string likely("0123456789.-+eE \n\r\0", 19);
  for (int round = 0; round < 4000; ++round) {
    std::string corrupt = text;
    const auto hits = 1 + random() % 4;
    for (unsigned hit = 0; hit < hits; ++hit) {
      const std::size_t place = random() % corrupt.size();
      switch (random() % 3) {
      case 0:
        corrupt[place] = static_cast<char>(random() % 256);
        break;
      case 1:
        corrupt[place] = likely[random() % likely.size()];
        break;
      default:
        corrupt.erase(place, 1 + random() % 5);
      }
    }
    const Pattern pattern = readDxf(corrupt, {});
    for (const base::Problem& problem : pattern.problems) {
      EXPECT_NE(problem.code, Code::NumericalFailure) << base::describe(problem) << "\n" << corrupt;
    }
    for (const Contour& contour : pattern.contours) {
      EXPECT_TRUE(std::isfinite(geometry::signedArea(contour.curves))) << corrupt;
    }
  }
}

TEST(AbsurdCoordinate, IsJudgedInMillimetres) {
  const std::string metres = DxfText().insUnits(6).add(geometry::Line{{0, 0}, {20000, 0}}).text();
  EXPECT_EQ(inspectDxf(metres, std::nullopt).error().code, Code::DxfCoordinateAbsurd);
  EXPECT_TRUE(inspectDxf(metres, recipe::Units::Millimetre).has_value()) << "the user says millimetres";
}

} // namespace
} // namespace arris::pattern
