// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

#include <array>
#include <optional>

namespace pixelplumb {

class SceneDocument;

/// Sliders for the segments of the document's first sphere or patch ("segmentsAround" and
/// "segmentsAlong"); hidden where there is none. The moves of one drag are one edit.
class SegmentSliders : public QWidget {
    Q_OBJECT

public:
    explicit SegmentSliders(SceneDocument *document, QWidget *parent = nullptr);

private:
    QSlider *makeSlider(const QString &name, const QString &tip);
    /// The solid's index; none where the document has no sphere and no patch.
    std::optional<std::size_t> solid() const;
    void follow();
    void apply();

    SceneDocument *m_document;
    std::array<QSlider *, 2> m_sliders;
    QLabel *m_numbers;
    int m_drag = 0;
};

} // namespace pixelplumb
