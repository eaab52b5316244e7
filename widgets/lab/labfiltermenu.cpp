// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labfiltermenu.h"

#include "core/methods/method.h"
#include "core/scan/choicenames.h"
#include "widgets/lab/labmarks.h"
#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"

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
    if (leftOut.contains(nameOf(kernelOf(contender)))
        || leftOut.contains(contender.section(u':', 0, 0)))
        return true;
    const std::optional<LabContender> known = labContenderNamed(contender);
    return known && leftOut.contains(nameText(nameOf(known->arithmetic)));
}

std::shared_ptr<const Study> filtered(const std::shared_ptr<const Study> &results,
                                      const LabFilter &filter)
{
    if (!results || filter.leftOut.empty())
        return results;
    auto kept = std::make_shared<Study>(*results);
    const auto isOut = [&filter](const QString &contender) { return filter.leavesOut(contender); };
    std::erase_if(kept->contenders, [&](const StudyContender &each) { return isOut(each.id); });
    std::erase_if(kept->rows, [&](const LabRow &each) { return isOut(each.contender); });
    if (filter.leftOut.contains(LabFilter::straightLoops)) {
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
    onEvents(this, {QEvent::PaletteChange}, [this] { fill(); });
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

void LabFilterMenu::addTick(const QString &name, const QString &text, const QIcon &icon)
{
    QAction *tick = m_menu->addAction(icon, text);
    tick->setObjectName(name);
    tick->setCheckable(true);
    tick->setChecked(!m_filter.leftOut.contains(name));
    connect(tick, &QAction::toggled, this, [this, name](bool isShown) {
        if (isShown)
            m_filter.leftOut.erase(name);
        else
            m_filter.leftOut.insert(name);
        tell();
        emit filterChanged();
    });
}

void LabFilterMenu::fill()
{
    m_menu->clear();
    for (const Arithmetic arithmetic : allArithmetics)
        addTick(nameText(nameOf(arithmetic)), nameText(nameOf(arithmetic)),
                iconOf(kernelDot(arithmetic, LabKernel::Plain, palette()), *this));
    m_menu->addSeparator();
    for (const LabKernel kernel : allLabKernels)
        addTick(nameOf(kernel), titleOf(kernel),
                iconOf(kernelDot(Arithmetic::Exact, kernel, palette()), *this));
    addTick(LabFilter::straightLoops, tr("straight loops"),
            iconOf(straightLoopDot(Arithmetic::Exact, palette()), *this));
    m_menu->addSeparator();
    for (const QString &id : std::as_const(m_methods)) {
        const Method *method = methodNamed(id);
        addTick(id, method ? methodTitle(*method) : id);
    }
}

/// Shows without opening the menu that some are left out.
void LabFilterMenu::tell()
{
    setText(m_filter.leftOut.empty() ? tr("Show: all") : tr("Show: some"));
}

} // namespace pixelplumb
