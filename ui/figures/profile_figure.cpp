#include "ui/figures/profile_figure.h"

#include "ui/figures/path_plot.h"
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

  void paintHeading(const QString& heading, const QString& subheading);
  void paintProfiles(const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits, const ProfileView& view);
  void paintPath(const std::vector<ProfileCurves>& profiles, const PathSetting& setting, const PathView& view);
  static QString subheading(const job::Job& job);

private:
  using Sample = std::function<void(const QRectF&)>;

  void paintLegend(const std::vector<ProfileCurves>& profiles, PlotContent content);
  void paintPathLegend(const std::vector<ProfileCurves>& profiles, const PathSetting& setting);
  void paintNames(double& x, const std::vector<ProfileCurves>& profiles, const QColor& color);
  void paintEntry(double& x, const QString& words, const Sample& sample);
  void paintPlot(QCustomPlot& plot);
  [[nodiscard]] QRectF plotArea() const;
  [[nodiscard]] Sample lineSample(const QPen& pen);
  [[nodiscard]] Sample bandSample(const QColor& color, bool edges);

  QCPPainter& m_painter;
  QRectF m_page;
  FigureStyle m_style;
};

void ProfilePage::paintProfiles(const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits,
                                const ProfileView& view) {
  ProfilePlot plot(m_style, view.content);
  plot.setProfiles(profiles, limits);
  plot.selectCorner(view.corner);
  if (view.times) {
    plot.showTimes(view.times->first, view.times->second);
  }
  plot.prepareForPrint(plotArea().size().toSize());
  paintPlot(plot);
  paintLegend(profiles, view.content);
}

void ProfilePage::paintPath(const std::vector<ProfileCurves>& profiles, const PathSetting& setting,
                            const PathView& view) {
  PathPlot plot(m_style);
  plot.setProfiles(profiles, setting, view.wheelRadius);
  if (view.pass) {
    plot.showPass(*view.pass);
  }
  plot.showExactly(view.box);
  plot.markInstant(view.instant);
  plot.prepareForPrint(plotArea().size().toSize());
  paintPlot(plot);
  paintPathLegend(profiles, setting);
}

void ProfilePage::paintHeading(const QString& heading, const QString& subheading) {
  m_painter.setPen(m_style.palette.ink);
  m_painter.setFont(m_style.font(kTitleHeight, true));
  m_painter.drawText(m_page, Qt::AlignLeft | Qt::AlignTop | Qt::TextDontClip, heading);
  m_painter.setFont(m_style.font(kTextHeight));
  m_painter.drawText(m_page.adjusted(0, kHeadingHeight, 0, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextDontClip,
                     subheading);
}

QRectF ProfilePage::plotArea() const {
  return m_page.adjusted(0, kHeadingHeight + kRowHeight, 0, -kRowHeight);
}

void ProfilePage::paintPlot(QCustomPlot& plot) {
  const QRectF area = plotArea();
  m_painter.save();
  m_painter.translate(area.topLeft());
  plot.toPainter(&m_painter, static_cast<int>(area.width()), static_cast<int>(area.height()));
  m_painter.restore();
}

void ProfilePage::paintEntry(double& x, const QString& words, const Sample& sample) {
  const QRectF box(x, m_page.bottom() - kRowHeight + 6, kSampleLength, kRowHeight - 12);
  sample(box);
  m_painter.setPen(m_style.palette.ink);
  m_painter.setFont(m_style.font(kSmallTextHeight));
  const QRectF text(box.right() + 12, box.top(), 0, box.height());
  m_painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, words);
  x = text.left() + QFontMetricsF(m_painter.font()).horizontalAdvance(words) + kLegendGap;
}

ProfilePage::Sample ProfilePage::lineSample(const QPen& pen) {
  return [this, pen](const QRectF& box) {
    m_painter.setPen(pen);
    m_painter.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
  };
}

ProfilePage::Sample ProfilePage::bandSample(const QColor& color, bool edges) {
  return [this, color, edges](const QRectF& box) {
    m_painter.fillRect(box, color);
    if (edges) {
      m_painter.setPen(m_style.pen(m_style.palette.transition, kThinLine));
      m_painter.drawLine(box.topLeft(), box.bottomLeft());
      m_painter.drawLine(box.topRight(), box.bottomRight());
    }
  };
}

