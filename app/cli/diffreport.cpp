// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/diffreport.h"

#include "app/cli/faintpixel.h"
#include "core/grade/diagnosis.h"

#include <QJsonArray>

namespace pixelplumb::cli {

namespace {

std::optional<QRgb> markOf(PixelVerdict verdict)
{
    switch (verdict) {
    case PixelVerdict::Same:
        break;
    case PixelVerdict::Missing:
        return qRgb(213, 94, 0);
    case PixelVerdict::Extra:
        return qRgb(0, 114, 178);
    case PixelVerdict::Colour:
        return qRgb(204, 121, 167);
    case PixelVerdict::Undecidable:
        return qRgb(240, 228, 66);
    }
    return std::nullopt;
}

} // namespace

QStringList textOf(const PictureDiff &diff)
{
    QStringList counts;
    for (const PixelVerdict verdict : allPixelVerdicts) {
        if (verdict == PixelVerdict::Same || diff.count(verdict) > 0)
            counts.append(QStringLiteral("%1 %2").arg(diff.count(verdict)).arg(nameOf(verdict)));
    }
    QString text = QStringLiteral("%1 × %2 pixels: %3")
                       .arg(diff.width)
                       .arg(diff.height)
                       .arg(counts.join(QStringLiteral(", ")));
    if (diff.largestError > 0)
        text += QStringLiteral("; a byte by %1 at most").arg(diff.largestError);
    QStringList lines = {text};
    constexpr qsizetype mostCauses = 3;
    for (const PictureCause &cause : diff.causes) {
        if (lines.size() > mostCauses)
            break;
        lines.append(cause.left == 0 ? QStringLiteral("explained wholly by: %1").arg(cause.name)
                                     : QStringLiteral("explained but for %1 by: %2")
                                           .arg(pixelsText(cause.left), cause.name));
    }
    return lines;
}

QJsonObject jsonOf(const PictureDiff &diff)
{
    QJsonObject object{{QStringLiteral("width"), diff.width},
                       {QStringLiteral("height"), diff.height},
                       {QStringLiteral("largestError"), diff.largestError}};
    for (const PixelVerdict verdict : allPixelVerdicts)
        object.insert(nameOf(verdict), qint64(diff.count(verdict)));
    QJsonArray causes;
    for (const PictureCause &cause : diff.causes)
        causes.append(QJsonObject{{QStringLiteral("cause"), cause.name},
                                  {QStringLiteral("left"), qint64(cause.left)}});
    object.insert(QStringLiteral("causes"), causes);
    return object;
}

QImage markedPicture(const PictureDiff &diff, const Picture &expected)
{
    QImage picture(diff.width, diff.height, QImage::Format_RGB32);
    for (int line = 0; line < diff.height; ++line) {
        auto *pixels = reinterpret_cast<QRgb *>(picture.scanLine(line));
        for (int x = 0; x < diff.width; ++x) {
            const std::size_t place = expected.placeOf(x, line);
            pixels[x] = markOf(diff.verdicts[place]).value_or(faint(expected.colours[place]));
        }
    }
    return picture;
}

} // namespace pixelplumb::cli
