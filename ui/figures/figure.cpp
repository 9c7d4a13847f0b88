#include "ui/figures/figure.h"

#include "core/base/window_thread.h"
#include "core/files/whole_file.h"

#include <QBuffer>
#include <QImage>
#include <QMarginsF>
#include <QPageLayout>
#include <QPageSize>
#include <QPdfWriter>
#include <QPicture>
#include <QRegularExpression>
#include <QSvgGenerator>
#include <qcustomplot.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <string>

namespace arris::ui {
namespace {

constexpr double kUnitsPerInch = 25.4 * kUnitsPerMillimetre;
constexpr int kPngDotsPerInch = 200;
constexpr int kPdfDotsPerInch = 1200;

void prepare(QCPPainter& painter, bool vector) {
  painter.setMode(QCPPainter::pmVectorized, vector);
  painter.setMode(QCPPainter::pmNoCaching);
  painter.setRenderHint(QPainter::Antialiasing);
}

void paintScaled(const Figure& figure, QCPPainter& painter, double dotsPerUnit, bool vector) {
  prepare(painter, vector);
  painter.scale(dotsPerUnit, dotsPerUnit);
  figure.paint(painter);
}

void paintScaled(const Figure& figure, QPaintDevice& device, double dotsPerUnit, bool vector) {
  QCPPainter painter(&device);
  paintScaled(figure, painter, dotsPerUnit, vector);
}

QByteArray asSvg(const Figure& figure) {
  QBuffer buffer;
  QSvgGenerator svg;
  svg.setOutputDevice(&buffer);
  svg.setTitle(figure.title);
  svg.setDescription(QStringLiteral("Arris"));
  svg.setResolution(static_cast<int>(kUnitsPerInch));
  svg.setSize(figure.page.toSize());
  svg.setViewBox(QRectF(QPointF(), figure.page));
  paintScaled(figure, svg, 1, true);
  return buffer.data();
}

// Qt stamps the time of writing into the file; the bytes of a figure must not depend on it. The length stays, because
// the file holds a table of byte offsets.
QByteArray withoutDate(QByteArray pdf) {
  static const QByteArray kKey = "/CreationDate (";
  const qsizetype key = pdf.indexOf(kKey);
  const qsizetype end = pdf.indexOf(')', key);
  if (key >= 0 && end >= 0) {
    QByteArray date = "D:20000101000000Z";
    const qsizetype start = key + kKey.size();
    date = date.leftJustified(end - start, ' ', true);
    pdf.replace(start, date.size(), date);
  }
  return pdf;
}

QPageLayout a4(const Figure& figure) {
  const bool lying = figure.page.width() > figure.page.height();
  return {QPageSize(QPageSize::A4), lying ? QPageLayout::Landscape : QPageLayout::Portrait, QMarginsF()};
}

QByteArray asPng(const Figure& figure) {
  const double dotsPerUnit = kPngDotsPerInch / kUnitsPerInch;
  QImage image((figure.page * dotsPerUnit).toSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  image.setDotsPerMeterX(static_cast<int>(std::lround(kPngDotsPerInch / 0.0254)));
  image.setDotsPerMeterY(image.dotsPerMeterX());
  paintScaled(figure, image, dotsPerUnit, false);
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return buffer.data();
}

} // namespace

QByteArray encodedPdf(const std::vector<Figure>& pages) {
  base::takesLong("encodedPdf");
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter pdf(&buffer);
  pdf.setTitle(pages.front().title);
  pdf.setCreator(QStringLiteral("Arris"));
  pdf.setResolution(kPdfDotsPerInch);
  pdf.setPageLayout(a4(pages.front()));
  QCPPainter painter(&pdf);
  for (const Figure& page : pages) {
    if (&page != &pages.front()) {
      pdf.setPageLayout(a4(page));
      pdf.newPage();
    }
    painter.save();
    paintScaled(page, painter, kPdfDotsPerInch / kUnitsPerInch, true);
    painter.restore();
  }
  painter.end();
  return withoutDate(buffer.data());
}

std::optional<FigureFormat> figureFormat(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".svg") {
    return FigureFormat::Svg;
  }
  if (ending == ".pdf") {
    return FigureFormat::Pdf;
  }
  if (ending == ".png") {
    return FigureFormat::Png;
  }
  return std::nullopt;
}

QByteArray encoded(const Figure& figure, FigureFormat format) {
  base::takesLong("encoded");
  switch (format) {
  case FigureFormat::Svg:
    return asSvg(figure);
  case FigureFormat::Pdf:
    return encodedPdf({figure});
  case FigureFormat::Png:
    return asPng(figure);
  }
  return {};
}

Figure recorded(const Figure& figure, FigureFormat format) {
  auto picture = std::make_shared<QPicture>();
  QCPPainter painter(picture.get());
  prepare(painter, format != FigureFormat::Png);
  figure.paint(painter);
  painter.end();
  Figure result = figure;
  result.paint = [picture](QCPPainter& onto) { picture->play(&onto); };
  return result;
}

base::Expected<FigureFormat> formatFor(const std::filesystem::path& file) {
  if (const std::optional<FigureFormat> format = figureFormat(file)) {
    return *format;
  }
  return base::Unexpected(base::Problem(base::Code::ValueNotAChoice, {{"name", "The ending of " + file.string()},
                                                                      {"value", file.extension().string()},
                                                                      {"choices", ".svg, .pdf, .png"}}));
}

base::Expected<QByteArray> encodedFor(const Figure& figure, const std::filesystem::path& file) {
  return formatFor(file).map([&](FigureFormat format) { return encoded(figure, format); });
}

base::Expected<void> renderToFile(const Figure& figure, const std::filesystem::path& file) {
  return encodedFor(figure, file).and_then([&](const QByteArray& bytes) {
    return files::writeWholeFile(file, bytes.toStdString());
  });
}

} // namespace arris::ui
