#include "ui/widgets/corner_card.h"

#include "ui/figures/profile_plot.h"
#include "ui/figures/relief_plot.h"
#include "ui/text/job_texts.h"
#include "ui/text/quantities.h"

#include <QLabel>
#include <QResizeEvent>
#include <QVBoxLayout>

namespace arris::ui {
namespace {

constexpr int kFiguresHeight = 14;   // px
constexpr int kPlotBesideFrom = 560; // px

} // namespace

CornerCard::CornerCard(QWidget* parent)
    : QWidget(parent), m_title(new QLabel), m_reason(new QLabel), m_figures(new QLabel),
      m_relief(new ReliefPlot(screenStyle(kPlotUnit))), m_beside(new QBoxLayout(QBoxLayout::TopToBottom)) {
  QFont bold = font();
  bold.setBold(true);
  m_title->setFont(bold);
  m_title->setObjectName(QStringLiteral("cornerTitle"));
  m_figures->setObjectName(QStringLiteral("cornerFigures"));
  m_figures->setTextFormat(Qt::RichText);
  QFont smaller = font();
  smaller.setPixelSize(kFiguresHeight);
  m_figures->setFont(smaller);
  m_figures->setTextInteractionFlags(Qt::TextSelectableByMouse);
  for (QLabel* label : {m_title, m_reason, m_figures}) {
    label->setWordWrap(true);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 6, 10, 6);
  layout->setSpacing(4);
  layout->addWidget(m_title);
  m_relief->setObjectName(QStringLiteral("cornerRelief"));
  m_relief->setAccessibleName(tr("Distance between wheel and corner over time"));
  auto* words = new QVBoxLayout;
  words->setSpacing(4);
  words->addWidget(m_reason);
  words->addWidget(m_figures);
  words->addStretch(1);
  m_beside->addLayout(words, 1);
  m_beside->addWidget(m_relief, 1);
  layout->addLayout(m_beside, 1);
  show({}, 0);
}

void CornerCard::show(const PlanPointer& plan, int corner) {
  const auto corners = plan ? static_cast<int>(plan->job.toolpath.corners.size()) : 0;
  const bool known = corner >= 1 && corner <= corners;
  m_reason->setVisible(known);
  m_figures->setVisible(known);
  if (!known) {
    m_relief->hide();
    m_title->setText(corners > 0 ? tr("Tap a corner to see its figures.") : tr("No corners."));
    return;
  }
  const toolpath::Corner& c = plan->job.toolpath.corners[static_cast<std::size_t>(corner - 1)];
  const bool isTransition = c.treatment == toolpath::Treatment::Transition;
  m_relief->setVisible(isTransition);
  m_title->setText(title(plan->job, c));
  m_reason->setText(reasonText(c.reason));
  QString table = QStringLiteral("<table cellspacing='0' cellpadding='1'>");
  for (const Row& row : rowsOf(plan->job, c)) {
    table += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>").arg(row.symbol, inShownUnits(row.value));
  }
  m_figures->setText(table + QStringLiteral("</table>"));
  if (isTransition) {
    m_relief->showCorner(c, plan->job.recipe.wheelRadius);
  }
}

QString CornerCard::title(const job::Job& job, const toolpath::Corner& corner) {
  const QString words =
      tr("Corner %1: %2, %3")
          .arg(QString::number(corner.id), angleText(corner.angle, QLocale()), treatmentText(corner.treatment));
  return job.contours.size() > 1 ? words + QLatin1Char(' ') + tr("(contour %1)").arg(corner.contour) : words;
}

QString CornerCard::inShort(const job::Job& job, int corner) {
  const auto index = static_cast<std::size_t>(corner - 1);
  const toolpath::Corner& c = job.toolpath.corners.at(index);
  if (index >= job.cornerResults.size() || c.treatment == toolpath::Treatment::Stop) {
    return title(job, c);
  }
  return title(job, c) + QLatin1Char('\n') +
         inShownUnits(plannedText(job.cornerResults[index], 1, 1)).replace(QLatin1Char(' '), QChar(QChar::Nbsp));
}

QString CornerCard::plannedText(const job::CornerResult& result, int speedDecimals, int timeDecimals) {
  const QLocale locale;
  return tr("%1 mm/s; %2 s")
      .arg(fixedLengthText(result.plannedSpeed, speedDecimals, locale),
           fixedText(result.plannedTime, timeDecimals, locale));
}

void CornerCard::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool beside = event->size().width() >= kPlotBesideFrom;
  m_beside->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

std::vector<CornerCard::Row> CornerCard::rowsOf(const job::Job& job, const toolpath::Corner& corner) {
  const QLocale locale;
  const auto number = [&](double value, int decimals) { return fixedLengthText(value, decimals, locale); };
  const auto seconds = [&](double value) { return fixedText(value, 3, locale); };
  std::vector<Row> rows;
  if (corner.treatment == toolpath::Treatment::Transition) {
    rows = {
        {tr("Speed v<sub>trans</sub>"),
         tr("%1 mm/s, %2").arg(number(corner.transitionSpeed, 2), limitedByText(corner.limitedBy))},
        {tr("Blending a, t<sub>m</sub>"),
         tr("%1 mm/s²; %2 s").arg(number(corner.blendAcceleration, 4), seconds(corner.blendTime))},
        {tr("Widest, leg ℓ"), tr("%1; %2 mm").arg(number(corner.widest, 3), number(corner.leg, 3))},
        {tr("Relief"), (corner.relief ? tr("yes: lifts %1; needs %2 mm") : tr("no: lifts %1; needs %2 mm"))
                           .arg(number(corner.widest - job.recipe.wheelRadius, 3), number(corner.tipDepth, 3))},
    };
  } else if (corner.kind == toolpath::CornerKind::Concave) {
    rows = {{tr("Glass left"), tr("%1 mm before the corner").arg(number(corner.fillet, 3))},
            {tr("Not ground"), tr("%1 mm of its edges").arg(number(corner.unground, 3))}};
  } else {
    rows = {{tr("Radius of the roll"), tr("%1 mm").arg(number(corner.widest, 3))}};
  }
  const auto index = static_cast<std::size_t>(corner.id - 1);
  if (index < job.cornerResults.size()) {
    const job::CornerResult& result = job.cornerResults[index];
    if (corner.treatment != toolpath::Treatment::Stop) { // a stop has neither speed nor time
      rows.push_back({tr("Planned"), plannedText(result, 2, 3)});
    }
    rows.push_back({tr("Slowing L<sub>d</sub>, L<sub>a</sub>"),
                    tr("%1; %2 mm").arg(number(result.decelerationLength, 2), number(result.accelerationLength, 2))});
  }
  return rows;
}

} // namespace arris::ui
