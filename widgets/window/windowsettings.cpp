// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/windowsettings.h"

#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/window/workspaces.h"

#include <QtWidgets>

namespace pixelplumb {

namespace {

constexpr QSize firstSize(1440, 960);
/// The window's own minimum size, so that no panel opened, dragged or reset can enlarge the window;
/// panels that do not fit get less room than they ask for.
constexpr QSize leastSize(800, 500);
/// The desktop's frame and title bar around the window; unknown before it is shown.
constexpr QSize frameRoom(8, 40);

template <class Choice>
Choice choiceFrom(const QSettings &settings, const char *key, Choice fallback, Choice last)
{
    const int stored = settings.value(QLatin1String(key), int(fallback)).toInt();
    return stored >= 0 && stored <= int(last) ? Choice(stored) : fallback;
}

} // namespace

WindowSettings::WindowSettings(const WindowParts &parts, Workspaces *workspaces,
                               QMainWindow *window)
    : m_parts(parts)
    , m_workspaces(workspaces)
    , m_window(window)
{
    window->setMinimumSize(leastSize.boundedTo(window->screen()->availableSize() - frameRoom));
}

void WindowSettings::restore()
{
    restoreChoices();
    const QSettings settings;
    m_window->resize(firstSize.boundedTo(m_window->screen()->availableSize() - frameRoom));
    m_window->restoreGeometry(settings.value(QLatin1String("window/geometry")).toByteArray());
    m_workspaces->restore(settings);
}

void WindowSettings::restoreChoices()
{
    const QSettings settings;
    m_parts.playhead->setStepsPerSecond(
        settings.value(QLatin1String("stepper/stepsPerSecond"), m_parts.playhead->stepsPerSecond())
            .toDouble());
    m_parts.playhead->setUnit(
        choiceFrom(settings, "stepper/unit", StepUnit::Span, StepUnit::Sample));
    m_parts.document->setSnap(choiceFrom(settings, "canvas/snap", Snap::Pixel, Snap(2)));
    DisplayOptions *options = m_parts.options;
    options->setGridShown(settings.value(QLatin1String("canvas/grid"), true).toBool());
    options->setDifferencesShown(
        settings.value(QLatin1String("canvas/differences"), true).toBool());
    options->setClippingShown(settings.value(QLatin1String("canvas/clipping"), false).toBool());
    options->setHexadecimal(settings.value(QLatin1String("canvas/hexadecimal"), false).toBool());
    options->setLayers(settings.value(QLatin1String("canvas/layers")).toStringList());
}

void WindowSettings::store() const
{
    QSettings settings;
    settings.setValue(QLatin1String("window/geometry"), m_window->saveGeometry());
    m_workspaces->store(settings);
    settings.setValue(QLatin1String("stepper/stepsPerSecond"), m_parts.playhead->stepsPerSecond());
    settings.setValue(QLatin1String("stepper/unit"), int(m_parts.playhead->unit()));
    settings.setValue(QLatin1String("canvas/snap"), int(m_parts.document->snap()));
    settings.setValue(QLatin1String("canvas/grid"), m_parts.options->isGridShown());
    settings.setValue(QLatin1String("canvas/differences"), m_parts.options->areDifferencesShown());
    settings.setValue(QLatin1String("canvas/clipping"), m_parts.options->isClippingShown());
    settings.setValue(QLatin1String("canvas/hexadecimal"), m_parts.options->isHexadecimal());
    settings.setValue(QLatin1String("canvas/layers"), m_parts.options->layers());
}

} // namespace pixelplumb
