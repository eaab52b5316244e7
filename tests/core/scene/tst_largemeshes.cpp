// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/meshfile.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_largemeshes {

using namespace pixelplumb;

namespace {

/// A mesh with three vertices and this many faces.
QByteArray meshOf(qsizetype faces, const QByteArray &lineEnd)
{
    const QByteArray vertices = "v 0 0 0" + lineEnd + "v 1 0 0" + lineEnd + "v 0 1 0" + lineEnd;
    return vertices + QByteArray("f 1 2 3" + lineEnd).repeated(faces);
}

} // namespace

/// Meshes up to the limit and beyond it. If each line were searched from the file's beginning or to
/// its end, these would take an hour and run into the test's time limit.
class TestLargeMeshes : public QObject {
    Q_OBJECT

private slots:
    void aMeshOfManyFacesIsReadLineByLine_data()
    {
        QTest::addColumn<QByteArray>("lineEnd");
        QTest::newRow("\\n") << QByteArray("\n");
        QTest::newRow("\\r\\n") << QByteArray("\r\n");
    }
    void aMeshOfManyFacesIsReadLineByLine()
    {
        QFETCH(QByteArray, lineEnd);
        constexpr qsizetype faces = 500'000;
        const auto mesh = parseMesh(meshOf(faces, lineEnd), u"m.obj"_s);
        QVERIFY2(mesh.isOk(), mesh ? "" : qPrintable(mesh.error().message()));
        QCOMPARE(mesh->faces.size(), std::size_t(faces));
        QCOMPARE(mesh->corners.size(), std::size_t(3));
        const auto broken = parseMesh(meshOf(faces, lineEnd) + "f 1 2 x" + lineEnd, u"m.obj"_s);
        QVERIFY(!broken.isOk());
        QVERIFY2(broken.error().message().contains(u"m.obj, line 500004"_s),
                 qPrintable(broken.error().message()));
    }

    void aMeshOfTooManyFacesIsRefusedAtTheFirstOneTooMany()
    {
        const auto mesh = parseMesh(meshOf(2'200'000, "\n"), u"m.obj"_s);
        QVERIFY(!mesh.isOk());
        QVERIFY2(mesh.error().message().contains(u"m.obj, line 2097156"_s),
                 qPrintable(mesh.error().message()));
    }
};

PIXELPLUMB_TEST(TestLargeMeshes)

} // namespace tst_largemeshes

#include "tst_largemeshes.moc"
