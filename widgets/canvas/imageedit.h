// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/affineimage.h"

#include <QUndoCommand>

#include <optional>

namespace pixelplumb {

class DisplayOptions;

/// A move of the affine map's image that can be undone like any edit: the image requested before
/// and after. The scene stays as it is, so the document does not become modified.
class ImageEdit final : public QUndoCommand {
public:
    /// Edits of the same drag become one.
    ImageEdit(DisplayOptions &options, const std::optional<AffineImage> &after,
              const std::optional<int> &drag = std::nullopt);

    void redo() override;
    void undo() override;
    int id() const override { return m_drag ? 2 : -1; } // 1 is that of the scene's edits
    bool mergeWith(const QUndoCommand *other) override;

private:
    DisplayOptions *m_options;
    std::optional<AffineImage> m_before;
    std::optional<AffineImage> m_after;
    std::optional<int> m_drag;
};

} // namespace pixelplumb
