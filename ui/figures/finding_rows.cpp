#include "ui/figures/finding_rows.h"

#include "ui/text/problem_texts.h"
#include "ui/text/quantities.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>

namespace arris::ui {
namespace {

struct Kind {
  const base::Problem* first = nullptr;
  std::int64_t count = 0;
};

template <typename T> T valueOf(const base::Problem& problem, std::string_view name) {
  for (const base::Value& value : problem.values) {
    if (value.name == name && std::holds_alternative<T>(value.value)) {
      return std::get<T>(value.value);
    }
  }
  return {};
}

void count(std::vector<Kind>& kinds, const base::Problems& problems) {
  for (const base::Problem& problem : problems) {
    const auto same =
        std::find_if(kinds.begin(), kinds.end(), [&](const Kind& kind) { return kind.first->code == problem.code; });
    if (same != kinds.end()) {
      ++same->count;
    } else if (problem.code != base::Code::MoreNotListed) {
      kinds.push_back({&problem, 1});
    }
  }
}

// Those that a list left out belong to the ones that it names.
void countUnlisted(std::vector<Kind>& kinds, const base::Problems& problems) {
  for (const base::Problem& problem : problems) {
    const auto code = valueOf<std::string>(problem, "code");
    for (Kind& kind : kinds) {
      if (problem.code == base::Code::MoreNotListed && base::info(kind.first->code).name == code) {
        kind.count += valueOf<std::int64_t>(problem, "count");
      }
    }
  }
}

QString wordsFor(const Kind& kind, const QLocale& locale, LengthUnit unit) {
  QString words = problemText(*kind.first, locale, unit);
  const QString place = placeText(*kind.first, locale, unit);
  if (!place.isEmpty()) {
    words += QLatin1Char(' ') + place;
  }
  if (kind.count > 1) {
    words +=
        QStringLiteral(" ") + QCoreApplication::translate("PreviewPage", "And %1 more like it.").arg(kind.count - 1);
  }
  return words;
}

} // namespace

std::vector<FindingRow> findingRows(const Drawing& drawing, const QLocale& locale, LengthUnit unit) {
  std::vector<Kind> kinds;
  count(kinds, drawing.problems);
  count(kinds, drawing.repairs);
  countUnlisted(kinds, drawing.problems);
  std::stable_sort(kinds.begin(), kinds.end(), [](const Kind& a, const Kind& b) {
    return base::severityOf(*a.first) < base::severityOf(*b.first);
  });
  std::vector<FindingRow> rows;
  for (const Kind& kind : kinds) {
    rows.push_back({base::severityOf(*kind.first), wordsFor(kind, locale, unit)});
  }
  return rows;
}

} // namespace arris::ui
