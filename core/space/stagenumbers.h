// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/exactreal.h"
#include "core/space/facestages.h"
#include "core/space/stagevectors.h"

#include <limits>

namespace pixelplumb {

/// Writes numbers as used, each with its unrounded value where there is one.
class StageNumberWriter {
public:
    explicit StageNumberWriter(std::vector<StageNumber> &numbers)
        : m_numbers(numbers)
    {
    }

    void add(const QString &name, double used, const ExactReal *exact, const QString &formula = {})
    {
        if (!exact) {
            m_numbers.push_back(
                {name, used, {}, std::numeric_limits<double>::quiet_NaN(), formula});
            return;
        }
        constexpr int digits = 20;
        m_numbers.push_back({name, used, QString::fromStdString(exact->str(digits)),
                             (ExactReal(used) - *exact).convert_to<double>(), formula});
    }
    void add(const QString &name, double used, const ExactReal &exact, const QString &formula = {})
    {
        add(name, used, &exact, formula);
    }
    /// The three components of a vector, named by `name`, with their formulas if any.
    void add(const Component &name, const SpaceVector<double> &used,
             const SpaceVector<ExactReal> *exact, const Component &formula = {})
    {
        const auto of = [&](QChar axis) { return formula ? formula(axis) : QString(); };
        add(name(u'x'), used.x, exact ? &exact->x : nullptr, of(u'x'));
        add(name(u'y'), used.y, exact ? &exact->y : nullptr, of(u'y'));
        add(name(u'z'), used.z, exact ? &exact->z : nullptr, of(u'z'));
    }
    /// x, y and z, each with the subscript.
    void add(const QString &subscript, const SpaceVector<double> &used,
             const SpaceVector<ExactReal> *exact, const Component &formula = {})
    {
        add([&](QChar axis) { return axis + subscript; }, used, exact, formula);
    }

private:
    std::vector<StageNumber> &m_numbers;
};

} // namespace pixelplumb
