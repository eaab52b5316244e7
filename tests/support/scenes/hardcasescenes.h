// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/scenes/scenesformethods.h"

namespace pixelplumb {

/// The hard cases that can be opened, each as the scene that the window's list opens.
std::vector<NamedScene> hardCaseScenes();

/// Like hardCaseScenes(), but cropped to the pixels around the place where a case is hard; if there
/// are more than a dozen triangles, the first dozen that reach these pixels are kept. So every row
/// of every run's tables can be written and read. The vertices stay where they are: the path to
/// that place keeps its length and its errors.
std::vector<NamedScene> hardCaseDetails();

} // namespace pixelplumb
