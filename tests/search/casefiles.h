// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <array>

namespace pixelplumb::search {

/// The hard-case files in tests/data whose shortfalls are recorded.
inline const std::array<QString, 3> caseFiles
    = {QStringLiteral("hard_cases.json"), QStringLiteral("more_cases.json"),
       QStringLiteral("shape_cases.json")};

inline const QString recordFile = QStringLiteral("expected_shortfalls.json");

} // namespace pixelplumb::search
