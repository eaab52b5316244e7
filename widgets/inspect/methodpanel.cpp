// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/methodpanel.h"

#include "core/runs/explain/stepmoment.h"
#include "core/runs/tracedscene.h"
#include "core/scan/choicenames.h"
#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/playhead.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr int indentation = 20; // logical pixels per level
constexpr float lineTint = 0.18F;
constexpr int roomAround = 8; // logical pixels around the current lines after scrolling
const QString lineMark = u"▶"_s;

/// A row of the table of lines: the mark, then the text.
QString lineHtml(const PseudocodeLine &line, bool isCurrent, const QColor &tint)
{
    return u"<tr%1><td width=16 align=center>%2</td><td style=\"padding-left:%3px\">"
           "%4</td></tr>"_s
               .arg(isCurrent ? u" bgcolor=\"%1\""_s.arg(tint.name()) : QString(),
                    isCurrent ? lineMark : QString())
               .arg(indentation * line.depth + 4)
               .arg(typesetHtml(line.text));
}

/// Where the run departs from the method, and how that changes the picture.
QString variantsHtml(VariantSet variants, SpanAxis axis)
{
    QString html;
    const auto text = [](std::string_view part) { return typesetHtml(nameText(part)); };
    for (const Variant variant : variantsIn(variants)) {
        const VariantWords &words = wordsOf(variant, axis);
        html += u"<p>%1 <b>%2</b>: %3 %4 %5. %6</p>"_s.arg(u"With the variant"_s, text(words.title),
                                                           text(words.printed), u"in place of"_s,
                                                           text(words.right), text(words.fault));
    }
    return html;
}

} // namespace

MethodPanel::MethodPanel(Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_text(new QTextBrowser(this))
{
    named(this, "methodPanel", tr("This method"));
    named(m_text, "methodText", tr("What the method does, line by line"));
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->setOpenLinks(false);
    m_text->document()->setDocumentMargin(8);
    withParts(new QVBoxLayout(this), {m_text}, -1, 0);
    onEvents(this, {QEvent::Show}, [this] {
        if (m_isStale)
            present();
    });
    onEvents(this, {QEvent::Resize}, [this] { showCurrentLines(); });
    onEvents(this, {QEvent::PaletteChange}, [this] { schedulePresentation(); });
    connect(playhead, &Playhead::positionChanged, this, &MethodPanel::schedulePresentation);
}

void MethodPanel::schedulePresentation()
{
    m_isStale = true;
    if (isVisible())
        present();
}

void MethodPanel::present()
{
    m_isStale = false;
    const TracedScene *traced = m_playhead->traced();
    if (!traced) {
        m_text->clear();
        return;
    }
    const auto step = m_playhead->currentStep();
    std::optional<Moment> moment;
    if (step)
        moment = momentOf(*traced->trace, m_playhead->position() - 1);
    const QColor tint = blended(palette().color(QPalette::Base),
                                signColour(Sign::CurrentColumn, palette()), lineTint);
    QString rows;
    QStringList current;
    for (const PseudocodeLine &line : pseudocodeOf(*traced, step ? step->primitive : 0)) {
        const bool isCurrent
            = moment && std::ranges::find(line.moments, *moment) != line.moments.end();
        rows += lineHtml(line, isCurrent, tint);
        if (isCurrent)
            current += line.text;
    }
    const Method &method = *traced->method;
    const int scrolled = m_text->verticalScrollBar()->value();
    m_text->setHtml(u"<p><b>%1</b><br>%2</p>%3<table cellspacing=0 cellpadding=2 "
                    "width=\"100%\">%4</table><p><small>%5</small></p>"_s.arg(
                        inEnglish(method.title).toHtmlEscaped(), typesetHtml(method.summary),
                        variantsHtml(traced->scene.settings.variants, method.spanAxis), rows,
                        u"From: %1."_s.arg(method.source).toHtmlEscaped()));
    m_text->verticalScrollBar()->setValue(scrolled);
    showCurrentLines();
    setAccessibleDescription(current.join(u"; "_s));
}

/// Scrolls as little as possible: to all current lines, or to as many as fit, from the first.
void MethodPanel::showCurrentLines()
{
    const QTextDocument &document = *m_text->document();
    QRectF lines;
    for (QTextCursor mark = document.find(lineMark); !mark.isNull();
         mark = document.find(lineMark, mark)) {
        // A row ends where its text does, in the cell after the mark's.
        const QTextBlock text = mark.block().next();
        lines |= document.documentLayout()->blockBoundingRect(mark.block());
        lines |= document.documentLayout()->blockBoundingRect(text);
    }
    if (lines.isNull())
        return;
    QScrollBar *bar = m_text->verticalScrollBar();
    const int top = int(lines.top()) - roomAround;
    const int bottom = int(lines.bottom()) + 1 + roomAround;
    const int lowest = std::max(bar->value(), bottom - m_text->viewport()->height());
    bar->setValue(std::min(lowest, top));
}

} // namespace pixelplumb
