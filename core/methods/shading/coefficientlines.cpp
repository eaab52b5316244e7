// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/coefficientlines.h"

#include <tuple>

namespace pixelplumb {

QStringList coefficientLines(InterpolationForm form, const QString &values)
{
    if (form != InterpolationForm::Barycentric)
        return {u"C ← (x₁ − x₀)·(y₂ − y₀) − (y₁ − y₀)·(x₂ − x₀)"_s,
                u"for %1: A_v ← (y₁ − y₀)·(v₂ − v₀) − (v₁ − v₀)·(y₂ − y₀); B_v ← (v₁ − v₀)·(x₂ − "
                "x₀) − (x₁ − x₀)·(v₂ − v₀); D_v ← −(A_v·x₀ + B_v·y₀ + C·v₀)"_s.arg(values),
                u"for %1: a_v, b_v, c_v ← −A_v/C, −B_v/C, −D_v/C"_s.arg(values)};
    QStringList lines;
    for (const auto &[weight, own, from, to] :
         {std::tuple(u'α', u'₀', u'₁', u'₂'), std::tuple(u'β', u'₁', u'₂', u'₀'),
          std::tuple(u'γ', u'₂', u'₀', u'₁')}) {
        lines += u"A_α, B_α ← y& − y#, x# − x&; C_α ← −A_α·x# − B_α·y#; k_α ← 1/(A_α·x@ + B_α·y@ + "
                 "C_α); a_α, b_α, c_α ← k_α·A_α, k_α·B_α, k_α·C_α"_s.replace(u'α', QChar(weight))
                     .replace(u'@', QChar(own))
                     .replace(u'#', QChar(from))
                     .replace(u'&', QChar(to));
    }
    return lines;
}

} // namespace pixelplumb
