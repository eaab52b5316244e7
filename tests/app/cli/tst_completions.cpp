// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layer.h"
#include "core/methods/method.h"
#include "core/scan/choicenames.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QProcess>
#include <QTest>

namespace tst_completions {

using namespace pixelplumb;

namespace {

const QString folder = resource(QStringLiteral("/completions/"));

QStringList linesOf(const QString &shell, const QStringList &arguments)
{
    QProcess process;
    process.start(shell, arguments);
    if (!process.waitForFinished() || process.exitCode() != 0)
        return {QString::fromUtf8(process.readAllStandardError())};
    QStringList lines = QString::fromUtf8(process.readAllStandardOutput()).split(u'\n');
    lines.removeAll(QString());
    return lines;
}

/// What a shell offers for the last of the words that follow the program's name.
QStringList offeredByBash(const QStringList &words)
{
    const QString script = QStringLiteral(R"(. "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
        _pixelplumb_cli 2>/dev/null; printf '%s\n' "${COMPREPLY[@]}")");
    return linesOf(QStringLiteral("bash"),
                   QStringList{QStringLiteral("-c"), script,
                               folder + QStringLiteral("pixelplumb-cli"), program()}
                       + words);
}

/// The same of zsh, which keeps those that begin with the word by itself.
QStringList offeredByZsh(const QStringList &words)
{
    const QString script
        = QStringLiteral(R"(compadd() { shift; print -l -- $@ }; _files() { print files }
        f() { local -a words=("$@"); local CURRENT=$#; source "$script" }; script=$1; shift; f "$@")");
    const QStringList all
        = linesOf(QStringLiteral("zsh"),
                  QStringList{QStringLiteral("-fc"), script, QStringLiteral("zsh"),
                              folder + QStringLiteral("_pixelplumb-cli"), program()}
                      + words);
    QStringList offered;
    for (const QString &each : all) {
        if (each.startsWith(words.last()))
            offered.append(each);
    }
    return offered;
}

QStringList methodNames()
{
    QStringList names;
    for (const Method &method : methods())
        names.append(method.id);
    return names;
}

QStringList layerNames()
{
    QStringList names;
    for (const Layer &layer : layers())
        names.append(layer.id);
    return names;
}

QString manualText(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

/// What the Tab key offers in a terminal.
class TestCompletions : public QObject {
    Q_OBJECT

private slots:
    void bothShellsOfferWhatTheProgramTakes_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QStringList>("offered");
        const auto row
            = [](const char *name, const QStringList &words, const QStringList &offered) {
                  QTest::newRow(name) << words << offered;
              };
        row("commands", {""},
            {"render", "trace", "pixel", "methods", "plan", "check", "compare", "diff", "diagnose",
             "try", "grade", "counterexample", "invariants", "motion", "lab", "help"});
        row("the beginning of a command", {"pl"}, {"plan"});
        row("commands to be helped with", {"help", "ren"}, {"render"});
        row("options", {"render", "scene.json", "--a"},
            {"--ascii", "--affine-image", "--accuracy", "--arithmetic"});
        row("options with a short form", {"trace", "--ou"}, {"--output"});
        row("methods", {"render", "--method", ""}, methodNames());
        row("a method to be told", {"methods", "barycentric-of"}, {"barycentric-off-screen"});
        row("arithmetics", {"trace", "--arithmetic", ""}, namesOf(allArithmetics));
        row("fill rules", {"pixel", "--fill-rule", ""}, namesOf(allFillRules));
        row("roundings", {"render", "--rounding", ""}, namesOf(allByteRoundings));
        row("variants", {"render", "--variant", ""},
            namesOf(allVariants) + QStringList{QStringLiteral("none")});
        row("layers", {"render", "--layers", ""}, layerNames());
        row("a switch", {"plan", "--force", "smooth-colour"},
            {"smooth-colour=on", "smooth-colour=off"});
        row("what a program reads", {"try", "--input", ""}, {"json", "lines"});
        row("what another program reads", {"counterexample", "--inp"}, {"--input"});
        row("tolerances", {"try", "--tolerance", ""}, {"float32", "float64"});
        row("leeways", {"diagnose", "--leeway", ""}, {"strict", "rule", "edges", "once"});
        row("contenders", {"compare", "--methods", "line-b"},
            {"line-bresenham", "line-bresenham-symmetric"});
        row("arithmetics of a check", {"check", "--arithmetic", "a"}, {"all"});
        row("nothing of that beginning", {"render", "--zz"}, {});
    }
    void bothShellsOfferWhatTheProgramTakes()
    {
        QFETCH(QStringList, words);
        QFETCH(QStringList, offered);

        QCOMPARE(offeredByBash(words), offered);
        QCOMPARE(offeredByZsh(words), offered);
    }

    void bashGoesOnWithAListBehindItsComma()
    {
        QCOMPARE(offeredByBash({"render", "--layers", "half-planes,bo"}),
                 QStringList("half-planes,box"));
        QCOMPARE(offeredByBash({"compare", "--methods", "truth,row-walk-"}),
                 QStringList("truth,row-walk-constant-rate"));
        QCOMPARE(offeredByBash({"trace", "--variant", "rounded-box,stay"}),
                 QStringList("rounded-box,stay-at-zero"));
    }

    void theManualHasTheHelpOfEveryCommand()
    {
        const QString source = manualText(resource(QStringLiteral("/man/pixelplumb-cli.1.in")));
        const QString path = QFileInfo(program()).path() + QStringLiteral("/pixelplumb-cli.1");
        const QString manual = manualText(path);
        QCOMPARE(linesOf(QStringLiteral("mandoc"), {"-T", "lint", "-W", "warning", path}),
                 QStringList());
        QVERIFY(!manual.contains(QStringLiteral("\n@")));
        for (const QString &command : offeredByBash({QString()})) {
            if (command == QStringLiteral("help"))
                continue;
            QVERIFY2(source.contains(u'\n' + QStringLiteral("@%1@\n").arg(command)),
                     qPrintable(command));
            const QStringList options = offeredByBash({command, QStringLiteral("--")});
            QVERIFY(options.contains(QStringLiteral("--help")));
            for (const QString &option : options) {
                const QString name = QString(option).replace(u'-', QStringLiteral("\\-"));
                QVERIFY2(option == QStringLiteral("--help") || manual.contains(name),
                         qPrintable(option + QStringLiteral(" is not in the manual")));
            }
        }
    }

    void theManualTellsEveryLayer()
    {
        const QString manual = manualText(resource(QStringLiteral("/man/pixelplumb-cli.1.in")));
        for (QString name : layerNames()) {
            name.replace(u'-', QStringLiteral("\\-"));
            QVERIFY2(manual.contains(QStringLiteral("Cm ") + name)
                         || manual.contains(QStringLiteral(" , ") + name),
                     qPrintable(name));
        }
    }
};

PIXELPLUMB_TEST(TestCompletions)

} // namespace tst_completions

#include "tst_completions.moc"
