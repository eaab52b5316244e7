// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/hardcase.h"

#include <QMetaType>

/// Shared helpers of the tests that go through the hard cases one by one.
namespace pixelplumb {

/// The cases in a file. If it cannot be read, the test fails and the list is empty.
std::vector<HardCase> casesOf(const QString &path);

/// Adds one data row per case; the column is "hardCase".
void addRows(const std::vector<HardCase> &cases);

const HardCase &caseNamed(const std::vector<HardCase> &cases, const QString &id);

/// A case file with a single case that has these members.
QByteArray fileOfCase(const QByteArray &members);

} // namespace pixelplumb
