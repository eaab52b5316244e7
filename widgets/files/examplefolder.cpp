// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/examplefolder.h"

#include <QtWidgets>

#include <algorithm>

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

constexpr Line lines[] = {
    {"circles", QT_TRANSLATE_NOOP("pixelplumb::Examples", "Circles and ellipses by the midpoint")},
    {"crossing-triangles",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Two triangles through each other: depth decides pixel by pixel")},
    {"curves",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Bézier curves, halved until their pieces are straight")},
    {"default",
     QT_TRANSLATE_NOOP("pixelplumb::Examples", "The assignment: one triangle, column by column")},
    {"even-lines",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Lines in all directions that are equally bright: strokes by area")},
    {"filled-curves",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Closed paths of Bézier curves, filled along their chords")},
    {"glass-panes",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "See-through triangles: the order of drawing is seen")},
    {"lines",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Bresenham's line in every octant, and the course's "
                       "own example from (20, 41) to (30, 44)")},
    {"lit-sphere",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "A sphere of triangles in the light of two lamps: Phong")},
    {"mesh",
     QT_TRANSLATE_NOOP("pixelplumb::Examples", "An icosahedron from an OBJ file, flatly shaded")},
    {"moving-sliver",
     QT_TRANSLATE_NOOP(
         "pixelplumb::Examples",
         "A sliver that moves: float32 lets its pixels flicker otherwise than truth")},
    {"patch",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "A free-form surface, cut into triangles as finely as needed")},
    {"polygon-outline",
     QT_TRANSLATE_NOOP("pixelplumb::Examples", "The edges of polygons as Bresenham's lines")},
    {"polygon-star",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "A star that crosses itself: even-odd beside non-zero")},
    {"projected-triangle",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "One triangle in space: each step of its way to the screen")},
    {"shared-edge",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Two triangles on one edge: who owns its pixels under which fill rule")},
    {"sliver",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "A triangle thinner than a pixel in float32: gaps and extras")},
    {"sliver-fan",
     QT_TRANSLATE_NOOP("pixelplumb::Examples", "Thin triangles, whole by sixteen samples a pixel")},
    {"stagnation",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Far from the origin float32's increments stand still")},
    {"steep-line",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Steep lines by y = mx + b: gaps, and the reason for octants")},
    {"text",
     QT_TRANSLATE_NOOP("pixelplumb::Examples", "Letters are polygons: outlines filled by parity")},
    {"textured-board",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "A chequered plane: what perspective correction mends")},
    {"ties-at-tenths",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Samples exactly on an edge whose slope is no binary fraction")},
    {"vertical-edges",
     QT_TRANSLATE_NOOP("pixelplumb::Examples",
                       "Vertical and level edges, where quotients have no value")},
};

QString lineOf(const QString &name)
{
    const auto *line = std::ranges::find_if(
        lines, [&name](const Line &each) { return name == QLatin1String(each.name); });
    return line == std::ranges::end(lines)
        ? QString()
        : QCoreApplication::translate("pixelplumb::Examples", line->text);
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
    for (const QString &file : folders.front().entryList({u"*.json"_s}, QDir::Files)) {
        const QString name = QFileInfo(file).completeBaseName();
        QString title = QString(name).replace(u'-', u' ');
        title[0] = title[0].toUpper();
        all.push_back({folders.front().filePath(file), title, lineOf(name)});
    }
    return all;
}

} // namespace pixelplumb
