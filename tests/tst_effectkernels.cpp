// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/shadeddrawing.h"
#include "core/frame/framebuffer.h"
#include "core/oracle/effectoracle.h"
#include "tests/support/effectscenes.h"
#include "tests/support/planbyhand.h"

#include <QTest>

using namespace pixelplumb;

namespace {

constexpr std::array shadedMethods = {ShadedMethod::ColumnScan, ShadedMethod::Bilinear,
                                      ShadedMethod::Plane, ShadedMethod::Barycentric};
/// Those that the methods keep.
constexpr std::array keptRules = {FillRule::Closed, FillRule::HalfOpenColumn, FillRule::Open};

QString nameOf(ShadedMethod method)
{
    switch (method) {
    case ShadedMethod::ColumnScan:
        return QStringLiteral("column-scan");
    case ShadedMethod::Bilinear:
        return QStringLiteral("interpolate-bilinear");
    case ShadedMethod::Plane:
        return QStringLiteral("interpolate-plane");
    case ShadedMethod::Barycentric:
        return QStringLiteral("interpolate-barycentric");
    }
    return {};
}

/// A picture with the pixels that the truth cannot tell.
struct Truth {
    FrameBuffer frame;
    std::vector<oracle::PixelPlace> undecided;
};

Truth truthOf(const EffectScene &scene, const ScanSettings &settings)
{
    Truth truth{FrameBuffer(scene.frame), {}};
    truth.undecided
        = oracle::drawEffects(scene.primitives, settings,
                              oracle::truthOf(scene.primitives.appearance), truth.frame.view());
    return truth;
}

template <class Draw>
FrameBuffer drawnBy(const Draw &draw, ShadedMethod method, const EffectScene &scene,
                    const ScanSettings &settings)
{
    FrameBuffer frame(scene.frame);
    draw(method, scene.primitives, settings, frame.view(), planByHand(scene.primitives));
    return frame;
}

/// How a picture differs from another.
struct Departure {
    int pixels = 0; ///< that differ
    int levels = 0; ///< the largest difference of a byte
    QString first; ///< "(x, y): 1 2 3 instead of 4 5 6"
};

Departure departureOf(const FrameBuffer &drawn, const FrameBuffer &truth,
                      const std::vector<oracle::PixelPlace> &undecided = {})
{
    Departure departure;
    const FrameView view = truth.view();
    const auto text = [](const Colour &colour) {
        return QStringLiteral("%1 %2 %3").arg(colour.red()).arg(colour.green()).arg(colour.blue());
    };
    for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
        for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x) {
            const Colour is = unpacked(*drawn.view().at(x, y));
            const Colour should = unpacked(*view.at(x, y));
            if (is == should || std::ranges::count(undecided, oracle::PixelPlace{x, y}) > 0)
                continue;
            if (departure.pixels++ == 0)
                departure.first = QStringLiteral("(%1, %2): %3 instead of %4")
                                      .arg(x)
                                      .arg(y)
                                      .arg(text(is), text(should));
            for (std::size_t channel = 0; channel < 3; ++channel)
                departure.levels = std::max(
                    departure.levels, std::abs(is.channels[channel] - should.channels[channel]));
        }
    }
    return departure;
}

constexpr std::uint64_t seedCount = 30;

void addHardshipRows()
{
    QTest::addColumn<EffectHardship>("hardship");
    for (const EffectHardship hardship : allEffectHardships)
        QTest::newRow(qPrintable(nameOf(hardship))) << hardship;
}

} // namespace

Q_DECLARE_METATYPE(pixelplumb::EffectHardship)

/// The kernels of effects against the truth, which shares nothing with them, on random scenes.
class TestEffectKernels : public QObject {
    Q_OBJECT

private slots:
    void inExactArithmeticEveryMethodDrawsTheTruth_data() { addHardshipRows(); }
    void inExactArithmeticEveryMethodDrawsTheTruth()
    {
        QFETCH(EffectHardship, hardship);
        for (std::uint64_t seed = 0; seed < seedCount; ++seed) {
            const EffectScene scene = randomEffectScene(seed, hardship);
            for (const FillRule rule : keptRules) {
                const ScanSettings settings
                    = {Arithmetic::Exact, rule,
                       seed % 4 == 0 ? ByteRounding::Truncate : ByteRounding::Nearest};
                const Truth truth = truthOf(scene, settings);
                for (const ShadedMethod method : shadedMethods) {
                    const Departure departure = departureOf(
                        drawnBy(drawShaded, method, scene, settings), truth.frame, truth.undecided);
                    if (departure.pixels > 0)
                        QFAIL(qPrintable(QStringLiteral("seed %1, %2, %3: %4 pixels, %5")
                                             .arg(seed)
                                             .arg(scene.name, nameOf(method))
                                             .arg(departure.pixels)
                                             .arg(departure.first)));
                }
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestEffectKernels)
#include "tst_effectkernels.moc"
