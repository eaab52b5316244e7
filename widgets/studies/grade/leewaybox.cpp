// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/leewaybox.h"

#include "widgets/look/parts.h"

namespace pixelplumb {

LeewayBox::LeewayBox(const char *name, QWidget *parent)
    : ElidingBox(parent)
{
    named(this, name, tr("Leeway: which pixels a right program may have otherwise"));
    const auto add = [this](Leeway leeway, const QString &text, const QString &inWords) {
        addItem(text, int(leeway));
        setItemData(count() - 1, inWords, Qt::ToolTipRole);
    };
    connect(this, &QComboBox::currentIndexChanged, this, [this] {
        setToolTip(accessibleName() + u"\n"_s + currentData(Qt::ToolTipRole).toString());
    });
    add(Leeway::Strict, tr("strict"), tr("None: the fill rule decides all, nothing is rounded"));
    add(Leeway::Rule, tr("rule"),
        tr("What rounding may decide; anything else on an edge is the fill rule's"));
    add(Leeway::Edges, tr("edges"), tr("Also every sample on an edge, where fill rules differ"));
    add(Leeway::Once, tr("once"),
        tr("As edges, but between triangles a sample is drawn by exactly one of them"));
    connect(this, &QComboBox::activated, this, [this] {
        if (const auto chosen = leeway())
            emit leewayChosen(*chosen);
    });
}

void LeewayBox::offerNone(const QString &text)
{
    insertItem(0, text);
    setCurrentIndex(0);
}

std::optional<Leeway> LeewayBox::leeway() const
{
    const QVariant data = currentData();
    return data.isValid() ? std::optional(Leeway(data.toInt())) : std::nullopt;
}

void LeewayBox::setLeeway(Leeway leeway) { setCurrentIndex(findData(int(leeway))); }

} // namespace pixelplumb
