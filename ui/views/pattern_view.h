#pragma once

#include "ui/figures/drawing.h"
#include "ui/figures/style.h"

#include <QWidget>

namespace arris::ui {

/// A drawing, whole and fitted into the view, to be looked at only; or words where there is none.
class PatternView : public QWidget {
  Q_OBJECT

public:
  explicit PatternView(QWidget* parent = nullptr);

  void showDrawing(const Drawing& drawing, const QString& words);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  Drawing m_drawing;
  QString m_words;
  FigureStyle m_style;
};

} // namespace arris::ui
