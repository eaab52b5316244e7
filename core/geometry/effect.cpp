// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/effect.h"

#include <QtGlobal>

namespace pixelplumb {

std::string_view nameOf(Effect effect)
{
    static constexpr std::array<std::string_view, allEffects.size()> names
        = {QT_TRANSLATE_NOOP("core", "smooth colour"), QT_TRANSLATE_NOOP("core", "clipping"),
           QT_TRANSLATE_NOOP("core", "depth"),         QT_TRANSLATE_NOOP("core", "perspective"),
           QT_TRANSLATE_NOOP("core", "texture"),       QT_TRANSLATE_NOOP("core", "light"),
           QT_TRANSLATE_NOOP("core", "blending"),      QT_TRANSLATE_NOOP("core", "antialiasing")};
    return names[std::size_t(effect)];
}

} // namespace pixelplumb
