// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scansettings.h"
#include "picture.h"

#include <memory>

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

enum class Role {
    Ours,
    Straight, ///< the yardstick of a plain kernel: its arithmetic as one loop
    Student, ///< the assignment, written without a thought for speed
    Limit, ///< the cost of the memory alone, no drawing
    Peer,
};

enum class Shading {
    Smooth,
    Flat, ///< gets each triangle in a single colour
};

/// A plain kernel: the one the window steps through, without a listener.
struct PlainKernel {
    QString method = u"column-scan"_s;
    ScanSettings settings;
};

/// What a renderer is and what it promises about its picture.
struct ContenderInfo {
    QString id; ///< "agg", for --filter and JSON
    QString name; ///< "AGG 2.6 span_gouraud_rgba"
    Role role = Role::Peer;
    Shading shading = Shading::Smooth;
    int threads = 1;
    /// The plain kernel that draws the same picture, bit for bit; in exact arithmetic that is the
    /// truth. None if nothing is promised.
    std::optional<PlainKernel> sameAsPlain;
    QString twinId = {}; ///< for a plain kernel: the straight loop it is compared with

    /// The rule under which every byte must agree with the oracle.
    std::optional<FillRule> exactUnder() const
    {
        if (sameAsPlain && sameAsPlain->settings.arithmetic == Arithmetic::Exact)
            return sameAsPlain->settings.fillRule;
        return std::nullopt;
    }
    /// The offset of the renderer's samples from ours, in lattice units, y upward; its picture is
    /// compared with the truth there. Not 0 only for libraries that cannot be configured otherwise.
    LatticePoint sampleOffset;
};

/// A renderer to be timed; each is in its own file, behind this interface.
class Contender {
public:
    explicit Contender(ContenderInfo info)
        : m_info(std::move(info))
    {
    }
    virtual ~Contender() = default;
    Contender(const Contender &) = delete;
    Contender &operator=(const Contender &) = delete;

    const ContenderInfo &info() const { return m_info; }
    bool hasPicture() const { return m_info.role != Role::Limit; }

    /// Makes a black frame and converts the triangles to the renderer's own form. Not timed. The
    /// scene's triangles outlive every draw().
    virtual void load(const Scene &scene) = 0;
    /// Draws the scene over the frame and returns when the pixels are written. Timed.
    virtual void draw() = 0;
    /// The current frame. Not timed; black for a Role::Limit.
    virtual Picture picture() = 0;

private:
    ContenderInfo m_info;
};

} // namespace pixelplumb::bench
