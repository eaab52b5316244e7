// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/compare/comparepane.h"

#include "core/lab/study/scenecost.h"
#include "core/scan/choicenames.h"
#include "widgets/look/corewords.h"
#include "widgets/look/framepainter.h"
#include "widgets/look/methodbox.h"
#include "widgets/look/parts.h"
#include "widgets/model/playhead.h"
#include "widgets/model/tracenavigation.h"
#include "widgets/studies/compare/comparelink.h"
#include "widgets/studies/compare/comparetext.h"
#include "widgets/studies/compare/compareview.h"

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr int leastBoxWidth = 48;
constexpr int boxMargins = 36; ///< beside a box's text, with its arrow

/// A finished picture's pixels on the background.
QImage onBackground(const WrittenFrame &written, const FrameSpec &spec)
{
    return pictureWith(spec, [&](const QPoint &at) {
        const bool isWritten = written.isWritten(at.x(), at.y());
        return packed(isWritten ? written.colourAt(at.x(), at.y()) : spec.background);
    });
}

} // namespace

/// The frame with the current span of the pane's own run.
class ComparePane::View : public CompareView {
public:
    using CompareView::CompareView;

    std::optional<SpanRecord> currentSpan;
    std::vector<std::array<LatticePoint, 3>> outlines;

protected:
    void paintSigns(QPainter &, FramePainter &frame, const ViewMapping &) override
    {
        for (const std::array<LatticePoint, 3> &corners : outlines)
            frame.drawOutline(corners, {});
        if (!currentSpan)
            return;
        frame.drawPlumbLine(currentSpan->place);
    }
};

