// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labplot.h"

namespace pixelplumb {

/// How far increments drift with the columns (objectName "labDrift"), one curve an arithmetic, and
/// dotted what they may by proof.
class DriftPlot : public LabPlot {
    Q_OBJECT

public:
    explicit DriftPlot(QWidget *parent = nullptr);

    void show(const SharedResults &results);

protected:
    void build() override;

private:
    SharedResults m_results;
};

} // namespace pixelplumb
