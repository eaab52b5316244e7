// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/interruption.h"

#include <csignal>

namespace pixelplumb::cli {

namespace {

volatile std::sig_atomic_t asked = 0;

extern "C" void noteInterruption(int signal)
{
    asked = 1;
    std::signal(signal, SIG_DFL);
}

} // namespace

Interruption::Interruption()
{
    asked = 0;
    std::signal(SIGINT, noteInterruption);
}

Interruption::~Interruption() { std::signal(SIGINT, SIG_DFL); }

bool Interruption::isAsked() { return asked != 0; }

} // namespace pixelplumb::cli
