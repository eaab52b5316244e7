// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/formulapanel.h"

#include "core/runs/explain/formulaexplanation.h"
#include "widgets/look/corewords.h"
#include "widgets/look/formulahtml.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/playhead.h"
#include "widgets/model/runnotes.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr int leastFormulaLines = 1;
constexpr float bannerTint = 0.18F;
constexpr int widthForBeside = 55; ///< characters
constexpr double tableExcess = 2; // logical pixels from rounded-up column widths

QString nounOf(SpanAxis axis)
{
    switch (axis) {
    case SpanAxis::Column:
        return FormulaPanel::tr("a column");
    case SpanAxis::Row:
        return FormulaPanel::tr("a row");
    case SpanAxis::Free:
        break;
    }
    return FormulaPanel::tr("a step");
}

/// What the panel shows without a current step.
Explanation invitation(const Playhead &playhead)
{
    Explanation explanation;
    const TracedScene *traced = playhead.traced();
    if (!traced || traced->trace->spanCount() == 0) {
        explanation.heading
            = traced ? FormulaPanel::tr("Nothing is drawn") : FormulaPanel::tr("Recording the run");
        explanation.sentence = emptyRunText(traced);
        return explanation;
    }
    explanation.heading = FormulaPanel::tr("Before the first step");
    explanation.sentence
        = FormulaPanel::tr("Nothing is drawn yet. Step forward by %1 or by a pixel: the buttons "
                           "above, or the Step menu with its keys.")
              .arg(nounOf(playhead.axis()));
    return explanation;
}

/// A step's explanation with its sentences in the window's language.
Explanation inWindowsWords(Explanation explanation)
{
    explanation.sentence = coreSentences(explanation.sentence);
    explanation.event = coreSentences(explanation.event);
    return explanation;
}

/// Of the formulas without a scroll bar: one that comes must not make them longer, or it stays.
int lineWidth(const QTextBrowser &formulas) { return formulas.maximumViewportSize().width(); }

ChannelSymbols symbolsIn(const QTextBrowser &formulas)
{
    const int wanted = widthForBeside * formulas.fontMetrics().averageCharWidth();
    return lineWidth(formulas) >= wanted ? ChannelSymbols::Beside : ChannelSymbols::Above;
}

constexpr std::size_t measuredSpans = 6; // of a run, evenly spaced

} // namespace

