// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/trace/numberdescription.h"

#include <algorithm>
#include <vector>

namespace pixelplumb {

/// Whether one of the numbers has this id.
inline bool hasNumber(const std::vector<NumberDescription> &descriptions, const QString &id)
{
    return std::ranges::find(descriptions, id, &NumberDescription::id) != descriptions.end();
}

/// The numbers of a record by their ids (NumberDescription::id).
class NamedNumbers {
public:
    /// Both must outlive it.
    NamedNumbers(const std::vector<NumberDescription> &descriptions,
                 const std::vector<Quantity> &cells)
        : m_descriptions(descriptions)
        , m_cells(cells)
    {
    }

    /// None if the record has no such number.
    Quantity operator[](const QString &id) const
    {
        const auto found = std::ranges::find(m_descriptions, id, &NumberDescription::id);
        const auto place = std::size_t(found - m_descriptions.begin());
        return place < m_cells.size() ? m_cells[place] : Quantity();
    }

private:
    const std::vector<NumberDescription> &m_descriptions;
    const std::vector<Quantity> &m_cells;
};

} // namespace pixelplumb
