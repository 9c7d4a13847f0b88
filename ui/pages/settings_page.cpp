#include "ui/pages/settings_page.h"

#include "core/recipe/fields.h"
#include "ui/text/job_texts.h"
#include "ui/text/problem_texts.h"
#include "ui/text/translators.h"
#include "ui/widgets/number_edit.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/touch_table.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace arris::ui {
namespace {

using files::Settings;

constexpr std::array kScales{100, 125, 150, 175, 200, 250, 300, 400}; // percent
constexpr QSize kLeastWindow(1024, 700);                              // px, of the window at its scale
constexpr int kChoiceWidth = 420;                                     // px
constexpr int kCodeWidth = 200;
constexpr int kWidestPages = 1100;
constexpr int kFieldHeight = 48;

QLabel* makeNote(const QString& text) {
  auto* note = new QLabel(text);
  note->setWordWrap(true);
  return note;
}

// Beside a field below its caption.
void addName(QGridLayout& grid, const QString& what) {
  QLabel* name = makeNote(what);
  name->setMinimumHeight(kFieldHeight);
  grid.addWidget(name, grid.rowCount(), 0, Qt::AlignBottom);
}

// A scale at which the window would not fit the screen is not offered.
bool fitsScreen(int scale) {
  const QScreen* screen = QGuiApplication::primaryScreen();
  const QSize pixels = screen->size() * screen->devicePixelRatio();
  const QSize room = pixels * 100 / scale;
  return room.width() >= kLeastWindow.width() && room.height() >= kLeastWindow.height();
}

} // namespace

SettingsPage::SettingsPage(Preferences& preferences, QWidget* parent)
    : QWidget(parent), m_preferences(preferences), m_machine(preferences.nextMachine()), m_complaint(new QLabel),
      m_codeState(new QLabel), m_code(new QLineEdit), m_enter(new QPushButton(tr("Unlock"))),
      m_set(new QPushButton(tr("Set this code"))), m_remove(new QPushButton(tr("Take the code away"))),
      m_lock(new QPushButton(tr("Lock the values now"))) {
  auto* pages = new QStackedWidget;
  pages->addWidget(makeWindow());
  pages->addWidget(makeMachine());
  pages->addWidget(makeCode());
  auto* segments = new Segments({{QStringLiteral("settingsWindow"), tr("Window")},
                                 {QStringLiteral("settingsMachine"), tr("Machine")},
                                 {QStringLiteral("settingsCode"), tr("Code")}});
  connect(segments, &Segments::picked, pages, &QStackedWidget::setCurrentIndex);
  pages->setMaximumWidth(kWidestPages); // a name stays in sight of its value
  m_complaint->setObjectName(QStringLiteral("complaint"));
  m_complaint->setWordWrap(true);
  m_complaint->setMargin(8);
  m_complaint->hide();
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(segments);
  layout->addWidget(pages, 1);
  layout->addWidget(m_complaint);
  connect(&preferences, &Preferences::openChanged, this, &SettingsPage::showOpen);
  showOpen();
}

void SettingsPage::change(const std::function<void(Settings&)>& edit) {
  Settings settings = m_preferences.settings();
  edit(settings);
  m_preferences.change(settings);
}

void SettingsPage::addChoice(QGridLayout& grid, const QString& what,
                             const std::vector<std::pair<QString, QString>>& buttons, int chosen,
                             const std::function<void(Settings&, int)>& take, int columns) {
  auto* segments = new Segments(buttons, chosen);
  segments->setFixedWidth(kChoiceWidth);
  const int row = grid.rowCount();
  grid.addWidget(makeNote(what), row, 0);
  grid.addWidget(segments, row, 1, 1, columns, Qt::AlignLeft);
  connect(segments, &Segments::picked, this,
          [this, take](int index) { change([&](Settings& settings) { take(settings, index); }); });
}

QComboBox* SettingsPage::makeLanguages() {
  auto* languages = new QComboBox;
  makeTouchable(*languages);
  languages->setObjectName(QStringLiteral("language"));
  languages->setAccessibleName(tr("Language"));
  languages->addItem(tr("That of the system"), QString());
  for (const QString& name : spokenLanguages()) {
    languages->addItem(QLocale(name).nativeLanguageName(), name);
  }
  languages->setCurrentIndex(
      std::max(0, languages->findData(QString::fromStdString(m_preferences.settings().language))));
  connect(languages, &QComboBox::activated, this, [this, languages] {
    change([&](Settings& settings) { settings.language = languages->currentData().toString().toStdString(); });
  });
  return languages;
}

