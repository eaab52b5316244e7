// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBuffer>
#include <QImageReader>

namespace pixelplumb {

/// Reads a picture's file, of a kind that its content tells. What its decoder would write to the
/// terminal is told as a fault, and pictures of up to 2^28 pixels are decoded, of which Qt reads
/// less by itself.
class PictureReader {
public:
    explicit PictureReader(const QByteArray &content);

    /// Where a PNG or a BMP is broken that its decoder would complain of by itself, or take; empty
    /// of a whole one and of other kinds. What is broken is not to be decoded.
    const QString &fault() const { return m_fault; }
    QByteArray format() { return m_reader.format(); } ///< "png"; empty: it is no picture
    QSize size() { return m_reader.size(); } ///< px, before it is decoded; not valid: unknown
    QImage read() { return m_reader.read(); } ///< null where it cannot be decoded
    QString errorString() const { return m_reader.errorString(); }

private:
    QString m_fault;
    QByteArray m_content;
    QBuffer m_buffer;
    QImageReader m_reader;
};

} // namespace pixelplumb
