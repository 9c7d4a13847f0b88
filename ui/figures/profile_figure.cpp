#include "ui/figures/profile_figure.h"

#include "ui/figures/profile_plot.h"
#include "ui/text/quantities.h"

#include <QCoreApplication>

#include <algorithm>

namespace arris::ui {
namespace {

// In units of figures.
constexpr double kMargin = 90;
constexpr double kHeadingHeight = 50;
constexpr double kRowHeight = 38;
constexpr double kSampleLength = 80;
constexpr double kLegendGap = 40;

class ProfilePage {
  Q_DECLARE_TR_FUNCTIONS(ProfilePage)

public:
  ProfilePage(QCPPainter& painter, const QSizeF& page)
      : m_painter(painter), m_page(kMargin, kMargin, page.width() - 2 * kMargin, page.height() - 2 * kMargin) {}

  void paint(const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits, const QString& heading,
             const QString& subheading);
  static QString subheading(const job::Job& job);

private:
  void paintHeading(const QString& heading, const QString& subheading);
  void paintLegend(const std::vector<ProfileCurves>& profiles);
  void paintEntry(double& x, const QString& words, const std::function<void(const QRectF&)>& sample);
  void paintPlot(const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits);

  QCPPainter& m_painter;
  QRectF m_page;
  FigureStyle m_style;
};

void ProfilePage::paint(const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits, const QString& heading,
                        const QString& subheading) {
  paintHeading(heading, subheading);
  paintPlot(profiles, limits);
  paintLegend(profiles);
}

void ProfilePage::paintHeading(const QString& heading, const QString& subheading) {
  m_painter.setPen(m_style.palette.ink);
  m_painter.setFont(m_style.font(kTitleHeight, true));
  m_painter.drawText(m_page, Qt::AlignLeft | Qt::AlignTop | Qt::TextDontClip, heading);
  m_painter.setFont(m_style.font(kTextHeight));
  m_painter.drawText(m_page.adjusted(0, kHeadingHeight, 0, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextDontClip,
                     subheading);
}

void ProfilePage::paintPlot(const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits) {
  const QRectF area = m_page.adjusted(0, kHeadingHeight + kRowHeight, 0, -kRowHeight);
  ProfilePlot plot(m_style);
  plot.setProfiles(profiles, limits);
  plot.prepareForPrint(area.size().toSize());
  m_painter.save();
  m_painter.translate(area.topLeft());
  plot.toPainter(&m_painter, static_cast<int>(area.width()), static_cast<int>(area.height()));
  m_painter.restore();
}

void ProfilePage::paintEntry(double& x, const QString& words, const std::function<void(const QRectF&)>& sample) {
  const QRectF box(x, m_page.bottom() - kRowHeight + 6, kSampleLength, kRowHeight - 12);
  sample(box);
  m_painter.setPen(m_style.palette.ink);
  m_painter.setFont(m_style.font(kSmallTextHeight));
  const QRectF text(box.right() + 12, box.top(), 0, box.height());
  m_painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, words);
  x = text.left() + QFontMetricsF(m_painter.font()).horizontalAdvance(words) + kLegendGap;
}

void ProfilePage::paintLegend(const std::vector<ProfileCurves>& profiles) {
  const auto line = [this](const QPen& pen) {
    return [this, pen](const QRectF& box) {
      m_painter.setPen(pen);
      m_painter.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
    };
  };
  const auto band = [this](const QColor& color, bool edges) {
    return [this, color, edges](const QRectF& box) {
      m_painter.fillRect(box, color);
      if (edges) {
        m_painter.setPen(m_style.pen(m_style.palette.transition, kThinLine));
        m_painter.drawLine(box.topLeft(), box.bottomLeft());
        m_painter.drawLine(box.topRight(), box.bottomRight());
      }
    };
  };
  double x = m_page.left();
  if (profiles.size() > 1) {
    paintEntry(x, profiles[0].name, line(overlaidPen(m_style, m_style.palette.speed)));
    paintEntry(x, profiles[1].name, line(m_style.pen(m_style.palette.speed, kLine + 0.5)));
  }
  paintEntry(x, tr("Corner with its angle: from A to C"), band(m_style.palette.cornerBand, true));
  paintEntry(x, tr("Braking before, accelerating after"), band(m_style.palette.phaseBand, false));
  const std::vector<CornerBand> bands = profiles.empty() ? std::vector<CornerBand>() : profiles.front().bands;
  if (std::any_of(bands.begin(), bands.end(), [](const CornerBand& b) { return b.zone == Zone::Away; })) {
    paintEntry(x, tr("Between contours"), band(m_style.palette.awayBand, false));
  }
  paintEntry(x, tr("Limit, feed, wheel radius R"), line(limitPen(m_style)));
  paintEntry(x, tr("R + depth at the tip"), line(reliefPen(m_style)));
}

QString ProfilePage::subheading(const job::Job& job) {
  const QLocale c = QLocale::c();
  return tr("Work %1 of %2 · wheel R %3 mm · feed %4 mm/min · acceleration X %5, Y %6 mm/s²")
      .arg(durationText(job.working, c), durationText(job.duration, c), numberText(job.recipe.wheelRadius, 3, c),
           numberText(job.recipe.feed, 1, c), numberText(job.recipe.accelX, 2, c), numberText(job.recipe.accelY, 2, c));
}

} // namespace

Figure profileFigure(const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits, const QString& heading,
                     const QString& subheading) {
  Figure figure;
  figure.title = heading;
  figure.paint = [=, page = figure.page](QCPPainter& painter) {
    ProfilePage(painter, page).paint(profiles, limits, heading, subheading);
  };
  return figure;
}

Figure profileFigure(const job::Job& job, const QString& file) {
  return profileFigure({curvesOf(columnsOf(job), QString())}, limitsOf(job), file, ProfilePage::subheading(job));
}

} // namespace arris::ui
