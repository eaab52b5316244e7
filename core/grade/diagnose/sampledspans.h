// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/diagnose/picturematch.h"

namespace pixelplumb {

/// A few columns of large pictures, or rows where the method goes by rows: most sets of defects
/// differ there so much that their pictures need not be drawn whole. Half of them stand where the
/// pictures found are wrong, half at equal distances.
class SampledSpans {
public:
    SampledSpans(DefectPictures &pictures, std::span<const FoundPicture> found);

    bool areSampled() const { return !m_sampled.empty(); }

    /// How many pixels differ in the whole pictures, estimated by those in the spans, up to a limit
    /// of at most those that differ from the right ones; certainly some where it is not 0. None
    /// where the spans do not tell: pictures are small, or pixels come from elsewhere in them.
    std::optional<std::int64_t> distance(const DefectSet &set, std::int64_t limit) const;

private:
    struct SampledSpan {
        FrameSpec part;
        Picture found;
    };
    struct SampledPicture {
        std::size_t scene = 0;
        std::vector<SampledSpan> spans;
    };

    SampledPicture sampled(const FoundPicture &found, const Picture &right) const;
    std::optional<std::int64_t> differingIn(const SampledPicture &sampled, const DefectSet &set,
                                            std::int64_t limit) const;

    DefectPictures &m_pictures;
    std::vector<SampledPicture> m_sampled;
    std::int64_t m_differing = 0; ///< of the right pictures
    std::int64_t m_differingInSpans = 0; ///< of these
};

} // namespace pixelplumb