QComboBox* SettingsPage::makeScales() {
  auto* scales = new QComboBox;
  makeTouchable(*scales);
  scales->setObjectName(QStringLiteral("scale"));
  scales->setAccessibleName(tr("Scale"));
  const int now = m_preferences.settings().scale;
  for (const int scale : kScales) {
    if (scale == now || scale == kScales.front() || fitsScreen(scale)) {
      scales->addItem(tr("%1 %").arg(scale), scale);
    }
  }
  scales->setCurrentIndex(std::max(0, scales->findData(now)));
  connect(scales, &QComboBox::activated, this,
          [this, scales] { change([&](Settings& settings) { settings.scale = scales->currentData().toInt(); }); });
  return scales;
}

QWidget* SettingsPage::makeWindow() {
  auto* page = new QWidget;
  auto* grid = new QGridLayout(page);
  const Settings& settings = m_preferences.settings();
  QComboBox* languages = makeLanguages();
  QComboBox* scales = makeScales();
  languages->setFixedWidth(kChoiceWidth);
  scales->setFixedWidth(kChoiceWidth);
  grid->addWidget(makeNote(tr("Language")), 0, 0);
  grid->addWidget(languages, 0, 1);
  addChoice(*grid, tr("Lengths"),
            {{QStringLiteral("unitMillimetre"), tr("mm")}, {QStringLiteral("unitInch"), tr("inch")}},
            static_cast<int>(settings.lengthUnit),
            [](Settings& changed, int index) { changed.lengthUnit = static_cast<Settings::LengthUnit>(index); });
  addChoice(*grid, tr("Appearance"),
            {{QStringLiteral("appearanceLight"), tr("Light")}, {QStringLiteral("appearanceDark"), tr("Dark")}},
            static_cast<int>(settings.appearance),
            [](Settings& changed, int index) { changed.appearance = static_cast<Settings::Appearance>(index); });
  addChoice(*grid, tr("Keypad on the screen"),
            {{QStringLiteral("keypadTouch"), tr("At a touch")}, {QStringLiteral("keypadAlways"), tr("At a click too")}},
            static_cast<int>(settings.keypad),
            [](Settings& changed, int index) { changed.keypad = static_cast<Settings::Keypad>(index); });
  const int row = grid->rowCount();
  grid->addWidget(makeNote(tr("Scale, from the next start")), row, 0);
  grid->addWidget(scales, row, 1);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(2, 1);
  grid->setRowStretch(grid->rowCount(), 1);
  return page;
}

void SettingsPage::addNumber(QGridLayout& grid, int column, NumberEdit* edit, const std::function<void(double)>& take) {
  m_numbers.push_back(edit);
  grid.addWidget(edit, grid.rowCount() - 1, column, Qt::AlignBottom);
  connect(edit, &NumberEdit::valueChanged, this, [this, take](double value) {
    take(value);
    keepMachine();
  });
  connect(edit, &NumberEdit::complaintChanged, this, &SettingsPage::showComplaint);
}

void SettingsPage::addFieldsOfMachine(QGridLayout& grid) {
  for (const auto& field : recipe::machineAxesFields()) {
    const QString what = machineFieldText(field.what);
    addName(grid, what);
    for (int axis = 0; axis < 3; ++axis) {
      const QString name(QStringLiteral("XYZ").at(axis));
      const NumberSpec spec{toQString(field.key) + name,
                            QStringLiteral("%1, %2").arg(what, name),
                            toQString(field.unit),
                            field.least,
                            field.most,
                            name};
      addNumber(grid, axis + 1, new NumberEdit(spec, (m_machine.*field.member)[axis]),
                [this, member = field.member, axis](double value) { (m_machine.*member)[axis] = value; });
    }
  }
  for (const auto& field : recipe::machineNumberFields()) {
    const QString what = machineFieldText(field.what);
    addName(grid, what);
    const NumberSpec spec{toQString(field.key), what,       toQString(field.unit),
                          field.least,          field.most, QStringLiteral(" ")};
    addNumber(grid, 1, new NumberEdit(spec, m_machine.*field.member),
              [this, member = field.member](double value) { m_machine.*member = value; });
  }
  for (const auto& field : recipe::machineFlagFields()) {
    auto* box = new QCheckBox(machineFieldText(field.what));
    box->setObjectName(toQString(field.key));
    box->setChecked(m_machine.*field.member);
    grid.addWidget(box, grid.rowCount(), 0, 1, 4);
    connect(box, &QCheckBox::toggled, this, [this, member = field.member](bool on) {
      m_machine.*member = on;
      keepMachine();
    });
  }
}

