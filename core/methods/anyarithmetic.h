// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/biasnumber.h"

#include <array>

/// The kernel's numbers as quantities, so that one table serves every arithmetic.
namespace pixelplumb {

/// Takes the place of the kernel's arithmetic.
struct AnyArithmetic {
    using Number = Quantity;
};

template <class Number, std::size_t Count>
std::array<Quantity, Count> quantitiesOf(const std::array<Number, Count> &numbers)
{
    std::array<Quantity, Count> quantities;
    for (std::size_t i = 0; i < Count; ++i)
        quantities[i] = quantityOf(numbers[i]);
    return quantities;
}

} // namespace pixelplumb
