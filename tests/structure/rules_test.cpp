#include "tests/structure/rules.h"

#include <gmock/gmock.h>

namespace arris::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<std::string> kSmallFlow{"base", "recipe", "pattern", "files"};

TEST(Flow, IsReadInItsOrder) {
  EXPECT_THAT(flowOf("x()\nforeach(folder base recipe)\n  add_subdirectory(${folder})\n"),
              ElementsAre("base", "recipe"));
}

TEST(RulesOfTheHouse, CoreIncludesNoQtInAnySpelling) {
  EXPECT_THAT(brokenRules("core/base/a.h",
                          "#include <QString>\n  #  include <qglobal.h>\n#include <QtCore/QList>\n"
                          "#include <qcustomplot.h>\n#include \"QtGui\" // why\n",
                          kSmallFlow),
              ElementsAre("core/base/a.h:1: core includes Qt", "core/base/a.h:2: core includes Qt",
                          "core/base/a.h:3: core includes Qt", "core/base/a.h:4: core includes Qt",
                          "core/base/a.h:5: core includes Qt"));
}

TEST(RulesOfTheHouse, CoreIncludesNeitherUiNorApp) {
  EXPECT_THAT(
      brokenRules("core/files/a.cpp", "#include \"ui/figures/figure.h\"\n#include \"app/options.h\"\n", kSmallFlow),
      ElementsAre("core/files/a.cpp:1: core includes ui", "core/files/a.cpp:2: core includes app"));
}

TEST(RulesOfTheHouse, AFolderOfCoreIncludesOnlyWhatStandsBeforeIt) {
  EXPECT_THAT(brokenRules("core/recipe/a.h", "#include \"core/pattern/pattern.h\"\n#include \"core/base/problem.h\"\n",
                          kSmallFlow),
              ElementsAre("core/recipe/a.h:1: core/recipe includes core/pattern, which stands after it in the flow"));
}

TEST(RulesOfTheHouse, AFolderOutsideTheFlowIsIncludedByNoneInIt) {
  EXPECT_THAT(brokenRules("core/files/a.h", "#include \"core/misc/bag.h\"\n", kSmallFlow),
              ElementsAre("core/files/a.h:1: core/files includes core/misc, which stands after it in the flow"));
}

TEST(RulesOfTheHouse, UiIncludesNoApp) {
  EXPECT_THAT(brokenRules("ui/pages/a.cpp", "#include \"app/options.h\"\n#include <QWidget>\n", kSmallFlow),
              ElementsAre("ui/pages/a.cpp:1: ui includes app"));
}

TEST(RulesOfTheHouse, OnlyUiTranslates) {
  const std::string text =
      "auto s = tr(\"x\");\nQCoreApplication::translate(\"c\", \"x\");\nauto x = str(1); // tr()\n";
  EXPECT_THAT(brokenRules("app/a.cpp", text, kSmallFlow),
              ElementsAre("app/a.cpp:1: only ui translates", "app/a.cpp:2: only ui translates"));
  EXPECT_THAT(brokenRules("core/base/a.cpp", text, kSmallFlow), testing::SizeIs(2));
  EXPECT_THAT(brokenRules("ui/a.cpp", text, kSmallFlow), IsEmpty());
  EXPECT_THAT(brokenRules("core/base/a.cpp", "placement.translate(way);\n", kSmallFlow), IsEmpty());
}

} // namespace
} // namespace arris::test
