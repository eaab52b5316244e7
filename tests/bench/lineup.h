// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contender.h"

#include <vector>

namespace pixelplumb::bench {

/// A renderer that could not take part, with the reason.
struct Absence {
    QString name;
    QString reason;
};

/// The contenders, in the order of the table.
struct Lineup {
    std::vector<std::unique_ptr<Contender>> contenders;
    std::vector<Absence> absent;
    /// The reference of all ratios: our best for smooth triangles on one thread.
    QString referenceId;
};

Lineup makeLineup();

/// The plain kernel's picture of a scene.
Picture plainPicture(const Scene &scene, const PlainKernel &kernel);

// One adapter per file. Each appends its contenders, or the reason why it has none.

void addPlain(Lineup &lineup);
void addFast(Lineup &lineup);
void addAssignment(Lineup &lineup);
void addMemoryLimit(Lineup &lineup);
void addAgg(Lineup &lineup);
void addSdl(Lineup &lineup);
void addCairo(Lineup &lineup);
void addLlvmpipe(Lineup &lineup);
void addAllegro(Lineup &lineup);
void addQPainter(Lineup &lineup);

} // namespace pixelplumb::bench
