// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/study.h"
#include "widgets/lab/labplot.h"

namespace pixelplumb {

/// What a pixel of a family costs, ns, split into the set-up of its triangle, its column or row,
/// and itself. The parts come from the fit over all families, so that the sum is near the measured
/// time, not equal.
struct CostParts {
    double setUp = 0;
    double columns = 0;
    double pixels = 0;

    double sum() const { return setUp + columns + pixels; }

    friend bool operator==(const CostParts &, const CostParts &) = default;
};

/// None where the contender or the family was not timed.
std::optional<CostParts> costPartsOf(const Study &study, const LabRow &row);

/// Where each contender's time goes (objectName "labCostStack"): set-up, columns and pixels as one
/// bar, with the measured time and its middle half beside it. As high as its bars need; sits in a
/// scroll area.
class CostStack : public LabPlot {
    Q_OBJECT

public:
    explicit CostStack(QWidget *parent = nullptr);

    void show(const SharedResults &results, const QString &family);

    QString textAt(const QPointF &position) const override;
    QString figureTitle() const override { return titleOn(m_results, m_family); }
    std::vector<QStringList> numbers() const override;

    bool eventFilter(QObject *watched, QEvent *event) override;

protected:
    int neededHeight() const override;
    void build() override;

private:
    struct Bar {
        QString label;
        CostParts parts;
        std::optional<Spread> measured; ///< ns a pixel
    };
    std::vector<Bar> bars() const;
    void addBars();
    void addMeasured();

    SharedResults m_results;
    QString m_family;
    std::vector<Bar> m_bars; ///< the cheapest first
};

} // namespace pixelplumb
