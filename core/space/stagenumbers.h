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
        m_numbers.push_back({name, used, unrounded(*exact),
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
    /// 20 digits, or more until the last is no 0; fewer only for a number that ends there.
    static QString unrounded(const ExactReal &exact)
    {
        constexpr int fewest = 20, most = 40;
        std::string text;
        for (int digits = fewest; digits <= most; ++digits) {
            text = exact.str(digits);
            const bool ends = abs(ExactReal(text) - exact) <= abs(exact) * ExactReal("1e-38");
            if (ends || text.size() > exact.str(digits - 1).size())
                break;
        }
        return QString::fromStdString(text);
    }

    std::vector<StageNumber> &m_numbers;
};

} // namespace pixelplumb
