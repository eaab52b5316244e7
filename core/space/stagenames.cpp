// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/stagenames.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

QString subscripted(QChar letter, std::size_t index)
{
    QString name(letter);
    for (const QChar digit : QString::number(index))
        name += QChar(u'₀' + digit.digitValue());
    return name;
}

} // namespace

QString faceVertexName(std::size_t vertex) { return subscripted(u'V', vertex); }

QString clippedCornerName(std::size_t corner) { return subscripted(u'C', corner); }

QString cameraPointName() { return u"the camera"_s; }

QString lightsPointName() { return u"the lights"_s; }

QString facePointName() { return u"the face"_s; }

bool isShared(const QString &point)
{
    return point == cameraPointName() || point == lightsPointName() || point == facePointName();
}

QString ofVertex(std::size_t vertex, const QString &number)
{
    return faceVertexName(vertex) + u'_' + number;
}

QString clipName(const QString &number, std::size_t vertex)
{
    return number + u'_' + faceVertexName(vertex);
}

} // namespace pixelplumb
