// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cases/hardcasesdetails.h"

#include "core/compare/contest.h"
#include "core/scan/choicenames.h"
#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"
#include "widgets/look/typesetting.h"
#include "widgets/studies/cases/hardcasespicture.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr QSize largestPicture(364, 120);
constexpr int leastReadingHeight = 64; ///< logical pixels; the rest scrolls

std::vector<Contender> contendersOf(const Method &method)
{
    std::vector<Contender> contenders;
    for (const Arithmetic arithmetic : method.arithmetics) {
        for (const FillRule rule : method.fillRules)
            contenders.push_back({&method, {arithmetic, rule, ByteRounding::Nearest}});
    }
    return contenders;
}

} // namespace

HardCasesDetails::HardCasesDetails(QWidget *parent)
    : QWidget(parent)
{
    named(this, "hardCasesDetails", tr("The chosen case"));
    m_title = readingLabel("hardCaseTitle", tr("Name of the case"), this);
    m_title->setFont(bold(font()));
    withParts(new QVBoxLayout(this), {m_title}, 8, 0);
    onEvents(this, {QEvent::Show}, [this] { checkNext(); });
    onEvents(this, {QEvent::PaletteChange}, [this] {
        if (m_case)
            showPicture();
    });
    addReading();
    addButtons();
    tell(tr("Choose a case."));
}

/// The readable part of a case: as wide as the panel; scrolls where it is higher.
void HardCasesDetails::addReading()
{
    m_picture = pushButton("hardCasePicture", {},
                           tr("A click opens the case at the first pixel that differs."), this);
    m_picture->setAccessibleName(tr("Open at the first pixel that differs"));
    m_picture->setFlat(true);
    m_picture->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_caption = readingLabel("hardCaseCaption", tr("Whose pictures they are"), this);
    m_words
        = readingLabel("hardCaseWords", tr("What the case stresses, and why it goes wrong"), this);
    m_words->setTextFormat(Qt::RichText);
    m_table = new HardCasesVerdicts(this);
    m_progress = new QProgressBar(this);
    m_progress->setFormat(tr("%v of %m methods"));
    m_cancel = pushButton("hardCasesCancel", tr("Cancel"), {}, this);
    auto *work = withParts(new QHBoxLayout, {{m_progress, 1}, m_cancel}, 8);

    m_reading = columnScroll(this);
    m_reading->setAccessibleName(tr("About the chosen case"));
    m_reading->setMinimumHeight(leastReadingHeight);
    auto *column = new QWidget(m_reading);
    auto *layout = withParts(new QVBoxLayout(column), {}, 8, 0);
    for (QWidget *each : {static_cast<QWidget *>(m_picture), static_cast<QWidget *>(m_caption),
                          static_cast<QWidget *>(m_words)})
        layout->addWidget(each);
    layout->addLayout(work);
    layout->addWidget(m_table, 1);
    m_reading->setWidget(column);
    static_cast<QVBoxLayout *>(this->layout())->addWidget(m_reading, 1);
    connect(m_picture, &QPushButton::clicked, this, &HardCasesDetails::open);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        m_isCancelled = true;
        m_job.cancel();
        showVerdicts();
    });
}

/// Adds the buttons below the scroll area, so that they are always visible.
void HardCasesDetails::addButtons()
{
    m_open = pushButton("hardCaseOpen", tr("Open"),
                        tr("Opens the case at the first pixel that differs"), this);
    m_compare = pushButton("hardCaseCompare", tr("Compare"),
                           tr("Opens the case and compares exact, float32 and float64"), this);
    m_precision = pushButton("hardCasePrecision", tr("Precision"),
                             tr("Opens the case and plots the error of the bounds"), this);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    for (QPushButton *each : {m_open, m_compare, m_precision}) {
        each->setMinimumWidth(each->fontMetrics().horizontalAdvance(each->text()) + 16);
        buttons->addWidget(each);
    }
    static_cast<QVBoxLayout *>(layout())->addLayout(buttons);
    connect(m_open, &QPushButton::clicked, this, &HardCasesDetails::open);
    connect(m_compare, &QPushButton::clicked, this, &HardCasesDetails::compare);
    connect(m_precision, &QPushButton::clicked, this, [this] {
        open();
        emit precisionRequested();
    });
}

void HardCasesDetails::tell(const QString &text)
{
    m_title->setText(text);
    for (QWidget *each : {static_cast<QWidget *>(m_open), static_cast<QWidget *>(m_compare),
                          static_cast<QWidget *>(m_precision), static_cast<QWidget *>(m_picture)})
        each->setEnabled(m_case.has_value());
}

