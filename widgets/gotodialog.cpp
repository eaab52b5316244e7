// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gotodialog.h"

#include "widgets/playhead.h"
#include "widgets/steptext.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>

namespace pixelplumb {

std::optional<GoToTarget> parseGoTo(const QString &text)
{
    static const QRegularExpression pixel(
        QStringLiteral(R"(^\s*\(?\s*(-?\d{1,10})\s*[,; ]\s*(-?\d{1,10})\s*\)?\s*$)"));
    static const QRegularExpression column(QStringLiteral(R"(^\s*(-?\d{1,10})\s*$)"));
    static const QRegularExpression step(QStringLiteral(R"(^\s*#\s*(\d{1,12})\s*$)"));
    if (const auto match = pixel.match(text); match.hasMatch()) {
        bool xFits = false;
        bool yFits = false;
        const QPoint point(match.captured(1).toInt(&xFits), match.captured(2).toInt(&yFits));
        if (xFits && yFits)
            return point;
        return std::nullopt;
    }
    if (const auto match = column.match(text); match.hasMatch())
        return GoToColumn{match.captured(1).toLongLong()};
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
    setObjectName(QStringLiteral("goToDialog"));
    setWindowTitle(tr("Go To"));
    auto *label = new QLabel(tr("&Pixel, column or step"), this);
    label->setBuddy(m_line);
    m_line->setObjectName(QStringLiteral("goToLine"));
    m_line->setAccessibleName(tr("Pixel, column or step"));
    m_line->setPlaceholderText(tr("27 19   a pixel;   27   a column;   #611   a step"));
    m_line->setMinimumWidth(m_line->fontMetrics().horizontalAdvance(m_line->placeholderText())
                            + 32);
    m_verdict->setObjectName(QStringLiteral("goToVerdict"));
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Go"));
    connect(m_buttons, &QDialogButtonBox::accepted, this, &GoToDialog::go);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_line, &QLineEdit::textChanged, this, &GoToDialog::judge);

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(8);
    column->addWidget(label);
    column->addWidget(m_line);
    column->addWidget(m_verdict);
    column->addWidget(m_buttons);
    judge();
}

std::optional<std::size_t> GoToDialog::columnAt(std::int64_t x) const
{
    const ScanTrace &trace = *m_playhead->traced()->trace;
    // Columns of the triangle in hand come before those of the others.
    const auto step = m_playhead->stepInHand();
    const std::size_t start
        = step && trace.primitiveCount() > 0 ? trace.firstSpanOf(step->primitive) : 0;
    for (std::size_t i = 0; i < trace.spanCount(); ++i) {
        const std::size_t column = (start + i) % trace.spanCount();
        if (trace.placeOf(column).coordinate == x)
            return column;
    }
    return std::nullopt;
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
    } else if (const auto *column = std::get_if<GoToColumn>(&target)) {
        if (!columnAt(column->x))
            return tr("No triangle has a column %1.").arg(column->x);
    } else if (std::get<GoToStep>(target).position > m_playhead->end()) {
        return tr("The last step is %1.").arg(m_playhead->end());
    }
    return {};
}

void GoToDialog::judge()
{
    const std::optional<GoToTarget> target = parseGoTo(m_line->text());
    QString verdict;
    if (target)
        verdict = objectionTo(*target);
    else if (!m_line->text().trimmed().isEmpty())
        verdict = tr("Type two numbers for a pixel, one for a column, # and one for a step.");
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(target && verdict.isEmpty());
    if (target && verdict.isEmpty()) {
        if (const auto *pixel = std::get_if<QPoint>(&*target))
            verdict
                = tr("Picks pixel (%1, %2); time stands still.").arg(pixel->x()).arg(pixel->y());
        else if (const auto *column = std::get_if<GoToColumn>(&*target))
            verdict = tr("Goes to column %1.").arg(column->x);
        else
            verdict = stepText(*m_playhead->traced(), std::get<GoToStep>(*target).position);
    }
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
    else if (const auto *column = std::get_if<GoToColumn>(&*target))
        m_playhead->seekToSpan(*columnAt(column->x));
    else
        m_playhead->seek(std::get<GoToStep>(*target).position);
    accept();
}

} // namespace pixelplumb
