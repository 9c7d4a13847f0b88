#pragma once

#include "ui/presenters/machine_link.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace arris::ui {

/// Offers the job that an earlier process left broken off: take it up, or discard it, which is asked once more. Says
/// why one cannot be used. There only while there is something to say.
class ResumeBar : public QWidget {
  Q_OBJECT

public:
  explicit ResumeBar(MachineLink& machine, QWidget* parent = nullptr);

private:
  QPushButton* add(const QString& text, const QString& name);
  void showOffer(const ResumeOffer& offer);
  void discard();
  [[nodiscard]] QString text(const ResumeOffer& offer) const;

  MachineLink& m_machine;
  QLabel* m_text;
  QPushButton* m_takeUp = nullptr;
  QPushButton* m_cancel = nullptr;
  QPushButton* m_discard = nullptr;
  QPushButton* m_keep = nullptr;
  QPushButton* m_dismiss = nullptr;
  bool m_asks = false; // whether it is truly to be discarded
};

} // namespace arris::ui
