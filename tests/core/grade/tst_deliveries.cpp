// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/delivery.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace tst_deliveries {

using namespace pixelplumb;

namespace {

QByteArray assignmentWith(const QByteArray &more)
{
    return R"({ "pixelplumbAssignment": 1, "name": "One", )" + more + R"("scenes": [ {
        "name": "one", "scene": { "pixelplumb": 1, "frame": { "width": 8, "height": 6 },
            "primitives": [ { "triangle": [[0, 0], [7, 0], [0, 5]],
                              "colors": ["#ff0000", "#00ff00", "#0000ff"] } ] } } ] })";
}

} // namespace

/// Which part of a submission counts as a scene's picture, and why there is none.
class TestDeliveries : public QObject {
    Q_OBJECT

private slots:
    void whyThereIsNoPictureIsKnown_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<PictureLack>("lack");
        const QString picture = QStringLiteral("one.png");
        QTest::newRow("no file") << QStringLiteral("notes.md") << QByteArray("-")
                                 << PictureLack::NotThere;
        QTest::newRow("no bytes") << picture << QByteArray() << PictureLack::Empty;
        QTest::newRow("words") << picture << QByteArray("to do") << PictureLack::Unreadable;
        QTest::newRow("another size")
            << picture << QByteArray("P3 1 1 255 9 9 9\n") << PictureLack::OtherSize;
        QTest::newRow("a raster of another size")
            << QStringLiteral("one.txt") << QByteArray("##\n..\n") << PictureLack::OtherSize;
        QTest::newRow("lines without pixels")
            << QStringLiteral("one.txt") << QByteArray("column 0 0 5\n") << PictureLack::TraceAlone;
        const QString program = QStringLiteral("main.py");
        QTest::newRow("a program that fails")
            << program << QByteArray("raise SystemExit(3)\n") << PictureLack::NotDrawn;
        QTest::newRow("a program that prints nothing")
            << program << QByteArray("pass\n") << PictureLack::Empty;
        QTest::newRow("a program that draws another size")
            << program << QByteArray("print('P3 1 1 255 9 9 9')\n") << PictureLack::OtherSize;
    }
    void whyThereIsNoPictureIsKnown()
    {
        QFETCH(QString, file);
        QFETCH(QByteArray, content);
        const QByteArray program = file.endsWith(QStringLiteral(".py")) ? R"("program": {}, )" : "";
        const auto assignment = readAssignment(assignmentWith(program));
        QVERIFY(assignment.isOk());
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("ann")));
        QVERIFY(!writeFile(folder.filePath(QStringLiteral("ann/") + file), content));
        const SubmissionEntry entry(QFile::encodeName(folder.path()), "ann");

        const Delivery delivery = deliveriesOf(entry, *assignment).front();

        QVERIFY(!delivery.fault.isEmpty());
        QVERIFY(delivery.lack.has_value());
        QTEST(*delivery.lack, "lack");
    }

    void aPictureIsJudgedThoughItsProgramEndsWithAnExitCode()
    {
        const auto assignment = readAssignment(assignmentWith(R"("program": {}, )"));
        QVERIFY(assignment.isOk());
        const FrameSpec &frame = assignment->scenes.front().scene.frame;
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("ann")));
        const QString program
            = QStringLiteral("print('P3 %1 %2 255 ' + '9 ' * %3)\nraise SystemExit(3)\n")
                  .arg(frame.width)
                  .arg(frame.height)
                  .arg(3 * frame.width * frame.height);
        QVERIFY(!writeFile(folder.filePath(QStringLiteral("ann/main.py")), program.toUtf8()));
        const SubmissionEntry entry(QFile::encodeName(folder.path()), "ann");

        const Delivery delivery = deliveriesOf(entry, *assignment).front();

        QCOMPARE(delivery.fault, QString());
        QVERIFY(delivery.picture.has_value());
        QCOMPARE(*delivery.note,
                 QStringLiteral("it ended with exit code 3; the picture that it wrote is judged "
                                "all the same"));
    }

    void aPictureOfAnotherNameIsSaidToBeTaken()
    {
        const auto assignment = readAssignment(assignmentWith({}));
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("ann")));
        const QByteArray raster = "#.......\n##......\n####....\n#####...\n######..\n########\n";
        QVERIFY(!writeFile(folder.filePath(QStringLiteral("ann/final.txt")), raster));
        const SubmissionEntry entry(QFile::encodeName(folder.path()), "ann");

        const Delivery delivery = deliveriesOf(entry, *assignment).front();

        QCOMPARE(delivery.fault, QString());
        QCOMPARE(delivery.note.value_or(QString()),
                 "final.txt was taken, the only picture; one.png was asked for");
    }

    void severalProgramsAreNotCalledNone()
    {
        const auto assignment = readAssignment(assignmentWith(R"("program": {}, )"));
        QVERIFY(assignment.isOk());
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("ann")));
        const auto faultWith = [&](const QStringList &files) {
            for (const QString &name : files) {
                QFile file(folder.filePath(QStringLiteral("ann/") + name));
                if (!file.open(QIODevice::WriteOnly))
                    return QString();
            }
            const SubmissionEntry entry(QFile::encodeName(folder.path()), "ann");
            return deliveriesOf(entry, *assignment).front().fault;
        };
        const QString expected
            = QStringLiteral("; expected one executable file, or one that ends in .py");
        QCOMPARE(faultWith({QStringLiteral("notes.md")}), "there is no program" + expected);
        QCOMPARE(faultWith({QStringLiteral("a.py"), QStringLiteral("b.py")}),
                 "there are 2 programs: a.py, b.py" + expected);
    }
};

PIXELPLUMB_TEST(TestDeliveries)

} // namespace tst_deliveries

#include "tst_deliveries.moc"
