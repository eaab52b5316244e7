// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"
#include "core/grade/rounding/margin.h"

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

namespace pixelplumb {

/// At most two defects, as ascending indices in a list of defects, and in addition the arithmetic
/// and a defect that alone is no mistake.
struct DefectSet {
    std::optional<std::size_t> first = {}, second = {};
    std::optional<Arithmetic> arithmetic = {}; ///< none: the scene's own
    std::optional<std::size_t> choice = {};

    friend auto operator<=>(const DefectSet &, const DefectSet &) = default;
};

/// How much has been drawn, whatever it took: counted, it is the same on every machine.
struct DrawnWork {
    std::int64_t pictures = 0; ///< whole ones
    std::int64_t pixels = 0; ///< of these and of parts

    friend DrawnWork operator+(const DrawnWork &a, const DrawnWork &b)
    {
        return {a.pictures + b.pictures, a.pixels + b.pixels};
    }
    friend DrawnWork operator-(const DrawnWork &a, const DrawnWork &b)
    {
        return {a.pictures - b.pictures, a.pixels - b.pixels};
    }
};

/// The pictures that programs with defects draw of some scenes, shared by all submissions. Each is
/// drawn on first request and kept while there is room, 256 MiB for all; of others only the hash is
/// kept, and they are drawn again. Thread-safe.
class DefectPictures {
public:
    using SharedPicture = std::shared_ptr<const Picture>;
    using SharedRange = std::shared_ptr<const PictureRange>;

    explicit DefectPictures(std::vector<Scene> scenes);

    const std::vector<Scene> &scenes() const { return m_scenes; }
    /// The defects that some scene can have, those of the picture last: a defect without effect on
    /// one scene may change another. Arithmetics are not among them.
    const std::vector<Defect> &defects() const { return m_defects; }
    /// The arithmetics that some scene can use besides its own, each as a defect.
    const std::map<Arithmetic, Defect> &arithmetics() const { return m_arithmetics; }
    /// The defects of a set without its arithmetic.
    std::vector<Defect> defectsIn(const DefectSet &set) const;
    /// Like defectsIn(), in the version of one scene; those that it cannot have are left out.
    std::vector<Defect> ownDefectsIn(const DefectSet &set, std::size_t scene) const;
    /// All defects that one scene can have, including arithmetics.
    const std::vector<Defect> &defectsOf(std::size_t scene) const { return m_ofScene[scene]; }

    /// None where the scene cannot be drawn so.
    SharedPicture picture(std::size_t scene, const DefectSet &set);
    /// What programs with these defects draw by the margin; none where unknown. The set's own
    /// arithmetic is ignored.
    SharedRange range(std::size_t scene, const DefectSet &set, const Margin &margin);
    /// Whether as many pixels as the limit are known to differ from the picture found: one by the
    /// hash of a picture that was drawn before and not kept, or some without drawing it whole
    /// (differsAtOnce).
    bool isKnownToDiffer(std::size_t scene, const DefectSet &set, const Picture &found,
                         std::int64_t limit);
    /// Whether some pixels spread over the picture tell that at least `limit` differ: of sets with
    /// a change of the finished picture. For a limit of 1 that is certain.
    bool isBeyond(std::size_t scene, const DefectSet &set, const Picture &found,
                  std::int64_t limit);

    DrawnWork work() const { return {m_pictures, m_pixels}; }
    /// Counts a part of a picture that is drawn elsewhere.
    void countPart(std::size_t pixels) { m_pixels += std::int64_t(pixels); }

private:
    struct Drawn {
        std::size_t colourHash = 0, coverageHash = 0;
        bool canBeDrawn = false;
        SharedPicture picture; ///< none where there is no room

        bool isKnownToDiffer(const Picture &found) const; ///< by the hashes kept in its place
    };
    using Key = std::pair<std::size_t, DefectSet>;

    struct LastPicture {
        std::optional<Scene> scene;
        SharedPicture picture;
    };

    /// What a change of the picture is done to.
    struct Base {
        std::optional<DefectSet> set;
        SharedPicture picture;
        Colour background;
    };

    Base baseOf(std::size_t scene, const DefectSet &set);
    bool isRefusedAtOnce(std::size_t scene, const DefectSet &set, const Picture &found,
                         std::int64_t limit) const;
    bool isRefusedWhenChanged(std::size_t scene, const DefectSet &set, const Picture &found,
                              std::int64_t limit);
    SharedPicture scenePicture(std::size_t scene, const Scene &drawn);
    Scene sceneIn(std::size_t scene, const DefectSet &set) const; ///< in the set's arithmetic
    SharedPicture draw(std::size_t scene, const DefectSet &set);
    SharedPicture changed(std::size_t scene, const DefectSet &set);

    /// The defect in the scene's version; null where the scene cannot have it.
    const Defect *own(std::size_t scene, std::size_t defect) const;

    std::vector<Scene> m_scenes;
    std::vector<std::vector<Defect>> m_ofScene;
    std::vector<std::vector<std::optional<std::size_t>>> m_ownPlaces; ///< by scene and defect
    std::vector<Defect> m_defects;
    mutable std::mutex m_mutex;
    std::map<Arithmetic, Defect> m_arithmetics;
    std::map<Key, Drawn> m_drawn;
    std::map<std::tuple<Key, Leeway, Arithmetic>, SharedRange>
        m_ranges; ///< as far as there is room
    std::vector<LastPicture> m_lastScenePicture; ///< by scene
    std::vector<Base> m_lastBase; ///< by scene
    std::size_t m_kept = 0; ///< bytes of pictures
    std::atomic<std::int64_t> m_pictures = 0, m_pixels = 0; ///< drawn
};

} // namespace pixelplumb
