// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgewalknames.h"
#include "core/trace/stepwords.h"

namespace pixelplumb {

/// What an edge walk says of its steps.
class EdgeWalkWords {
public:
    explicit EdgeWalkWords(const EdgeWalkForm &form)
        : m_names(form)
    {
    }

    void tell(StepWords &words, const EdgeWalkSetUpState &state) const;
    void tell(StepWords &words, const EdgeWalkSpanState &state) const;
    void tell(StepWords &words, const EdgeWalkSampleState &state) const;

private:
    /// What happens at the middle vertex; empty where nothing does.
    QString turnSentence(const EdgeWalkSpanState &state) const;
    QString emptySentence(const EdgeWalkSpanState &state) const;
    QString coverSentence(const EdgeWalkSpanState &state) const;
    QString departureSentence(const EdgeWalkSpanState &state) const;

    EdgeWalkNames m_names;
};

} // namespace pixelplumb
