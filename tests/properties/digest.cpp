// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/oracle.h"
#include "core/scan/walks/columnscan.h"

#include <cstdio>
#include <vector>

/// Prints a digest of the pictures of a fixed set of triangles for each arithmetic and rule, built
/// by several compilers at several optimisation levels: the lines must be the same. It includes the
/// kernels directly; of core's library it uses only the oracle's source, which is compiled with
/// this file.
namespace {

using namespace pixelplumb;

/// SplitMix64, as in tests/support/randomnumbers.h.
std::uint64_t nextRandom(std::uint64_t &state)
{
    state += 0x9e3779b97f4a7c15U;
    std::uint64_t bits = state;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31);
}

constexpr std::int32_t side = 96; ///< px

struct Sample {
    Triangle triangle;
    LatticePoint corner; ///< of the frame, px
};

/// Triangles of one family per number: whole pixels, 1/16 and 1/256 px, slivers, far away, beyond
/// 2^15 px.
Sample sampleNumber(int number)
{
    std::uint64_t state = std::uint64_t(number) + 1;
    const auto in = [&](Lattice first, Lattice last) {
        return first + Lattice(nextRandom(state) % std::uint64_t(last - first + 1));
    };
    const std::array<Lattice, 4> grids = {256, 16, 1, 256};
    const Lattice grid = grids[std::size_t(number % 4)];
    const bool isWide = number % 8 == 7;
    const Lattice extent = (isWide ? Lattice(1) << 20 : side) * unitsPerPixel / grid;
    const std::array<Lattice, 3> places = {0, 16384, -(Lattice(1) << 20)};
    const Lattice place = isWide ? -(Lattice(1) << 19) : places[std::size_t(number / 8 % 3)];
    Sample sample;
    for (Vertex &vertex : sample.triangle.vertices) {
        vertex.position = {in(0, extent) * grid + place * unitsPerPixel,
                           in(0, extent) * grid + place * unitsPerPixel};
        for (std::uint8_t &channel : vertex.colour.channels)
            channel = std::uint8_t(in(0, 255));
    }
    if (number % 5 == 0) { // a sliver: the third vertex near the middle of the others
        const LatticePoint a = sample.triangle.vertices[0].position;
        const LatticePoint b = sample.triangle.vertices[1].position;
        sample.triangle.vertices[2].position
            = {(a.x + b.x) / 2 / grid * grid, (a.y + b.y) / 2 / grid * grid + grid};
    }
    sample.corner = {place, place};
    if (isWide) {
        const LatticePoint a = sample.triangle.vertices[0].position;
        const LatticePoint b = sample.triangle.vertices[1].position;
        sample.corner
            = {floorPixel((a.x + b.x) / 2) - side / 2, floorPixel((a.y + b.y) / 2) - side / 2};
    }
    return sample;
}

class Digest {
public:
    /// FNV-1a, 64 bits.
    void add(const std::vector<QRgb> &pixels)
    {
        for (const QRgb pixel : pixels) {
            for (int shift = 0; shift < 32; shift += 8)
                m_value = (m_value ^ ((pixel >> shift) & 0xffU)) * 0x100000001b3U;
        }
    }
    unsigned long long value() const { return m_value; }

private:
    std::uint64_t m_value = 0xcbf29ce484222325U;
};

constexpr int sampleCount = 1920;

template <class Draw>
void print(const char *name, const char *rule, const Draw &draw)
{
    Digest digest;
    std::vector<QRgb> pixels;
    for (int number = 0; number < sampleCount; ++number) {
        const Sample sample = sampleNumber(number);
        pixels.assign(std::size_t(side) * side, QRgb(0));
        draw(sample.triangle,
             FrameView{pixels.data(), side, std::int32_t(sample.corner.x),
                       std::int32_t(sample.corner.y), side, side});
        digest.add(pixels);
    }
    std::printf("%-12s %-18s %016llx\n", name, rule, digest.value());
}

template <class A>
void printScan(const char *name)
{
    print(name, "closed", [](const Triangle &triangle, FrameView frame) {
        ColumnScan<A, NullObserver>(triangle, columnIntervals(FillRule::Closed),
                                    ByteRounding::Nearest, frame, {})
            .run();
    });
    print(name, "half-open-column", [](const Triangle &triangle, FrameView frame) {
        ColumnScan<A, NullObserver>(triangle, columnIntervals(FillRule::HalfOpenColumn),
                                    ByteRounding::Truncate, frame, {})
            .run();
    });
}

void printOracle(const char *rule, FillRule fillRule, ByteRounding rounding)
{
    print("oracle", rule, [&](const Triangle &triangle, FrameView frame) {
        oracle::draw(triangle, fillRule, rounding, frame);
    });
}

} // namespace

int main()
{
    printScan<ExactArithmetic<Int128>>("exact");
    printScan<RoundedArithmetic<float>>("float32");
    printScan<RoundedArithmetic<double>>("float64");
    printScan<RoundedArithmetic<FixedPoint16>>("fixed16.16");
    printScan<RoundedArithmetic<FixedPoint32>>("fixed32.32");
    printOracle("closed", FillRule::Closed, ByteRounding::Nearest);
    printOracle("half-open-column", FillRule::HalfOpenColumn, ByteRounding::Truncate);
    printOracle("top-left", FillRule::TopLeft, ByteRounding::Nearest);
    return 0;
}
