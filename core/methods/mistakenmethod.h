// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/kernelmethod.h"

/// How a program's mistakes become runs that can be stepped.
namespace pixelplumb {

/// The numbers without formulas, which say what a right program computes.
template <class State>
NumberTable<State> withoutFormulas(NumberTable<State> table)
{
    const auto forget = [](NumberDescription &description) {
        description.formula.clear();
        description.startFormula.clear();
    };
    for (NumberRow<State> &row : table) {
        forget(row.description);
        if (row.specify)
            row.specify = [forget, specify = row.specify](NumberDescription &description,
                                                          const State &state) {
                specify(description, state);
                forget(description);
            };
    }
    return table;
}

/// Like traceWith(), of a program with bugs.
template <class Kernel>
std::unique_ptr<ScanTrace> traceMistaken(const Run &run, FrameView frame,
                                         const TraceOptions &options)
{
    const Primitives &primitives = run.primitives;
    const ScanSettings &settings = run.settings;
    return Kernel::withNumbers(settings, IntegerWidth::Bits128, [&]<class A>() {
        using R = typename Kernel::template Recording<A>;
        const TablesOf<R> tables{withoutFormulas(R::setUpNumbers()),
                                 withoutFormulas(R::spanNumbers()),
                                 withoutFormulas(R::sampleNumbers())};
        return recordTrace<R>(
            primitives.size(), settings, options,
            [&](std::size_t index) { return Kernel::draws(primitives, index); },
            [&](std::size_t index, const auto &recorder) {
                Kernel::template scan<A>(Kernel::geometryOf(primitives, index), settings, frame,
                                         recorder);
            },
            std::make_shared<const TablesOf<R>>(tables));
    });
}

} // namespace pixelplumb
