#include "ui/widgets/wheel_bar.h"

#include "ui/presenters/wheel_walk.h"
#include "ui/text/wheel_text.h"
#include "ui/widgets/sign_button.h"

#include <QHBoxLayout>
#include <QLabel>

namespace arris::ui {
namespace {

constexpr int kStepDelay = 400; // ms until a step that is kept pressed repeats
constexpr int kStepInterval = 80;

QString elidedLines(const QLabel& label, const QString& text) {
  QStringList lines = text.split(QLatin1Char('\n'));
  for (QString& line : lines) {
    line = label.fontMetrics().elidedText(line, Qt::ElideRight, label.contentsRect().width());
  }
  return lines.join(QLatin1Char('\n'));
}

} // namespace

WheelBar::WheelBar(WheelWalk& walk, QWidget* parent)
    : QWidget(parent), m_walk(walk),
      m_back(makeStep(QStringLiteral("◀"), QStringLiteral("wheelBack"), tr("Wheel back along its path"))),
      m_place(new QLabel),
      m_on(makeStep(QStringLiteral("▶"), QStringLiteral("wheelOn"), tr("Wheel on along its path"))) {
  m_place->setObjectName(QStringLiteral("wheelPlace"));
  m_place->setAlignment(Qt::AlignCenter);
  m_place->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // the text never pushes the window larger
  m_place->setText(QStringLiteral(" \n "));
  m_place->setFixedHeight(m_place->sizeHint().height());
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_back);
  row->addWidget(m_place, 1);
  row->addWidget(m_on);
  connect(m_back, &QPushButton::clicked, &walk, &WheelWalk::stepBack);
  connect(m_on, &QPushButton::clicked, &walk, &WheelWalk::stepOn);
  connect(&walk, &WheelWalk::changed, this, &WheelBar::showPlace);
  showPlace();
}

QPushButton* WheelBar::makeStep(const QString& text, const QString& name, const QString& what) {
  QPushButton* button = makeSignButton(text, name, what);
  button->setAutoRepeat(true);
  button->setAutoRepeatDelay(kStepDelay);
  button->setAutoRepeatInterval(kStepInterval);
  return button;
}

void WheelBar::showPlace() {
  const std::optional<job::Sample> place = m_walk.place();
  m_back->setEnabled(place && !m_walk.isAtStart());
  m_on->setEnabled(place && !m_walk.isAtEnd());
  const QString text = place ? wheelText(*place, m_walk.duration(), QLocale()) : QString();
  m_place->setText(elidedLines(*m_place, text));
  m_place->setAccessibleName(text);
}

void WheelBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layout()->activate(); // so that the text has its room already
  showPlace();
}

} // namespace arris::ui
