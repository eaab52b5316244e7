// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/colourvision.h"

#include "core/frame/srgb.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cstdint>

namespace pixelplumb {

namespace {

using ConeMatrix = std::array<std::array<float, 3>, 3>; ///< rows: of red, green and blue light

constexpr ConeMatrix protanopia = {{{0.152286F, 1.052583F, -0.204868F},
                                    {0.114503F, 0.786281F, 0.099216F},
                                    {-0.003882F, -0.048116F, 1.051998F}}};
constexpr ConeMatrix deuteranopia = {{{0.367322F, 0.860646F, -0.227968F},
                                      {0.280085F, 0.672501F, 0.047413F},
                                      {-0.011820F, 0.042940F, 0.968881F}}};
constexpr ConeMatrix tritanopia = {{{1.255528F, -0.076749F, -0.178779F},
                                    {-0.078411F, 0.930809F, 0.147602F},
                                    {0.004733F, 0.691367F, 0.303900F}}};

const ConeMatrix &matrixOf(ColourVision vision)
{
    switch (vision) {
    case ColourVision::Ordinary: // by whom it is not asked for
    case ColourVision::Protanopia:
        break;
    case ColourVision::Deuteranopia:
        return deuteranopia;
    case ColourVision::Tritanopia:
        return tritanopia;
    }
    return protanopia;
}

/// Between bytes and linear light, by tables: a window has millions of pixels.
class LightBytes {
public:
    LightBytes()
    {
        for (std::size_t byte = 0; byte < 256; ++byte) {
            m_light[byte] = float(linearLight(double(byte) / 255));
            m_end[byte] = float(linearLight((double(byte) + 0.5) / 255));
        }
        std::size_t byte = 0;
        for (std::size_t step = 0; step <= steps; ++step) {
            while (m_end[byte] <= float(step) / float(steps))
                ++byte;
            m_nearest[step] = std::uint8_t(byte);
        }
    }

    float light(int byte) const { return m_light[std::size_t(byte)]; }
    /// The nearest one, of light that may lie outside 0 … 1.
    int byte(float light) const
    {
        light = std::clamp(light, 0.0F, 1.0F);
        int byte = m_nearest[std::size_t(light * float(steps))];
        while (m_end[std::size_t(byte)] <= light)
            ++byte;
        return byte;
    }

private:
    static constexpr std::size_t steps = 4096;

    std::array<float, 256> m_light;
    std::array<float, 256> m_end; ///< from which on the next byte is nearer
    std::array<std::uint8_t, steps + 1> m_nearest; ///< of the light at the step's begin
};

QRgb transformed(const ConeMatrix &matrix, QRgb colour)
{
    static const LightBytes bytes;
    const float red = bytes.light(qRed(colour));
    const float green = bytes.light(qGreen(colour));
    const float blue = bytes.light(qBlue(colour));
    const auto channel = [&](const std::array<float, 3> &row) {
        return bytes.byte(row[0] * red + row[1] * green + row[2] * blue);
    };
    return qRgba(channel(matrix[0]), channel(matrix[1]), channel(matrix[2]), qAlpha(colour));
}

struct VisionNames {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::ColourVision)
};

} // namespace

QString nameOf(ColourVision vision)
{
    switch (vision) {
    case ColourVision::Ordinary:
        break;
    case ColourVision::Protanopia:
        return VisionNames::tr("protanopia");
    case ColourVision::Deuteranopia:
        return VisionNames::tr("deuteranopia");
    case ColourVision::Tritanopia:
        return VisionNames::tr("tritanopia");
    }
    return VisionNames::tr("ordinary vision");
}

QRgb seenWith(ColourVision vision, QRgb colour)
{
    return vision == ColourVision::Ordinary ? colour : transformed(matrixOf(vision), colour);
}

void seeWith(ColourVision vision, QImage &picture)
{
    picture.convertTo(QImage::Format_ARGB32);
    if (vision == ColourVision::Ordinary)
        return;
    const ConeMatrix &matrix = matrixOf(vision);
    // Neighbours are of one colour, mostly.
    QRgb last = qRgb(0, 0, 0);
    QRgb lastSeen = last;
    for (int row = 0; row < picture.height(); ++row) {
        auto *pixels = reinterpret_cast<QRgb *>(picture.scanLine(row));
        for (int column = 0; column < picture.width(); ++column) {
            if (pixels[column] != last) {
                last = pixels[column];
                lastSeen = transformed(matrix, last);
            }
            pixels[column] = lastSeen;
        }
    }
}

} // namespace pixelplumb
