// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scansettings.h"
#include "picture.h"

#include <memory>

namespace pixelplumb::bench {

enum class Role {
    Ours,
    Straight, ///< what a plain kernel is measured by: its arithmetic as one loop
    Student, ///< the assignment, written without a thought for speed
    Limit, ///< what the memory takes, no drawing
    Peer,
};

enum class Shading {
    Smooth,
    Flat, ///< gets the triangles in one colour each
};

/// A plain kernel: what the window steps through, with nothing listening.
struct PlainKernel {
    QString method = QStringLiteral("column-scan");
    ScanSettings settings;
};

/// What a renderer is and what it promises of its picture.
struct ContenderInfo {
    QString id; ///< "agg", for --filter and JSON
    QString name; ///< "AGG 2.6 span_gouraud_rgba"
    Role role = Role::Peer;
    Shading shading = Shading::Smooth;
    int threads = 1;
    /// The plain kernel that draws the same picture, bit for bit; in exact arithmetic that is the
    /// truth. None where nothing is promised.
    std::optional<PlainKernel> sameAsPlain;
    QString twinId = {}; ///< of a plain kernel: the straight loop that it is measured by

    /// The rule under which the oracle has to agree in every byte.
    std::optional<FillRule> exactUnder() const
    {
        if (sameAsPlain && sameAsPlain->settings.arithmetic == Arithmetic::Exact)
            return sameAsPlain->settings.fillRule;
        return std::nullopt;
    }
    /// Where the renderer's samples lie beside ours, lattice units, y upward; its picture is
    /// measured by the truth there. Not 0 where a library cannot be told otherwise.
    LatticePoint sampleOffset;
};

/// A renderer under the clock: one file each, behind this interface.
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

    /// Makes a black frame and the triangles ready in the renderer's own form. Not timed. The
    /// scene's triangles outlive every draw().
    virtual void load(const Scene &scene) = 0;
    /// Draws the scene over what the frame holds and returns when the pixels stand. Timed.
    virtual void draw() = 0;
    /// The frame as it is. Not timed; a black one from a Role::Limit.
    virtual Picture picture() = 0;

private:
    ContenderInfo m_info;
};

} // namespace pixelplumb::bench
