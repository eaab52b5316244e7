// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/space/segmentsliders.h"

#include "core/space/surfaces.h"
#include "widgets/look/parts.h"
#include "widgets/model/scenedocument.h"

#include <algorithm>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

constexpr std::array mostDragged = {128, 64}; ///< higher numbers are typed into the file

bool hasSegments(const Solid &solid)
{
    return solid.kind == SolidKind::Sphere || solid.kind == SolidKind::Patch;
}

} // namespace

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