QWidget* SettingsPage::makeMachine() {
  m_engineering = new QWidget;
  auto* grid = new QGridLayout(m_engineering);
  grid->addWidget(makeNote(tr("What is changed here counts from the next start of Arris.")), 0, 0, 1, 4);
  addChoice(
      *grid, tr("Axes"),
      {{QStringLiteral("axesSimulated"), tr("Simulated")}, {QStringLiteral("axesLinuxcnc"), tr("LinuxCNC")}},
      static_cast<int>(m_preferences.settings().axes),
      [](Settings& changed, int index) { changed.axes = static_cast<files::Axes>(index); }, 3);
  addFieldsOfMachine(*grid);
  grid->setColumnStretch(0, 1);
  grid->setRowStretch(grid->rowCount(), 1);
  auto* scroll = new QScrollArea;
  scroll->setWidget(m_engineering);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  makeTouchable(*scroll);
  return scroll;
}

QWidget* SettingsPage::makeCode() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  m_code->setObjectName(QStringLiteral("code"));
  m_code->setEchoMode(QLineEdit::Password);
  m_code->setMaxLength(Preferences::kLongestCode);
  m_code->setInputMethodHints(Qt::ImhDigitsOnly | Qt::ImhHiddenText);
  m_code->setFixedWidth(kCodeWidth);
  m_code->setAccessibleName(tr("Code"));
  m_enter->setObjectName(QStringLiteral("codeOpen"));
  m_set->setObjectName(QStringLiteral("codeSet"));
  m_remove->setObjectName(QStringLiteral("codeRemove"));
  m_lock->setObjectName(QStringLiteral("codeLock"));
  m_codeState->setWordWrap(true);
  m_codeState->setObjectName(QStringLiteral("codeState"));
  column->addWidget(makeNote(tr("A code protects the machine's values and, in the recipe, the accelerations. "
                                "The operator's values stay open.")));
  column->addWidget(m_codeState);
  auto* row = new QHBoxLayout;
  row->addWidget(m_code);
  row->addWidget(m_enter);
  row->addWidget(m_set);
  row->addStretch(1);
  column->addLayout(row);
  auto* below = new QHBoxLayout;
  below->addWidget(m_lock);
  below->addWidget(m_remove);
  below->addStretch(1);
  column->addLayout(below);
  column->addStretch(1);
  connect(m_code, &QLineEdit::textChanged, this, &SettingsPage::showCodeButtons);
  connect(m_enter, &QPushButton::clicked, this, &SettingsPage::enterCode);
  connect(m_set, &QPushButton::clicked, this, &SettingsPage::takeCode);
  connect(m_remove, &QPushButton::clicked, this, [this] { m_preferences.setCode({}); });
  connect(m_lock, &QPushButton::clicked, &m_preferences, &Preferences::lock);
  connect(m_code, &QLineEdit::returnPressed, this, [this] { m_preferences.isOpen() ? takeCode() : enterCode(); });
  return page;
}

void SettingsPage::enterCode() {
  if (!m_preferences.open(m_code->text())) {
    m_codeState->setText(tr("This is not the code."));
  }
  m_code->clear();
}

void SettingsPage::takeCode() {
  if (Preferences::isCode(m_code->text())) {
    m_preferences.setCode(m_code->text());
    m_code->clear();
  } else {
    m_codeState->setText(
        tr("A code has %1 to %2 digits.").arg(Preferences::kShortestCode).arg(Preferences::kLongestCode));
  }
}

void SettingsPage::showOpen() {
  const bool isOpen = m_preferences.isOpen();
  const bool hasCode = !m_preferences.settings().code.empty();
  m_engineering->setEnabled(isOpen);
  showCodeButtons();
  m_remove->setEnabled(isOpen && hasCode);
  m_lock->setEnabled(isOpen && hasCode);
  m_codeState->setText(!hasCode ? tr("No code is set: all values are open.")
                       : isOpen ? tr("All values are open until they are locked or Arris starts again.")
                                : tr("Locked: enter the code to change the machine."));
}

void SettingsPage::showCodeButtons() {
  const bool isTyped = !m_code->text().isEmpty();
  m_enter->setEnabled(isTyped && !m_preferences.isOpen());
  m_set->setEnabled(isTyped && m_preferences.isOpen());
}

void SettingsPage::keepMachine() {
  if (!base::hasErrors(recipe::check(m_machine))) {
    m_preferences.setMachine(m_machine);
  }
  showComplaint();
}

void SettingsPage::showComplaint() {
  QString complaint;
  for (const NumberEdit* edit : m_numbers) {
    complaint = complaint.isEmpty() ? edit->complaint() : complaint;
  }
  if (const base::Problems problems = recipe::check(m_machine); complaint.isEmpty() && !problems.empty()) {
    complaint = problemText(problems.front(), QLocale());
  }
  m_complaint->setText(complaint);
  m_complaint->setVisible(!complaint.isEmpty());
}

} // namespace arris::ui
