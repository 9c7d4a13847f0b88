#pragma once

#include "core/control/run_keeper.h"
#include "core/files/settings_json.h"

#include <QObject>
#include <QString>

#include <optional>

namespace arris::ui {

/// What the operator has chosen: settings, the machine, the recipe of last time, each a file of the state folder. A
/// damaged file is set aside and told, and defaults take its place: nothing here keeps the program from starting.
class Preferences : public QObject {
  Q_OBJECT

public:
  /// `machine`: what it is where no file says so.
  explicit Preferences(files::StateFolder folder, const recipe::Machine& machine = {}, QObject* parent = nullptr);

  [[nodiscard]] const files::Settings& settings() const {
    return m_settings;
  }

  /// The machine in effect: as the file said when the program began. What is chosen later counts from the next start.
  [[nodiscard]] const recipe::Machine& machine() const {
    return m_machine;
  }

  /// What the file of the machine says now.
  [[nodiscard]] const recipe::Machine& nextMachine() const {
    return m_nextMachine;
  }

  /// Of last time; the defaults where there was none, within what the machine allows.
  [[nodiscard]] const recipe::Recipe& lastRecipe() const {
    return m_lastRecipe;
  }

  /// What was wrong when the files were read, and what could not be written since; each once.
  [[nodiscard]] base::Problems takeProblems();

  void change(const files::Settings& settings);
  void setMachine(const recipe::Machine& machine);
  void keepRecipe(const recipe::Recipe& recipe);
  void noteOpened(const std::filesystem::path& pattern); ///< first among the recent ones

  /// Off: nothing is written any more, since the files have been replaced by others, which count from the next start.
  void setKeeping(bool keeps) {
    m_keeps = keeps;
  }

  /// Whether the engineering values may be changed: always where no code is set.
  [[nodiscard]] bool isOpen() const {
    return m_isOpen;
  }

  bool open(const QString& code); ///< false where the code is another
  void lock();

  /// Digits, `kShortestCode` to `kLongestCode`; an empty one takes the code away.
  void setCode(const QString& code);

  static constexpr int kShortestCode = 4;
  static constexpr int kLongestCode = 8;
  [[nodiscard]] static bool isCode(const QString& text);

Q_SIGNALS:
  void changed();       ///< settings
  void openChanged();   ///< the engineering values were locked or opened
  void problemsArose(); ///< see `takeProblems`

private:
  void write(const std::filesystem::path& file, const std::string& text);

  files::StateFolder m_folder;
  files::Settings m_settings;
  recipe::Machine m_machine;
  recipe::Machine m_nextMachine;
  recipe::Recipe m_lastRecipe;
  bool m_isOpen = true;
  bool m_keeps = true;
  base::Problems m_problems;
};

} // namespace arris::ui