void HardCasesDetails::show(const GalleryCase &chosen, const Method &method,
                            const ScanSettings &settings, const HardCasePicture *picture)
{
    const bool isOther = !m_case || m_case->hardCase.id != chosen.hardCase.id;
    m_case = chosen;
    m_method = &method;
    m_settings = settings;
    m_shown = picture ? *picture : HardCasePicture();
    tell(chosen.hardCase.id);
    QStringList words = {u"<b>What is hard:</b> %1."_s.arg(typesetHtml(chosen.hardCase.stresses)),
                         u"<b>Why:</b> %1"_s.arg(typesetHtml(chosen.why))};
    if (!chosen.failsIn.isEmpty())
        words.append(u"<b>Seen to fail:</b> %1."_s.arg(typesetHtml(chosen.failsIn.join(u"; "_s))));
    if (!chosen.note.isEmpty())
        words.append(u"<b>Note:</b> %1."_s.arg(typesetHtml(chosen.note)));
    m_words->setText(inEnglish(u"<p>"_s + words.join(u"</p><p>"_s) + u"</p>"_s));
    showPicture();
    if (isOther) {
        m_isCancelled = false;
        m_job.cancel();
        m_checking.clear();
        m_reading->verticalScrollBar()->setValue(0);
    }
    showVerdicts();
    checkNext();
}

void HardCasesDetails::showPicture()
{
    const int width = std::clamp(m_reading->viewport()->width() - 8, 1, largestPicture.width());
    const QSize size = QSize(width, largestPicture.height() * width / largestPicture.width());
    m_picture->setIconSize(size);
    m_picture->setFixedHeight(size.height() + 8);
    m_picture->setIcon(sideBySide(m_shown, size, palette(), devicePixelRatioF()));
    if (m_shown.drawn.isNull())
        return m_caption->setText(tr("Being drawn by the current method."));
    const Contender &contender = m_shown.contender;
    const QStringList drawnBy
        = {methodTitle(*contender.method), coreWord(nameOf(contender.settings.arithmetic)),
           coreWord(nameOf(contender.settings.fillRule))};
    m_caption->setText(
        tr("Left: %1: %2. Right: the truth.").arg(drawnBy.join(u", "_s), m_shown.verdict()));
}

const std::vector<ContenderVerdict> &HardCasesDetails::verdicts() const
{
    static const std::vector<ContenderVerdict> none;
    if (!m_case)
        return none;
    const auto known = m_verdicts.find(m_case->hardCase.id);
    return known == m_verdicts.end() ? none : known->second.all;
}

void HardCasesDetails::checkNext()
{
    if (!m_case || !isVisible() || m_isCancelled)
        return;
    const QString id = m_case->hardCase.id;
    if (m_job.isRunning() && m_checking == id)
        return;
    m_checking = id;
    const std::size_t next = m_verdicts[id].methodsDone;
    if (next == methods().size())
        return;
    m_job.start(
        [hardCase = m_case->hardCase, next](const ProgressListener &listener) {
            std::vector<ContenderVerdict> verdicts;
            for (const Contender &contender : contendersOf(methods()[next])) {
                if (!listener(
                        {JobPhase::Checking, std::int64_t(next), std::int64_t(methods().size())}))
                    break;
                const CaseReport report = checkCase(hardCase, {contender});
                verdicts.insert(verdicts.end(), report.verdicts.begin(), report.verdicts.end());
            }
            return verdicts;
        },
        [this, id](const std::vector<ContenderVerdict> &verdicts) {
            Verdicts &known = m_verdicts[id];
            known.all.insert(known.all.end(), verdicts.begin(), verdicts.end());
            ++known.methodsDone;
            showVerdicts();
            checkNext();
        });
}

void HardCasesDetails::showVerdicts()
{
    const Verdicts known = m_case ? m_verdicts[m_case->hardCase.id] : Verdicts();
    m_table->show(known.all);
    m_progress->setRange(0, int(methods().size()));
    m_progress->setValue(int(known.methodsDone));
    const bool isDone = known.methodsDone == methods().size();
    m_progress->setVisible(!isDone);
    m_cancel->setVisible(!isDone && !m_isCancelled);
}

void HardCasesDetails::open()
{
    if (m_case)
        emit openRequested(sceneOf(m_case->hardCase, *m_method, m_settings));
}

void HardCasesDetails::compare()
{
    if (!m_case)
        return;
    const Scene scene = sceneOf(m_case->hardCase, *m_method, m_settings);
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    std::vector<Contender> contenders;
    for (const Arithmetic arithmetic :
         {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64}) {
        ScanSettings settings = scene.settings;
        settings.arithmetic = arithmetic;
        if (method.refusal(settings).isEmpty())
            contenders.push_back({&method, settings});
    }
    if (contenders.size() < fewestContenders)
        contenders.push_back({nullptr, scene.settings});
    open();
    emit compareRequested(contenders);
}

void HardCasesDetails::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    if (m_case && event->size().width() != event->oldSize().width())
        showPicture();
}

} // namespace pixelplumb
