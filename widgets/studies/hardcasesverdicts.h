// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casecheck.h"

#include <QTableWidget>

namespace pixelplumb {

/// How every method does at a hard case: a row a method, a column an arithmetic, over all fill
/// rules that the case has facts for.
class HardCasesVerdicts : public QTableWidget {
    Q_OBJECT

public:
    explicit HardCasesVerdicts(QWidget *parent = nullptr);

    /// In the order of the table of methods.
    void show(const std::vector<ContenderVerdict> &verdicts);
};

} // namespace pixelplumb