ComparePane::ComparePane(int number, CompareLink *link, Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_number(number)
    , m_playhead(playhead)
{
    m_method = addBox(new MethodBox(this), u"Method"_s, tr("Method of pane %1").arg(number));
    m_method->insertItem(0, tr("Truth"), QString());
    m_arithmetic
        = addBox(new ElidingBox(this), u"Arithmetic"_s, tr("Arithmetic of pane %1").arg(number));
    m_fillRule
        = addBox(new ElidingBox(this), u"FillRule"_s, tr("Fill rule of pane %1").arg(number));
    m_result = new QLabel(this);
    m_result->setWordWrap(true);
    m_view = new View(link, playhead, this);
    m_view->setObjectName(u"compareView%1"_s.arg(number));
    m_view->setAccessibleName(tr("Picture of pane %1").arg(number));

    auto *first = new QHBoxLayout;
    first->setSpacing(4);
    auto *name = new QLabel(QString::number(number), this);
    name->setFont(bold(font()));
    first->addWidget(name);
    first->addWidget(m_method, 1);
    // In their own row: four panes side by side would push out the panels at the right.
    m_settings = withParts(new QHBoxLayout, {{m_arithmetic, 1}, {m_fillRule, 1}}, 4);
    withParts(new QVBoxLayout(this), {first, m_settings, {m_view, 1}, m_result}, 4, 0);

    onEvents(this, {QEvent::Resize}, [this] {
        emit roomChanged();
        tellResult();
    });
    connect(m_method, &QComboBox::activated, this, [this] {
        offerSettings(contender().settings);
        emit contenderChanged();
    });
    connect(m_arithmetic, &QComboBox::activated, this, &ComparePane::contenderChanged);
    connect(m_fillRule, &QComboBox::activated, this, &ComparePane::contenderChanged);
    connect(playhead, &Playhead::positionChanged, this, &ComparePane::followPlayhead);
    offerSettings({});
}

QComboBox *ComparePane::addBox(QComboBox *box, const QString &name, const QString &label)
{
    box->setObjectName(u"compare%1%2"_s.arg(name, QString::number(m_number)));
    box->setAccessibleName(label);
    box->setToolTip(label);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(6);
    // Lets four panes and the map fit into a small window; longer text is elided.
    box->setMinimumWidth(leastBoxWidth);
    return box;
}

Contender ComparePane::contender() const
{
    Contender contender{methodNamed(m_method->currentData().toString()),
                        {Arithmetic::Exact, FillRule::Closed, m_rounding}};
    if (m_arithmetic->currentIndex() >= 0)
        contender.settings.arithmetic = Arithmetic(m_arithmetic->currentData().toInt());
    if (m_fillRule->currentIndex() >= 0)
        contender.settings.fillRule = FillRule(m_fillRule->currentData().toInt());
    contender.settings.variants = m_variants;
    return contender;
}

void ComparePane::setContender(const Contender &contender)
{
    m_rounding = contender.settings.rounding;
    const QString id = contender.isTruth() ? QString() : contender.method->id;
    m_method->setCurrentIndex(std::max(0, m_method->findData(id)));
    offerSettings(contender.settings);
}

void ComparePane::offerSettings(const ScanSettings &wanted)
{
    const Method *method = methodNamed(m_method->currentData().toString());
    const Contender chosen = method ? contenderFor(*method, wanted) : Contender{nullptr, wanted};
    const std::vector<Arithmetic> arithmetics
        = method ? method->arithmetics : std::vector<Arithmetic>{Arithmetic::Exact};
    const std::vector<FillRule> rules = method
        ? method->fillRules
        : std::vector<FillRule>(allFillRules.begin(), allFillRules.end());
    const auto offer = [](QComboBox *box, const auto &choices, auto current) {
        box->clear();
        for (const auto choice : choices)
            box->addItem(coreWord(nameOf(choice)), int(choice));
        box->setCurrentIndex(std::max(0, box->findData(int(current))));
        box->setEnabled(choices.size() > 1);
    };
    offer(m_arithmetic, arithmetics, chosen.settings.arithmetic);
    offer(m_fillRule, rules, chosen.settings.fillRule);
    m_variants = chosen.settings.variants;
    emit roomChanged();
}

bool ComparePane::fitsSettingsInARow() const
{
    const auto widthOf = [this](const QComboBox *box) {
        return fontMetrics().horizontalAdvance(box->currentText()) + boxMargins;
    };
    return 2 * std::max(widthOf(m_arithmetic), widthOf(m_fillRule)) + m_settings->spacing()
        <= width();
}

void ComparePane::setSettingsDirection(QBoxLayout::Direction direction)
{
    m_settings->setDirection(direction);
}

void ComparePane::show(const std::shared_ptr<const Contest> &contest, std::size_t run)
{
    m_cursor.reset(); // it refers to the previous contest
    m_pace.reset();
    m_contest = contest;
    m_run = run;
    const ContenderRun &shown = contest->runs[run];
    m_view->outlines.clear();
    for (const Triangle &triangle : contest->primitives.triangles)
        m_view->outlines.push_back({triangle.vertices[0].position, triangle.vertices[1].position,
                                    triangle.vertices[2].position});
    if (shown.traced)
        m_cursor = std::make_unique<TraceCursor>(*shown.traced->trace, contest->scene.frame);
    m_figures.clear();
    m_details.clear();
    followPlayhead();
}

/// Whether the longest names of an arithmetic and of a fill rule do not fit side by side.
bool ComparePane::isNarrow() const
{
    const int names = fontMetrics().horizontalAdvance(u"fixed16.16half-open-column"_s);
    return width() < names + 2 * leastBoxWidth;
}

void ComparePane::tellResult()
{
    if (!m_contest)
        return;
    const ContenderRun &run = m_contest->runs[m_run];
    const ContenderTally tally = tallyNow();
    const QString whole = resultText(run, tally) + m_figures;
    const bool isShort = isNarrow();
    m_result->setText(isShort ? shortResultText(run, tally) : whole);
    QStringList beside;
    if (isShort)
        beside += whole;
    if (!m_details.isEmpty())
        beside += m_details;
    m_result->setToolTip(beside.join(u'\n'));
}

/// The counts up to the pane's position; of what is not stepped, those of the finished picture.
ContenderTally ComparePane::tallyNow()
{
    if (!m_cursor)
        return m_contest->runs[m_run].tally;
    if (!m_pace)
        m_pace.emplace(*m_contest, m_run);
    return m_pace->at(m_cursor->position());
}

void ComparePane::clear(const QString &message)
{
    m_cursor.reset();
    m_pace.reset();
    m_contest.reset();
    m_view->currentSpan.reset();
    m_view->outlines.clear();
    m_view->setPicture({});
    m_view->setMessage(message);
    m_result->clear();
}

void ComparePane::showCost(const SceneCost &cost)
{
    const QString separator = u" · "_s;
    m_figures = separator + coreWord(cost.text());
    m_details = coreWords(cost.details(), separator);
    tellResult();
}

CompareView *ComparePane::view() const { return m_view; }

std::optional<std::size_t> ComparePane::position() const
{
    return m_cursor ? std::optional(m_cursor->position()) : std::nullopt;
}

void ComparePane::followPlayhead()
{
    if (!m_contest || !m_playhead->traced())
        return;
    m_view->currentSpan.reset();
    const ContenderRun &run = m_contest->runs[m_run];
    if (!m_cursor) {
        tellResult();
        return m_view->setPicture(onBackground(run.picture, m_contest->scene.frame));
    }
    const ScanTrace &trace = *run.traced->trace;
    const std::size_t position
        = TraceNavigation(trace).positionLike(*m_playhead->traced()->trace, m_playhead->position());
    m_cursor->seek(position);
    tellResult();
    if (position > 0) {
        const TraceStep step = trace.stepAt(position - 1);
        if (step.kind != StepKind::SetUp)
            m_view->currentSpan = trace.span(step.span);
    }
    m_view->setPicture(m_cursor->frame().image());
}

} // namespace pixelplumb
