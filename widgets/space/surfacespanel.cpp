// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/space/surfacespanel.h"

#include "core/space/surfaces.h"
#include "widgets/look/corewords.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/parts.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/space/stagetree.h"

#include <algorithm>
#include <span>

namespace pixelplumb {

namespace {

constexpr int sliderSteps = 200;

double inPixels(Lattice units) { return double(units) / double(unitsPerPixel); }

/// The scene's first line, circle, plane or sphere, if it has one.
std::optional<Surface> surfaceOf(SurfaceKind kind, const Scene &scene)
{
    if (kind == SurfaceKind::Line || kind == SurfaceKind::Circle) {
        const PrimitiveKind shape
            = kind == SurfaceKind::Line ? PrimitiveKind::Line : PrimitiveKind::Circle;
        const auto found = std::ranges::find(scene.shapes, shape, &Shape::kind);
        if (found == scene.shapes.end())
            return std::nullopt;
        const LatticePoint &a = found->vertices[0].position;
        const LatticePoint &b = found->vertices[1].position;
        return Surface{kind,
                       {{{inPixels(a.x), inPixels(a.y), 0}, {inPixels(b.x), inPixels(b.y), 0}, {}}},
                       inPixels(absolute(b.x - a.x))};
    }
    const SolidKind solid = kind == SurfaceKind::Plane ? SolidKind::Plane : SolidKind::Sphere;
    const auto found = std::ranges::find(scene.solids, solid, &Solid::kind);
    if (found == scene.solids.end())
        return std::nullopt;
    Surface surface{kind, {}, found->radius};
    for (std::size_t i = 0; i < std::min(found->corners.size(), surface.points.size()); ++i)
        surface.points[i] = found->corners[i].position;
    return surface;
}

/// What is shown where the scene has none.
Surface exampleOf(SurfaceKind kind)
{
    switch (kind) {
    case SurfaceKind::Line:
    case SurfaceKind::Circle:
        return {kind, {{{1, 2, 0}, {7, 5, 0}, {}}}, 2};
    case SurfaceKind::Plane:
        return {kind, {{{0, 0, 0}, {2, 0, 1}, {0, 3, 1}}}, 1};
    case SurfaceKind::Sphere:
        break;
    }
    return {kind, {}, 1};
}

/// A cell of the table of forms.
QString formHtml(const SurfaceForm &form)
{
    QStringList lines = {u"<b>%1</b>"_s.arg(SymbolText(form.formula).html())};
    for (const StageNumber &number : form.numbers) {
        const QString error = number.error == 0
            ? SurfacesPanel::tr("exact")
            : SurfacesPanel::tr("error %1").arg(errorText(number));
        lines += u"%1 = %2 (%3)"_s.arg(number.name, usedText(number), error);
    }
    if (form.numbers.empty())
        lines += SurfacesPanel::tr("no such number here");
    lines += u"<i>%1</i>"_s.arg(SymbolText(form.note).html());
    return u"<td>%1</td>"_s.arg(lines.join(u"<br>"_s));
}

QString pointText(const QString &name, std::span<const double> coordinates)
{
    QStringList numbers;
    for (const double coordinate : coordinates)
        numbers += displayText(Quantity::of(coordinate));
    return u"%1 = (%2)"_s.arg(SymbolText(name).html(), numbers.join(u", "_s));
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
        return {point(u"P₀"_s, 0), point(u"P₁"_s, 1)};
    case SurfaceKind::Plane:
        return {point(u"P₀"_s, 0), point(u"P₁"_s, 1), point(u"P₂"_s, 2)};
    case SurfaceKind::Circle:
    case SurfaceKind::Sphere:
        break;
    }
    return {point(u"C"_s, 0), u"r = %1"_s.arg(displayText(Quantity::of(surface.radius)))};
}

/// A row of the table: a kind of curve or surface.
QString formsHtml(SurfaceKind kind, const Scene &scene, double s, double t)
{
    const std::optional<Surface> own = surfaceOf(kind, scene);
    const Surface surface = own.value_or(exampleOf(kind));
    QString row = u"<tr><td><b>%1</b>%2<br>%3</td>"_s.arg(
        coreWord(nameOf(kind)),
        own ? QString()
            : u"<br><i>%1</i>"_s.arg(SurfacesPanel::tr("an example: the scene has none")),
        givenBy(surface).join(u"<br>"_s));
    for (const SurfaceForm &form : formsOf(surface, s, t))
        row += formHtml(form);
    return row + u"</tr>"_s;
}

constexpr std::array mostDragged = {128, 64}; ///< higher numbers are typed into the file

bool hasSegments(const Solid &solid)
{
    return solid.kind == SolidKind::Sphere || solid.kind == SolidKind::Patch;
}

} // namespace

