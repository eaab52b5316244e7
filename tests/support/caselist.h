// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/hardcase.h"

#include <QMetaType>

/// What the tests that take hard cases one by one share.
namespace pixelplumb {

/// The cases of a file; the test fails, and there are none, where it cannot be read.
std::vector<HardCase> casesOf(const QString &path);

/// A row a case; the column is "hardCase".
void addRows(const std::vector<HardCase> &cases);

const HardCase &caseNamed(const std::vector<HardCase> &cases, const QString &id);

/// A file with one case of these members.
QByteArray fileOfCase(const QByteArray &members);

} // namespace pixelplumb
