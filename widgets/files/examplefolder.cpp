// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/examplefolder.h"

#include <QtWidgets>

#include <algorithm>
#include <utility>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// The folders beside the sources and an installed program, nearest first.
QList<QDir> exampleFolders()
{
    QList<QDir> folders;
    QDir above(QCoreApplication::applicationDirPath());
    do {
        for (const char *scenes : {"resources/scenes", "share/pixelplumb/scenes"}) {
            const QDir folder(above.filePath(QString::fromLatin1(scenes)));
            if (folder.exists())
                folders.append(folder);
        }
    } while (above.cdUp());
    return folders;
}

struct Line {
    const char *name; ///< the file's, without its ending
    const char *text;
};

/// In the order of a course: triangles and what rounding does to them, lines and curves, polygons,
/// what is in space.
constexpr Line lines[] = {
    {"default",
     QT_TRANSLATE_NOOP("pixelplumb::Examples", "The assignment: one triangle, column by column")},
    {"vertical-edges",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Vertical and horizontal edges, where a quotient divides by zero")},
    {"shared-edge",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Two triangles share an edge: which one draws its pixels under "
                       "each fill rule")},
    {"ties-at-tenths",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Samples lie exactly on an edge whose slope is not a binary "
                       "fraction")},
    {"sliver",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "A triangle thinner than a pixel: missing and extra pixels in "
                       "float32")},
    {"stagnation",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Far from the origin, increments in float32 have no effect")},
    {"moving-sliver",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "A moving sliver: in float32 other pixels flicker than in the "
                       "truth")},
    {"sliver-fan",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Thin triangles without gaps: sixteen samples per pixel")},
    {"steep-line",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Steep lines by y = mx + b have gaps: why there are octants")},
    {"lines",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Bresenham's line in every octant, and the course's "
                       "own example from (20, 41) to (30, 44)")},
    {"even-lines",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Lines are equally bright in all directions: strokes drawn by "
                       "area")},
    {"circles", QT_TRANSLATE_NOOP("pixelplumb::Examples", "Circles and ellipses by the midpoint")},
    {"curves",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Bézier curves, halved until their pieces are straight")},
    {"filled-curves",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Closed paths of Bézier curves, filled along their chords")},
    {"polygon-outline",
     QT_TRANSLATE_NOOP("pixelplumb::Examples", "The edges of polygons as Bresenham's lines")},
    {"polygon-star",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "A star that crosses itself: even-odd beside non-zero")},
    {"text",
     QT_TRANSLATE_NOOP("pixelplumb::Examples", "Letters are polygons: outlines filled by parity")},
    {"crossing-triangles",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Two triangles cross: depth decides pixel by pixel")},
    {"glass-panes",
     QT_TRANSLATE_NOOP("pixelplumb::Examples", "Transparent triangles: the drawing order shows")},
    {"projected-triangle",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "One triangle in space, and each step that takes it to the screen")},
    {"textured-board",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "A chequered plane: what perspective correction corrects")},
    {"mesh",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "An icosahedron from an OBJ file, with flat shading")},
    {"lit-sphere",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "A sphere of triangles lit by two lights: Phong shading")},
    {"patch",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "A free-form surface, cut into triangles as finely as needed")},
};

/// Those without a line come last.
const Line *lineOf(const QString &name)
{
    return std::ranges::find_if(
        lines, [&name](const Line &each) { return name == QLatin1String(each.name); });
}

} // namespace

bool isExample(const QString &path)
{
    const QString folder = QFileInfo(path).dir().canonicalPath();
    if (folder.isEmpty())
        return false;
    for (const QDir &examples : exampleFolders()) {
        if (examples.canonicalPath() == folder)
            return true;
    }
    return false;
}

std::vector<Example> examples()
{
    std::vector<Example> all;
    const QList<QDir> folders = exampleFolders();
    if (folders.isEmpty())
        return all;
    QStringList names;
    for (const QString &file : folders.front().entryList({u"*.json"_s}, QDir::Files))
        names += QFileInfo(file).completeBaseName();
    std::ranges::stable_sort(names, {}, lineOf);
    for (const QString &name : std::as_const(names)) {
        QString title = QString(name).replace(u'-', u' ');
        title[0] = title[0].toUpper();
        const Line *line = lineOf(name);
        all.push_back({folders.front().filePath(name + u".json"_s), title,
                       line == std::ranges::end(lines)
                           ? QString()
                           : QCoreApplication::translate("pixelplumb::Examples", line->text)});
    }
    return all;
}

} // namespace pixelplumb
