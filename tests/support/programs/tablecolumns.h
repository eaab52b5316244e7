// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/columntablemodel.h"

namespace pixelplumb {

/// The column with this name in files; -1 where there is none.
inline int columnNamed(const ColumnTableModel &model, const QString &fileName)
{
    for (int column = 0; column < model.columnCount(); ++column) {
        if (model.fileName(column) == fileName)
            return column;
    }
    return -1;
}

} // namespace pixelplumb
