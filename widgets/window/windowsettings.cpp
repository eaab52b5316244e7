// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/windowsettings.h"

#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/window/panels.h"

#include <QMainWindow>
#include <QScreen>
#include <QSettings>

namespace pixelplumb {

namespace {

/// Another one when panels come or go, so that an old layout is not forced on them; the first
/// number is to be raised when tool bars do.
int layoutVersion() { return 3 * 100 + int(panels().size()); }

constexpr QSize firstSize(1440, 960);
/// Asked for by the window itself, so that no panel that is opened, dragged or reset can make the
/// window larger than a person has made it: panels that do not fit have less room than they ask
/// for.
constexpr QSize leastSize(800, 500);
/// What a desktop's frame and title bar take beside the window's own size; not known before it is
/// shown.
constexpr QSize frameRoom(8, 40);

template <class Choice>
Choice choiceFrom(const QSettings &settings, const char *key, Choice fallback, Choice last)
{
    const int stored = settings.value(QLatin1String(key), int(fallback)).toInt();
    return stored >= 0 && stored <= int(last) ? Choice(stored) : fallback;
}

} // namespace

WindowSettings::WindowSettings(const WindowParts &parts, QMainWindow *window)
    : m_parts(parts)
    , m_window(window)
{
    window->setMinimumSize(leastSize.boundedTo(window->screen()->availableSize() - frameRoom));
}

bool WindowSettings::restore()
{
    restoreChoices();
    const QSettings settings;
    m_window->resize(firstSize.boundedTo(m_window->screen()->availableSize() - frameRoom));
    m_window->restoreGeometry(settings.value(QLatin1String("window/geometry")).toByteArray());
    return m_window->restoreState(settings.value(QLatin1String("window/layout")).toByteArray(),
                                  layoutVersion());
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
    settings.setValue(QLatin1String("window/layout"), m_window->saveState(layoutVersion()));
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
