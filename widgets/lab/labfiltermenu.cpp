// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labfiltermenu.h"

#include "core/methods/method.h"
#include "core/scan/choicenames.h"
#include "widgets/lab/labmarks.h"
#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"

#include <QEvent>
#include <QMenu>

namespace pixelplumb {

namespace {

constexpr int iconSide = 20; ///< logical pixels

QIcon iconOf(const QCPScatterStyle &dot, const QWidget &widget)
{
    QPixmap picture(QSize(iconSide, iconSide) * widget.devicePixelRatioF());
    picture.setDevicePixelRatio(widget.devicePixelRatioF());
    picture.fill(Qt::transparent);
    QCPPainter painter(&picture);
    painter.setAntialiasing(true);
    dot.applyTo(&painter, dot.pen());
    dot.drawShape(&painter, iconSide / 2.0, iconSide / 2.0);
    return QIcon(picture);
}

template <class Value>
void leaveOut(std::set<Value> &values, const Value &value, bool isShown)
{
    if (isShown)
        values.erase(value);
    else
        values.insert(value);
}

QString titleOf(LabKernel kernel)
{
    switch (kernel) {
    case LabKernel::Plain:
        return LabFilterMenu::tr("plain kernels");
    case LabKernel::Fast:
        return LabFilterMenu::tr("SIMD kernels");
    case LabKernel::Peer:
        return LabFilterMenu::tr("other renderers");
    }
    return {};
}

} // namespace

bool LabFilter::leavesOut(const QString &contender) const
{
    if (kernels.contains(kernelOf(contender)) || methods.contains(contender.section(u':', 0, 0)))
        return true;
    const std::optional<LabContender> known = labContenderNamed(contender);
    return known && arithmetics.contains(known->arithmetic);
}

std::shared_ptr<const Study> filtered(const std::shared_ptr<const Study> &results,
                                      const LabFilter &filter)
{
    if (!results || filter.leavesNobodyOut())
        return results;
    auto kept = std::make_shared<Study>(*results);
    const auto isOut = [&filter](const QString &contender) { return filter.leavesOut(contender); };
    std::erase_if(kept->contenders, [&](const StudyContender &each) { return isOut(each.id); });
    std::erase_if(kept->rows, [&](const LabRow &each) { return isOut(each.contender); });
    if (filter.straightLoops == LabFilter::StraightLoops::LeftOut) {
        for (LabRow &row : kept->rows) {
            if (row.cost)
                row.cost->straight.reset();
        }
    }
    return kept;
}

LabFilterMenu::LabFilterMenu(QWidget *parent)
    : QToolButton(parent)
    , m_menu(new QMenu(this))
{
    named(this, "labShown", tr("Who is shown"),
          tr("Choose what charts and table show: arithmetics, kernels, methods. The best are "
             "the best of those shown."));
    setPopupMode(QToolButton::InstantPopup);
    setAutoRaise(true);
    setMenu(m_menu);
    fill();
    tell();
}

void LabFilterMenu::setContenders(const std::vector<StudyContender> &contenders)
{
    QStringList methods;
    for (const StudyContender &contender : contenders) {
        if (const QString id = contender.id.section(u':', 0, 0); !methods.contains(id))
            methods.append(id);
    }
    if (methods == m_methods)
        return;
    m_methods = methods;
    fill();
}

void LabFilterMenu::addTick(const QString &name, const QString &text, const QIcon &icon,
                            bool isShown, const std::function<void(bool)> &show)
{
    QAction *tick = m_menu->addAction(icon, text);
    tick->setObjectName(name);
    tick->setCheckable(true);
    tick->setChecked(isShown);
    connect(tick, &QAction::toggled, this, [this, show](bool isOn) {
        show(isOn);
        tell();
        emit filterChanged();
    });
}

void LabFilterMenu::fill()
{
    m_menu->clear();
    for (const Arithmetic arithmetic : allArithmetics)
        addTick(nameText(nameOf(arithmetic)), nameText(nameOf(arithmetic)),
                iconOf(kernelDot(arithmetic, LabKernel::Plain, palette()), *this),
                !m_filter.arithmetics.contains(arithmetic), [this, arithmetic](bool isShown) {
                    leaveOut(m_filter.arithmetics, arithmetic, isShown);
                });
    m_menu->addSeparator();
    for (const LabKernel kernel : allLabKernels)
        addTick(nameOf(kernel), titleOf(kernel),
                iconOf(kernelDot(Arithmetic::Exact, kernel, palette()), *this),
                !m_filter.kernels.contains(kernel),
                [this, kernel](bool isShown) { leaveOut(m_filter.kernels, kernel, isShown); });
    addTick(QStringLiteral("straight"), tr("straight loops"),
            iconOf(straightLoopDot(Arithmetic::Exact, palette()), *this),
            m_filter.straightLoops == LabFilter::StraightLoops::Shown, [this](bool isShown) {
                m_filter.straightLoops
                    = isShown ? LabFilter::StraightLoops::Shown : LabFilter::StraightLoops::LeftOut;
            });
    m_menu->addSeparator();
    for (const QString &id : std::as_const(m_methods)) {
        const Method *method = methodNamed(id);
        addTick(id, method ? methodTitle(*method) : id, {}, !m_filter.methods.contains(id),
                [this, id](bool isShown) { leaveOut(m_filter.methods, id, isShown); });
    }
}

/// Shows without opening the menu that some are left out.
void LabFilterMenu::tell()
{
    setText(m_filter.leavesNobodyOut() ? tr("Show: all") : tr("Show: some"));
}

void LabFilterMenu::changeEvent(QEvent *event)
{
    QToolButton::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        fill();
}

} // namespace pixelplumb
