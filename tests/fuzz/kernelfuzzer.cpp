// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/oracle/oracle.h"
#include "core/scan/walks/columndrawing.h"
#include "core/scene/text/coordinatetext.h"

#include <cstdlib>
#include <cstring>

using namespace pixelplumb;

namespace {

/// Takes values from the fuzzer's bytes; zero once they have run out.
class Bytes {
public:
    Bytes(const std::uint8_t *data, std::size_t size)
        : m_data(data)
        , m_size(size)
    {
    }

    template <class Value>
    Value take()
    {
        Value value = {};
        const std::size_t count = std::min(sizeof(Value), m_size);
        std::memcpy(&value, m_data, count);
        m_data += count;
        m_size -= count;
        return value;
    }

private:
    const std::uint8_t *m_data;
    std::size_t m_size;
};

/// The reader's own check, which comes before every kernel: the coordinate n/256 px as a file would
/// write it.
std::optional<Lattice> coordinateRead(std::int64_t units)
{
    const Result<SnappedNumber> read = parseCoordinate(u"%1/256"_s.arg(units));
    const bool fits = units >= -largestCoordinate && units <= largestCoordinate;
    if (read.isOk() != fits || (fits && read->units != units))
        std::abort();
    return fits ? std::optional(units) : std::nullopt;
}

/// A coordinate from any 64 bits; `form` says how many of them are used, so that near and far
/// coordinates are both common.
std::int64_t someCoordinate(Bytes &bytes, std::uint8_t form)
{
    const auto wide = bytes.take<std::int64_t>();
    constexpr std::array<int, 8> shifts = {0, 20, 25, 32, 40, 47, 50, 56};
    return wide >> shifts[form % 8];
}

/// A frame of 1 … 32 px per side, anywhere or on the triangle.
FrameSpec someFrame(Bytes &bytes, const Triangle &triangle)
{
    FrameSpec frame;
    const auto choice = bytes.take<std::uint8_t>();
    frame.width = 1 + bytes.take<std::uint8_t>() % 32;
    frame.height = 1 + bytes.take<std::uint8_t>() % 32;
    std::int64_t x = bytes.take<std::int32_t>() / 2;
    std::int64_t y = bytes.take<std::int32_t>() / 2;
    if (choice % 4 != 0) { // near a vertex, or between two
        const LatticePoint a = triangle.vertices[choice % 3].position;
        const LatticePoint b = triangle.vertices[choice / 4 % 3].position;
        x = floorPixel((a.x + b.x) / 2) - x % 32;
        y = floorPixel((a.y + b.y) / 2) - y % 32;
    }
    frame.firstColumn = std::int32_t(std::clamp(x, -largestPixel, largestPixel));
    frame.firstRow = std::int32_t(std::clamp(y, -largestPixel, largestPixel));
    return frame;
}

} // namespace

/// Takes any triangle within the range and any frame: no arithmetic may cause undefined behaviour
/// under any rule, and the exact one draws the truth.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    Bytes bytes(data, size);
    Triangle triangle;
    const auto forms = bytes.take<std::uint32_t>();
    for (std::size_t i = 0; i < 3; ++i) {
        Vertex &vertex = triangle.vertices[i];
        const auto x = coordinateRead(someCoordinate(bytes, std::uint8_t(forms >> (i * 6) & 7)));
        const auto y
            = coordinateRead(someCoordinate(bytes, std::uint8_t(forms >> (i * 6 + 3) & 7)));
        if (!x || !y)
            return 0; // refused: no kernel gets it
        vertex.position = {*x, *y};
        vertex.colour = {bytes.take<std::array<std::uint8_t, 3>>()};
    }
    const FrameSpec frame = someFrame(bytes, triangle);
    for (const FillRule rule : allFillRules) {
        for (const ByteRounding rounding : allByteRoundings) {
            const FrameBuffer truth(frame);
            oracle::draw(triangle, rule, rounding, truth.view());
            if (rule == FillRule::TopLeft || rule == FillRule::OffScreenPoint)
                continue;
            for (const Arithmetic arithmetic : allArithmetics) {
                const FrameBuffer drawn(frame);
                drawColumns({&triangle, 1}, {arithmetic, rule, rounding}, drawn.view());
                if (arithmetic == Arithmetic::Exact && drawn.image() != truth.image())
                    std::abort();
            }
        }
    }
    // The oracle sample by sample, at a corner of the frame, with all its numbers.
    for (const FillRule rule : allFillRules)
        oracle::judge(triangle, rule, frame.firstColumn, frame.firstRow);
    oracle::columnAt(triangle, FillRule::Closed, frame.firstColumn);
    oracle::hasTie(triangle, frame.firstColumn);
    oracle::colourAt(triangle, frame.firstColumn, frame.firstRow);
    return 0;
}
