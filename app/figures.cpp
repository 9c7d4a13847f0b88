#include "app/figures.h"

#include "app/messages.h"
#include "core/files/whole_file.h"

#include <QByteArray>
#include <QHash>
#include <QString>
#include <QtGlobal>

#include <cassert>

namespace arris::app {
namespace {

/// Qt's remarks about the system (fonts, folders) are not for the user of a command line.
void onlyGrave(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtCriticalMsg || type == QtFatalMsg) {
    complain(message.toStdString());
  }
}

int& prepared(int& count) {
  qInstallMessageHandler(onlyGrave);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QHashSeed::setDeterministicGlobalSeed(); // a PDF's fonts and patterns stand in the order of a hash
  return count;
}

} // namespace

Offscreen::Offscreen() : m_application(prepared(m_count), m_arguments) {}

base::Expected<void> writeFigure(const ui::Figure& figure, const std::filesystem::path& file) {
  const auto format = ui::figureFormat(file);
  assert(format);
  const QByteArray bytes = ui::encoded(figure, *format);
  return files::writeWholeFile(file, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

} // namespace arris::app
