// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/words/formulatext.h"
#include "core/number/quantity.h"
#include "core/trace/numberdescription.h"

#include <optional>
#include <vector>

namespace pixelplumb {

/// The numbers that formulas name, by the titles of their columns. Later additions are found first,
/// so that a sample's name hides a span's.
class FormulaNames {
public:
    void add(const QString &title, const Quantity &value,
             const std::optional<Quantity> &earlier = std::nullopt)
    {
        m_entries.push_back({title, value, earlier});
    }
    void add(const std::vector<NumberDescription> &columns, const std::vector<Quantity> &cells,
             const std::vector<Quantity> *earlier = nullptr);

    /// The right side of a number's formula with each known name replaced by its value, and a name
    /// with a prime by the value one step earlier. A name without a value stays. So does the
    /// number's own title: ⌈y_B⌉ is computed from y_B. Long values have `places` digits after the
    /// point.
    QString substituted(const QString &formula, const QString &title,
                        int places = usualPlaces) const;

private:
    struct Entry {
        QString title;
        Quantity value;
        std::optional<Quantity> earlier;
    };

    /// The longest name at a position of the text; null if there is none.
    const Entry *nameAt(const QString &text, qsizetype place, const QString &ownTitle) const;

    std::vector<Entry> m_entries;
};

} // namespace pixelplumb
