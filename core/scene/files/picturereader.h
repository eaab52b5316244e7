// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBuffer>
#include <QImageReader>

namespace pixelplumb {

/// Reads a picture file and recognises its format by the content. What its decoder would print to
/// the terminal is reported as a fault. Pictures of up to 2^28 pixels are decoded, more than Qt
/// allows by default.
class PictureReader {
public:
    explicit PictureReader(const QByteArray &content);

    /// Where a PNG or BMP has a fault that its decoder would print or ignore; empty for a whole one
    /// and for other formats. A broken picture must not be decoded.
    const QString &fault() const { return m_fault; }
    QByteArray format() { return m_reader.format(); } ///< "png"; empty: no picture
    QSize size() { return m_reader.size(); } ///< px, before decoding; not valid: unknown
    QImage read() { return m_reader.read(); } ///< null where it cannot be decoded
    QString errorString() const { return m_reader.errorString(); }

private:
    QString m_fault;
    QByteArray m_content;
    QBuffer m_buffer;
    QImageReader m_reader;
};

} // namespace pixelplumb
