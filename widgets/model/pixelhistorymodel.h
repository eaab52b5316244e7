// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/ahead.h"
#include "core/runs/explain/pixelhistory.h"

#include <QtCore>

#include <optional>

namespace pixelplumb {

/// What each triangle did to one pixel, in drawing order, with the numbers of each attempt below
/// it: three channels where it wrote, three edges where one rejected the pixel. Only the first few
/// triangles that reject the pixel are listed; a last row counts the others.
class PixelHistoryModel : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Column { WhatColumn, UsedColumn, ByteColumn, ExactColumn, columnTotal };
    enum Role {
        ReasonRole = Qt::UserRole + 1, ///< QString: the attempt's reason
        StepRole, ///< qulonglong: the step that wrote; invalid where none did
        IsAheadRole, ///< bool: written by a step beyond the position
        BeforeColourRole, ///< QColor, of a write
        AfterColourRole,
    };

    static constexpr int listedRefusals = int(fewRefusals);

    using QAbstractItemModel::QAbstractItemModel;

    void setPixel(std::shared_ptr<const TracedScene> traced, const std::optional<QPoint> &pixel,
                  Ahead ahead = Ahead::Shown);
    void setPosition(std::size_t position);
    /// Whether attempts are left out because they lie ahead.
    bool isSomethingHidden() const { return m_isSomethingHidden; }

    /// The row of the write that the frame shows, else of the next write to come, else 0; none when
    /// empty.
    QModelIndex decisiveRow() const;
    /// The attempt of the current step; invalid where the step belongs to another pixel.
    QModelIndex currentRow() const;

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &child) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

private:
    static constexpr int channelRows = 3; // of a write; they come before the edges

    bool isCountRow(const QModelIndex &index) const;
    QString attemptText(const PixelAttempt &attempt, int column) const;
    QString channelText(const PixelAttempt &attempt, std::size_t channel, int column) const;
    QString carriedText(const PixelAttempt::Carried &number, int column) const;
    QString besideText(const QString &pattern, const Quantity &used, const Quantity &exact) const;
    QString edgeText(const PixelAttempt &attempt, std::size_t index, int column) const;
    /// The channels of a write come first, then the edges of a triangle.
    QString detailText(const PixelAttempt &attempt, std::size_t row, int column) const;

    std::shared_ptr<const TracedScene> m_traced;
    std::vector<PixelAttempt> m_attempts; ///< the listed ones
    std::size_t m_unlisted = 0; ///< further refusals
    std::size_t m_position = 0;
    bool m_isSomethingHidden = false;
};

} // namespace pixelplumb
