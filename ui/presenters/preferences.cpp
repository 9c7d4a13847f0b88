#include "ui/presenters/preferences.h"

#include "core/files/set_aside.h"
#include "core/files/whole_file.h"
#include "core/recipe/fields.h"

#include <QCryptographicHash>
#include <QRandomGenerator>

#include <algorithm>
#include <functional>
#include <utility>

namespace arris::ui {
namespace {

namespace fs = std::filesystem;

constexpr int kSaltLength = 8;

template <typename Value>
using Reader = std::function<files::Read<Value>(std::string_view text, std::string_view file, const Value& defaults)>;

// Where there is no file, or none that is sound, `defaults`.
template <typename Value>
Value readOr(const Value& defaults, const fs::path& file, const Reader<Value>& reader, base::Problems& problems) {
  std::error_code failure;
  if (!fs::exists(file, failure)) {
    return defaults;
  }
  files::Read<Value> read{defaults, {}};
  if (const auto text = files::readFile(file)) {
    read = reader(*text, file.string(), defaults);
  } else {
    read.problems.push_back(text.error());
  }
  problems.insert(problems.end(), read.problems.begin(), read.problems.end());
  if (!base::hasErrors(read.problems)) {
    return read.value;
  }
  problems.push_back(files::setAsideAndTell(file));
  return defaults;
}

QString fingerprint(const QString& code, const QString& salt) {
  const QByteArray hash = QCryptographicHash::hash((salt + code).toUtf8(), QCryptographicHash::Sha256);
  return salt + QLatin1Char(':') + QString::fromLatin1(hash.toHex());
}

// The paper's values can be above what a small machine allows.
recipe::Recipe withinMachine(recipe::Recipe recipe, const recipe::Machine& machine) {
  recipe.accelX = std::min(recipe.accelX, machine.maxAccel.x());
  recipe.accelY = std::min(recipe.accelY, machine.maxAccel.y());
  recipe.accelZ = std::min(recipe.accelZ, machine.maxAccel.z());
  return recipe;
}

} // namespace

Preferences::Preferences(files::StateFolder folder, const recipe::Machine& machine, QObject* parent)
    : QObject(parent), m_folder(std::move(folder)) {
  m_settings = readOr<files::Settings>(
      {}, m_folder.settings(),
      [](std::string_view text, std::string_view file, const files::Settings&) {
        return files::readSettingsFile(text, file);
      },
      m_problems);
  m_machine = readOr<recipe::Machine>(machine, m_folder.machine(), files::readMachine, m_problems);
  m_nextMachine = m_machine;
  m_lastRecipe = readOr<recipe::Recipe>({}, m_folder.recipe(), files::readRecipe, m_problems);
  m_lastRecipe = withinMachine(m_lastRecipe, m_machine);
  m_isOpen = m_settings.code.empty();
}

base::Problems Preferences::takeProblems() {
  return std::exchange(m_problems, {});
}

void Preferences::change(const files::Settings& settings) {
  if (settings != m_settings) {
    m_settings = settings;
    write(m_folder.settings(), files::writeSettingsFile(m_settings));
    Q_EMIT changed();
  }
}

void Preferences::setMachine(const recipe::Machine& machine) {
  if (machine != m_nextMachine) {
    m_nextMachine = machine;
    write(m_folder.machine(), files::writeMachine(machine));
  }
}

void Preferences::keepRecipe(const recipe::Recipe& recipe) {
  if (recipe != m_lastRecipe) {
    m_lastRecipe = recipe;
    write(m_folder.recipe(), files::writeRecipe(recipe));
  }
}

void Preferences::noteOpened(const fs::path& pattern) {
  files::Settings settings = m_settings;
  std::vector<std::string>& recent = settings.recent;
  std::error_code failure;
  const fs::path whole = fs::absolute(pattern, failure); // it is opened again from anywhere
  const std::string file = (failure ? pattern : whole).string();
  recent.erase(std::remove(recent.begin(), recent.end(), file), recent.end());
  recent.insert(recent.begin(), file);
  recent.resize(std::min(recent.size(), files::kMostRecent));
  change(settings);
}

bool Preferences::open(const QString& code) {
  const QString kept = QString::fromStdString(m_settings.code);
  if (!m_isOpen && kept == fingerprint(code, kept.section(QLatin1Char(':'), 0, 0))) {
    m_isOpen = true;
    Q_EMIT openChanged();
  }
  return m_isOpen;
}

void Preferences::lock() {
  if (m_isOpen && !m_settings.code.empty()) {
    m_isOpen = false;
    Q_EMIT openChanged();
  }
}

void Preferences::setCode(const QString& code) {
  files::Settings settings = m_settings;
  if (code.isEmpty()) {
    settings.code.clear();
  } else {
    const QString salt = QString::number(QRandomGenerator::system()->generate(), 16).rightJustified(kSaltLength, '0');
    settings.code = fingerprint(code, salt).toStdString();
  }
  change(settings);
  Q_EMIT openChanged();
}

bool Preferences::isCode(const QString& text) {
  return text.size() >= kShortestCode && text.size() <= kLongestCode &&
         std::all_of(text.begin(), text.end(), [](QChar c) { return c >= QLatin1Char('0') && c <= QLatin1Char('9'); });
}

void Preferences::write(const fs::path& file, const std::string& text) {
  if (!m_keeps) {
    return;
  }
  std::error_code failure;
  fs::create_directories(m_folder.root, failure); // where that fails the write tells why
  if (const auto written = files::writeWholeFile(file, text); !written) {
    m_problems.push_back(written.error());
    Q_EMIT problemsArose();
  }
}

} // namespace arris::ui
