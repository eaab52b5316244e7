// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labplot.h"

class QCPScatterStyle;

namespace pixelplumb {

/// How times grow with a size (objectName "labScaling"), both logarithmic, with the fitted
/// exponents.
class ScalingPlot : public LabPlot {
    Q_OBJECT

public:
    explicit ScalingPlot(QWidget *parent = nullptr);

    void show(const SharedResults &results, SizeAxis axis);

    QString textAt(const QPointF &position) const override;
    QString figureTitle() const override;
    std::vector<QStringList> numbers() const override;

protected:
    void build() override;

private:
    QCPScatterStyle markOf(const SizeCurve &curve) const;
    QString labelOf(const SizeCurve &curve) const;

    SharedResults m_results;
    SizeAxis m_axis = SizeAxis::Width;
};

} // namespace pixelplumb
