// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnosis.h"
#include "core/scene/scenefile.h"
#include "tests/support/programrun.h"
#include "tests/support/sourcetree.h"

#include <QSize>
#include <QTemporaryDir>
#include <QTest>

using namespace pixelplumb;

namespace {

constexpr Colour white{{255, 255, 255}};

std::vector<Scene> probes()
{
    std::vector<Scene> scenes;
    for (int i = 1; i <= 3; ++i)
        scenes.push_back(
            readSceneFile(resource(QStringLiteral("/probes/column-scan-%1.json")).arg(i))->scene);
    return scenes;
}

using PixelChange = Colour (*)(const Colour &right, bool isCovered);

/// As a program would write it: what is covered is told by the colours alone.
Submission submissionOf(const Scene &scene, PixelChange change)
{
    Picture picture = pictureOf(scene);
    for (std::size_t i = 0; i < picture.size(); ++i)
        picture.colours[i] = change(picture.colours[i], picture.covered[i] != 0);
    coverAllBut(scene.frame.background, picture);
    return {scene, picture};
}

} // namespace

/// What programs do to a picture beside the drawing: another colour of the frame, a mask, nothing.
class TestWholePicture : public QObject {
    Q_OBJECT

private slots:
    void whatIsDoneToAWholePictureIsNamedAlone_data()
    {
        QTest::addColumn<PixelChange>("change");
        const auto row
            = [](const char *name, PixelChange change) { QTest::newRow(name) << change; };
        row("drawn-on-white",
            [](const Colour &right, bool isCovered) { return isCovered ? right : white; });
        row("drawn-in-white-alone",
            [](const Colour &right, bool isCovered) { return isCovered ? white : right; });
        row("nothing-drawn", [](const Colour &, bool) { return Colour(); });
    }
    void whatIsDoneToAWholePictureIsNamedAlone()
    {
        QFETCH(PixelChange, change);
        std::vector<Submission> submissions;
        for (const Scene &scene : probes()) {
            QCOMPARE(scene.frame.background, Colour());
            submissions.push_back(submissionOf(scene, change));
        }

        const auto diagnosis = diagnose(submissions);

        QVERIFY(diagnosis);
        QCOMPARE(diagnosis->candidates.size(), std::size_t(1));
        QCOMPARE(diagnosis->candidates.front().defects.size(), std::size_t(1));
        QCOMPARE(diagnosis->candidates.front().defects.front().id,
                 QString::fromLatin1(QTest::currentDataTag()));
    }

    void onWhiteADefectOfTheDrawingIsNamedBesideTheBackground()
    {
        std::vector<Submission> submissions;
        for (Scene scene : probes()) {
            const Scene right = scene;
            scene.settings.variants = scene.settings.variants.with(Variant::DivisorPlusOne);
            submissions.push_back(submissionOf(scene, [](const Colour &drawn, bool isCovered) {
                return isCovered ? drawn : white;
            }));
            submissions.back().scene = right;
        }

        const auto diagnosis = diagnose(submissions);

        QVERIFY(diagnosis);
        QCOMPARE(diagnosis->candidates.size(), std::size_t(1));
        QStringList ids;
        for (const Defect &defect : diagnosis->candidates.front().defects)
            ids += defect.id;
        QCOMPARE(ids, QStringList({"divisor-plus-one", "drawn-on-white"}));
    }

    void anEnlargedPictureIsSaidToBeOne()
    {
        QCOMPARE(enlargementText({512, 384}, {64, 48}),
                 QStringLiteral(", 8 times as many each way, as if enlarged"));
        for (const QSize other : {QSize(64, 48), QSize(128, 48), QSize(100, 75), QSize(32, 24)})
            QCOMPARE(enlargementText(other, {64, 48}), QString());

        QTemporaryDir folder;
        const QString small = folder.filePath(QStringLiteral("small.png"));
        const QString large = folder.filePath(QStringLiteral("large.png"));
        const QString scene = resource(QStringLiteral("/probes/column-scan-1.json"));
        QCOMPARE(run({QStringLiteral("render"), scene, QStringLiteral("-o"), small}).exitCode, 0);
        QCOMPARE(run({QStringLiteral("render"), scene, QStringLiteral("--scale"),
                      QStringLiteral("3"), QStringLiteral("-o"), large})
                     .exitCode,
                 0);
        const ProgramRun result = run({QStringLiteral("diff"), small, large});
        QCOMPARE(result.exitCode, 3);
        QVERIFY2(result.messages.contains("3 times as many each way, as if enlarged"),
                 result.messages.constData());
    }
};

QTEST_MAIN(TestWholePicture)
#include "tst_wholepicture.moc"
