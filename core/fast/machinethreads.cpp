// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/machinethreads.h"

#include <algorithm>
#include <thread>

namespace pixelplumb {

int threadsOfMachine()
{
    static const int threads = int(std::max(1U, std::thread::hardware_concurrency()));
    return threads;
}

} // namespace pixelplumb
