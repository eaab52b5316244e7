// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/files/pngpicture.h"
#include "core/scene/files/pnmpicture.h"

#include <QBuffer>
#include <QImageReader>

#include <optional>

namespace pixelplumb {

/// Reads a picture file and recognises its format by the content. Nothing is printed to the
/// terminal. Pictures of up to 2^28 pixels are decoded, more than Qt allows by default.
class PictureReader {
public:
    explicit PictureReader(const QByteArray &content);

    /// What is wrong with it, as far as it was read; empty for whole pictures and for other formats
    /// than PNG, PNM and BMP.
    QString fault() const { return m_png ? m_png->fault() : m_pnm ? m_pnm->fault() : m_bmpFault; }
    QByteArray format(); ///< "png", "ppm", …; empty: no picture
    /// In px, before decoding; not valid: unknown.
    QSize size();
    /// Null where it cannot be decoded.
    QImage read() { return m_png ? m_png->read() : m_pnm ? m_pnm->read() : m_reader.read(); }
    QString errorString() const { return m_png || m_pnm ? fault() : m_reader.errorString(); }

private:
    std::optional<PngPicture> m_png;
    std::optional<PnmPicture> m_pnm;
    QString m_bmpFault;
    QByteArray m_content;
    QBuffer m_buffer;
    QImageReader m_reader;
};

} // namespace pixelplumb