void ProfilePage::paintNames(double& x, const std::vector<ProfileCurves>& profiles, const QColor& color) {
  if (profiles.size() > 1) {
    paintEntry(x, profiles[0].name, lineSample(overlaidPen(m_style, color)));
    paintEntry(x, profiles[1].name, lineSample(m_style.pen(color, kLine + 0.5)));
  }
}

void ProfilePage::paintLegend(const std::vector<ProfileCurves>& profiles, PlotContent content) {
  double x = m_page.left();
  paintNames(x, profiles, m_style.palette.speed);
  paintEntry(x, tr("Corner with its angle: from A to C"), bandSample(m_style.palette.cornerBand, true));
  paintEntry(x, tr("Braking before, accelerating after"), bandSample(m_style.palette.phaseBand, false));
  const std::vector<CornerBand> bands = profiles.empty() ? std::vector<CornerBand>() : profiles.front().bands;
  if (std::any_of(bands.begin(), bands.end(), [](const CornerBand& b) { return b.zone == Zone::Away; })) {
    paintEntry(x, tr("Between contours"), bandSample(m_style.palette.awayBand, false));
  }
  if (content == PlotContent::Positions) {
    paintEntry(x, tr("End of the travel"), lineSample(limitPen(m_style)));
    return;
  }
  paintEntry(x, tr("Limit, feed, wheel radius R"), lineSample(limitPen(m_style)));
  paintEntry(x, tr("R + depth at the tip"), lineSample(reliefPen(m_style)));
}

void ProfilePage::paintPathLegend(const std::vector<ProfileCurves>& profiles, const PathSetting& setting) {
  double x = m_page.left();
  paintNames(x, profiles, m_style.palette.path);
  if (profiles.size() == 1) {
    paintEntry(x, tr("Way of the wheel's centre"), lineSample(m_style.pen(m_style.palette.path, kLine)));
  }
  paintEntry(x, tr("In a corner, from A to C"), lineSample(m_style.pen(m_style.palette.transition, kLine + 1)));
  if (!setting.glass.contours.empty()) {
    paintEntry(x, tr("Glass"), bandSample(m_style.palette.glass, false));
  }
}

QString ProfilePage::subheading(const job::Job& job) {
  const QLocale c = QLocale::c();
  return tr("Work %1 of %2 · wheel R %3 mm · feed %4 mm/min · acceleration X %5, Y %6 mm/s²")
      .arg(durationText(job.working, c), durationText(job.duration, c), numberText(job.recipe.wheelRadius, 3, c),
           numberText(job.recipe.feed, 1, c), numberText(job.recipe.accelX, 2, c), numberText(job.recipe.accelY, 2, c));
}

Figure pageUnder(const QString& heading, const QString& subheading,
                 const std::function<void(ProfilePage& sheet)>& paint) {
  Figure figure;
  figure.title = heading;
  figure.paint = [=, page = figure.page](QCPPainter& painter) {
    ProfilePage sheet(painter, page);
    sheet.paintHeading(heading, subheading);
    paint(sheet);
  };
  return figure;
}

} // namespace

Figure profileFigure(const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits, const QString& heading,
                     const QString& subheading, const ProfileView& view) {
  return pageUnder(heading, subheading, [=](ProfilePage& sheet) { sheet.paintProfiles(profiles, limits, view); });
}

Figure pathFigure(const std::vector<ProfileCurves>& profiles, const PathSetting& setting, const QString& heading,
                  const QString& subheading, const PathView& view) {
  return pageUnder(heading, subheading, [=](ProfilePage& sheet) { sheet.paintPath(profiles, setting, view); });
}

QString profileSubheading(const job::Job& job) {
  return ProfilePage::subheading(job);
}

Figure profileFigure(const job::Job& job, const QString& file) {
  return profileFigure({curvesOf(columnsOf(job), QString())}, limitsOf(job), file, ProfilePage::subheading(job));
}

} // namespace arris::ui
