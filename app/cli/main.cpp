// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "core/scene/files/inputrecord.h"
#include "version.h"

#include <QCoreApplication>
#include <QLoggingCategory>

#include <algorithm>
#include <exception>

namespace pixelplumb::cli {

const std::vector<Command> &commands()
{
    static const std::vector<Command> table = {
        {u"render"_s, u"Draw a scene to a picture or as text."_s, render},
        {u"trace"_s, u"Print the numbers that the drawing used."_s, trace},
        {u"pixel"_s, u"Tell what wrote a pixel, or what refuses it."_s, pixel},
        {u"methods"_s, u"List the methods of scan conversion, or describe one in full."_s,
         listMethods},
        {u"plan"_s, u"Tell which effects a scene calls for, and why."_s, plan},
        {u"check"_s, u"Run a file of hard cases."_s, check},
        {u"compare"_s, u"Tell where methods disagree, and why."_s, compare},
        {u"diff"_s, u"Tell how two pictures differ, and by what cause."_s, diff},
        {u"diagnose"_s, u"Name the defects whose pictures equal a student's."_s, diagnose},
        {u"try"_s, u"Run a student's program, and tell where it goes wrong."_s, tryProgram},
        {u"grade"_s, u"Grade a folder of submissions."_s, grade},
        {u"counterexample"_s, u"Find a small scene that two drawers draw differently."_s,
         counterExample},
        {u"invariants"_s, u"Check the properties that every right picture has."_s, invariants},
        {u"motion"_s, u"Count what flickers while a scene moves."_s, motion},
        {u"lab"_s, u"Measure what accuracy costs in time."_s, lab},
        {u"help"_s, u"Show this help, or a command's: help COMMAND."_s, help},
    };
    return table;
}

namespace {

QStringList commandNames()
{
    QStringList names;
    for (const Command &command : commands())
        names.append(command.name);
    return names;
}

const Command *commandNamed(const QString &name)
{
    const auto found = std::ranges::find(commands(), name, &Command::name);
    return found == commands().end() ? nullptr : &*found;
}

QString helpText()
{
    const QString program = QCoreApplication::applicationName();
    QString text
        = u"Usage: %1 COMMAND [options] ARGUMENTS\n"
          "Draw, trace and measure triangle scan conversion.\n\nCommands:\n"_s.arg(program);
    for (const Command &command : commands())
        text += u"  %1  %2\n"_s.arg(command.name.leftJustified(14), command.summary);
    text += u"\nOptions:\n"
            "  -h, --help     Show this help; after a command, the command's.\n"
            "  -v, --version  Show the version.\n\n"
            "Exit status: 0 done or same, 1 differs or falls short, 2 usage or unreadable input,\n"
            "3 sizes differ, 70 internal error."_s;
    return text;
}

ExitCode refuseWords(const QString &what)
{
    const QString program = QCoreApplication::applicationName();
    sayLine(u"%1: %2"_s.arg(program, what));
    sayLine(u"Try “%1 --help”."_s.arg(program));
    return ExitCode::Usage;
}

ExitCode run(const QStringList &arguments)
{
    const InputRecord inputs;
    if (arguments.isEmpty())
        return refuseWords(u"a command is missing"_s);
    const QString &word = arguments.front();
    if (word == u"--help"_s || word == u"-h"_s)
        return help(*commandNamed(u"help"_s), arguments.sliced(1));
    if (word == u"--version"_s || word == u"-v"_s) {
        if (arguments.size() > 1)
            return refuseWords(u"%1: unexpected argument “%2”"_s.arg(word, arguments[1]));
        printLine(QCoreApplication::applicationName() + u' '
                  + QCoreApplication::applicationVersion());
        return ExitCode::Done;
    }
    if (const Command *command = commandNamed(word))
        return endOf(word, [&] { return command->run(*command, arguments.sliced(1)); });
    if (word.startsWith(u'-')) {
        const QStringList options = {u"--help"_s, u"--version"_s};
        return refuseWords(u"unknown option %1"_s.arg(word) + suggestion(word, options));
    }
    return refuseWords(u"unknown command “%1”"_s.arg(word) + suggestion(word, commandNames()));
}

} // namespace

ExitCode help(const Command &command, const QStringList &arguments)
{
    const QString option = u"--help"_s;
    const QString word = arguments.value(0, option);
    // `help help` adds nothing to the general help.
    if (word == command.name || word == option || word == u"-h"_s) {
        printLines(helpText().split(u'\n'));
        return ExitCode::Done;
    }
    if (arguments.size() > 1)
        return refuseWords(u"help: unexpected argument “%1”"_s.arg(arguments[1]));
    const Command *explained = commandNamed(word);
    if (!explained)
        return refuseWords(u"help: unknown command “%1”"_s.arg(word)
                           + suggestion(word, commandNames()));
    return endOf(explained->name, [&] { return explained->run(*explained, {option}); });
}

} // namespace pixelplumb::cli

int main(int argc, char *argv[])
{
    using namespace pixelplumb::cli;

    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(u"pixelplumb-cli"_s);
    QCoreApplication::setApplicationVersion(QStringLiteral(PIXELPLUMB_VERSION));
    // Image errors are reported by the commands, with the picture's name.
    QLoggingCategory::setFilterRules(u"qt.gui.imageio*=false"_s);
    if (const auto refusal = refusalOfBytes(argc, argv)) {
        sayLine(u"pixelplumb-cli: "_s + *refusal);
        return int(ExitCode::Usage);
    }
    try {
        ExitCode code = run(QCoreApplication::arguments().sliced(1));
        // Unless a command has reported it.
        const auto error = finishPrinting();
        if (error && code != ExitCode::Usage) {
            sayLine(u"pixelplumb-cli: "_s + error->message());
            code = ExitCode::Usage;
        }
        return int(code);
    } catch (const std::bad_alloc &) {
        sayLine(u"pixelplumb-cli: this does not fit into memory"_s);
    } catch (const std::exception &exception) {
        sayLine(
            u"pixelplumb-cli: internal error: %1"_s.arg(QString::fromLocal8Bit(exception.what())));
    } catch (...) {
        sayLine(u"pixelplumb-cli: internal error"_s);
    }
    return int(ExitCode::Internal);
}
