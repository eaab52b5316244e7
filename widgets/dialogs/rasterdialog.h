// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/asciiraster.h"

#include <QDialog>

namespace pixelplumb {

/// A pasted raster laid over the picture: what both cover, what only one does.
class RasterDialog : public QDialog {
    Q_OBJECT

public:
    explicit RasterDialog(const RasterComparison &comparison, QWidget *parent = nullptr);
};

/// "1262 pixels match, 3 extra (!), none missing (?)".
QString summaryOf(const RasterComparison &comparison);

} // namespace pixelplumb
