// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defect.h"

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace pixelplumb {

/// At most two defects, by their places in a list of them, ascending, and beside them what is
/// computed in and one that alone is no mistake.
struct DefectSet {
    std::optional<std::size_t> first = {}, second = {};
    std::optional<Arithmetic> arithmetic = {}; ///< none: the scene's own
    std::optional<std::size_t> choice = {};

    friend auto operator<=>(const DefectSet &, const DefectSet &) = default;
};

/// The pictures that programs with defects draw of some scenes, for as many submissions as ask:
/// each is drawn when it is first asked for and kept as long as there is room for it, 256 MiB for
/// all; of others the hash is kept, and they are drawn again. Several threads may ask at once.
class DefectPictures {
public:
    using SharedPicture = std::shared_ptr<const Picture>;
    using SharedRange = std::shared_ptr<const PictureRange>;

    explicit DefectPictures(std::vector<Scene> scenes);

    const std::vector<Scene> &scenes() const { return m_scenes; }
    /// Those that some scene can have, what is done to a picture after all others: a defect that
    /// leaves one scene as it is may change another. Arithmetics are none of them.
    const std::vector<Defect> &defects() const { return m_defects; }
    /// What some scene can be computed in beside its own arithmetic, and that as a defect.
    const std::map<Arithmetic, Defect> &arithmetics() const { return m_arithmetics; }
    /// Without the arithmetic.
    std::vector<Defect> defectsIn(const DefectSet &set) const;
    /// The same as one of the scenes has them; those that it cannot have are left out.
    std::vector<Defect> ownDefectsIn(const DefectSet &set, std::size_t scene) const;
    /// All that one of the scenes can have, arithmetics among them.
    const std::vector<Defect> &defectsOf(std::size_t scene) const { return m_ofScene[scene]; }

    /// None where the scene cannot be drawn so.
    SharedPicture picture(std::size_t scene, const DefectSet &set);
    /// What programs draw that have these defects and compute in arithmetic up to this one; none
    /// where nobody knows. The set's own is not asked.
    SharedRange range(std::size_t scene, const DefectSet &set, Arithmetic arithmetic);
    /// Whether what was drawn before, and not kept, differs by its hash from what was found, or, if
    /// it was not, does so at once (differsAtOnce).
    bool isKnownToDiffer(std::size_t scene, const DefectSet &set, const Picture &found) const;

private:
    struct Drawn {
        std::size_t colourHash = 0, coverageHash = 0;
        bool canBeDrawn = false;
        SharedPicture picture; ///< none where there is no room

        bool isKnownToDiffer(const Picture &found) const; ///< by what was kept in its place
    };
    using Key = std::pair<std::size_t, DefectSet>;

    struct LastPicture {
        std::optional<Scene> scene;
        SharedPicture picture;
    };

    bool isRefusedAtOnce(std::size_t scene, const DefectSet &set, const Picture &found) const;
    SharedPicture scenePicture(std::size_t scene, const Scene &drawn);
    Scene sceneIn(std::size_t scene, const DefectSet &set) const; ///< in the set's arithmetic
    SharedPicture draw(std::size_t scene, const DefectSet &set);
    SharedPicture changed(std::size_t scene, const DefectSet &set);

    /// As the scene has it; null where it cannot.
    const Defect *own(std::size_t scene, std::size_t defect) const;

    std::vector<Scene> m_scenes;
    std::vector<std::vector<Defect>> m_ofScene;
    std::vector<std::vector<std::optional<std::size_t>>> m_ownPlaces; ///< by scene and defect
    std::vector<Defect> m_defects;
    mutable std::mutex m_mutex;
    std::map<Arithmetic, Defect> m_arithmetics;
    std::map<Key, Drawn> m_drawn;
    std::map<std::pair<Key, Arithmetic>, SharedRange> m_ranges; ///< those that there is room for
    std::vector<LastPicture> m_lastScenePicture; ///< by scene
    std::size_t m_kept = 0; ///< bytes of pictures
};

} // namespace pixelplumb
