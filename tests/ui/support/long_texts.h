#pragma once

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <QTranslator>

#include <set>
#include <string>
#include <utility>

namespace arris::test {

/// As long as it lives every text of these contexts is 40 % longer, as in a language of longer words; stands before the
/// widgets that show them.
class LongTexts : public QTranslator {
public:
  explicit LongTexts(std::set<std::string> contexts) : m_contexts(std::move(contexts)) {
    QCoreApplication::installTranslator(this);
  }

  ~LongTexts() override {
    QCoreApplication::removeTranslator(this);
  }

  LongTexts(const LongTexts&) = delete;
  LongTexts& operator=(const LongTexts&) = delete;
  LongTexts(LongTexts&&) = delete;
  LongTexts& operator=(LongTexts&&) = delete;

  [[nodiscard]] bool isEmpty() const override {
    return false;
  }

  [[nodiscard]] QString translate(const char* context, const char* source, const char* /*disambiguation*/,
                                  int /*n*/) const override {
    if (!m_contexts.contains(context)) {
      return {};
    }
    QStringList lines = QString::fromUtf8(source).split(QLatin1Char('\n'));
    for (QString& line : lines) {
      const qsizetype wanted = line.size() * 14 / 10;
      while (line.size() < wanted) {
        line += line.size() + 6 < wanted ? QStringLiteral(" langes") : QStringLiteral("n");
      }
    }
    return lines.join(QLatin1Char('\n'));
  }

private:
  std::set<std::string> m_contexts;
};

} // namespace arris::test
