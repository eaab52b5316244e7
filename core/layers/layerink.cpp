// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layerink.h"

namespace pixelplumb {

namespace {

struct InkColours {
    QRgb light; ///< on light paper
    QRgb dark; ///< on dark paper
};

InkColours coloursOf(LayerInk ink)
{
    switch (ink) {
    case LayerInk::Mark:
        return {0x202020, 0xf0f0f0};
    case LayerInk::First:
    case LayerInk::Inside:
        return {0x0072b2, 0x56b4e9};
    case LayerInk::Second:
        return {0xb34700, 0xff9e4a};
    case LayerInk::Third:
        return {0x8a3f6e, 0xe39ac4};
    case LayerInk::Negative:
        return {0xb34700, 0xff9e4a};
    case LayerInk::Hand:
        return {0x00775a, 0x2fd0a0};
    }
    return {0, 0xffffff};
}

} // namespace

QColor colourOf(LayerInk ink, LayerTone tone)
{
    const InkColours colours = coloursOf(ink);
    return QColor::fromRgb(tone == LayerTone::Light ? colours.light : colours.dark);
}

QColor paperOf(LayerTone tone)
{
    return QColor::fromRgb(tone == LayerTone::Light ? 0xffffff : 0x202020);
}

} // namespace pixelplumb
