// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/methodbox.h"

#include "core/methods/method.h"
#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"

#include <algorithm>
#include <optional>

namespace pixelplumb {

MethodBox::MethodBox(QWidget *parent)
    : ElidingBox(parent)
{
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMaxVisibleItems(40);
    std::optional<MethodFamily> family;
    for (const Method &method : methods()) {
        if (family != method.family) {
            addItem(coreWord(titleOf(method.family)));
            setItemData(count() - 1, bold(font()), Qt::FontRole);
            setItemData(count() - 1, 0, Qt::UserRole - 1); // the standard model's flags: none
        }
        family = method.family;
        const QString title = methodTitle(method);
        addItem(title, method.id);
        setItemData(count() - 1, methodSummary(method) + u'\n' + method.source, Qt::ToolTipRole);
        m_titleWidth = std::max(m_titleWidth, fontMetrics().horizontalAdvance(title));
    }
    setCurrentIndex(1);
    view()->setMinimumWidth(view()->sizeHintForColumn(0));
}

QSize MethodBox::sizeHint() const
{
    QStyleOptionComboBox option;
    initStyleOption(&option);
    const QSize least = minimumSizeHint();
    const QSize contents(m_titleWidth + fontMetrics().averageCharWidth(), least.height());
    const QSize whole = style()->sizeFromContents(QStyle::CT_ComboBox, &option, contents, this);
    return {std::max(least.width(), whole.width()), least.height()};
}

} // namespace pixelplumb
