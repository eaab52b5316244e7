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

const QString folder = resource(u"/completions/"_s);

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
    return linesOf(u"bash"_s,
                   QStringList{u"-c"_s, script, folder + u"pixelplumb-cli"_s, program()} + words);
}

/// The same of zsh, which keeps those that begin with the word by itself.
QStringList offeredByZsh(const QStringList &words)
{
    const QString script
        = QStringLiteral(R"(compadd() { shift; print -l -- $@ }; _files() { print files }
        f() { local -a words=("$@"); local CURRENT=$#; source "$script" }; script=$1; shift; f "$@")");
    const QStringList all = linesOf(
        u"zsh"_s,
        QStringList{u"-fc"_s, script, u"zsh"_s, folder + u"_pixelplumb-cli"_s, program()} + words);
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
        row("variants", {"render", "--variant", ""}, namesOf(allVariants) + QStringList{u"none"_s});
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
        const QString source = manualText(resource(u"/man/pixelplumb-cli.1.in"_s));
        const QString path = QFileInfo(program()).path() + u"/pixelplumb-cli.1"_s;
        const QString manual = manualText(path);
        QCOMPARE(linesOf(u"mandoc"_s, {"-T", "lint", "-W", "warning", path}), QStringList());
        QVERIFY(!manual.contains(u"\n@"_s));
        for (const QString &command : offeredByBash({QString()})) {
            if (command == u"help"_s)
                continue;
            QVERIFY2(source.contains(u'\n' + u"@%1@\n"_s.arg(command)), qPrintable(command));
            const QStringList options = offeredByBash({command, u"--"_s});
            QVERIFY(options.contains(u"--help"_s));
            for (const QString &option : options) {
                const QString name = QString(option).replace(u'-', u"\\-"_s);
                QVERIFY2(option == u"--help"_s || manual.contains(name),
                         qPrintable(option + u" is not in the manual"_s));
            }
        }
    }

    void theManualTellsEveryLayer()
    {
        const QString manual = manualText(resource(u"/man/pixelplumb-cli.1.in"_s));
        for (QString name : layerNames()) {
            name.replace(u'-', u"\\-"_s);
            QVERIFY2(manual.contains(u"Cm "_s + name) || manual.contains(u" , "_s + name),
                     qPrintable(name));
        }
    }
};

PIXELPLUMB_TEST(TestCompletions)

} // namespace tst_completions

#include "tst_completions.moc"
