// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/stepping/stepperbar.h"

#include "widgets/look/labels.h"
#include "widgets/look/parts.h"

#include <cmath>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr int padding = 8;
constexpr int signSize = 12;
constexpr int iconGap = 6;

} // namespace

StepButton::StepButton(QAction *action, SignSide side, QWidget *parent)
    : QToolButton(parent)
    , m_side(side)
{
    setObjectName(action->objectName() + u"Button"_s);
    setDefaultAction(action);
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(QString(action->text()).remove(QLatin1Char('&')));
}

QSize StepButton::sizeHint() const
{
    int width = 2 * padding + signSize;
    if (m_side != SignSide::Alone) {
        int text = fontMetrics().horizontalAdvance(this->text());
        for (const QString &other : m_texts)
            text = std::max(text, fontMetrics().horizontalAdvance(other));
        width += iconGap + text;
    }
    return {width, QToolButton::sizeHint().height()};
}

void StepButton::keepRoomFor(const QStringList &texts)
{
    m_texts = texts;
    updateGeometry();
}

void StepButton::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    QStyleOptionToolButton option;
    initStyleOption(&option);
    const QString text = m_side == SignSide::Alone ? QString() : option.text;
    const QIcon sign = option.icon;
    option.text.clear();
    option.icon = {};
    painter.drawComplexControl(QStyle::CC_ToolButton, option);

    const int textWidth = text.isEmpty() ? 0 : iconGap + fontMetrics().horizontalAdvance(text);
    const int left = (width() - signSize - textWidth) / 2;
    const int signLeft = m_side == SignSide::AfterText ? left + textWidth : left;
    sign.paint(&painter, QRect(signLeft, (height() - signSize) / 2, signSize, signSize),
               Qt::AlignCenter, isEnabled() ? QIcon::Normal : QIcon::Disabled);
    const int textLeft = m_side == SignSide::AfterText ? left : left + signSize + iconGap;
    painter.drawItemText(QRect(textLeft, 0, width() - textLeft, height()),
                         Qt::AlignLeft | Qt::AlignVCenter, palette(), isEnabled(), text,
                         QPalette::ButtonText);
}

StepperBar::StepperBar(Playhead *playhead, const StepActions &actions, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_layout(new QHBoxLayout(this))
{
    named(this, "stepperBar", tr("Stepper"));
    m_layout->setContentsMargins(8, 0, 0, 0);
    m_layout->setSpacing(2);
    addButtons(actions);
    m_layout->addSpacing(8);
    addUnitBox(actions);
    m_layout->addSpacing(8);
    addSpeed();
    m_layout->addStretch();
}

void StepperBar::addButtons(const StepActions &actions)
{
    using Side = StepButton::SignSide;
    const auto add = [this](QAction *action, Side side) {
        auto *button = new StepButton(action, side, this);
        m_layout->addWidget(button);
        return button;
    };
    add(actions.toStart(), Side::Alone);
    add(actions.step(StepUnit::Span, StepDirection::Backward), Side::BeforeText);
    add(actions.step(StepUnit::Sample, StepDirection::Backward), Side::BeforeText);
    add(actions.play(), Side::BeforeText)->keepRoomFor({tr("play"), tr("pause")});
    add(actions.step(StepUnit::Sample, StepDirection::Forward), Side::AfterText);
    add(actions.step(StepUnit::Span, StepDirection::Forward), Side::AfterText);
    add(actions.toEnd(), Side::Alone);
}

void StepperBar::addUnitBox(const StepActions &actions)
{
    m_unitBox = named(new QComboBox(this), "unitBox", tr("Unit of playing"));
    m_unitBox->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_unitBox->setToolTip(tr("Play by primitives, by columns (rows, steps) or by pixels"));
    for (QAction *unit : actions.units()) {
        const int row = m_unitBox->count();
        m_unitBox->addItem(unit->text());
        connect(unit, &QAction::changed, m_unitBox, // the name of a span depends on the method
                [box = m_unitBox, unit, row] { box->setItemText(row, unit->text()); });
    }
    m_unitBox->setCurrentIndex(int(m_playhead->unit()));
    connect(m_unitBox, &QComboBox::activated, m_playhead,
            [playhead = m_playhead](int index) { playhead->setUnit(StepUnit(index)); });
    connect(m_playhead, &Playhead::unitChanged, m_unitBox,
            [box = m_unitBox](StepUnit unit) { box->setCurrentIndex(int(unit)); });
    m_layout->addWidget(m_unitBox);
}

void StepperBar::addSpeed()
{
    auto *box
        = explained(new DecimalBox(this), "speedBox", tr("Speed of playing, steps per second"));
    box->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    box->setRange(Playhead::slowest, Playhead::fastest);
    box->setDecimals(1);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setAlignment(Qt::AlignRight);
    box->setSuffix(tr(" /s"));
    box->setKeyboardTracking(false);
    box->setValue(m_playhead->stepsPerSecond());
    connect(box, &QDoubleSpinBox::valueChanged, m_playhead, &Playhead::setStepsPerSecond);
    connect(m_playhead, &Playhead::stepsPerSecondChanged, box, &QDoubleSpinBox::setValue);
    m_layout->addWidget(box);
}

} // namespace pixelplumb
