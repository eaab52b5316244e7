// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/surfaces.h"
#include "tests/support/scenes/spacescenes.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/model/scenedocument.h"
#include "widgets/space/surfacespanel.h"

#include <QTest>
#include <QtWidgets>

#include <algorithm>

namespace tst_segmentsliders {

using namespace pixelplumb;

namespace {

Scene sphereScene()
{
    Scene scene;
    scene.camera = Camera();
    scene.solids = {solidOf(SolidKind::Sphere)};
    return scene;
}

std::array<int, 2> segmentsIn(const SceneDocument &document)
{
    const std::vector<Solid> &solids = document.scene().solids;
    return std::ranges::find(solids, SolidKind::Sphere, &Solid::kind)->segments;
}

} // namespace

/// The sphere's segments, changed with sliders.
class TestSegmentSliders : public QObject {
    Q_OBJECT

private slots:
    void aSliderChangesTheSphereAndCanBeUndone()
    {
        SceneDocument document;
        document.reset(sphereScene());
        SegmentSliders sliders(&document);
        auto *around = named<QSlider>(sliders, "segmentsAround");
        const std::array<int, 2> before = segmentsIn(document);
        QCOMPARE(around->value(), before[0]);

        around->setValue(before[0] + 5);
        QCOMPARE(segmentsIn(document), (std::array{before[0] + 5, before[1]}));

        document.undoStack()->undo();
        QCOMPARE(segmentsIn(document), before);
        QCOMPARE(around->value(), before[0]);
    }

    void theMovesOfOneDragAreOneEdit()
    {
        SceneDocument document;
        document.reset(sphereScene());
        SegmentSliders sliders(&document);
        auto *along = named<QSlider>(sliders, "segmentsAlong");

        along->setSliderDown(true);
        for (const int value : {9, 10, 11, 12})
            along->setSliderPosition(value);
        along->setSliderDown(false);

        QCOMPARE(segmentsIn(document)[1], 12);
        QCOMPARE(document.undoStack()->count(), 1);
    }

    void moreSegmentsAreNearerToTheSphere()
    {
        SceneDocument document;
        document.reset(sphereScene());
        SegmentSliders sliders(&document);
        const auto isTold = [&sliders](const QString &text) {
            return std::ranges::any_of(
                sliders.findChildren<QLabel *>(),
                [&text](const QLabel *label) { return label->text() == text; });
        };

        for (const std::array<int, 2> segments : {std::array{16, 8}, std::array{32, 16}}) {
            Solid sphere = document.scene().solids[0];
            sphere.segments = segments;
            document.setSolid(0, sphere, document.newDrag());
            QVERIFY(isTold(u"%1 × %2, at most %3 from the sphere"_s.arg(segments[0])
                               .arg(segments[1])
                               .arg(sphereDistance(sphere.radius, segments), 0, 'g', 3)));
        }
    }

    void aSceneWithoutSphereOrPatchHasNoSliders()
    {
        SceneDocument document;
        SegmentSliders sliders(&document);
        QVERIFY(sliders.isHidden());

        document.reset(sphereScene());
        QVERIFY(!sliders.isHidden());
    }
};

PIXELPLUMB_TEST(TestSegmentSliders)

} // namespace tst_segmentsliders

#include "tst_segmentsliders.moc"
