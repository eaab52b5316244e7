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

    QString textAt(const QPointF &position) const override;
    std::vector<QStringList> numbers() const override;

protected:
    void build() override;

private:
    SharedResults m_results;
};

} // namespace pixelplumb
