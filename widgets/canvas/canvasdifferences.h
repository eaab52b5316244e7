// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/scenepicture.h"
#include "core/runs/tracedscene.h"
#include "widgets/look/signs.h"
#include "widgets/look/viewmapping.h"
#include "widgets/model/studentpicture.h"

#include <QtGui>

#include <array>
#include <vector>

namespace pixelplumb {

/// Marks in the picture on the screen the visible pixels that differ from the truth or in a
/// student's picture, or that a forced effect changes: by a glyph where the cell has room, else by
/// a coloured frame, else by the colour alone. Below 1:1 a device pixel is marked when any of its
/// frame pixels differs.
class CanvasDifferences {
public:
    /// A run, or a finished picture, whose differences are decided at every position. Held here so
    /// that no other object gets its address.
    struct Source {
        std::shared_ptr<const TracedScene> traced = nullptr;
        std::shared_ptr<const ScenePicture> picture = nullptr;
        /// What forcing changes, instead of what differs from the truth; null where nothing is
        /// forced.
        std::shared_ptr<const DifferenceMap> changes = nullptr;
        /// The verdict on a student's picture, instead of all of these; decided at every position
        /// where there is no run.
        std::shared_ptr<const PictureJudgement> judgement = nullptr;

        const DifferenceMap &differences() const
        {
            if (changes)
                return *changes;
            return traced ? traced->differences : picture->differences();
        }
        std::size_t decidedAt(std::int64_t x, std::int64_t y) const
        {
            return traced ? traced->decidedAt(x, y) : 0;
        }
        friend bool operator==(const Source &, const Source &) = default;
    };

    /// Looks up the visible pixels; cheap when neither the source nor the view has changed.
    void lookUp(const Source &source, const ViewMapping &mapping, const QRect &device);
    void forget();
    /// Whether any visible pixel differs.
    bool hasMarks() const { return !m_marks.empty(); }
    /// Marks the pixels that are decided at a position in the cells themselves, where these are too
    /// small for glyphs; `shown` shows the device rectangle of lookUp().
    void markCells(QImage &shown, std::size_t position, const QPalette &palette);
    /// Draws the glyphs of the pixels that are decided at a position, where cells have room. They
    /// lie over the outlines, because missing and extra pixels lie along edges.
    void drawGlyphs(QPainter &painter, std::size_t position, const QPalette &palette);

private:
    struct Mark {
        QPoint device; ///< the cell's upper left, relative to the device rectangle
        std::size_t sign = 0; ///< index in markSigns
        std::size_t decidedAt = 0;
    };
    static constexpr std::array markSigns
        = {Sign::Missing, Sign::Extra, Sign::ColourDiffers, Sign::Tie};

    /// `rowAt(y)`: a byte per pixel of the row, 0 where nothing is marked, else 1 + the sign's
    /// index.
    template <class RowAt>
    void lookUpCells(const QRect &cells, RowAt rowAt);
    void markDevicePixels(QImage &shown, std::size_t position) const;
    bool hasGlyphs() const;
    void makeStamps(const QPalette &palette);

    Source m_source;
    ViewMapping m_mapping;
    QRect m_device;
    std::vector<Mark> m_marks;
    std::array<QImage, markSigns.size()> m_stamps;
    qint64 m_stampsPalette = 0;
    int m_stampsZoom = 0;
    double m_stampsRatio = 0;
};

} // namespace pixelplumb
