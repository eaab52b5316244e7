// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/scenedocument.h"

#include <QMenu>

namespace pixelplumb {

/// The forms that a primitive can take in its place: a circle or an ellipse, outlined or filled, by
/// either rule. The current form is checked; choosing another is an edit that can be undone.
class PrimitiveForms : public QMenu {
    Q_OBJECT

public:
    explicit PrimitiveForms(SceneDocument *document, QWidget *parent = nullptr);

    /// Offers the forms of this primitive; no forms without a primitive and for triangles and
    /// lines.
    void offer(std::optional<int> primitive);

private:
    void add(const QString &text, const Shape &form);

    SceneDocument *m_document;
    int m_primitive = -1;
};

} // namespace pixelplumb
