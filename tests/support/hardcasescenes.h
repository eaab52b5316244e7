// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/scenesformethods.h"

namespace pixelplumb {

/// The hard cases that open, each as the scene that the window's list of hard cases opens.
std::vector<NamedScene> hardCaseScenes();

/// The same cut down to the pixels around the place where a case is hard, and to the first dozen
/// primitives that reach them, so that every row of every run's tables can be written and read.
/// The vertices stay where they are: the way to that place keeps its length and its errors.
std::vector<NamedScene> hardCaseDetails();

} // namespace pixelplumb
