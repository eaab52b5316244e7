// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casecheck.h"

#include <QTableWidget>

namespace pixelplumb {

/// How every method does on a hard case: a row per method, a column per arithmetic, over all fill
/// rules for which the case has facts.
class HardCasesVerdicts : public QTableWidget {
    Q_OBJECT

public:
    explicit HardCasesVerdicts(QWidget *parent = nullptr);

    /// `verdicts`: in the order of the table of methods.
    void show(const std::vector<ContenderVerdict> &verdicts);
};

} // namespace pixelplumb
