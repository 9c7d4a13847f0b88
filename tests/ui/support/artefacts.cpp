#include "tests/ui/support/artefacts.h"

#include <QPixmap>
#include <QWidget>

#include <fstream>

namespace arris::test {

std::filesystem::path artefact(const std::string& name) {
  const std::filesystem::path folder(ARRIS_ARTEFACTS);
  std::filesystem::create_directories(folder);
  return folder / name;
}

void keep(const std::string& name, const QByteArray& bytes) {
  std::ofstream(artefact(name), std::ios::binary).write(bytes.constData(), bytes.size());
}

void keep(const std::string& name, const ui::Figure& figure) {
  keep(name + ".svg", encoded(figure, ui::FigureFormat::Svg));
  keep(name + ".pdf", encoded(figure, ui::FigureFormat::Pdf));
  keep(name + ".png", encoded(figure, ui::FigureFormat::Png));
}

void keep(const std::string& name, QWidget& widget) {
  widget.grab().save(QString::fromStdString(artefact(name + ".png").string()));
}

} // namespace arris::test
