// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/leewaybox.h"

#include "widgets/look/parts.h"

namespace pixelplumb {

LeewayBox::LeewayBox(const char *name, QWidget *parent)
    : ElidingBox(parent)
{
    const QString question = tr("Leeway: which pixels may differ in a right picture");
    explained(this, name, question);
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(8);
    const auto add = [this](Leeway leeway, const QString &text, const QString &inWords) {
        addItem(text, int(leeway));
        setItemData(count() - 1, inWords, Qt::ToolTipRole);
    };
    add(Leeway::Strict, tr("strict: no pixel"),
        tr("strict: no pixel may differ; the scene's fill rule decides every pixel"));
    add(Leeway::Rule, tr("rule: rounding"),
        tr("rule: only pixels that rounding may decide; the scene's fill rule decides all others"));
    add(Leeway::Edges, tr("edges: any fill rule"),
        tr("edges: also every pixel exactly on an edge, so any fill rule is right"));
    add(Leeway::Once, tr("once: any rule, no gaps"),
        tr("once: as edges, but a pixel on a shared edge is drawn by exactly one triangle"));
    connect(this, &QComboBox::currentIndexChanged, this, [this, question] {
        const QString inWords = currentData(Qt::ToolTipRole).toString();
        setToolTip(inWords.isEmpty() ? question : question + u'\n' + inWords);
    });
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
