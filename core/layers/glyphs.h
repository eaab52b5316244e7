// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainterPath>
#include <QString>

#include <unordered_map>

namespace pixelplumb {

/// The outlines of characters, each looked up once: text without a font system, so that a program
/// without a display can write it, and the same picture has the same bytes everywhere. Without the
/// font (textFontFile) there is no text. Subscripts are lowered (symbolRuns).
class Glyphs {
public:
    /// In ems.
    double widthOf(const QString &text);
    /// From the start of the baseline at (0, 0), in ems, y downward.
    QPainterPath outlineOf(const QString &text);

private:
    struct Glyph {
        QPainterPath outline;
        double advance = 0;
    };

    const Glyph &glyphOf(char32_t character);

    std::unordered_map<char32_t, Glyph> m_glyphs;
};

} // namespace pixelplumb
