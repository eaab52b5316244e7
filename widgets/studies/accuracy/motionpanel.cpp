// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/accuracy/motionpanel.h"

#include "core/runs/scenerun.h"
#include "core/scene/text/coordinatetext.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"

namespace pixelplumb {

namespace {

using namespace std::chrono_literals;

} // namespace

MotionPanel::MotionPanel(SceneDocument *document, QWidget *parent)
    : StudyPanel("motion", tr("Motion"), parent)
    , m_document(document)
    , m_x(named(new QLineEdit(u"4"_s, this), "motionX", tr("Motion along x, px")))
    , m_y(named(new QLineEdit(u"2"_s, this), "motionY", tr("Motion along y, px")))
    , m_frames(named(new QSpinBox(this), "motionFrames", tr("Frames")))
    , m_move(named(new QPushButton(tr("Move"), this), "motionSet", tr("Let the scene move")))
    , m_stop(named(new QPushButton(tr("Stand still"), this), "motionEnd",
                   tr("Let the scene stand still")))
    , m_slider(named(new QSlider(Qt::Horizontal, this), "motionSlider", tr("Current frame")))
    , m_play(named(new QToolButton(this), "motionPlay", tr("Play the motion")))
    , m_position(named(new QLabel(this), "motionPosition", tr("Current frame")))
    , m_view(new MotionView(this))
    , m_table(named(new QTableView(this), "motionTable", tr("Pixels frame by frame")))
{
    m_summary = readingLabel("motionSummary", tr("What flickers"), this);
    makeTable();
    auto *shown = withParts(new QHBoxLayout, {{m_view, 1}, m_table}, 8);
    withParts(new QVBoxLayout(this), {motionRow(), playRow(), m_summary, {shown, 1}}, 8, 8);
    m_clock.setInterval(120ms);
    connect(&m_clock, &QTimer::timeout, m_slider, [this] {
        m_slider->setValue(m_slider->value() < m_slider->maximum() ? m_slider->value() + 1 : 0);
    });
    connect(document, &SceneDocument::sceneChanged, this, &MotionPanel::followScene);
    connect(document, &SceneDocument::currentFrameChanged, this,
            [this] { m_slider->setValue(m_document->currentFrame()); });
    followScene();
}

QSize MotionPanel::sizeHint() const
{
    const bool moves = m_document->scene().motion.has_value();
    return {900, moves ? 320 : layout()->sizeHint().height()};
}

QBoxLayout *MotionPanel::motionRow()
{
    m_frames->setRange(2, largestFrameCount);
    m_frames->setValue(33);
    m_x->setMaximumWidth(80);
    m_y->setMaximumWidth(80);
    m_move->setToolTip(tr("All triangles and shapes move by (x, y) px from the first frame to the "
                          "last; saved with the scene"));
    auto *row = withParts(new QHBoxLayout,
                          {new QLabel(tr("Move by x"), this), m_x, new QLabel(tr("y"), this), m_y,
                           new QLabel(tr("px in"), this), m_frames, new QLabel(tr("frames"), this),
                           m_move, m_stop, Room()},
                          8);
    connect(m_move, &QPushButton::clicked, this, &MotionPanel::setMotion);
    connect(m_x, &QLineEdit::returnPressed, this, &MotionPanel::setMotion);
    connect(m_y, &QLineEdit::returnPressed, this, &MotionPanel::setMotion);
    connect(m_stop, &QPushButton::clicked, m_document,
            [this] { m_document->setMotion(std::nullopt); });
    return row;
}

QBoxLayout *MotionPanel::playRow()
{
    m_play->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_play->setCheckable(true);
    play(false);
    m_play->setToolTip(tr("Show one frame after the other, over and over"));
    auto *row = withParts(new QHBoxLayout, {m_play, {m_slider, 1}, m_position}, 8);
    connect(m_play, &QToolButton::toggled, this, &MotionPanel::play);
    connect(m_slider, &QSlider::valueChanged, m_document, &SceneDocument::setCurrentFrame);
    connect(m_slider, &QSlider::valueChanged, this, &MotionPanel::showFrame);
    return row;
}

void MotionPanel::makeTable()
{
    const auto column = [](const QString &title, std::int64_t MotionFrame::*count) {
        return RowsColumn<MotionFrame>{
            title, {}, [count](const MotionFrame &frame) { return QString::number(frame.*count); }};
    };
    m_rows = new RowsModel<MotionFrame>({column(tr("pixels"), &MotionFrame::drawn),
                                         column(tr("in truth"), &MotionFrame::truth),
                                         column(tr("came or went"), &MotionFrame::toggled),
                                         column(tr("in truth"), &MotionFrame::truthToggled)},
                                        this);
    m_table->setModel(m_rows);
    readByRows(m_table);
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, m_slider,
            [this](const QModelIndex &current) {
                if (current.isValid())
                    m_slider->setValue(current.row());
            });
}

