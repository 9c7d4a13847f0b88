#include "ui/widgets/number_edit.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace arris::ui {
namespace {

const NumberSpec kWheelRadius{"wheel_radius_mm", "Wheel radius", "mm", 0.5, 500};

TEST(NumberEdit, ShowsAnotherValueWithoutSayingThatItHasChanged) {
  NumberEdit edit(kWheelRadius, 75);
  const QSignalSpy changed(&edit, &NumberEdit::valueChanged);
  edit.setValue(60.5);
  EXPECT_EQ(edit.line()->text(), "60.5");
  EXPECT_DOUBLE_EQ(edit.value(), 60.5);
  EXPECT_EQ(changed.count(), 0);
}

TEST(NumberEdit, PutsAGoodValueInPlaceOfAWrongText) {
  NumberEdit edit(kWheelRadius, 75);
  edit.line()->setText("700");
  ASSERT_FALSE(edit.complaint().isEmpty());
  const QSignalSpy complaints(&edit, &NumberEdit::complaintChanged);
  edit.setValue(75); // the last good one
  EXPECT_EQ(edit.line()->text(), "75");
  EXPECT_TRUE(edit.complaint().isEmpty());
  EXPECT_EQ(complaints.count(), 1);
}

// The echo of what is typed must not disturb the typing.
TEST(NumberEdit, LeavesATextThatMeansTheValueAlready) {
  NumberEdit edit(kWheelRadius, 75);
  edit.line()->setText("60.");
  ASSERT_DOUBLE_EQ(edit.value(), 60);
  edit.setValue(60);
  EXPECT_EQ(edit.line()->text(), "60.");
}

} // namespace
} // namespace arris::ui
