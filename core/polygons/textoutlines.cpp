// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/textoutlines.h"

#include "core/polygons/glyphpen.h"

#include <QFile>
#include <QStandardPaths>
#include <QStringList>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <memory>
#include <mutex>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

struct LibraryDone {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct FaceDone {
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};
using Library = std::unique_ptr<FT_LibraryRec_, LibraryDone>;
using Face = std::unique_ptr<FT_FaceRec_, FaceDone>;

/// Its own library and face: FreeType shares nothing between libraries, so threads need no lock.
struct Font {
    Library library;
    Face face;
};

std::optional<Font> openFont()
{
    Font font;
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0)
        return std::nullopt;
    font.library.reset(library);
    FT_Face face = nullptr;
    const QByteArray path = QFile::encodeName(textFontFile());
    if (path.isEmpty() || FT_New_Face(library, path.constData(), 0, &face) != 0)
        return std::nullopt;
    font.face.reset(face);
    if (!FT_IS_SCALABLE(face) || face->units_per_EM == 0)
        return std::nullopt;
    return font;
}

FontPoint pointOf(const FT_Vector *vector) { return {vector->x, vector->y}; }

GlyphPen &penOf(void *pen) { return *static_cast<GlyphPen *>(pen); }

int moveTo(const FT_Vector *to, void *pen)
{
    penOf(pen).moveTo(pointOf(to));
    return 0;
}

int lineTo(const FT_Vector *to, void *pen)
{
    penOf(pen).lineTo(pointOf(to));
    return 0;
}

int quadraticTo(const FT_Vector *control, const FT_Vector *to, void *pen)
{
    penOf(pen).quadraticTo(pointOf(control), pointOf(to));
    return 0;
}

int cubicTo(const FT_Vector *control1, const FT_Vector *control2, const FT_Vector *to, void *pen)
{
    penOf(pen).cubicTo(pointOf(control1), pointOf(control2), pointOf(to));
    return 0;
}

} // namespace

QString textFontFile()
{
    // The folder's names on Debian, Fedora and Arch.
    const QStringList folders = {u"truetype/dejavu"_s, u"dejavu-sans-fonts"_s, u"TTF"_s};
    for (const QString &folder : folders) {
        QString file = QStandardPaths::locate(QStandardPaths::GenericDataLocation,
                                              u"fonts/%1/DejaVuSans.ttf"_s.arg(folder));
        if (!file.isEmpty())
            return file;
    }
    return {};
}

TextOutlines outlinesOf(const Shape &text)
{
    TextOutlines outlines;
    outlines.polygon.kind = PrimitiveKind::Polygon;
    outlines.polygon.fill = ShapeFill::NonZero;
    if (text.vertices.empty())
        return outlines;
    const std::optional<Font> font = openFont();
    if (!font) {
        outlines.rejection = PrimitiveRejection::FontMissing;
        return outlines;
    }
    FT_FaceRec *const face = font->face.get();
    const FontScale scale{text.vertices.front().position, text.textHeight, face->units_per_EM};
    GlyphPen pen(scale, text.vertices.front(), outlines.polygon);
    const FT_Outline_Funcs functions{moveTo, lineTo, quadraticTo, cubicTo, 0, 0};
    std::int64_t origin = 0;
    for (const char32_t character : QString::fromStdString(text.text).toUcs4()) {
        if (FT_Load_Char(face, character, FT_LOAD_NO_SCALE) != 0)
            continue;
        pen.setOrigin(origin);
        FT_Outline_Decompose(&face->glyph->outline, &functions, &pen);
        origin += face->glyph->metrics.horiAdvance;
        if (!pen.isWithinRange())
            break;
    }
    if (!pen.isWithinRange()) {
        outlines.rejection = PrimitiveRejection::OutlineTooLarge;
        outlines.polygon.vertices.clear();
        outlines.polygon.laterContours.clear();
    } else if (outlines.polygon.vertices.empty()) {
        outlines.rejection = PrimitiveRejection::NoOutline;
    }
    outlines.polygon.vertices.shrink_to_fit();
    outlines.contours = contoursOf(outlines.polygon);
    return outlines;
}

std::shared_ptr<const TextOutlines> sharedOutlinesOf(const Shape &text)
{
    static std::mutex mutex;
    static Shape lastText;
    static QString lastFont;
    static std::shared_ptr<const TextOutlines> last;
    const QString font = textFontFile();
    // Held while they are made: threads that ask at once shall wait and share them.
    const std::lock_guard guard(mutex);
    if (last && lastFont == font && lastText == text)
        return last;
    last.reset();
    last = std::make_shared<const TextOutlines>(outlinesOf(text));
    lastText = text;
    lastFont = font;
    return last;
}

Lattice advanceOf(const Shape &text)
{
    const std::optional<Font> font = openFont();
    if (!font)
        return 0;
    FT_FaceRec *const face = font->face.get();
    Int128 advance = 0; // font units
    for (const char32_t character : QString::fromStdString(text.text).toUcs4()) {
        if (FT_Load_Char(face, character, FT_LOAD_NO_SCALE) == 0)
            advance += face->glyph->metrics.horiAdvance;
    }
    return Lattice(advance * absolute(text.textHeight) / face->units_per_EM);
}

} // namespace pixelplumb
