#pragma once

#include <QStringList>
#include <QTranslator>

#include <memory>
#include <vector>

namespace arris::ui {

/// As long as the result lives the program speaks the first of these languages that it knows, in Qt's own texts too.
/// Nothing is installed where that is English, the language of the sources, or where it knows none of them.
[[nodiscard]] std::vector<std::unique_ptr<QTranslator>> installTranslators(const QStringList& languages);

} // namespace arris::ui
