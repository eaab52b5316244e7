// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb {

/// How many threads the system lets this process run at once, 1 or more. It is asked once, which
/// takes as long as a small picture.
int threadsOfMachine();

} // namespace pixelplumb
