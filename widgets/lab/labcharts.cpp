// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labcharts.h"

#include "widgets/lab/labanswers.h"
#include "widgets/lab/labfiltermenu.h"
#include "widgets/lab/labtable.h"
#include "widgets/lab/labtext.h"
#include "widgets/lab/missplot.h"
#include "widgets/lab/paretoplot.h"
#include "widgets/look/labels.h"
#include "widgets/look/parts.h"

#include <algorithm>

namespace pixelplumb {

namespace {

QComboBox *namedBox(const char *name, const QString &accessibleName, QWidget *parent)
{
    auto *box = explained(new ElidingBox(parent), name, accessibleName);
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    return box;
}

/// A chart with a box of choices above it, or beside it when low; or with a line of text above it,
/// hidden when low.
class LabPage : public QWidget {
public:
    LabPage(QWidget *box, QWidget *shown, QWidget *parent)
        : QWidget(parent)
        , m_box(box)
        , m_layout(new QBoxLayout(QBoxLayout::TopToBottom, this))
    {
        m_layout->setContentsMargins(0, 4, 0, 0);
        m_layout->setSpacing(4);
        if (box)
            m_layout->addWidget(box, 0, isText() ? Qt::Alignment() : Qt::AlignLeft | Qt::AlignTop);
        m_layout->addWidget(shown, 1);
    }

protected:
    void resizeEvent(QResizeEvent *event) override
    {
        QWidget::resizeEvent(event);
        if (!m_box)
            return;
        const bool isLow = height() < lowPage;
        if (isText()) {
            m_box->setVisible(!isLow);
            return;
        }
        m_layout->setDirection(isLow ? QBoxLayout::RightToLeft : QBoxLayout::TopToBottom);
        m_box->setMaximumWidth(isLow ? boxBeside : QWIDGETSIZE_MAX);
    }

private:
    static constexpr int lowPage = 180; ///< logical pixels
    static constexpr int boxBeside = 120;

    bool isText() const { return qobject_cast<ElidedLabel *>(m_box) != nullptr; }

    QWidget *m_box;
    QBoxLayout *m_layout;
};

/// The contender with most missing and extra samples; the first one where none has any.
QString worstOf(const Study &study, const QString &family)
{
    QString worst;
    std::int64_t most = -1;
    for (const LabRow &row : study.rows) {
        if (row.family != family || !row.accuracy || row.accuracy->wrongCoverage() <= most)
            continue;
        most = row.accuracy->wrongCoverage();
        worst = row.contender;
    }
    return worst;
}

} // namespace

LabCharts::LabCharts(QWidget *parent)
    : QTabWidget(parent)
    , m_pareto(new ParetoPlot(this))
    , m_table(new LabTable(this))
    , m_answers(new LabAnswers(this))
    , m_misses(new MissPlot(this))
    , m_effects(new LabEffects(this))
    , m_contender(namedBox("labMissContender", tr("Whose misses"), this))
    , m_filter(new LabFilterMenu(this))
    , m_price(new ElidedLabel(this))
{
    named(m_price, "labPrice", tr("What accuracy costs here"));
    named(this, "labTabs", tr("Charts of the lab"));
    setDocumentMode(true);
    setCornerWidget(m_filter);
    addPage(m_price, m_pareto, tr("Cost and error"),
            tr("Every contender by what it costs and what it gets wrong"));
    addPage(nullptr, m_table, tr("Table"), tr("The same in figures, sorted by any column"));
    addPage(nullptr, m_answers, tr("Budgets"),
            tr("The cheapest contender that is accurate enough"));
    addPage(m_contender, m_misses, tr("Misses"),
            tr("How far missed samples lie from the boundary"));
    addPage(nullptr, m_effects, tr("Effects"), tr("What effects cost and what they mend"));

    connect(m_pareto, &ParetoPlot::contenderClicked, this, [this](const QString &contender) {
        select(contender);
        emit missRequested(contender);
    });
    connect(m_pareto, &ParetoPlot::contenderSelected, this, &LabCharts::select);
    connect(m_table, &LabTable::contenderSelected, this, &LabCharts::select);
    connect(m_table, &LabTable::contenderActivated, this, &LabCharts::missRequested);
    connect(m_answers, &LabAnswers::contenderSelected, this, &LabCharts::select);
    connect(m_contender, &QComboBox::activated, this,
            [this] { select(m_contender->currentData().toString()); });
    connect(m_filter, &LabFilterMenu::filterChanged, this, &LabCharts::showAll);
}

void LabCharts::addPage(QWidget *box, QWidget *shown, const QString &title, const QString &toolTip)
{
    setTabToolTip(addTab(new LabPage(box, shown, this), title), toolTip);
}

void LabCharts::show(const SharedResults &results, const QString &family, const ErrorAxis &axis)
{
    m_results = results;
    m_family = family;
    m_axis = &axis;
    m_filter->setContenders(results->contenders);
    showAll();
}

/// The filter does not apply to budgets and misses.
void LabCharts::showAll()
{
    if (!m_results)
        return;
    m_shown = filtered(m_results, m_filter->filter());
    m_pareto->show(m_shown, m_family, *m_axis);
    m_table->show(m_shown, m_family);
    m_answers->show(*m_results, m_family);
    m_price->setWholeText(priceText(*m_results, m_family));
    fillContenders();
    showMisses();
    m_effects->show(*m_results);
}

void LabCharts::fillContenders()
{
    m_contender->clear();
    for (const StudyContender &contender : m_results->contenders)
        m_contender->addItem(contender.label, contender.id);
}

void LabCharts::showMisses()
{
    const QString shown = m_selected.isEmpty() ? worstOf(*m_results, m_family) : m_selected;
    m_contender->setCurrentIndex(m_contender->findData(shown));
    m_misses->show(m_results, m_family, shown);
}

void LabCharts::select(const QString &contender)
{
    m_selected = contender;
    if (!m_results)
        return;
    m_pareto->select(contender);
    m_table->select(contender);
    showMisses();
}

LabPlot *LabCharts::chartInFront() const
{
    return currentWidget() ? currentWidget()->findChild<LabPlot *>() : nullptr;
}

} // namespace pixelplumb
