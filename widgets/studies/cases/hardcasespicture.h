// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casecheck.h"
#include "core/compare/casegallery.h"
#include "core/runs/contender.h"
#include "core/runs/differencemap.h"
#include "widgets/look/rowsmodel.h"

#include <QtGui>

namespace pixelplumb {

/// A part of a hard case as a method draws it and as it truly is, around the first pixel that
/// differs, else around the drawn pixel nearest to the middle of all.
struct HardCasePicture {
    Contender contender; ///< who drew it: the current method, or the first that can draw the case
    QImage drawn, truth; ///< one pixel per frame pixel
    FrameSpec part; ///< of the frame, that the pictures show
    std::vector<std::pair<QPoint, Difference>> marks; ///< pixels of `drawn` that differ
    /// Of triangles, on samples; they may reach far beyond the part.
    std::vector<std::array<LatticePoint, 3>> outlines;
    std::int64_t missing = 0, extra = 0, otherColour = 0; ///< of the whole canvas

    bool isRight() const { return missing == 0 && extra == 0 && otherColour == 0; }
    /// "64 missing, 2198 in another colour" or "right".
    QString verdict() const;
};

HardCasePicture pictureOf(const HardCase &hardCase, const Method &method,
                          const ScanSettings &settings);

/// Both pictures side by side, enlarged by whole numbers to fit, with the differing pixels marked
/// in the first, and the true edges where the pixels are large enough.
QPixmap sideBySide(const HardCasePicture &picture, const QSize &size, const QPalette &palette,
                   double devicePixelRatio);

/// How every method does on a hard case: a row per method, a column per arithmetic, over all fill
/// rules for which the case has facts.
class HardCasesVerdicts : public QTableView {
    Q_OBJECT

public:
    explicit HardCasesVerdicts(QWidget *parent = nullptr);

    /// `verdicts`: in the order of the table of methods.
    void show(const std::vector<ContenderVerdict> &verdicts);

private:
    struct Row;
    RowsModel<Row> *m_rows;
};

} // namespace pixelplumb
