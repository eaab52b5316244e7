// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scenefile.h"

/// What the tests of scene files share: texts of scenes, and what the reader says of them.
namespace pixelplumb {

/// A scene of 64 × 48 pixels with these members from line 4 on.
QByteArray sceneWith(const QByteArray &members);
/// A scene of one triangle; the x of its first vertex stands in line 5, column 21.
QByteArray sceneOfTriangleAt(const QByteArray &firstX);

/// The same with members that end in a comma, then primitives; single quotation marks stand for
/// double ones.
QByteArray sceneOf(const QByteArray &members, const QByteArray &primitives = {});

/// The reader's message; "no error" where it reads the text.
QString errorOf(const QByteArray &text);
/// The message without line and column.
QString faultOf(const QByteArray &text);

/// The text with each of these bytes in each place, one place at a time.
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

/// Any scene of triangles that a file can hold.
Scene randomScene(quint32 seed);

} // namespace pixelplumb
