// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>

namespace pixelplumb {

/// A PBM, PGM or PPM file, in text (P1 … P3) or binary (P4 … P6). Qt reads these, too, but takes a
/// broken file for a whole one, and cuts levels whose greatest is not 255.
class PnmPicture {
public:
    static bool isPnm(const QByteArray &content);
    /// Reads the header.
    explicit PnmPicture(const QByteArray &content);

    /// What is wrong with it, as far as it was read: "line 4: no level from 0 to 255".
    const QString &fault() const { return m_fault; }
    QByteArray format() const; ///< "pbm", "pgm", "ppm"
    QSize size() const { return {m_width, m_height}; } ///< px
    /// Levels as the nearest of 0 … 255, halves up; null where it is broken or memory is lacking.
    QImage read();

private:
    bool isText() const { return m_digit <= '3'; }
    bool isBitmap() const { return m_digit == '1' || m_digit == '4'; }
    bool hasColours() const { return m_digit == '3' || m_digit == '6'; }
    QString kind() const { return QString::fromLatin1(format().toUpper()); }
    qint64 levelsOfLine() const { return qint64(m_width) * (hasColours() ? 3 : 1); }
    qint64 bytesOfLine() const;
    void keepMissing(qint64 found, qint64 needed, const char *what);
    template <class Next>
    void readLevels(const Next &next, QImage &picture);
    void readText(QImage &picture);
    void readBinary(QImage &picture);

    QByteArray m_content;
    char m_digit; ///< of P1 … P6
    int m_width = 0;
    int m_height = 0;
    int m_greatest = 1; ///< levels run from 0 to this one
    qsizetype m_headersEnd = 0;
    int m_line = 1; ///< in which the header ends
    QString m_fault;
};

} // namespace pixelplumb
