// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tracecolumn.h"
#include "core/number/quantity.h"

#include <optional>
#include <vector>

namespace pixelplumb {

/// The numbers that formulas name, by the titles of their columns. What is added later is found
/// first, so that a sample's name hides a span's.
class FormulaNames {
public:
    void add(const QString &title, const Quantity &value,
             const std::optional<Quantity> &earlier = std::nullopt)
    {
        m_entries.push_back({title, value, earlier});
    }
    void add(const std::vector<TraceColumn> &columns, const std::vector<Quantity> &cells,
             const std::vector<Quantity> *earlier = nullptr);

    /// A formula's right side with each known name replaced by its number, a name with a prime by
    /// the number one step earlier.
    QString substituted(const QString &formula) const;

private:
    struct Entry {
        QString title;
        Quantity value;
        std::optional<Quantity> earlier;
    };

    /// The longest name that stands at a place of the text; null where there is none.
    const Entry *nameAt(const QString &text, qsizetype place) const;

    std::vector<Entry> m_entries;
};

} // namespace pixelplumb
