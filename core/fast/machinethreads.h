// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb {

/// How many threads the system lets this process run at once, 1 or more. The system is asked only
/// once, since that takes as long as a small picture.
int threadsOfMachine();

} // namespace pixelplumb
