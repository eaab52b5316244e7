// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileaccess.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <memory>

namespace tst_handedin {

using namespace pixelplumb;

namespace {

/// JSON with ' for ".
QByteArray quoted(const char *text) { return QByteArray(text).replace('\'', '"'); }

} // namespace

/// What is said of pictures and programs that students hand in.
class TestHandedIn : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(!writeFile(path("white.json"),
                           quoted("{ 'pixelplumb': 1,"
                                  " 'frame': { 'width': 8, 'height': 6 }, 'primitives': ["
                                  " { 'triangle': [[1, 1], [6, 1], [1, 4]],"
                                  " 'colors': ['#ffffff', '#ffffff', '#ffffff'] } ] }")));
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("subs/one")));
        QCOMPARE(run({"render", path("white.json"), "-o", path("white.png")}).exitCode, 0);
    }

    void transparencyIsIgnoredAndThatIsSaid()
    {
        const QImage image = QImage(path("white.png")).convertToFormat(QImage::Format_ARGB32);
        QImage clear = image;
        for (int y = 0; y < clear.height(); ++y) {
            for (int x = 0; x < clear.width(); ++x)
                clear.setPixel(x, y, clear.pixel(x, y) & 0x80ffffffU);
        }
        QVERIFY(clear.save(path("clear.png")));

        const ProgramRun opaque = run({"diff", path("white.json"), path("white.png")});
        const ProgramRun told = run({"diff", path("white.json"), path("clear.png")});
        const ProgramRun json = run({"diff", path("white.json"), path("clear.png"), "--json"});

        QVERIFY2(opaque.messages.isEmpty(), opaque.messages.constData());
        QVERIFY2(told.messages.contains("transparency is ignored"), told.messages.constData());
        QVERIFY(
            QJsonDocument::fromJson(json.output)[QStringLiteral("transparencyIgnored")].toBool());
    }

    void everyCommandSaysThatTransparencyIsIgnored()
    {
        QImage clear = QImage(path("white.png")).convertToFormat(QImage::Format_ARGB32);
        const auto runsOn = [&] {
            return std::pair(
                run({"diagnose", path("clear.png"), "--scene", path("white.json")}),
                run({"try", "--scene", path("white.json"), "--", "/bin/cat", path("clear.png")}));
        };
        const auto isInJson = [&](const QStringList &command) {
            return QJsonDocument::fromJson(run(command).output);
        };
        for (const bool isTransparent : {true, false}) {
            clear.setPixel(0, 0, isTransparent ? 0 : 0xff000000U); // as is the background
            QVERIFY(clear.save(path("clear.png")));

            const auto [diagnosed, tried] = runsOn();

            QCOMPARE(diagnosed.messages.contains(
                         "clear.png: has transparent pixels; their transparency is ignored"),
                     isTransparent);
            QCOMPARE(tried.output.contains("its picture has transparent pixels"), isTransparent);
            QCOMPARE(isInJson({"diagnose", path("clear.png"), "--scene", path("white.json"),
                               "--json"})[QStringLiteral("transparencyIgnored")]
                         .toBool(!isTransparent),
                     isTransparent);
            QCOMPARE(isInJson({"try", "--json", "--scene", path("white.json"), "--", "/bin/cat",
                               path("clear.png")})[QStringLiteral("trials")][0]
                                                  [QStringLiteral("transparencyIgnored")]
                                                      .toBool(!isTransparent),
                     isTransparent);
        }
    }

    void whatIsNoDocumentedKindOfPictureIsRefused()
    {
        const QImage image(path("white.png"));
        if (!image.save(path("white.jpg"), "jpg"))
            QSKIP("no JPEG here");

        const ProgramRun result = run({"diff", path("white.json"), path("white.jpg")});

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains("jpeg"), result.messages.constData());
        QVERIFY2(result.messages.contains("expected PNG, PPM, BMP"), result.messages.constData());
    }

    void aBrokenFileIsCalledByItsName()
    {
        const QByteArray whole = *readFile(path("white.png"));
        QVERIFY(!writeFile(path("subs/one/white.png"), whole.left(whole.size() - 20)));

        const QString sentences = gradedText(quoted(" 'scenes': [ { 'name': 'white',"
                                                    " 'scene': 'white.json' } ]"));

        QVERIFY2(sentences.contains(QStringLiteral("white.png: ")), qPrintable(sentences));
        QVERIFY2(!sentences.contains(QStringLiteral("the output")), qPrintable(sentences));
    }

    void theFirstPixelIsToldInTheFramesCoordinates()
    {
        QImage image(path("white.png"));
        image.setPixel(2, 3, qRgb(9, 9, 9)); // line 3 from the top is row 2
        QVERIFY(image.save(path("subs/one/white.png")));

        const QString sentences = gradedText(quoted(" 'hint': 'pixels', 'scenes': [ {"
                                                    " 'name': 'white', 'scene': 'white.json' } ]"));

        QVERIFY2(sentences.contains(QStringLiteral("; the first is (2, 2)")),
                 qPrintable(sentences));
    }

    void whoSleepsInOneSceneIsWaitedForLessInTheOthers()
    {
        QVERIFY(!writeFile(path("subs/one/main.py"), "import time\ntime.sleep(1000)\n"));

        const QString sentences
            = gradedText(quoted(" 'scenes': ["
                                " { 'name': 'first', 'scene': 'white.json' },"
                                " { 'name': 'second', 'scene': 'white.json' } ],"
                                " 'program': { 'seconds': 1 }"));

        QVERIFY2(sentences.contains(
                     QStringLiteral("first: it was ended by the clock: it had waited for 4 s")),
                 qPrintable(sentences));
        QVERIFY2(sentences.contains(
                     QStringLiteral("second: it was ended by the clock: it had waited for 1 s")),
                 qPrintable(sentences));
        QVERIFY2(sentences.contains(QStringLiteral("second: it was given less time by the clock")),
                 qPrintable(sentences));
    }

    void whatAProgramPrintedBeforeItCrashedIsLookedAt()
    {
        // y_B of column 2 is 1: wrong is the second line; what is not there is none.
        const ProgramRun tried
            = run({"try", "--scene", path("white.json"), "--", "sh", "-c",
                   "printf 'column 1 1 4\\ncolumn 2 1.5 3.4\\ncolumn 3 1 2'; kill -ABRT $$"});

        QCOMPARE(tried.exitCode, 1);
        QVERIFY2(tried.output.contains("it crashed"), tried.output.constData());
        QVERIFY2(tried.output.contains("first difference: column 2, y_B: 1.5, should be 1"),
                 tried.output.constData());
        const ProgramRun right = run({"try", "--scene", path("white.json"), "--", "sh", "-c",
                                      "printf 'column 1 1 4\\ncolumn 2 1 3.4\\n'; kill -ABRT $$"});
        QVERIFY2(!right.output.contains("first difference"), right.output.constData());
    }

    void whatMayBeEitherWayHasAVerdict()
    {
        const auto triedWith = [this](QRgb onTheEdge) {
            QImage image(path("white.png"));
            image.setPixel(3, 4, onTheEdge); // row 1: the lower edge
            [[maybe_unused]] const bool isSaved = image.save(path("tried.png"));
            return run({"try", "--scene", path("white.json"), "--", "cat", path("tried.png")});
        };

        const ProgramRun right = triedWith(qRgb(255, 255, 255));
        const ProgramRun open = triedWith(qRgb(0, 0, 0));
        const ProgramRun wrong = triedWith(qRgb(9, 9, 9));

        QCOMPARE(right.exitCode, 0);
        QVERIFY2(right.output.endsWith("\nright\n"), right.output.constData());
        QCOMPARE(open.exitCode, 0);
        QVERIFY2(open.output.endsWith("\nundecidable: 1 pixel differs, as a right program may have "
                                      "it\n"),
                 open.output.constData());
        QCOMPARE(wrong.exitCode, 1);
    }

    void noNameOfAFileOfResultsIsTakenForAnOption()
    {
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("subs/--help")));

        gradedText(quoted(" 'scenes': [ { 'name': 'white', 'scene': 'white.json' } ]"));

        for (const QString &name : QDir(path("out/gradescope")).entryList(QDir::Files))
            QVERIFY2(!name.startsWith(u'-'), qPrintable(name));
        const auto results = QJsonDocument::fromJson(*readFile(path("out/results.json")));
        const QByteArray table = *readFile(path("out/grades.csv"));
        for (const QJsonValue &each : results[QStringLiteral("submissions")].toArray())
            QVERIFY2(table.contains(',' + each[QStringLiteral("id")].toString().toUtf8()),
                     table.constData());
    }

    void messagesHoldNoControlCharacters_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("an unknown key") << QStringList{"render", "-", "-o", "x.png"};
        QTest::newRow("a method") << QStringList{"render", defaultScene(), "--ascii", "--method",
                                                 "a\033[31mb\a"};
        QTest::newRow("a file") << QStringList{"render", "/nowhere/a\033[31mb\a\n", "--ascii"};
        QTest::newRow("an option") << QStringList{"render", defaultScene(), "--a\033[31mb\a"};
        QTest::newRow("a command") << QStringList{"a\033[31mb\a"};
    }
    void messagesHoldNoControlCharacters()
    {
        QFETCH(QStringList, words);

        const ProgramRun result = run(
            words, quoted("{ 'pixelplumb': 1, 'a\\u001b[31mb\\u0007': 1, 'primitives': [] }"));

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains("a\\x1b[31mb\\x07"), result.messages.constData());
        QVERIFY(std::ranges::none_of(result.messages, [](char character) {
            return character >= 0 && character < ' ' && character != '\n';
        }));
    }

private:
    QString path(const char *name) const { return m_folder->filePath(QString::fromLatin1(name)); }

    /// The first submission's sentences, under an assignment that has these members.
    QString gradedText(const QByteArray &members)
    {
        const QByteArray head = quoted("{ 'pixelplumbAssignment': 1, 'name': 'a', ");
        if (writeFile(path("a.json"), head + members + " }"))
            return {};
        const ProgramRun graded
            = run({"grade", path("subs"), "--assignment", path("a.json"), "-o", path("out")});
        const auto results = QJsonDocument::fromJson(*readFile(path("out/results.json")));
        return results[QStringLiteral("submissions")][0][QStringLiteral("output")].toString()
            + QString::fromUtf8(graded.messages);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

PIXELPLUMB_TEST(TestHandedIn)

} // namespace tst_handedin

#include "tst_handedin.moc"
