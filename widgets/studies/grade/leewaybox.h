// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/rounding/margin.h"
#include "widgets/look/labels.h"

#include <optional>

namespace pixelplumb {

/// Chooses which pixels a right program may have otherwise, each by its name in assignments and on
/// the command line, and in words.
class LeewayBox : public ElidingBox {
    Q_OBJECT

public:
    explicit LeewayBox(const char *name, QWidget *parent = nullptr);

    /// Puts a choice before the others that is none of them, and chooses it.
    void offerNone(const QString &text);
    std::optional<Leeway> leeway() const; ///< none: that choice
    void setLeeway(Leeway leeway); ///< without a signal

signals:
    void leewayChosen(pixelplumb::Leeway leeway);
};

} // namespace pixelplumb
