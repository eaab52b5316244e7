// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>

#include <png.h>

#include <string>

namespace pixelplumb {

/// Reads a PNG by libpng, with its words for what is wrong. Colours are those that the file stores:
/// neither gamma nor a profile changes them.
class PngPicture {
public:
    static bool isPng(const QByteArray &content);

    explicit PngPicture(const QByteArray &content); ///< reads the header
    ~PngPicture();
    Q_DISABLE_COPY_MOVE(PngPicture)

    const QString &fault() const { return m_fault; } ///< of what was read; empty: none
    QSize size() const { return m_size; } ///< px; not valid where the header is broken
    QImage read(); ///< null where the pixels are broken

private:
    void keepFault();

    std::string m_content; ///< libpng's image refers to it
    png_image m_image = {};
    QSize m_size;
    QString m_fault;
};

} // namespace pixelplumb
