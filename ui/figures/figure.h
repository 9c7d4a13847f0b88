#pragma once

#include "core/base/problem.h"

#include <QByteArray>
#include <QSizeF>
#include <QString>

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

class QCPPainter;

namespace arris::ui {

/// Length unit of figures: 0.1 mm on paper.
inline constexpr double kUnitsPerMillimetre = 10;

inline const QSizeF kA4Portrait(2100, 2970);  ///< in units of figures
inline const QSizeF kA4Landscape(2970, 2100); ///< in units of figures

/// A page to be painted on any device. Painting needs a QGuiApplication, and a QApplication where it holds a plot.
struct Figure {
  QString title;                          ///< what SVG and PDF call themselves
  QSizeF page = kA4Landscape;             ///< 0.1 mm
  std::function<void(QCPPainter&)> paint; ///< in units of 0.1 mm from the upper left corner of the page, Y down
};

enum class FigureFormat { Svg, Pdf, Png };

/// The format that the ending of a file name asks for (.svg, .pdf, .png in any case); nothing for any other.
[[nodiscard]] std::optional<FigureFormat> figureFormat(const std::filesystem::path& file);

/// The same; ValueNotAChoice for any other ending.
[[nodiscard]] base::Expected<FigureFormat> formatFor(const std::filesystem::path& file);

/// The figure painted beforehand, to be encoded in this format. Plots are widgets, which only the thread of the window
/// may paint; what comes of them can be encoded in any thread.
[[nodiscard]] Figure recorded(const Figure& figure, FigureFormat format);

/// The bytes of the file: SVG, PDF of one A4 page, or PNG at 200 dots per inch. The same figure gives the same bytes:
/// no dates inside.
[[nodiscard]] QByteArray encoded(const Figure& figure, FigureFormat format);

/// A PDF of as many pages of A4, each standing or lying as it asks; called as the first.
[[nodiscard]] QByteArray encodedPdf(const std::vector<Figure>& pages);

/// The same in the format of a file's ending; ValueNotAChoice for another ending.
[[nodiscard]] base::Expected<QByteArray> encodedFor(const Figure& figure, const std::filesystem::path& file);

/// Writes the figure in the format of the file's ending, whole or not at all. ValueNotAChoice for another ending,
/// CannotWrite with the reason.
[[nodiscard]] base::Expected<void> renderToFile(const Figure& figure, const std::filesystem::path& file);

} // namespace arris::ui
