// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/formulapanel.h"

#include "core/methods/formulaexplanation.h"
#include "widgets/blend.h"
#include "widgets/formulahtml.h"
#include "widgets/numberlayout.h"
#include "widgets/playhead.h"
#include "widgets/signs.h"

#include <QEvent>
#include <QLabel>
#include <QScrollBar>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace pixelplumb {

namespace {

constexpr int sentenceLines = 2; // always kept free, so that the formulas stay where they are
constexpr float bannerTint = 0.18F;

/// What the panel says where no step is in hand.
Explanation invitation(const Playhead &playhead)
{
    Explanation explanation;
    if (!playhead.traced() || playhead.traced()->primitives.size() == 0) {
        explanation.heading = FormulaPanel::tr("No triangle yet");
        explanation.sentence = FormulaPanel::tr(
            "Click three points on the canvas. The triangle is drawn column by column, and every "
            "number of every step appears here.");
        return explanation;
    }
    explanation.heading = FormulaPanel::tr("Before the first step");
    explanation.sentence = FormulaPanel::tr(
        "Nothing is drawn yet. Step forward by a column with F10 or by a pixel with F11.");
    return explanation;
}

} // namespace

FormulaPanel::FormulaPanel(Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_heading(new QLabel(this))
    , m_sentence(new QLabel(this))
    , m_formulas(new QTextBrowser(this))
{
    setObjectName(QStringLiteral("formulaPanel"));
    setAccessibleName(tr("Formulas of the step in hand"));
    const auto selectable = Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard;

    m_heading->setObjectName(QStringLiteral("formulaHeading"));
    m_heading->setTextFormat(Qt::RichText);
    m_heading->setMargin(4);
    m_heading->setAutoFillBackground(true);
    m_heading->setTextInteractionFlags(selectable);
    m_heading->setMinimumWidth(1); // a long heading must not widen the window

    m_sentence->setObjectName(QStringLiteral("formulaSentence"));
    m_sentence->setTextFormat(Qt::RichText);
    m_sentence->setWordWrap(true);
    m_sentence->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_sentence->setContentsMargins(4, 0, 4, 4);
    m_sentence->setTextInteractionFlags(selectable);

    m_formulas->setObjectName(QStringLiteral("formulaText"));
    m_formulas->setAccessibleName(tr("Formulas"));
    m_formulas->setFrameShape(QFrame::NoFrame);
    m_formulas->setOpenLinks(false);
    if (const QFont figures = tabularFont(font()); figures != font())
        m_formulas->setFont(figures);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_heading);
    layout->addWidget(m_sentence);
    layout->addWidget(m_formulas, 1);

    connect(playhead, &Playhead::tracedChanged, this, &FormulaPanel::explainStep);
    connect(playhead, &Playhead::positionChanged, this, &FormulaPanel::explainStep);
    explainStep();
}

QSize FormulaPanel::sizeHint() const { return {440, 300}; }

void FormulaPanel::explainStep()
{
    if (!m_playhead->stepInHand()) {
        present(invitation(*m_playhead));
        return;
    }
    const TracedScene &traced = *m_playhead->traced();
    present(pixelplumb::explainStep(traced, m_playhead->position() - 1));
}

void FormulaPanel::present(const Explanation &explanation)
{
    const Arithmetic arithmetic = m_playhead->traced()
        ? m_playhead->traced()->scene.settings.arithmetic
        : Arithmetic::Exact;

    QPalette headingPalette = palette();
    if (explanation.isHalfChange)
        headingPalette.setColor(QPalette::Window,
                                blended(palette().color(QPalette::Window),
                                        signColour(Sign::ColumnInHand, palette()), bannerTint));
    m_heading->setPalette(headingPalette);
    const QString event
        = explanation.isHalfChange ? tr("x₁ reached: L₁₂ takes over from L₀₁") : QString();
    m_heading->setText(
        QStringLiteral("<b>%1</b>%2")
            .arg(sentenceHtml(explanation.heading),
                 event.isEmpty() ? QString() : QStringLiteral(" &nbsp;⚑ ") + sentenceHtml(event)));
    m_sentence->setMinimumHeight(fontMetrics().lineSpacing() * sentenceLines + 6);
    m_sentence->setText(sentenceHtml(explanation.sentence));

    const int scrolled = m_formulas->verticalScrollBar()->value();
    m_formulas->setHtml(formulaHtml(explanation, arithmetic, palette()));
    m_formulas->verticalScrollBar()->setValue(scrolled);
    setAccessibleDescription(explanation.heading + QStringLiteral(". ") + explanation.sentence
                             + u'\n' + formulaText(explanation, arithmetic));
}

void FormulaPanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        explainStep();
}

} // namespace pixelplumb
