// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenefile.h"

#include <cstdlib>

/// Takes any bytes: the reader accepts them or says what is wrong; what it accepts can be written
/// and read again as the same scene.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    using namespace pixelplumb;
    const QByteArray text(reinterpret_cast<const char *>(data), qsizetype(size));
    const Result<SceneReading> reading = readScene(text);
    if (!reading) {
        if (reading.error().message().isEmpty())
            std::abort();
        return 0;
    }
    for (const Triangle &triangle : reading->scene.triangles) {
        for (const Vertex &vertex : triangle.vertices) {
            if (!isWithinRange(vertex.position))
                std::abort();
        }
    }
    const Result<SceneReading> again = readScene(writeScene(reading->scene));
    if (!again || !(again->scene == reading->scene) || !again->snaps.empty())
        std::abort();
    return 0;
}