FormulaPanel::FormulaPanel(Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_heading(new QLabel(this))
    , m_sentence(new QLabel(this))
    , m_formulas(new QTextBrowser(this))
{
    named(this, "formulaPanel", tr("Formulas of the current step"));
    const auto selectable = Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard;

    m_heading->setObjectName(u"formulaHeading"_s);
    m_heading->setTextFormat(Qt::RichText);
    m_heading->setContentsMargins(4, 0, 4, 0);
    m_heading->setAutoFillBackground(true);
    m_heading->setTextInteractionFlags(selectable);
    m_heading->setMinimumWidth(1); // a long heading must not widen the window

    m_sentence->setObjectName(u"formulaSentence"_s);
    m_sentence->setTextFormat(Qt::RichText);
    m_sentence->setWordWrap(true);
    m_sentence->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_sentence->setContentsMargins(4, 0, 4, 0);
    m_sentence->setTextInteractionFlags(selectable);

    named(m_formulas, "formulaText", tr("Formulas"));
    m_formulas->setFrameShape(QFrame::NoFrame);
    m_formulas->setOpenLinks(false);
    m_formulas->setMinimumHeight(fontMetrics().lineSpacing() * leastFormulaLines);
    m_formulas->document()->setDocumentMargin(2);

    auto *layout = withParts(new QVBoxLayout(this), {m_heading, m_sentence, {m_formulas, 1}}, 2);
    layout->setContentsMargins(8, 2, 0, 0);

    m_measuring.setSingleShot(true);
    m_measuring.setInterval(0);
    onEvents(this, {QEvent::Show}, [this] { m_measuring.start(); });
    onEvents(this, {QEvent::PaletteChange, QEvent::FontChange}, [this] { explainStep(); });
    connect(&m_measuring, &QTimer::timeout, this, &FormulaPanel::measureRun);
    connect(playhead, &Playhead::tracedChanged, this, &FormulaPanel::takeTraced);
    connect(playhead, &Playhead::positionChanged, this, &FormulaPanel::explainStep);
    explainStep();
}

QSize FormulaPanel::sizeHint() const { return {440, 200}; }

QSize FormulaPanel::minimumSizeHint() const { return {200, layout()->minimumSize().height()}; }

void FormulaPanel::takeTraced()
{
    m_measuring.start();
    explainStep();
}

void FormulaPanel::explainStep()
{
    const bool isForeign
        = m_playhead->traced() && !foreignSceneHint(m_playhead->traced()->scene).isEmpty();
    if (!m_playhead->currentStep() || isForeign) {
        present(invitation(*m_playhead));
        return;
    }
    const TracedScene &traced = *m_playhead->traced();
    present(inWindowsWords(pixelplumb::explainStep(traced, m_playhead->position() - 1)));
}

void FormulaPanel::present(const Explanation &explanation)
{
    QPalette headingPalette = palette();
    if (!explanation.event.isEmpty())
        headingPalette.setColor(QPalette::Window,
                                blended(palette().color(QPalette::Window),
                                        signColour(Sign::CurrentColumn, palette()), bannerTint));
    m_heading->setPalette(headingPalette);
    const QString heading = coreWords(explanation.heading, u": "_s);
    m_heading->setText(u"<b>%1</b>%2"_s.arg(
        typesetHtml(heading),
        explanation.event.isEmpty() ? QString() : u" &nbsp;⚑ "_s + typesetHtml(explanation.event)));
    m_sentence->setText(typesetHtml(explanation.sentence));

    const int scrolled = m_formulas->verticalScrollBar()->value();
    // The stages from space to the frame come first.
    m_formulas->setHtml(
        stagesHtml(explanation, arithmetic(), palette())
        + formulaHtml(explanation, arithmetic(), palette(), symbolsIn(*m_formulas)));
    m_formulas->verticalScrollBar()->setValue(scrolled);
    setAccessibleDescription(heading + u". "_s + explanation.sentence + u'\n'
                             + formulaText(explanation, arithmetic()));
    fitScrollBar();
    if (!isScrolledTo(explanation))
        growTo(int(std::ceil(m_formulas->document()->size().height())));
}

/// Whether an explanation may scroll: stages are long, and a set-up, one of a primitive's hundreds
/// of steps, is often twice as long as any other, so that the panel would be half empty otherwise.
bool FormulaPanel::isScrolledTo(const Explanation &explanation) const
{
    const std::optional<TraceStep> step = m_playhead->currentStep();
    return !explanation.stages.empty() || (step && step->kind == StepKind::SetUp);
}

/// A table of full width reports itself slightly wider than its room.
void FormulaPanel::fitScrollBar()
{
    const double excess = m_formulas->document()->idealWidth() - m_formulas->viewport()->width();
    const bool fits = excess <= tableExcess;
    m_formulas->setHorizontalScrollBarPolicy(fits ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
}

Arithmetic FormulaPanel::arithmetic() const
{
    return m_playhead->traced() ? m_playhead->traced()->scene.settings.arithmetic
                                : Arithmetic::Exact;
}

/// A step that was not measured may need more height than those measured.
void FormulaPanel::growTo(int formulas)
{
    const int needed = height() - m_formulas->height() + formulas;
    if (!isVisible() || m_measuring.isActive() || needed <= m_neededHeight)
        return;
    m_neededHeight = needed;
    emit neededHeightChanged();
}

/// The height the explanation's sentence would have in the panel.
int FormulaPanel::sentenceHeight(const Explanation &explanation) const
{
    const QMargins margins = m_sentence->contentsMargins();
    QTextDocument document;
    document.setDefaultFont(m_sentence->font());
    document.setDocumentMargin(0);
    document.setHtml(typesetHtml(explanation.sentence));
    document.setTextWidth(m_sentence->width() - margins.left() - margins.right());
    return int(std::ceil(document.size().height())) + margins.top() + margins.bottom();
}

int FormulaPanel::formulasHeight(const Explanation &explanation) const
{
    QTextDocument document;
    document.setDefaultFont(m_formulas->font());
    document.setDocumentMargin(m_formulas->document()->documentMargin());
    document.setHtml(formulaHtml(explanation, arithmetic(), palette(), symbolsIn(*m_formulas)));
    document.setTextWidth(lineWidth(*m_formulas));
    return int(std::ceil(document.size().height()));
}

void FormulaPanel::measureRun()
{
    const TracedScene *traced = m_playhead->traced();
    if (!isVisible() || !traced)
        return; // its size is not final yet, or it shows nothing
    const std::tuple run(traced->method->id, traced->scene.settings.arithmetic,
                         lineWidth(*m_formulas));
    const bool isOther = run != m_measured;
    m_measured = run;
    int sentence = isOther ? 0 : m_sentence->minimumHeight();
    int formulas = 0;
    const ScanTrace &trace = *traced->trace;
    if (trace.stepCount() == 0)
        sentence = sentenceHeight(invitation(*m_playhead));
    const auto include = [&](std::size_t step) {
        if (step >= trace.stepCount() || trace.stepAt(step).kind == StepKind::SetUp)
            return;
        const Explanation explanation = inWindowsWords(pixelplumb::explainStep(*traced, step));
        sentence = std::max(sentence, sentenceHeight(explanation));
        formulas = std::max(formulas, formulasHeight(explanation));
    };
    include(m_playhead->position() > 0 ? m_playhead->position() - 1 : 0);
    for (std::size_t i = 0; i < measuredSpans && trace.spanCount() > 0; ++i) {
        const std::size_t span = i * (trace.spanCount() - 1) / (measuredSpans - 1);
        include(trace.indexOfSpan(span));
        const std::size_t samples = trace.endSampleOf(span) - trace.firstSampleOf(span);
        for (const std::size_t sample : {std::size_t(1), std::size_t(2), samples / 2, samples})
            include(trace.indexOfSpan(span) + sample);
    }
    m_sentence->setMinimumHeight(sentence);
    const int rest = height() - m_formulas->height() - m_sentence->height();
    // Longer numbers of a step that was not measured may wrap into one more line.
    const int spare = m_formulas->fontMetrics().lineSpacing();
    const int needed = std::max(isOther ? 0 : m_neededHeight, rest + sentence + formulas + spare);
    if (needed == m_neededHeight && height() >= needed)
        return;
    m_neededHeight = needed;
    emit neededHeightChanged();
}

void FormulaPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        explainStep(); // the symbols may have another place
    fitScrollBar();
    const bool isSqueezed
        = height() < m_neededHeight && QGuiApplication::mouseButtons() == Qt::NoButton;
    if (isSqueezed || event->size().width() != event->oldSize().width())
        m_measuring.start();
}

} // namespace pixelplumb
