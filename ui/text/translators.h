#pragma once

#include <QStringList>
#include <QTranslator>

#include <memory>
#include <vector>

namespace arris::ui {

/// As long as the result lives the program speaks the first of these languages that it knows, in Qt's own texts too.
/// Nothing is installed where that is English, the language of the sources, or where it knows none of them.
[[nodiscard]] std::vector<std::unique_ptr<QTranslator>> installTranslators(const QStringList& languages);

/// The languages that the window speaks: "en", "de", "it", "zh_CN".
[[nodiscard]] QStringList spokenLanguages();

/// From now on the window speaks this language, and its numbers are as there: an empty one is that of the system. Where
/// the system's language is the same its own numbers stay (those of Switzerland in German).
void speak(const QString& language);

} // namespace arris::ui
