// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "core/scene/scenefile.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/testprogram.h"

#include <QImage>
#include <QTemporaryDir>
#include <QTest>

namespace tst_rendercommand {

using namespace pixelplumb;

/// Pixels of pictures from the command line. The rest is in tests/data/transcripts/render.txt.
class TestRenderCommand : public QObject {
    Q_OBJECT

private slots:
    void init() { QVERIFY(m_folder.isValid()); }

    void aScaledPictureHasASquareForEachPixel()
    {
        const QString plain = m_folder.filePath(u"plain.png"_s);
        const QString scaled = m_folder.filePath(u"scaled.png"_s);

        QCOMPARE(run({"render", defaultScene(), "-o", plain}).exitCode, 0);
        QCOMPARE(run({"render", defaultScene(), "-o", scaled, "--scale", "3"}).exitCode, 0);

        const QImage small(plain);
        const QImage large(scaled);
        QCOMPARE(large.size(), small.size() * 3);
        for (int y = 0; y < large.height(); ++y) {
            for (int x = 0; x < large.width(); ++x)
                QCOMPARE(large.pixel(x, y), small.pixel(x / 3, y / 3));
        }
    }

    void drawsTheFrameAsItIsAtAPosition()
    {
        const QString path = m_folder.filePath(u"moment.png"_s);
        const Scene scene = readSceneFile(defaultScene())->scene;
        const auto traced = traceScene(scene);
        TraceCursor cursor(*traced->trace, scene.frame);
        cursor.seek(traced->trace->stepCount() / 2);

        const ProgramRun result = run({"render", defaultScene(), "-o", path, "--position",
                                       QString::number(traced->trace->stepCount() / 2)});

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(QImage(path).convertToFormat(QImage::Format_RGB32), cursor.frame().copy());
    }

    void layersLieOverThePicture()
    {
        const QString path = m_folder.filePath(u"layers.png"_s);
        const QString plainPath = m_folder.filePath(u"without.png"_s);

        const ProgramRun result
            = run({"render", defaultScene(), "-o", path, "--scale", "16", "--layers",
                   "box,half-planes", "--method", "edge-equations"});
        const ProgramRun plain = run({"render", defaultScene(), "-o", plainPath, "--scale", "16",
                                      "--method", "edge-equations"});

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(result.messages, QByteArray());
        QCOMPARE(plain.exitCode, 0);
        const QImage picture(path);
        const QImage without(plainPath);
        QCOMPARE(picture.size(), QSize(64 * 16, 48 * 16));
        // The background is tinted where an edge function is positive, here E₀ and E₁.
        QVERIFY(picture.pixel(24, 20 * 16) != without.pixel(24, 20 * 16));
        // The box that was visited begins between the columns 3 and 4.
        QVERIFY(picture.pixel(4 * 16, 20 * 16) != picture.pixel(2 * 16, 20 * 16));
    }

private:
    QTemporaryDir m_folder;
};

PIXELPLUMB_TEST(TestRenderCommand)

} // namespace tst_rendercommand

#include "tst_rendercommand.moc"
