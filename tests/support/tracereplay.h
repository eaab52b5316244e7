// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/runs/tracedscene.h"

/// What the tests of traces share that hold for every method of a family.
namespace pixelplumb {

/// A row for each arithmetic of each method of the family; the columns are "method" and
/// "arithmetic".
void addMethodsOf(MethodFamily family);

/// The picture that the changes of a trace make, one after the other.
QImage replayed(const ScanTrace &trace, const FrameSpec &frame);

} // namespace pixelplumb
