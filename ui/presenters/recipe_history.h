#pragma once

#include "ui/presenters/planner.h"

#include <vector>

namespace arris::ui {

/// Undo and redo of what changes in the planner's recipe, whoever changes it. What is typed into one field is one step
/// until the field is left.
class RecipeHistory : public QObject {
  Q_OBJECT

public:
  explicit RecipeHistory(Planner& planner, QObject* parent = nullptr);

  [[nodiscard]] bool canUndo() const {
    return !m_before.empty();
  }

  [[nodiscard]] bool canRedo() const {
    return !m_after.empty();
  }

  void undo();
  void redo();

  /// The next change is a step of its own, also of the same value.
  void endStep() {
    m_openKey = {};
  }

  /// Nothing that was before can be brought back.
  void forget();

  static constexpr std::size_t kMostSteps = 100;

Q_SIGNALS:
  void changed();

private:
  void take(const recipe::Recipe& recipe);
  void move(std::vector<recipe::Recipe>& from, std::vector<recipe::Recipe>& to);

  Planner& m_planner;
  recipe::Recipe m_now;
  std::vector<recipe::Recipe> m_before; // the latest last
  std::vector<recipe::Recipe> m_after;  // the next last
  std::string_view m_openKey;           // of the value whose changes go into one step; empty: none
};

} // namespace arris::ui
