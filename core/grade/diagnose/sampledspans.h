// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/pictures/chosenspans.h"

namespace pixelplumb {

/// Pixels; smaller pictures are drawn whole as soon.
inline constexpr std::size_t largePicture = 1U << 15;

/// A few columns of large pictures, or rows where the method goes by rows: most sets of defects
/// differ there so much that their pictures need not be drawn whole. Half of them stand where the
/// pictures found are wrong, half at equal distances.
class SampledSpans {
public:
    SampledSpans(DefectPictures &pictures, std::span<const FoundPicture> found);

    bool areSampled() const { return !m_sampled.empty(); }
    const SampledPart &part() const { return m_part; } ///< of all pictures

    /// How many pixels differ in the whole pictures, estimated by those in the spans, up to a limit
    /// of at most those that differ from the right ones; certainly some where it is not 0. None
    /// where the spans do not tell: pictures are small, or pixels come from elsewhere in them. What
    /// differs in every fourth of them by a quarter more than its share counts as beyond the limit.
    std::optional<std::int64_t> distance(const DefectSet &set, std::int64_t limit) const;

private:
    struct SampledPicture {
        std::size_t scene = 0;
        ChosenSpans chosen;
        Picture found; ///< of these spans
        std::vector<SampledPicture> spans = {}; ///< each of them alone
    };

    SampledPicture sampled(const FoundPicture &found, const Picture &right) const;
    static SampledPicture fewOf(const SampledPicture &sampled, const FrameSpec &frame,
                                const Picture &found);
    static ChosenSpans aroundOf(const ChosenSpans &chosen, const FrameSpec &frame);
    /// Of few spans, with a change that takes pixels from other places, as far as these are drawn.
    std::optional<std::int64_t> differingMoved(std::size_t index, const DefectSet &set,
                                               std::int64_t limit) const;
    Picture drawn(const SampledPicture &sampled, const Scene &scene,
                  const std::optional<Defect> &redrawing) const;
    const Picture &baseOf(const SampledPicture &sampled, const DefectSet &set, const Scene &scene,
                          const std::optional<Defect> &redrawing) const;
    std::optional<std::int64_t> differingIn(const SampledPicture &sampled, const DefectSet &set,
                                            std::int64_t limit) const;
    std::optional<std::int64_t> differingIn(const std::vector<SampledPicture> &pictures,
                                            const DefectSet &set, std::int64_t limit) const;

    DefectPictures &m_pictures;
    std::vector<SampledPicture> m_sampled;
    std::vector<SampledPicture> m_few; ///< every fourth span of these
    using BaseKey = std::pair<const SampledPicture *, DefectSet>;
    mutable std::pair<BaseKey, Picture> m_lastBase = {}, m_lastMoved = {};
    SampledPart m_part;
    std::int64_t m_differing = 0; ///< of the right pictures
    std::int64_t m_differingInSpans = 0; ///< of these
    std::int64_t m_differingInFew = 0; ///< of these
};

} // namespace pixelplumb
