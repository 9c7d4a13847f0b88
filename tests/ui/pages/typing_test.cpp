// Typing numbers: every field of the window says what it takes, and what it cannot take changes nothing.

#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/locales.h"
#include "ui/text/number_input.h"
#include "ui/widgets/number_edit.h"

#include <QSignalSpy>
#include <QTest>

namespace arris::ui {
namespace {

using test::kPages;

// A triangle is loaded; its values can be typed on the pages.
class TypingWindow : public test::DrivenWindow {
protected:
  TypingWindow() {
    m_window.openPattern("triangle.dxf");
    settle();
    m_window.machine().load(m_window.planner().plan());
  }

  NumberEdit* field(const QString& name) {
    auto* line = m_window.findChild<QLineEdit*>(name);
    return line != nullptr ? qobject_cast<NumberEdit*>(line->parentWidget()) : nullptr;
  }

  static void type(const NumberEdit& field, const QString& text) {
    field.line()->selectAll();
    QTest::keyClick(field.line(), Qt::Key_Delete);
    QTest::keyClicks(field.line(), text);
  }

  // The complaint, where the page shows it in words.
  static QString shown(const NumberEdit& field) {
    for (const QLabel* label : pageOf(field)->findChildren<QLabel*>()) {
      if (!field.complaint().isEmpty() && label->text().contains(field.complaint())) {
        return label->text();
      }
    }
    return {};
  }

  static QWidget* pageOf(const NumberEdit& field) {
    QWidget* page = field.parentWidget();
    while (!page->property("page").isValid()) {
      page = page->parentWidget();
    }
    return page;
  }

  void expectNothingChangedBy(const QString& text, NumberEdit& field);

  /// Of everything that a number can be typed for.
  struct InEffect {
    recipe::Recipe recipe;
    recipe::Machine machine;
    Eigen::Vector3d origin;
    double spindle, override;
    int wanted;
    PlanPointer plan, loaded;
    bool operator==(const InEffect&) const = default;
  };

  InEffect inEffect() {
    const MachineLink& machine = m_window.machine();
    return {m_window.planner().recipe(),     m_window.preferences().nextMachine(),
            machine.report().origin,         m_window.machine().setupChoices().spindle,
            machine.report().overrideFactor, machine.order().wanted(),
            m_window.planner().plan(),       machine.loaded()};
  }
};

void TypingWindow::expectNothingChangedBy(const QString& text, NumberEdit& field) {
  settle();
  const double value = field.value();
  const InEffect before = inEffect();
  QSignalSpy changed(&field, &NumberEdit::valueChanged);
  QSignalSpy planned(&m_window.planner(), &Planner::planned);
  field.line()->setText(text); // at once: what is typed key by key may be good on the way
  const std::string what = field.spec().name.toStdString() + " with \"" + text.toStdString() + '"';
  EXPECT_FALSE(field.complaint().isEmpty()) << what;
  const bool isAmbiguous = readNumber(text, QLocale()).kind == NumberInput::Kind::Ambiguous;
  EXPECT_TRUE(isAmbiguous || field.complaint().contains(field.rangeText())) << what;
  EXPECT_FALSE(shown(field).isEmpty()) << what << " is explained nowhere on its page";
  settle();
  EXPECT_EQ(changed.count(), 0) << what;
  EXPECT_EQ(planned.count(), 0) << what;
  EXPECT_EQ(field.value(), value) << what;
  EXPECT_TRUE(inEffect() == before) << what;
}

TEST_F(TypingWindow, EveryFieldExplainsWhatItCannotTakeAndTheLastGoodValueStays) {
  const QList<NumberEdit*> fields = m_window.findChildren<NumberEdit*>();
  EXPECT_GT(fields.size(), 30);
  for (NumberEdit* field : fields) {
    const QString good = field->line()->text();
    for (const char* wrong : {"", " ", "wide", "1e3", "nan", "-", "--1", "1,234.5", "3,600", "9999999999"}) {
      expectNothingChangedBy(QString::fromUtf8(wrong), *field);
    }
    field->line()->setText(good);
    EXPECT_EQ(field->complaint(), QString()) << field->spec().name.toStdString();
  }
}

// One field a page, as it is typed key by key.
struct Typed {
  const char* page;
  const char* field;
};

constexpr Typed kTyped[] = {{"pageJob", "feed_mm_min"},
                            {"pageSetup", "spindle_by_hand_r_min"},
                            {"pageSettings", "travel_mmX"},
                            {"pageSetup", "origin_x_mm"}};

class TypingIn : public testing::WithParamInterface<std::string>, public test::Language, public TypingWindow {
protected:
  TypingIn() : Language(GetParam()) {}

