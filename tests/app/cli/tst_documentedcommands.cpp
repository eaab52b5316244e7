// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programs/programrun.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

namespace tst_documentedcommands {

using namespace pixelplumb;

namespace {

/// A command of a document that runs tests by a regular expression of their names.
struct TestCommand {
    QString text;
    QStringList names; ///< the alternatives of the expression: "lab(plots|figures)" has two
    bool runsSlowTests = false;
};

QList<TestCommand> testCommandsIn(const QString &path)
{
    static const QRegularExpression command(
        u"`(?:tests/run )?(--all )?-R ('([^']+)'|([\\w-]+))[^`]*`"_s);
    static const QRegularExpression group(u"^(.*)\\((.*)\\)(.*)$"_s);
    QList<TestCommand> commands;
    const QString text = textInTree(path).simplified();
    for (const QRegularExpressionMatch &match : command.globalMatch(text)) {
        const QString expression = match.captured(3) + match.captured(4);
        const QRegularExpressionMatch grouped = group.match(expression);
        QStringList names = (grouped.hasMatch() ? grouped.captured(2) : expression).split(u'|');
        for (QString &name : names)
            name = grouped.captured(1) + name + grouped.captured(3);
        commands.append({match.captured(), names, !match.captured(1).isEmpty()});
    }
    return commands;
}

/// The names of the tests of the build that this program belongs to, and whether each is slow.
QMap<QString, bool> slownessOfTests()
{
    QDir build(QCoreApplication::applicationDirPath());
    while (!build.exists(u"CMakeCache.txt"_s) && build.cdUp()) { }
    QProcess ctest;
    ctest.start(u"ctest"_s, {u"--test-dir"_s, build.path(), u"--show-only=json-v1"_s});
    if (!ctest.waitForFinished())
        return {};
    const QJsonObject answer = QJsonDocument::fromJson(ctest.readAllStandardOutput()).object();
    QMap<QString, bool> slowness;
    for (const QJsonValue &test : answer[QLatin1String("tests")].toArray()) {
        bool isSlow = false;
        for (const QJsonValue &property : test[QLatin1String("properties")].toArray())
            isSlow = isSlow
                || (property[QLatin1String("name")] == QLatin1String("LABELS")
                    && property[QLatin1String("value")].toArray().contains(QLatin1String("slow")));
        slowness.insert(test[QLatin1String("name")].toString(), isSlow);
    }
    return slowness;
}

} // namespace

/// The commands that README and the documents give do what is said of them.
class TestDocumentedCommands : public QObject {
    Q_OBJECT

private slots:
    void everyCommandOfADocumentRunsATest()
    {
        const QMap<QString, bool> slowness = slownessOfTests();
        QVERIFY(slowness.size() > 100);
        qsizetype commands = 0;
        for (const QString &path : documents()) {
            for (const TestCommand &command : testCommandsIn(path)) {
                ++commands;
                for (const QString &name : command.names) {
                    const QRegularExpression expression(name);
                    const bool runsOne
                        = std::ranges::any_of(slowness.keys(), [&](const QString &test) {
                              return expression.match(test).hasMatch()
                                  && (command.runsSlowTests || !slowness[test]);
                          });
                    QVERIFY2(runsOne, qPrintable(path + u' ' + command.text + u' ' + name));
                }
            }
        }
        QVERIFY(commands > 30);
    }

    void everyClaimHasItsCommand()
    {
        // A claim is an item of a list; its command stands in the same item.
        const QString claims = textInTree("resources/testing.md").section(u"\n## "_s, 1);
        const QStringList items = claims.split(QRegularExpression(u"\n(?=- )"_s));
        QVERIFY(items.size() > 25);
        for (const QString &item : items.mid(1)) {
            const QString claim = item.section(u"\n\n"_s, 0, 0);
            QVERIFY2(claim.contains(QLatin1String("`tests/"))
                         || claim.contains(QLatin1String("`build/release/app/")),
                     qPrintable(claim));
        }
    }

    void everyTestThatTakesATenthOfItsCasesIsToldOf()
    {
        const QString told = textInTree("resources/testing.md");
        int takingATenth = 0;
        for (const QString &path : filesBelow("tests", {"tst_*.cpp"})) {
            const QString name = path.section(u'/', -1).mid(4).chopped(4);
            const bool takesATenth = textInTree(path).contains(
                QLatin1String("#include \"tests/support/casestorun.h\""));
            if (!takesATenth || name == QLatin1String("casestorun"))
                continue;
            ++takingATenth;
            QVERIFY2(told.contains(u'`' + name + u'`'), qPrintable(name));
        }
        QVERIFY(takingATenth > 5);
    }

    void theReadmesExampleIsWhatTheProgramPrints()
    {
        static const QRegularExpression example(
            u"^    \\$ build/release/app/pixelplumb-cli (.+)\\n((?:    .*\\n)+)"_s,
            QRegularExpression::MultilineOption);
        const QRegularExpressionMatch match = example.match(textInTree(u"README.md"_s));
        QVERIFY(match.hasMatch());
        QStringList arguments = match.captured(1).split(u' ');
        for (QString &argument : arguments) {
            if (argument.startsWith(QLatin1String("resources/")))
                argument = inTree(argument);
        }
        const QString expected = match.captured(2).remove(
            QRegularExpression(u"^    "_s, QRegularExpression::MultilineOption));

        const ProgramRun result = run(arguments);

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(QString::fromUtf8(result.output), expected);
    }
};

PIXELPLUMB_TEST(TestDocumentedCommands)

} // namespace tst_documentedcommands

#include "tst_documentedcommands.moc"