SurfacesPanel::SurfacesPanel(SceneDocument *document, Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_s(makeSlider(u"surfaceS"_s, tr("The parameter s, 0 … 1")))
    , m_t(makeSlider(u"surfaceT"_s, tr("The parameter t of a surface, 0 … 1")))
    , m_parameters(new QLabel)
    , m_forms(new QTextBrowser)
{
    named(this, "surfacesPanel", tr("Surfaces"));
    named(m_forms, "surfaceForms", tr("Forms of curves and surfaces"));
    m_forms->setFrameShape(QFrame::NoFrame);
    m_forms->setWordWrapMode(QTextOption::WordWrap); // not in the middle of a number
    auto *sliders = withParts(new QHBoxLayout,
                              {new QLabel(u"s"_s), m_s, new QLabel(u"t"_s), m_t, m_parameters});
    withParts(new QVBoxLayout(this), {new SegmentSliders(document), sliders, {m_forms, 1}}, -1, 8);
    for (QSlider *slider : {m_s, m_t})
        connect(slider, &QSlider::valueChanged, this, &SurfacesPanel::fillForms);
    onEvents(this, {QEvent::Show}, [this] { takeTraced(); });
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
}

void SurfacesPanel::fillForms()
{
    const double s = double(m_s->value()) / sliderSteps;
    const double t = double(m_t->value()) / sliderSteps;
    m_parameters->setText(tr("s = %1, t = %2").arg(s, 0, 'f', 3).arg(t, 0, 'f', 3));
    const TracedScene *traced = m_playhead->traced();
    const Scene scene = traced ? traced->scene : Scene();
    QString html = u"<table width='100%' border='1' cellspacing='0' cellpadding='4' "
                   "style='border-collapse: collapse'><tr><th></th>"_s;
    for (const QString &form : {tr("Explicit"), tr("Parametric"), tr("Implicit")})
        html += u"<th align='left'>%1</th>"_s.arg(form);
    html += u"</tr>"_s;
    for (const SurfaceKind kind : allSurfaces)
        html += formsHtml(kind, scene, s, t);
    const int place = m_forms->verticalScrollBar()->value();
    m_forms->setHtml(html + u"</table>"_s);
    m_forms->verticalScrollBar()->setValue(place);
}

SegmentSliders::SegmentSliders(SceneDocument *document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_sliders({makeSlider(u"segmentsAround"_s, tr("Segments around, or along s")),
                 makeSlider(u"segmentsAlong"_s, tr("Segments from pole to pole, or along t"))})
    , m_numbers(new QLabel(this))
{
    auto *row = withParts(new QHBoxLayout(this), {new QLabel(tr("Segments"))}, -1, 0);
    for (QSlider *slider : m_sliders)
        row->addWidget(slider);
    row->addWidget(m_numbers);
    connect(document, &SceneDocument::sceneChanged, this, &SegmentSliders::follow);
    follow();
}

QSlider *SegmentSliders::makeSlider(const QString &name, const QString &tip)
{
    auto *slider = new QSlider(Qt::Horizontal, this);
    slider->setObjectName(name);
    slider->setAccessibleName(tip);
    slider->setToolTip(tip);
    connect(slider, &QSlider::sliderPressed, this, [this] { m_drag = m_document->newDrag(); });
    connect(slider, &QSlider::valueChanged, this, &SegmentSliders::apply);
    return slider;
}

std::optional<std::size_t> SegmentSliders::solid() const
{
    const std::vector<Solid> &solids = m_document->scene().solids;
    const auto found = std::ranges::find_if(solids, hasSegments);
    if (found == solids.end())
        return std::nullopt;
    return std::size_t(found - solids.begin());
}

void SegmentSliders::follow()
{
    const std::optional<std::size_t> index = solid();
    setVisible(index.has_value());
    if (!index)
        return;
    const Solid &shown = m_document->scene().solids[*index];
    const std::array least = shown.kind == SolidKind::Sphere ? std::array{3, 2} : std::array{1, 1};
    for (std::size_t i = 0; i < 2; ++i) {
        const QSignalBlocker blocker(m_sliders[i]);
        m_sliders[i]->setRange(least[i], std::max(mostDragged[i], shown.segments[i]));
        m_sliders[i]->setValue(shown.segments[i]);
    }
    const QString segments = u"%1 × %2"_s.arg(shown.segments[0]).arg(shown.segments[1]);
    m_numbers->setText(shown.kind == SolidKind::Sphere
                           ? tr("%1, at most %2 from the sphere")
                                 .arg(segments)
                                 .arg(sphereDistance(shown.radius, shown.segments), 0, 'g', 3)
                           : segments);
}

void SegmentSliders::apply()
{
    const std::optional<std::size_t> index = solid();
    if (!index)
        return;
    const bool isDragged
        = std::ranges::any_of(m_sliders, [](const QSlider *each) { return each->isSliderDown(); });
    Solid changed = m_document->scene().solids[*index];
    changed.segments = {m_sliders[0]->value(), m_sliders[1]->value()};
    m_document->setSolid(*index, changed, isDragged ? m_drag : m_document->newDrag());
}

} // namespace pixelplumb
