// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/hardcasespicture.h"

#include "core/check/casepicture.h"
#include "widgets/look/framepainter.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPixmap>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr QSize cropSize(36, 24); ///< frame pixels

Difference differenceAt(const WrittenFrame &drawn, const WrittenFrame &truth, std::int64_t x,
                        std::int64_t y)
{
    if (drawn.isWritten(x, y) != truth.isWritten(x, y))
        return truth.isWritten(x, y) ? Difference::Missing : Difference::Extra;
    return *drawn.view().at(x, y) == *truth.view().at(x, y) ? Difference::None : Difference::Colour;
}

/// What a crop should show in its middle.
class Focus {
public:
    void see(std::int64_t x, std::int64_t y, Difference kind, bool isCovered)
    {
        const QPoint pixel{int(x), int(y)};
        const bool isCoverage = kind == Difference::Missing || kind == Difference::Extra;
        if (isCoverage && !m_coverage)
            m_coverage = pixel;
        if (kind == Difference::Colour && !m_colour)
            m_colour = pixel;
        if (isCovered) {
            m_sum += QPointF(pixel);
            ++m_covered;
        }
    }
    QPoint pixel(const FrameSpec &frame) const
    {
        if (m_coverage)
            return *m_coverage;
        if (m_colour)
            return *m_colour;
        if (m_covered > 0)
            return (m_sum / m_covered).toPoint();
        return {frame.firstColumn + frame.width / 2, frame.firstRow + frame.height / 2};
    }

private:
    std::optional<QPoint> m_coverage, m_colour;
    QPointF m_sum;
    double m_covered = 0;
};

QImage crop(const WrittenFrame &written, const FrameSpec &frame, const QRect &part)
{
    QImage picture(part.size(), QImage::Format_RGB32);
    for (int row = 0; row < part.height(); ++row) {
        auto *const pixels = reinterpret_cast<QRgb *>(picture.scanLine(part.height() - 1 - row));
        for (int column = 0; column < part.width(); ++column) {
            const std::int64_t x = part.left() + column;
            const std::int64_t y = part.top() + row;
            pixels[column]
                = packed(written.isWritten(x, y) ? written.colourAt(x, y) : frame.background);
        }
    }
    return picture;
}

struct CaseVerdict {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::HardCasePicture)
};

} // namespace

QString HardCasePicture::verdict() const
{
    QStringList parts;
    if (missing > 0)
        parts.append(CaseVerdict::tr("%1 missing").arg(missing));
    if (extra > 0)
        parts.append(CaseVerdict::tr("%1 extra").arg(extra));
    if (otherColour > 0)
        parts.append(CaseVerdict::tr("%1 in another colour").arg(otherColour));
    return parts.isEmpty() ? CaseVerdict::tr("right") : parts.join(QStringLiteral(", "));
}

HardCasePicture pictureOf(const HardCase &hardCase, const Method &method,
                          const ScanSettings &settings)
{
    const Scene scene = sceneOf(hardCase, method, settings);
    HardCasePicture picture;
    picture.contender = {methodNamed(QString::fromStdString(scene.method)), scene.settings};
    const Primitives primitives = primitivesOnSamples(scene);
    const WrittenFrame drawn(scene.frame);
    const WrittenFrame truth(scene.frame);
    const Method &drawnBy = *picture.contender.method;
    drawnBy.drawFastest(primitives, scene.settings, drawn.view());
    drawTruly(primitivesFor(primitives, picture.contender), scene.settings, truth.view());

    Focus focus;
    const FrameView window = drawn.view();
    for (std::int64_t x = window.firstColumn; x < window.endColumn(); ++x) {
        for (std::int64_t y = window.firstRow; y < window.endRow(); ++y) {
            const Difference kind = differenceAt(drawn, truth, x, y);
            picture.missing += kind == Difference::Missing ? 1 : 0;
            picture.extra += kind == Difference::Extra ? 1 : 0;
            picture.otherColour += kind == Difference::Colour ? 1 : 0;
            focus.see(x, y, kind, truth.isWritten(x, y));
        }
    }
    const QPoint middle = focus.pixel(scene.frame);
    const int width = std::min(cropSize.width(), scene.frame.width);
    const int height = std::min(cropSize.height(), scene.frame.height);
    const auto placed = [](int centre, int size, std::int64_t first, std::int64_t end) {
        return int(std::clamp<std::int64_t>(centre - size / 2, first, end - size));
    };
    picture.firstPixel = {placed(middle.x(), width, window.firstColumn, window.endColumn()),
                          placed(middle.y(), height, window.firstRow, window.endRow())};
    const QRect part(picture.firstPixel, QSize(width, height));
    picture.drawn = crop(drawn, scene.frame, part);
    picture.truth = crop(truth, scene.frame, part);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const Difference kind
                = differenceAt(drawn, truth, part.left() + column, part.top() + row);
            if (kind != Difference::None)
                picture.marks.emplace_back(QPoint(column, height - 1 - row), kind);
        }
    }
    return picture;
}

QPixmap sideBySide(const HardCasePicture &picture, const QSize &size, const QPalette &palette,
                   double devicePixelRatio)
{
    QPixmap pixmap(size * devicePixelRatio);
    pixmap.setDevicePixelRatio(devicePixelRatio);
    pixmap.fill(Qt::transparent);
    if (picture.drawn.isNull())
        return pixmap;
    constexpr int gap = 4;
    QPainter painter(&pixmap);
    const int cell = std::max(1,
                              std::min((size.width() - gap) / 2 / picture.drawn.width(),
                                       size.height() / picture.drawn.height()));
    const QSize part = picture.drawn.size() * cell;
    const int half = (size.width() - gap) / 2;
    const QPoint left((half - part.width()) / 2, (size.height() - part.height()) / 2);
    const QPoint right = left + QPoint(half + gap, 0);
    painter.drawImage(QRect(left, part), picture.drawn);
    painter.drawImage(QRect(right, part), picture.truth);
    for (const auto &[at, kind] : picture.marks)
        paintDifference(painter, QRectF(left + at * cell, QSizeF(cell, cell)), kind, palette);
    return pixmap;
}

} // namespace pixelplumb
