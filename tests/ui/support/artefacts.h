#pragma once

#include "ui/figures/figure.h"

#include <QByteArray>
#include <QString>

#include <filesystem>

class QWidget;

namespace arris::test {

/// Where a test leaves a file of this name for people to look at: the folder `artefacts` of the build.
[[nodiscard]] std::filesystem::path artefact(const std::string& name);

void keep(const std::string& name, const QByteArray& bytes);

/// The figure as `name`.svg, `name`.pdf and `name`.png.
void keep(const std::string& name, const ui::Figure& figure);

/// What the widget looks like, as `name`.png.
void keep(const std::string& name, QWidget& widget);

/// Fails for every text, button and table column of the window that has less room than it asks for.
void expectNothingCutOff(const QWidget& window);

} // namespace arris::test
