// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/glyphs.h"

#include "core/polygons/contours.h"
#include "core/polygons/textoutlines.h"
#include "core/trace/symbolruns.h"

#include <QTransform>

namespace pixelplumb {

namespace {

constexpr Lattice emHeight
    = 24 * unitsPerPixel; ///< fine enough for chords, coarse enough for few of them

/// How a run of characters is set.
struct Setting {
    double size = 1; ///< of the line's
    double drop = 0; ///< ems below the baseline
};

Setting settingOf(const SymbolRun &run)
{
    return run.level == SymbolRun::Level::Subscript ? Setting{0.75, 0.17} : Setting{};
}

} // namespace

double Glyphs::widthOf(const QString &text)
{
    double width = 0;
    for (const SymbolRun &run : symbolRuns(text)) {
        for (const char32_t character : run.text.toUcs4())
            width += settingOf(run).size * glyphOf(character).advance;
    }
    return width;
}

QPainterPath Glyphs::outlineOf(const QString &text)
{
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    double origin = 0;
    for (const SymbolRun &run : symbolRuns(text)) {
        const auto [size, drop] = settingOf(run);
        for (const char32_t character : run.text.toUcs4()) {
            const Glyph &glyph = glyphOf(character);
            path.addPath(QTransform(size, 0, 0, size, origin, drop).map(glyph.outline));
            origin += size * glyph.advance;
        }
    }
    return path;
}

const Glyphs::Glyph &Glyphs::glyphOf(char32_t character)
{
    const auto [place, isNew] = m_glyphs.try_emplace(character);
    if (!isNew)
        return place->second;
    Shape text;
    text.kind = PrimitiveKind::Text;
    text.vertices = {Vertex{}};
    text.text = QString::fromUcs4(&character, 1).toStdString();
    text.textHeight = -emHeight;
    Glyph &glyph = place->second;
    glyph.advance = double(advanceOf(text)) / emHeight;
    const auto pointOf = [](const LatticePoint &point) {
        return QPointF(double(point.x), double(point.y)) / emHeight;
    };
    const LatticePoint *end = nullptr;
    const Contours contours = outlinesOf(text).contours;
    for (const ContourEdge &edge : contours.edges) {
        if (!end || edge.from != *end)
            glyph.outline.moveTo(pointOf(edge.from));
        glyph.outline.lineTo(pointOf(edge.to));
        end = &edge.to;
    }
    return glyph;
}

} // namespace pixelplumb
