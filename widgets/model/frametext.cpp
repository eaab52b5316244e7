// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/frametext.h"

#include "widgets/model/scenedocument.h"

#include <QCoreApplication>

namespace pixelplumb {

namespace {

/// The translation context.
struct FrameText {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::FrameText)
};

} // namespace

std::optional<int> movingFrame(const SceneDocument &document)
{
    return document.scene().motion ? std::optional(document.currentFrame()) : std::nullopt;
}

QString frameText(const SceneDocument &document)
{
    const std::optional<int> frame = movingFrame(document);
    return frame ? FrameText::tr("frame %1 of %2 of the motion")
                       .arg(*frame)
                       .arg(document.scene().motion->frames - 1)
                 : QString();
}

} // namespace pixelplumb
