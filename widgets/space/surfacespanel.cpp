// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/space/surfacespanel.h"

#include "widgets/look/corewords.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/numberlayout.h"
#include "widgets/look/symboltext.h"
#include "widgets/model/playhead.h"
#include "widgets/space/segmentsliders.h"
#include "widgets/space/stagetree.h"

#include <QBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QSlider>
#include <QSplitter>
#include <QTableWidget>
#include <QTextBrowser>

#include <span>

namespace pixelplumb {

namespace {

constexpr int sliderSteps = 200;

/// A cell of the table of forms.
QString formHtml(const SurfaceForm &form)
{
    QStringList lines = {QStringLiteral("<b>%1</b>").arg(SymbolText(form.formula).html())};
    for (const StageNumber &number : form.numbers) {
        const QString error = number.error == 0
            ? SurfacesPanel::tr("exact")
            : SurfacesPanel::tr("error %1").arg(errorText(number));
        lines += QStringLiteral("%1 = %2 (%3)").arg(number.name, usedText(number), error);
    }
    if (form.numbers.empty())
        lines += SurfacesPanel::tr("no such number here");
    lines += QStringLiteral("<i>%1</i>").arg(SymbolText(form.note).html());
    return QStringLiteral("<td>%1</td>").arg(lines.join(QStringLiteral("<br>")));
}

QString pointText(const QString &name, std::span<const double> coordinates)
{
    QStringList numbers;
    for (const double coordinate : coordinates)
        numbers += displayText(Quantity::of(coordinate));
    return QStringLiteral("%1 = (%2)")
        .arg(SymbolText(name).html(), numbers.join(QStringLiteral(", ")));
}

/// The given data of the formulas.
QStringList givenBy(const Surface &surface)
{
    const bool isFlat = surface.kind == SurfaceKind::Line || surface.kind == SurfaceKind::Circle;
    const auto point = [&](const QString &name, std::size_t index) {
        return pointText(name, std::span(surface.points[index]).first(isFlat ? 2 : 3));
    };
    switch (surface.kind) {
    case SurfaceKind::Line:
        return {point(QStringLiteral("P₀"), 0), point(QStringLiteral("P₁"), 1)};
    case SurfaceKind::Plane:
        return {point(QStringLiteral("P₀"), 0), point(QStringLiteral("P₁"), 1),
                point(QStringLiteral("P₂"), 2)};
    case SurfaceKind::Circle:
    case SurfaceKind::Sphere:
        break;
    }
    return {point(QStringLiteral("C"), 0),
            QStringLiteral("r = %1").arg(displayText(Quantity::of(surface.radius)))};
}

/// A row of the table: a kind of curve or surface.
QString formsHtml(SurfaceKind kind, const Scene &scene, double s, double t)
{
    const std::optional<Surface> own = surfaceOf(kind, scene);
    const Surface surface = own.value_or(exampleOf(kind));
    QString row = QStringLiteral("<tr><td><b>%1</b>%2<br>%3</td>")
                      .arg(coreWord(nameOf(kind)),
                           own ? QString()
                               : QStringLiteral("<br><i>%1</i>")
                                     .arg(SurfacesPanel::tr("an example: the scene has none")),
                           givenBy(surface).join(QStringLiteral("<br>")));
    for (const SurfaceForm &form : formsOf(surface, s, t))
        row += formHtml(form);
    return row + QStringLiteral("</tr>");
}

QTableWidgetItem *figureItem(const QString &text)
{
    auto *item = new QTableWidgetItem(text);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return item;
}

QTableWidget *makeTable(const QString &name, const QString &accessibleName,
                        const QStringList &columns)
{
    auto *table = new QTableWidget(0, int(columns.size()));
    table->setObjectName(name);
    table->setAccessibleName(accessibleName);
    table->setHorizontalHeaderLabels(columns);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setFrameShape(QFrame::NoFrame);
    table->setFont(tabularFont(table->font()));
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    return table;
}

} // namespace

SurfacesPanel::SurfacesPanel(SceneDocument *document, Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_s(makeSlider(QStringLiteral("surfaceS"), tr("The parameter s, 0 … 1")))
    , m_t(makeSlider(QStringLiteral("surfaceT"), tr("The parameter t of a surface, 0 … 1")))
    , m_parameters(new QLabel)
    , m_forms(new QTextBrowser)
    , m_segmentSentence(new QLabel)
    , m_segments(makeTable(QStringLiteral("segmentTable"), tr("Distance by segments"),
                           {tr("Segments"), tr("Faces"), tr("Distance"), tr("Time, µs")}))
{
    setObjectName(QStringLiteral("surfacesPanel"));
    setAccessibleName(tr("Surfaces"));
    m_parameters->setFont(tabularFont(font()));
    m_forms->setObjectName(QStringLiteral("surfaceForms"));
    m_forms->setAccessibleName(tr("Forms of curves and surfaces"));
    m_forms->setFrameShape(QFrame::NoFrame);
    m_forms->setFont(tabularFont(font()));
    m_forms->setWordWrapMode(QTextOption::WordWrap); // not in the middle of a number
    m_segmentSentence->setWordWrap(true);
    m_segments->verticalHeader()->hide();
    auto *sliders = new QHBoxLayout;
    sliders->addWidget(new QLabel(QStringLiteral("s")));
    sliders->addWidget(m_s);
    sliders->addWidget(new QLabel(QStringLiteral("t")));
    sliders->addWidget(m_t);
    sliders->addWidget(m_parameters);
    auto *forms = new QWidget;
    auto *formsColumn = new QVBoxLayout(forms);
    formsColumn->setContentsMargins(0, 0, 0, 0);
    formsColumn->addLayout(sliders);
    formsColumn->addWidget(m_forms, 1);
    auto *segments = new QWidget;
    auto *segmentsColumn = new QVBoxLayout(segments);
    segmentsColumn->setContentsMargins(0, 0, 0, 0);
    segmentsColumn->addWidget(new SegmentSliders(document));
    segmentsColumn->addWidget(m_segmentSentence);
    segmentsColumn->addWidget(m_segments, 1);
    auto *parts = new QSplitter(Qt::Horizontal);
    parts->addWidget(forms);
    parts->addWidget(segments);
    parts->setStretchFactor(0, 2);
    parts->setStretchFactor(1, 1);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(parts);
    for (QSlider *slider : {m_s, m_t})
        connect(slider, &QSlider::valueChanged, this, &SurfacesPanel::fillForms);
    connect(playhead, &Playhead::tracedChanged, this, [this] {
        m_isStale = true;
        takeTraced();
    });
}

QSlider *SurfacesPanel::makeSlider(const QString &name, const QString &tip)
{
    auto *slider = new QSlider(Qt::Horizontal, this);
    slider->setObjectName(name);
    slider->setAccessibleName(tip);
    slider->setToolTip(tip);
    slider->setRange(0, sliderSteps);
    slider->setValue(sliderSteps * 3 / 10);
    return slider;
}

void SurfacesPanel::takeTraced()
{
    if (!isVisible() || !m_isStale)
        return;
    m_isStale = false;
    fillForms();
    studySegments();
}

void SurfacesPanel::fillForms()
{
    const double s = double(m_s->value()) / sliderSteps;
    const double t = double(m_t->value()) / sliderSteps;
    m_parameters->setText(tr("s = %1, t = %2").arg(s, 0, 'f', 3).arg(t, 0, 'f', 3));
    const TracedScene *traced = m_playhead->traced();
    const Scene scene = traced ? traced->scene : Scene();
    QString html = QStringLiteral("<table width='100%' border='1' cellspacing='0' cellpadding='4' "
                                  "style='border-collapse: collapse'><tr><th></th>");
    for (const QString &form : {tr("Explicit"), tr("Parametric"), tr("Implicit")})
        html += QStringLiteral("<th align='left'>%1</th>").arg(form);
    html += QStringLiteral("</tr>");
    for (const SurfaceKind kind : allSurfaces)
        html += formsHtml(kind, scene, s, t);
    const int place = m_forms->verticalScrollBar()->value();
    m_forms->setHtml(html + QStringLiteral("</table>"));
    m_forms->verticalScrollBar()->setValue(place);
}

void SurfacesPanel::studySegments()
{
    const std::shared_ptr<const TracedScene> traced = m_playhead->sharedTraced();
    const Scene scene = traced ? traced->scene : Scene();
    const std::optional<Solid> own = studiedSolid(scene);
    m_isExample = !own;
    m_studied = own.value_or(exampleSolid());
    m_figures.clear();
    fillSegments();
    m_job.start(
        [solid = m_studied, scene](const ProgressListener &listener) {
            return pixelplumb::studySegments(solid, scene, listener);
        },
        [this](std::vector<SegmentFigure> figures) {
            m_figures = std::move(figures);
            fillSegments();
            emit figuresChanged();
        });
}

void SurfacesPanel::fillSegments()
{
    m_segmentSentence->setText(
        m_studied.kind == SolidKind::Sphere
            ? (m_isExample ? tr("An example, since the scene has no sphere and no patch: ")
                           : QString())
                + tr("A sphere of radius %1 by its faces: the largest distance of a face to the "
                     "sphere, by a formula, and the time of projecting it. Twice as many segments "
                     "each way are four times as many faces, and in the long run four times "
                     "nearer.")
                      .arg(m_studied.radius)
            : tr("A patch by its triangles: the largest distance found between points of the "
                 "triangles and the patch at the same parameters, 9 × 9 a cell, and the time of "
                 "projecting it."));
    m_segments->setRowCount(int(m_figures.size()));
    for (int row = 0; row < m_segments->rowCount(); ++row) {
        const SegmentFigure &figure = m_figures[std::size_t(row)];
        const bool isOwn = !m_isExample && figure.segments == m_studied.segments;
        const QString segments
            = QStringLiteral("%1 × %2").arg(figure.segments[0]).arg(figure.segments[1]);
        m_segments->setItem(row, 0, figureItem(isOwn ? segments + QStringLiteral(" ◂") : segments));
        m_segments->setItem(row, 1, figureItem(QString::number(figure.faces)));
        m_segments->setItem(row, 2, figureItem(QString::number(figure.distance, 'g', 3)));
        m_segments->setItem(row, 3, figureItem(QString::number(figure.time / 1000, 'f', 0)));
    }
}

void SurfacesPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    takeTraced();
}

} // namespace pixelplumb
