// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/hardcasesdetails.h"

#include "widgets/hardcasesverdicts.h"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>

namespace pixelplumb {

namespace {

constexpr QSize pictureSize(364, 120);

std::vector<Candidate> candidatesOf(const Method &method)
{
    std::vector<Candidate> candidates;
    for (const Arithmetic arithmetic : method.arithmetics) {
        for (const FillRule rule : method.fillRules)
            candidates.push_back({&method, {arithmetic, rule, ByteRounding::Nearest}});
    }
    return candidates;
}

} // namespace

HardCasesDetails::HardCasesDetails(QWidget *parent)
    : QScrollArea(parent)
{
    setObjectName(QStringLiteral("hardCasesDetails"));
    setAccessibleName(tr("The chosen case"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(new QWidget(this));
    auto *column = new QVBoxLayout(widget());
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    m_title = addText("hardCaseTitle");
    m_title->setAccessibleName(tr("Name of the case"));
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_picture = new QPushButton(this);
    m_picture->setObjectName(QStringLiteral("hardCasePicture"));
    m_picture->setAccessibleName(tr("Open at the first pixel that differs"));
    m_picture->setToolTip(tr("A click opens the case at the first pixel that differs."));
    m_picture->setFlat(true);
    m_picture->setIconSize(pictureSize);
    m_picture->setMinimumHeight(pictureSize.height() + 8);
    m_caption = addText("hardCaseCaption");
    m_caption->setAccessibleName(tr("Whose pictures they are"));
    m_words = addText("hardCaseWords");
    m_words->setAccessibleName(tr("What the case stresses, and why it goes wrong"));
    m_words->setTextFormat(Qt::RichText);
    m_open = new QPushButton(tr("Open at the first difference"), this);
    m_open->setObjectName(QStringLiteral("hardCaseOpen"));
    m_compare = new QPushButton(tr("Compare numbers"), this);
    m_compare->setObjectName(QStringLiteral("hardCaseCompare"));
    m_compare->setToolTip(tr("Opens the case and compares exact, float32 and float64"));
    m_precision = new QPushButton(tr("Show the errors"), this);
    m_precision->setObjectName(QStringLiteral("hardCasePrecision"));
    m_precision->setToolTip(tr("Opens the case and plots the error of the bounds"));
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(m_open);
    buttons->addWidget(m_compare);
    buttons->addWidget(m_precision);
    buttons->addStretch();
    m_table = new HardCasesVerdicts(this);
    m_progress = new QProgressBar(this);
    m_progress->setFormat(tr("%v of %m methods"));
    m_cancel = new QPushButton(tr("Cancel"), this);
    m_cancel->setObjectName(QStringLiteral("hardCasesCancel"));
    auto *work = new QHBoxLayout;
    work->setSpacing(8);
    work->addWidget(m_progress, 1);
    work->addWidget(m_cancel);
    for (QWidget *each : {static_cast<QWidget *>(m_title), static_cast<QWidget *>(m_picture),
                          static_cast<QWidget *>(m_caption), static_cast<QWidget *>(m_words)})
        column->addWidget(each);
    column->addLayout(buttons);
    column->addLayout(work);
    column->addWidget(m_table, 1);
    connect(m_picture, &QPushButton::clicked, this, &HardCasesDetails::open);
    connect(m_open, &QPushButton::clicked, this, &HardCasesDetails::open);
    connect(m_compare, &QPushButton::clicked, this, &HardCasesDetails::compare);
    connect(m_precision, &QPushButton::clicked, this, [this] {
        open();
        emit precisionRequested();
    });
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        m_isCancelled = true;
        m_job.cancel();
        showVerdicts();
    });
    tell(tr("Choose a case."));
}

HardCasesDetails::~HardCasesDetails() = default;

QLabel *HardCasesDetails::addText(const char *name)
{
    auto *label = new QLabel(this);
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
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
    QStringList words = {tr("<b>Stresses:</b> %1.").arg(chosen.hardCase.stresses.toHtmlEscaped()),
                         tr("<b>Why:</b> %1").arg(chosen.why.toHtmlEscaped())};
    if (!chosen.failsIn.isEmpty())
        words.append(tr("<b>Seen to fail:</b> %1.")
                         .arg(chosen.failsIn.join(QStringLiteral("; ")).toHtmlEscaped()));
    if (!chosen.note.isEmpty())
        words.append(tr("<b>Note:</b> %1.").arg(chosen.note.toHtmlEscaped()));
    m_words->setText(QStringLiteral("<p>") + words.join(QStringLiteral("</p><p>"))
                     + QStringLiteral("</p>"));
    showPicture();
    if (isOther) {
        m_isCancelled = false;
        m_job.cancel();
        m_checking.clear();
        verticalScrollBar()->setValue(0);
    }
    showVerdicts();
    checkNext();
}

void HardCasesDetails::showPicture()
{
    m_picture->setIcon(sideBySide(m_shown, pictureSize, palette(), devicePixelRatioF()));
    m_caption->setText(m_shown.drawn.isNull()
                           ? tr("Being drawn by the method in hand.")
                           : tr("Left: %1, %2. Right: the truth.")
                                 .arg(m_shown.contender.name(), m_shown.verdict()));
}

const std::vector<CandidateVerdict> &HardCasesDetails::verdicts() const
{
    static const std::vector<CandidateVerdict> none;
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
        [hardCase = m_case->hardCase, next](JobControl &control) {
            std::vector<CandidateVerdict> verdicts;
            for (const Candidate &candidate : candidatesOf(methods()[next])) {
                if (control.cancelled)
                    break;
                const CaseReport report = checkCase(hardCase, {candidate});
                verdicts.insert(verdicts.end(), report.verdicts.begin(), report.verdicts.end());
            }
            return verdicts;
        },
        [this, id](const std::vector<CandidateVerdict> &verdicts) {
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

void HardCasesDetails::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange && m_case)
        showPicture();
    QScrollArea::changeEvent(event);
}

void HardCasesDetails::showEvent(QShowEvent *event)
{
    QScrollArea::showEvent(event);
    checkNext();
}

} // namespace pixelplumb
