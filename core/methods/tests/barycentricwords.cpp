// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/tests/barycentricwords.h"

#include "core/methods/tests/edgetestnames.h"
#include "core/methods/words/formulatext.h"

#include <QStringList>

namespace pixelplumb {

namespace {

/// "α of P₀, β of P₁ and γ of P₂".
QString weightsText(const EdgeTestForm &form)
{
    const EdgeTestNames names(form);
    QStringList owners;
    for (std::size_t line = 0; line < 3; ++line) {
        const QString vertex = names.vertexName(edgeEndsOf(form, line).opposite);
        owners.append(u"%1 of %2"_s.arg(names.weight(line), vertex.section(u' ', -1)));
    }
    const QString last = owners.takeLast();
    return owners.join(u", "_s) + u" and "_s + last;
}

} // namespace

void tellBarycentric(StepWords &words, const EdgeTestSetUpState &state, const EdgeTestForm &form)
{
    const EdgeTestNames names(form);
    QStringList vertices;
    for (std::size_t i = 0; i < 3; ++i)
        vertices.append(names.vertexName(i) + u' ' + pointText(state.vertices[i].position));
    words.sentence = vertices.join(u", "_s) + u'.';
    if (!state.zeroArea)
        words.sentence += u" The weights are %1."_s.arg(weightsText(form));
}

void tellBarycentric(StepWords &words, const EdgeTestSampleState &state, const EdgeTestForm &form)
{
    if (state.isCovered && !state.ofSegment)
        words.sentence
            = u"The weights %1 accept the sample: it is written."_s.arg(weightsText(form));
}

} // namespace pixelplumb
