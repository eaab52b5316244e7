// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scan/errorlimit.h"

#include <cmath>
#include <limits>

namespace pixelplumb {

namespace {

template <class Float>
double floatErrorLimit(double additions, double largest, double extent)
{
    constexpr double unit = double(std::numeric_limits<Float>::epsilon()) / 2;
    const auto halfUlp = [](double magnitude) {
        const auto number = Float(magnitude);
        return (double(std::nextafter(number, std::numeric_limits<Float>::infinity()))
                - double(number))
            / 2;
    };
    // Five roundings make the pre-step times the slope, three of them make the slope; the products
    // of these errors add less than one per mille.
    const double slope = 5.005 * unit * extent;
    // Errors may take the number past a power of two, where an ulp is twice as long.
    const double reached = largest + additions * halfUlp(largest) + slope;
    return additions * halfUlp(reached) + slope;
}

} // namespace

double errorLimit(Arithmetic arithmetic, double additions, double largest, double extent)
{
    switch (arithmetic) {
    case Arithmetic::Exact:
        return 0;
    case Arithmetic::Float32:
        return floatErrorLimit<float>(additions, largest, extent);
    case Arithmetic::Float64:
        return floatErrorLimit<double>(additions, largest, extent);
    case Arithmetic::Fixed16:
        return std::ldexp(additions + 1, -17);
    case Arithmetic::Fixed32:
        return std::ldexp(additions + 1, -33);
    }
    return 0;
}

} // namespace pixelplumb
