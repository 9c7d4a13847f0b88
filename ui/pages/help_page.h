#pragma once

#include <QTextBrowser>

namespace arris::ui {

/// The operator's manual in the language of the window: a part for each page, that of a page first on request.
class HelpPage : public QTextBrowser {
  Q_OBJECT

public:
  explicit HelpPage(QWidget* parent = nullptr);

  /// The part of the page with this name of its button: "pageRun".
  void showPart(const QString& page);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void scrollToPart();

  QString m_part;
};

} // namespace arris::ui
