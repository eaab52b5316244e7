// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/lab/labplot.h"

namespace pixelplumb {

/// How far a contender's missed samples lie from the triangle's boundary (objectName "labMisses"):
/// missing ones left, extra ones right, ties, which lie on it, in the middle.
class MissPlot : public LabPlot {
    Q_OBJECT

public:
    explicit MissPlot(QWidget *parent = nullptr);

    void show(const SharedResults &results, const QString &family, const QString &contender);

    /// The place of a bin's bar on the distance axis: extra at 2, 3, …, missing at −2, −3, …, ties
    /// around 0.
    enum class Side { Missing, Extra };
    static double placeOf(Side side, std::size_t bin);

    QString textAt(const QPointF &position) const override;
    QString figureTitle() const override;

protected:
    void build() override;

private:
    struct Bar {
        double place = 0;
        std::int64_t count = 0;
        QString meaning; ///< "missing, 10⁻⁴ to 10⁻³ px inside"
    };
    std::vector<Bar> bars() const;
    void addBars(double from, double to, Qt::BrushStyle style, const QColor &colour,
                 const QString &name);

    SharedResults m_results;
    QString m_family;
    QString m_contender;
    std::vector<Bar> m_bars;
};

} // namespace pixelplumb