  [[nodiscard]] static bool isGerman() {
    return GetParam() == "de";
  }
};

TEST_P(TypingIn, DecimalCommaAndPointMeanTheSame) {
  for (const Typed& row : kTyped) {
    NumberEdit& edit = *field(QString::fromLatin1(row.field));
    for (const char* text : {"1200,5", "1200.5"}) {
      type(edit, QStringLiteral("7"));
      type(edit, QString::fromLatin1(text));
      EXPECT_EQ(edit.complaint(), QString()) << row.field;
      EXPECT_DOUBLE_EQ(edit.value(), 1200.5) << row.field << ' ' << text;
    }
  }
  for (const char* text : {"0,25", "0.25"}) {
    type(*field(QStringLiteral("nextPaneCorrection")), QStringLiteral("0"));
    type(*field(QStringLiteral("nextPaneCorrection")), QString::fromLatin1(text));
    EXPECT_DOUBLE_EQ(m_window.planner().recipe().sizeCorrection, 0.25) << text;
  }
}

// Where the point separates thousands "1.200" may be either; where it is the decimal point it is 1.2, and "1,200" may
// be either.
TEST_P(TypingIn, ThreeDigitsAfterThePointOfThousandsAreAskedAbout) {
  const QString clear = isGerman() ? QStringLiteral("1,200") : QStringLiteral("1.200");
  const QString either = isGerman() ? QStringLiteral("1.200") : QStringLiteral("1,200");
  for (const Typed& row : kTyped) {
    NumberEdit& edit = *field(QString::fromLatin1(row.field));
    type(edit, clear);
    EXPECT_EQ(edit.complaint(), QString()) << row.field;
    EXPECT_DOUBLE_EQ(edit.value(), 1.2) << row.field;
    expectNothingChangedBy(either, edit);
    EXPECT_TRUE(shown(edit).contains(isGerman() ? QStringLiteral("1,2 ") : QStringLiteral("1.2 "))) << row.field;
    EXPECT_TRUE(shown(edit).contains(QStringLiteral("1200"))) << row.field;
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, TypingIn, testing::Values("en", "de"), [](const auto& row) { return row.param; });

TEST_F(TypingWindow, TheFieldSaysWhatIsAllowedInNumbers) {
  const auto complains = [this](const char* name, const char* text) {
    NumberEdit& edit = *field(QString::fromLatin1(name));
    edit.line()->setText(QString::fromLatin1(text));
    return shown(edit).section('\n', 0, 0).replace(QChar(QChar::Nbsp), ' ').toStdString();
  };
  EXPECT_EQ(complains("feed_mm_min", "0"), "Feed is out of range; it must be from 1 to 60000 mm/min.");
  EXPECT_EQ(complains("nextPaneCorrection", ""), "Size correction, next pane: type a number from -5 to 5 mm.");
  EXPECT_EQ(complains("origin_x_mm", "left"),
            "Zero of the table in X is not a number; type one from -1500 to 1500 mm.");
  EXPECT_EQ(complains("spindle_by_hand_r_min", "60001"),
            "Spindle speed by hand is out of range; it must be from 1 to 60000 r/min.");
}

// Override and order are set by taps alone: they end where no more is allowed.
TEST_F(TypingWindow, OverrideAndOrderEndAtWhatIsAllowed) {
  tap("pageRun");
  for (int taps = 0; taps < 20; ++taps) {
    tap("overrideUp");
    QTest::qWait(60); // until it is reported
  }
  EXPECT_EQ(label("override"), QStringLiteral("150 %"));
  for (int taps = 0; taps < 20; ++taps) {
    tap("overrideDown");
    QTest::qWait(60);
  }
  EXPECT_EQ(label("override"), QStringLiteral("10 %"));
  EXPECT_EQ(label("panesWanted"), QStringLiteral("1"));
  EXPECT_FALSE(button("panesFewer")->isEnabled());
}

} // namespace
} // namespace arris::ui
