// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/scanning.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/scenetracer.h"
#include "widgets/window/mainwindow.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QTest>
#include <QTimer>

#include <cmath>
#include <ctime>
#include <memory>
#include <random>

/// Scenes with many triangles, and a window that shows them.
namespace pixelplumb {

inline constexpr int timeout = 120'000; // ms, for busy machines

/// Random triangles of this expected area anywhere in the frame.
inline Scene crowd(int triangles, double area, const ScanSettings &settings,
                   const FrameSpec &frame = frameOf(1920, 1080))
{
    // Three points of a square of side s make an expected area of 11/144 s² (Alagar 1977).
    const auto side = Lattice(std::sqrt(area * 144 / 11) * unitsPerPixel);
    std::mt19937 random(1);
    std::uniform_int_distribution<Lattice> left(0, frame.width * unitsPerPixel - side);
    std::uniform_int_distribution<Lattice> bottom(0, frame.height * unitsPerPixel - side);
    std::uniform_int_distribution<Lattice> offset(0, side);
    std::uniform_int_distribution<int> level(0, 255);
    Scene scene;
    scene.frame = frame;
    scene.settings = settings;
    for (int i = 0; i < triangles; ++i) {
        Triangle triangle;
        const LatticePoint corner = {left(random), bottom(random)};
        for (Vertex &vertex : triangle.vertices) {
            vertex.position = {corner.x + offset(random), corner.y + offset(random)};
            for (auto &channel : vertex.colour.channels)
                channel = std::uint8_t(level(random));
        }
        scene.triangles.push_back(triangle);
    }
    return scene;
}

inline constexpr ScanSettings exact{Arithmetic::Exact, FillRule::Closed, ByteRounding::Nearest};
inline constexpr ScanSettings singles{Arithmetic::Float32, FillRule::Closed, ByteRounding::Nearest};

/// A window whose canvas shows a 1920 × 1080 frame pixel by pixel, with every panel active.
inline std::unique_ptr<MainWindow> windowWith(const Scene &scene)
{
    auto window = std::make_unique<MainWindow>();
    window->resize(2700, 1700);
    window->show();
    window->parts().document->reset(scene);
    return window;
}

inline bool waitForTrace(const MainWindow &window)
{
    return QTest::qWaitFor([&] { return !window.parts().tracer->isRunning(); }, timeout);
}

/// Waits without QTest's naps of 10 ms between two checks.
template <class Condition>
bool waitUntil(const Condition &isTrue)
{
    QDeadlineTimer deadline(timeout);
    QTimer alarm; // wakes the event loop when nothing else does
    alarm.start(timeout);
    while (!isTrue() && !deadline.hasExpired())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    return isTrue();
}

inline double processorTime(clockid_t clock) // ms
{
    timespec time = {};
    clock_gettime(clock, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) / 1e6;
}

} // namespace pixelplumb