/// Fits the table to its columns; the picture gets the remaining width.
void MotionPanel::showAllColumns()
{
    int width = m_table->verticalHeader()->sizeHint().width()
        + m_table->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    for (int column = 0; column < m_rows->columnCount(); ++column)
        width += std::max(m_table->horizontalHeader()->sectionSizeHint(column),
                          static_cast<QAbstractItemView *>(m_table)->sizeHintForColumn(column));
    m_table->setFixedWidth(width + 4); // px: the styles' margin around a scroll bar
}

void MotionPanel::play(bool isPlaying)
{
    m_play->setText(isPlaying ? tr("pause") : tr("play"));
    m_play->setIcon(stepIcon(isPlaying ? StepSign::Pause : StepSign::Play));
    isPlaying ? m_clock.start() : m_clock.stop();
}

void MotionPanel::setMotion()
{
    const Result<SnappedNumber> x = parseCoordinate(m_x->text().trimmed());
    const Result<SnappedNumber> y = parseCoordinate(m_y->text().trimmed());
    if (!x || !y) {
        m_summary->setText(tr("“%1” is no distance: expected px, such as 4, 0.5 or 1/3.")
                               .arg(x ? m_y->text() : m_x->text()));
        return;
    }
    m_document->setMotion(Motion{{x->units, y->units}, m_frames->value()});
}

void MotionPanel::followScene()
{
    m_study.reset();
    const std::optional<Motion> &motion = m_document->scene().motion;
    if (motion) {
        m_x->setText(coordinateText(motion->by.x));
        m_y->setText(coordinateText(motion->by.y));
        m_frames->setValue(motion->frames);
    } else {
        m_play->setChecked(false);
    }
    m_stop->setEnabled(motion.has_value());
    m_play->setEnabled(motion.has_value());
    m_slider->setEnabled(motion.has_value());
    m_slider->setValue(m_document->currentFrame()); // before a new end moves it
    m_slider->setMaximum(motion ? motion->frames - 1 : 0);
    for (QWidget *each :
         std::initializer_list<QWidget *>{m_view, m_table, m_slider, m_play, m_position})
        each->setVisible(motion.has_value()); // a still scene has nothing to show
    updateGeometry();
    emit neededHeightChanged();
    restart();
}

void MotionPanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_play->setChecked(false);
    m_drawing.cancel();
}

bool MotionPanel::beginStudy()
{
    const auto scene = m_document->snapshot();
    m_objection = scene->motion ? objectionTo(*scene) : QString();
    m_rows->setRows({}); // the current frame stays
    showFrame();
    tellStudy();
    if (!scene->motion || !m_objection.isEmpty())
        return true;
    m_job.start([scene](const ProgressListener &listener) { return studyMotion(*scene, listener); },
                [this](std::optional<MotionStudy> study) { take(std::move(study)); });
    return true;
}

void MotionPanel::take(std::optional<MotionStudy> study)
{
    m_study = std::move(study);
    m_rows->setRows(m_study ? m_study->frames : std::vector<MotionFrame>());
    showAllColumns();
    m_table->setCurrentIndex(m_rows->index(m_slider->value(), 0));
    tellStudy();
}

void MotionPanel::tellStudy()
{
    const auto timesText = [](std::int64_t count) { return tr("%n times", nullptr, int(count)); };
    QString text;
    if (!m_document->scene().motion)
        text = tr("The scene stands still. Move it by a few pixels in many frames: pixels that "
                  "flicker are counted.");
    else if (!m_objection.isEmpty())
        text = tr("The method %1.").arg(withTitles(m_objection));
    else if (!m_study)
        text = tr("The frames are being drawn.");
    else
        text = tr("Over %1 frames pixels toggle %2; in the truth, %3.")
                   .arg(m_study->frames.size())
                   .arg(timesText(m_study->toggled()), timesText(m_study->truthToggled()));
    tell(text);
}

void MotionPanel::showFrame()
{
    if (!isVisible() || isStale()) // beginStudy() shows it
        return;
    const auto scene = m_document->snapshot();
    const int frame = m_slider->value();
    if (!scene->motion || !m_objection.isEmpty()) {
        m_position->clear();
        m_view->setPicture({});
        return;
    }
    m_position->setText(tr("frame %1 of %2").arg(frame).arg(scene->motion->frames - 1));
    m_drawing.start(
        [scene, frame](const ProgressListener &) { return motionPicture(*scene, frame); },
        [this](const MotionPicture &picture) { m_view->setPicture(picture); });
    m_table->setCurrentIndex(m_rows->index(frame, 0));
}

} // namespace pixelplumb
