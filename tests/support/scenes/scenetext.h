// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scenefile.h"

/// Shared helpers of the scene-file tests: scene texts, and the reader's messages about them.
namespace pixelplumb {

/// A scene of 64 × 48 pixels with these members from line 4 on.
QByteArray sceneWith(const QByteArray &members);
/// A scene of one triangle; the x of its first vertex is at line 5, column 21.
QByteArray sceneOfTriangleAt(const QByteArray &firstX);

/// A scene with members (ending in a comma), then primitives; apostrophes stand for double
/// quotation marks.
QByteArray sceneOf(const QByteArray &members, const QByteArray &primitives = {});

/// The reader's message; "no error" if it reads the text.
QString errorOf(const QByteArray &text);
/// The message without line and column.
QString faultOf(const QByteArray &text);

/// Calls the function with each of these bytes in each position of the text, one position at a
/// time.
template <class Function>
void forEachDamaged(const QByteArray &text, QByteArrayView wrongBytes, const Function &function)
{
    for (qsizetype position = 0; position < text.size(); ++position) {
        for (const char wrong : wrongBytes) {
            QByteArray damaged = text;
            damaged[position] = wrong;
            function(damaged);
        }
    }
}

/// A random scene of triangles that a file can hold.
Scene randomScene(quint32 seed);

} // namespace pixelplumb
