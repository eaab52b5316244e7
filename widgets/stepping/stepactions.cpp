// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/stepping/stepactions.h"

#include "widgets/look/menuaction.h"
#include "widgets/look/signs.h"

namespace pixelplumb {

namespace {

constexpr auto forward = StepDirection::Forward;
constexpr auto backward = StepDirection::Backward;

} // namespace

StepActions::StepActions(Playhead *playhead, QObject *parent)
    : QObject(parent)
    , m_playhead(playhead)
{
    addSteps();
    addBreakpoints();
    addUnits();
    const auto update = [this] { updateEnabled(); };
    connect(playhead, &Playhead::tracedChanged, this, update);
    connect(playhead, &Playhead::tracedChanged, this, [this] { nameSpans(); });
    connect(playhead, &Playhead::positionChanged, this, [this] { nameSpans(); });
    connect(playhead, &Playhead::positionChanged, this, update);
    connect(playhead, &Playhead::pickedPixelChanged, this, update);
    connect(playhead, &Playhead::breakpointsChanged, this, update);
    connect(playhead, &Playhead::playingChanged, this, [this] { updatePlay(); });
    updateEnabled();
    updatePlay();
    nameSpans();
}

QAction *StepActions::step(StepUnit unit, StepDirection direction) const
{
    return m_steps[std::size_t(unit)][std::size_t(direction)];
}

QAction *StepActions::runToPixel(StepDirection direction) const
{
    return m_runToPixel[std::size_t(direction)];
}

QAction *StepActions::unit(StepUnit unit) const { return m_units->actions().at(int(unit)); }

QAction *StepActions::add(const QString &name, const QString &text, const QString &iconText,
                          const QKeySequence &key, const QString &tip)
{
    auto *action = new QAction(text, this);
    action->setObjectName(name);
    action->setIconText(iconText);
    action->setShortcut(key);
    action->setToolTip(tipWithKey(tip, key));
    return action;
}

template <class Do>
QAction *StepActions::addMove(const QString &name, const QString &text, const QString &iconText,
                              const QKeySequence &key, const QString &tip, Do move)
{
    QAction *action = add(name, text, iconText, key, tip);
    connect(action, &QAction::triggered, this, [this, move] {
        m_playhead->setPlaying(false);
        move(m_playhead);
    });
    return action;
}

void StepActions::addSteps()
{
    const auto addStep = [this](StepUnit unit, StepDirection direction, const char *name,
                                const QString &text, const QString &iconText,
                                const QKeySequence &key, const QString &tip) {
        QAction *action
            = addMove(QLatin1String(name), text, iconText, key, tip,
                      [unit, direction](Playhead *playhead) { playhead->step(unit, direction); });
        action->setIcon(stepIcon(direction == forward ? StepSign::Forward : StepSign::Backward));
        m_steps[std::size_t(unit)][std::size_t(direction)] = action;
    };
    addStep(StepUnit::Span, forward, "nextColumn", {}, {}, Qt::Key_F10, {}); // see nameSpans()
    addStep(StepUnit::Span, backward, "previousColumn", {}, {}, Qt::SHIFT | Qt::Key_F10, {});
    addStep(StepUnit::Sample, forward, "nextPixel", tr("Next &pixel"), tr("pixel"), Qt::Key_F11,
            tr("Write the next pixel"));
    addStep(StepUnit::Sample, backward, "previousPixel", tr("Previous p&ixel"), tr("pixel"),
            Qt::SHIFT | Qt::Key_F11, tr("Take back the last pixel"));
    addStep(StepUnit::SetUp, forward, "nextSetUp", tr("Next pri&mitive"), tr("primitive"),
            Qt::CTRL | Qt::Key_F11, tr("Go on to the next primitive's set-up"));
    addStep(StepUnit::SetUp, backward, "previousSetUp", tr("Previous p&rimitive"), tr("primitive"),
            Qt::CTRL | Qt::SHIFT | Qt::Key_F11, tr("Go back to the previous primitive's set-up"));

    m_toEnd = addMove(u"runToEnd"_s, tr("Run to the &end"), tr("end"), Qt::Key_F5,
                      tr("Go on to the next breakpoint or the end"),
                      [](Playhead *playhead) { playhead->run(forward); });
    m_toEnd->setIcon(stepIcon(StepSign::ToEnd));
    m_toStart = addMove(u"runToStart"_s, tr("Run back to the &start"), tr("start"),
                        Qt::SHIFT | Qt::Key_F5, tr("Go back to the last breakpoint or the start"),
                        [](Playhead *playhead) { playhead->run(backward); });
    m_toStart->setIcon(stepIcon(StepSign::ToStart));
    m_runToPixel[std::size_t(forward)]
        = addMove(u"runToPickedPixel"_s, tr("Run to the picke&d pixel"), {}, Qt::CTRL | Qt::Key_F10,
                  tr("Go on to the next step that writes the picked pixel"),
                  [](Playhead *playhead) { playhead->runToPickedPixel(forward); });
    m_runToPixel[std::size_t(backward)]
        = addMove(u"runBackToPickedPixel"_s, tr("Run &back to the picked pixel"), {},
                  Qt::CTRL | Qt::SHIFT | Qt::Key_F10,
                  tr("Go back to the last step that writes the picked pixel"),
                  [](Playhead *playhead) { playhead->runToPickedPixel(backward); });

    m_play = add(u"play"_s, tr("Pla&y"), tr("play"), Qt::Key_Space, {});
    connect(m_play, &QAction::triggered, this,
            [this] { m_playhead->setPlaying(!m_playhead->isPlaying()); });
}

void StepActions::addBreakpoints()
{
    m_columnBreakpoint = add(u"toggleColumnBreakpoint"_s, {}, {}, Qt::Key_F9,
                             tr("Set or clear a breakpoint on the current column or row"));
    connect(m_columnBreakpoint, &QAction::triggered, this, [this] {
        if (const std::optional<SpanPlace> place = m_playhead->currentPlace())
            m_playhead->toggleSpanBreakpoint(*place);
        else if (const auto pixel = m_playhead->pickedPixel())
            m_playhead->toggleSpanBreakpoint({SpanAxis::Column, pixel->x(), 0});
    });
    m_pixelBreakpoint
        = add(u"togglePixelBreakpoint"_s, tr("Breakpoint on the picked pi&xel"), {},
              Qt::SHIFT | Qt::Key_F9, tr("Set or clear a breakpoint on the picked pixel"));
    connect(m_pixelBreakpoint, &QAction::triggered, this, [this] {
        if (const auto pixel = m_playhead->pickedPixel())
            m_playhead->togglePixelBreakpoint(*pixel);
    });
    m_clearBreakpoints = add(u"clearBreakpoints"_s, tr("C&lear all breakpoints"), {},
                             Qt::CTRL | Qt::SHIFT | Qt::Key_F9, tr("Clear all breakpoints"));
    connect(m_clearBreakpoints, &QAction::triggered, m_playhead, &Playhead::clearBreakpoints);
}

void StepActions::addUnits()
{
    m_units = new QActionGroup(this);
    const auto addUnit = [this](StepUnit unit, const char *name, const QString &text) {
        QAction *action = add(QLatin1String(name), text, {}, {},
                              tr("Playing and the scrubber's arrow keys go by this unit"));
        action->setCheckable(true);
        action->setChecked(m_playhead->unit() == unit);
        m_units->addAction(action);
        connect(action, &QAction::triggered, this, [this, unit] { m_playhead->setUnit(unit); });
        connect(m_playhead, &Playhead::unitChanged, action,
                [action, unit](StepUnit chosen) { action->setChecked(chosen == unit); });
    };
    addUnit(StepUnit::SetUp, "unitSetUp", tr("by primitives"));
    addUnit(StepUnit::Span, "unitColumn", {});
    addUnit(StepUnit::Sample, "unitPixel", tr("by pixels"));
}

void StepActions::updateEnabled()
{
    const bool canGoOn = m_playhead->position() < m_playhead->end();
    const bool canGoBack = m_playhead->position() > 0;
    for (const auto &unit : m_steps) {
        unit[std::size_t(forward)]->setEnabled(canGoOn);
        unit[std::size_t(backward)]->setEnabled(canGoBack);
    }
    m_toEnd->setEnabled(canGoOn);
    m_toStart->setEnabled(canGoBack);
    m_play->setEnabled(m_playhead->end() > 0);
    const bool hasPixel = m_playhead->traced() && m_playhead->pickedPixel();
    for (QAction *run : m_runToPixel)
        run->setEnabled(hasPixel);
    m_pixelBreakpoint->setEnabled(hasPixel);
    m_columnBreakpoint->setEnabled(hasPixel || m_playhead->currentSpan());
    m_clearBreakpoints->setEnabled(!m_playhead->breakpoints().isEmpty());
}

/// Names the spans for the method of the run.
void StepActions::nameSpans()
{
    struct Words {
        QString next, previous, span, nextTip, previousTip, breakpoint, unit;
    };
    const auto wordsFor = [](SpanAxis axis) -> Words {
        switch (axis) {
        case SpanAxis::Column:
            break;
        case SpanAxis::Row:
            return {
                tr("Next &row"),
                tr("Previous r&ow"),
                tr("row"),
                tr("Go on to the next row, or first to the pixel that stepping back set out from"),
                tr("Go back to where this row begins, to the previous one, or to the pixel that "
                   "stepping on set out from"),
                tr("Break&point on the row"),
                tr("by rows")};
        case SpanAxis::Free:
            return {tr("Next &step"),
                    tr("Previous st&ep"),
                    tr("step"),
                    tr("Go on to the method's next step"),
                    tr("Go back to the method's previous step"),
                    tr("Break&point"),
                    tr("by steps")};
        }
        return {
            tr("Next &column"),
            tr("Previous c&olumn"),
            tr("column"),
            tr("Go on to the next column, or first to the pixel that stepping back set out from"),
            tr("Go back to where this column begins, to the previous one, or to the pixel that "
               "stepping on set out from"),
            tr("Break&point on the column"),
            tr("by columns")};
    };
    if (m_namedAxis == m_playhead->axis())
        return;
    m_namedAxis = m_playhead->axis();
    const Words words = wordsFor(*m_namedAxis);
    const auto name
        = [](QAction *action, const QString &text, const QString &iconText, const QString &tip) {
              action->setText(text);
              action->setIconText(iconText);
              action->setToolTip(tipWithKey(tip, action->shortcut()));
          };
    name(step(StepUnit::Span, forward), words.next, words.span, words.nextTip);
    name(step(StepUnit::Span, backward), words.previous, words.span, words.previousTip);
    m_columnBreakpoint->setText(words.breakpoint);
    unit(StepUnit::Span)->setText(words.unit);
}

void StepActions::updatePlay()
{
    const bool playing = m_playhead->isPlaying();
    m_play->setIcon(stepIcon(playing ? StepSign::Pause : StepSign::Play));
    m_play->setIconText(playing ? tr("pause") : tr("play"));
    m_play->setText(playing ? tr("Pause (pla&y)") : tr("Pla&y"));
    m_play->setToolTip(
        tipWithKey(playing ? tr("Pause") : tr("Play by the chosen unit"), m_play->shortcut()));
}

} // namespace pixelplumb
