// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb::cli {

/// While an instance is alive, the first Ctrl-C asks the command to end with what it has so far; a
/// second one ends the program.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption &) = delete;
    Interruption &operator=(const Interruption &) = delete;

    static bool isAsked();
};

} // namespace pixelplumb::cli
