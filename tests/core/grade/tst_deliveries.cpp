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
        const QString picture = u"one.png"_s;
        QTest::newRow("no file") << u"notes.md"_s << QByteArray("-") << PictureLack::NotThere;
        QTest::newRow("no bytes") << picture << QByteArray() << PictureLack::Empty;
        QTest::newRow("words") << picture << QByteArray("to do") << PictureLack::Unreadable;
        QTest::newRow("another size")
            << picture << QByteArray("P3 1 1 255 9 9 9\n") << PictureLack::OtherSize;
        QTest::newRow("a raster of another size")
            << u"one.txt"_s << QByteArray("##\n..\n") << PictureLack::OtherSize;
        QTest::newRow("lines without pixels")
            << u"one.txt"_s << QByteArray("column 0 0 5\n") << PictureLack::TraceAlone;
        const QString program = u"main.py"_s;
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
        const QByteArray program = file.endsWith(u".py"_s) ? R"("program": {}, )" : "";
        const auto assignment = readAssignment(assignmentWith(program));
        QVERIFY(assignment.isOk());
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(u"ann"_s));
        QVERIFY(!writeFile(folder.filePath(u"ann/"_s + file), content));
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
        QVERIFY(QDir(folder.path()).mkpath(u"ann"_s));
        const QString program
            = u"print('P3 %1 %2 255 ' + '9 ' * %3)\nraise SystemExit(3)\n"_s.arg(frame.width)
                  .arg(frame.height)
                  .arg(3 * frame.width * frame.height);
        QVERIFY(!writeFile(folder.filePath(u"ann/main.py"_s), program.toUtf8()));
        const SubmissionEntry entry(QFile::encodeName(folder.path()), "ann");

        const Delivery delivery = deliveriesOf(entry, *assignment).front();

        QCOMPARE(delivery.fault, QString());
        QVERIFY(delivery.picture.has_value());
        QCOMPARE(*delivery.note,
                 u"it ended with exit code 3; the picture that it wrote is judged "
                 "all the same"_s);
    }

    void theOnlyPictureIsTakenWhateverItsName()
    {
        const auto assignment = readAssignment(assignmentWith({}));
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(u"ann"_s));
        const QByteArray raster = "#.......\n##......\n####....\n#####...\n######..\n########\n";
        QVERIFY(!writeFile(folder.filePath(u"ann/final.txt"_s), raster));
        const SubmissionEntry entry(QFile::encodeName(folder.path()), "ann");

        const Delivery delivery = deliveriesOf(entry, *assignment).front();

        QCOMPARE(delivery.fault, QString());
        QCOMPARE(delivery.file, u"final.txt"_s);
        QCOMPARE(delivery.note, std::nullopt);
        QVERIFY(!writeFile(folder.filePath(u"ann/draft.txt"_s), raster));
        const SubmissionEntry both(QFile::encodeName(folder.path()), "ann");
        const QString fault = deliveriesOf(both, *assignment).front().fault;
        QCOMPARE(fault, u"there are 2 pictures: draft.txt, final.txt; none is one.png"_s);
    }

    void severalProgramsAreNotCalledNone()
    {
        const auto assignment = readAssignment(assignmentWith(R"("program": {}, )"));
        QVERIFY(assignment.isOk());
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(u"ann"_s));
        const auto faultWith = [&](const QStringList &files) {
            for (const QString &name : files) {
                QFile file(folder.filePath(u"ann/"_s + name));
                if (!file.open(QIODevice::WriteOnly))
                    return QString();
            }
            const SubmissionEntry entry(QFile::encodeName(folder.path()), "ann");
            return deliveriesOf(entry, *assignment).front().fault;
        };
        const QString expected = u"; expected one executable file, or one that ends in .py"_s;
        QCOMPARE(faultWith({u"notes.md"_s}), "there is no program" + expected);
        QCOMPARE(faultWith({u"a.py"_s, u"b.py"_s}), "there are 2 programs: a.py, b.py" + expected);
    }
};

PIXELPLUMB_TEST(TestDeliveries)

} // namespace tst_deliveries

#include "tst_deliveries.moc"
