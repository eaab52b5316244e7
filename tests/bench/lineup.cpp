// SPDX-License-Identifier: GPL-3.0-or-later
#include "lineup.h"

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

// Unused if every library was found.
[[maybe_unused]] void addAbsence(Lineup &lineup, const char *name, const char *package)
{
    lineup.absent.push_back(
        {QString::fromLatin1(name),
         u"%1 was not found when this was configured"_s.arg(QLatin1String(package))});
}

} // namespace

Lineup makeLineup()
{
    Lineup lineup;
    addFast(lineup);
    addPlain(lineup);
    addAssignment(lineup);
    addMemoryLimit(lineup);
    // The macros are 0 or 1, from CMakeLists.txt; the adapter of an absent library is not linked.
    if constexpr (PIXELPLUMB_BENCH_AGG)
        addAgg(lineup);
    else
        addAbsence(lineup, "AGG", "libagg-dev");
    if constexpr (PIXELPLUMB_BENCH_SDL2)
        addSdl(lineup);
    else
        addAbsence(lineup, "SDL2", "libsdl2-dev");
    if constexpr (PIXELPLUMB_BENCH_CAIRO)
        addCairo(lineup);
    else
        addAbsence(lineup, "Cairo", "libcairo2-dev");
    if constexpr (PIXELPLUMB_BENCH_LLVMPIPE)
        addLlvmpipe(lineup);
    else
        addAbsence(lineup, "Mesa llvmpipe", "libegl-dev or libgles-dev");
    if constexpr (PIXELPLUMB_BENCH_ALLEGRO)
        addAllegro(lineup);
    else
        addAbsence(lineup, "Allegro 4", "liballegro4-dev");
    addQPainter(lineup);
    return lineup;
}

} // namespace pixelplumb::bench
