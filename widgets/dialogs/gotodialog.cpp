// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/gotodialog.h"

#include "widgets/look/parts.h"
#include "widgets/model/playhead.h"
#include "widgets/model/steptext.h"

namespace pixelplumb {

namespace {

/// The words for one number, for a method that walks along this axis.
struct SpanWords {
    QString title; ///< of the line to type in
    QString example;
    QString parts; ///< in the error for unreadable input
    QString none; ///< when nothing has that number
    QString goes;
};

SpanWords wordsFor(SpanAxis axis)
{
    switch (axis) {
    case SpanAxis::Column:
        break;
    case SpanAxis::Row:
        return {
            GoToDialog::tr("&Pixel, row or step"),
            GoToDialog::tr("27 19   a pixel;   27   a row;   #611   a step"),
            GoToDialog::tr("Type two numbers for a pixel, one for a row, # and one for a step."),
            GoToDialog::tr("There is no row %1."), GoToDialog::tr("Goes to row %1.")};
    case SpanAxis::Free:
        return {
            GoToDialog::tr("&Pixel, step of the shape or step of the run"),
            GoToDialog::tr("27 19   a pixel;   27   a shape's step;   #611   a step"),
            GoToDialog::tr("Type two numbers for a pixel, one for a shape's step, # and one for "
                           "a step of the run."),
            GoToDialog::tr("The shape has no step %1."),
            GoToDialog::tr("Goes to the shape's step %1.")};
    }
    return {GoToDialog::tr("&Pixel, column or step"),
            GoToDialog::tr("27 19   a pixel;   27   a column;   #611   a step"),
            GoToDialog::tr("Type two numbers for a pixel, one for a column, # and one for a step."),
            GoToDialog::tr("There is no column %1."), GoToDialog::tr("Goes to column %1.")};
}

} // namespace

std::optional<GoToTarget> parseGoTo(const QString &text)
{
    static const QRegularExpression span(QStringLiteral(R"(^\s*(-?\d{1,10})\s*$)"));
    static const QRegularExpression step(QStringLiteral(R"(^\s*#\s*(\d{1,12})\s*$)"));
    if (const std::optional<QPoint> pixel = typedPixel(text))
        return *pixel;
    if (const auto match = span.match(text); match.hasMatch())
        return GoToSpan{match.captured(1).toLongLong()};
    if (const auto match = step.match(text); match.hasMatch())
        return GoToStep{std::size_t(match.captured(1).toULongLong())};
    return std::nullopt;
}

GoToDialog::GoToDialog(Playhead *playhead, QWidget *parent)
    : QDialog(parent)
    , m_playhead(playhead)
    , m_line(new QLineEdit(this))
    , m_verdict(new QLabel(this))
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this))
{
    setObjectName(u"goToDialog"_s);
    setWindowTitle(tr("Go To"));
    const SpanWords words = wordsFor(m_playhead->axis());
    auto *label = named(new QLabel(words.title, this), "goToLabel");
    label->setBuddy(m_line);
    named(m_line, "goToLine", QString(words.title).remove(u'&'));
    m_line->setPlaceholderText(words.example);
    m_line->setMinimumWidth(m_line->fontMetrics().horizontalAdvance(m_line->placeholderText())
                            + 32);
    m_verdict->setObjectName(u"goToVerdict"_s);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Go"));
    connect(m_buttons, &QDialogButtonBox::accepted, this, &GoToDialog::go);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_line, &QLineEdit::textChanged, this, &GoToDialog::judge);

    withParts(new QVBoxLayout(this), {label, m_line, m_verdict, m_buttons}, 8, 16);
    judge();
}

std::optional<std::size_t> GoToDialog::spanAt(std::int64_t coordinate) const
{
    const ScanTrace &trace = *m_playhead->traced()->trace;
    // Spans of the current primitive come first.
    const auto step = m_playhead->currentStep();
    const std::size_t start
        = step && trace.primitiveCount() > 0 ? trace.firstSpanOf(step->primitive) : 0;
    std::optional<std::size_t> ofOtherAxis;
    for (std::size_t i = 0; i < trace.spanCount(); ++i) {
        const std::size_t span = (start + i) % trace.spanCount();
        if (trace.placeOf(span).coordinate != coordinate)
            continue;
        if (trace.placeOf(span).axis == m_playhead->axis())
            return span;
        if (!ofOtherAxis)
            ofOtherAxis = span;
    }
    return ofOtherAxis;
}

QString GoToDialog::objectionTo(const GoToTarget &target) const
{
    if (!m_playhead->traced())
        return tr("There is no run yet.");
    const FrameSpec &frame = m_playhead->traced()->scene.frame;
    if (const auto *pixel = std::get_if<QPoint>(&target)) {
        const QRect inside(frame.firstColumn, frame.firstRow, frame.width, frame.height);
        if (!inside.contains(*pixel))
            return tr("The frame's pixels are (%1, %2) … (%3, %4).")
                .arg(inside.left())
                .arg(inside.top())
                .arg(inside.right())
                .arg(inside.bottom());
    } else if (const auto *span = std::get_if<GoToSpan>(&target)) {
        if (!spanAt(span->coordinate))
            return wordsFor(m_playhead->axis()).none.arg(span->coordinate);
    } else if (std::get<GoToStep>(target).position > m_playhead->end()) {
        return tr("The last step is %1.").arg(m_playhead->end());
    }
    return {};
}

QString GoToDialog::verdictOn(const GoToTarget &target) const
{
    if (const auto *pixel = std::get_if<QPoint>(&target))
        return tr("Picks pixel (%1, %2); time stands still.").arg(pixel->x()).arg(pixel->y());
    if (const auto *span = std::get_if<GoToSpan>(&target)) {
        const SpanPlace &place = m_playhead->traced()->trace->placeOf(*spanAt(span->coordinate));
        return wordsFor(place.axis).goes.arg(span->coordinate);
    }
    return stepText(*m_playhead->traced(), std::get<GoToStep>(target).position);
}

void GoToDialog::judge()
{
    const std::optional<GoToTarget> target = parseGoTo(m_line->text());
    QString verdict;
    if (target)
        verdict = objectionTo(*target);
    else if (!m_line->text().trimmed().isEmpty())
        verdict = wordsFor(m_playhead->axis()).parts;
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(target && verdict.isEmpty());
    if (target && verdict.isEmpty())
        verdict = verdictOn(*target);
    m_verdict->setText(verdict);
}

void GoToDialog::go()
{
    const std::optional<GoToTarget> target = parseGoTo(m_line->text());
    if (!target || !objectionTo(*target).isEmpty())
        return;
    m_playhead->setPlaying(false);
    if (const auto *pixel = std::get_if<QPoint>(&*target))
        m_playhead->pick(*pixel);
    else if (const auto *span = std::get_if<GoToSpan>(&*target))
        m_playhead->seekToSpan(*spanAt(span->coordinate));
    else
        m_playhead->seek(std::get<GoToStep>(*target).position);
    accept();
}

} // namespace pixelplumb
