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
        {QStringLiteral("render"), QStringLiteral("Draw a scene to a picture or as text."), render},
        {QStringLiteral("trace"), QStringLiteral("Print the numbers that the drawing used."),
         trace},
        {QStringLiteral("pixel"), QStringLiteral("Tell what wrote a pixel, or what refuses it."),
         pixel},
        {QStringLiteral("methods"),
         QStringLiteral("List the methods of scan conversion, or describe one in full."),
         listMethods},
        {QStringLiteral("plan"), QStringLiteral("Tell which effects a scene calls for, and why."),
         plan},
        {QStringLiteral("check"), QStringLiteral("Run a file of hard cases."), check},
        {QStringLiteral("compare"), QStringLiteral("Tell where methods disagree, and why."),
         compare},
        {QStringLiteral("diff"), QStringLiteral("Tell how two pictures differ, and by what cause."),
         diff},
        {QStringLiteral("diagnose"),
         QStringLiteral("Name the defects whose pictures equal a student's."), diagnose},
        {QStringLiteral("try"),
         QStringLiteral("Run a student's program, and tell where it goes wrong."), tryProgram},
        {QStringLiteral("grade"), QStringLiteral("Grade a folder of submissions."), grade},
        {QStringLiteral("counterexample"),
         QStringLiteral("Find a small scene that two drawers draw differently."), counterExample},
        {QStringLiteral("invariants"),
         QStringLiteral("Check the properties that every right picture has."), invariants},
        {QStringLiteral("motion"), QStringLiteral("Count what flickers while a scene moves."),
         motion},
        {QStringLiteral("lab"), QStringLiteral("Measure what accuracy costs in time."), lab},
        {QStringLiteral("help"), QStringLiteral("Show this help, or a command's: help COMMAND."),
         help},
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
    QString text = QStringLiteral("Usage: %1 COMMAND [options] ARGUMENTS\n"
                                  "Draw, trace and measure triangle scan conversion.\n\n"
                                  "Commands:\n")
                       .arg(program);
    for (const Command &command : commands())
        text += QStringLiteral("  %1  %2\n").arg(command.name.leftJustified(14), command.summary);
    text += QStringLiteral(
        "\nOptions:\n"
        "  -h, --help     Show this help; after a command, the command's.\n"
        "  -v, --version  Show the version.\n\n"
        "Exit status: 0 done or same, 1 differs or falls short, 2 usage or unreadable "
        "input,\n3 sizes differ, 70 internal error.");
    return text;
}

ExitCode refuseWords(const QString &what)
{
    const QString program = QCoreApplication::applicationName();
    sayLine(QStringLiteral("%1: %2").arg(program, what));
    sayLine(QStringLiteral("Try “%1 --help”.").arg(program));
    return ExitCode::Usage;
}

ExitCode run(const QStringList &arguments)
{
    const InputRecord inputs;
    if (arguments.isEmpty())
        return refuseWords(QStringLiteral("a command is missing"));
    const QString &word = arguments.front();
    if (word == QStringLiteral("--help") || word == QStringLiteral("-h"))
        return help(*commandNamed(QStringLiteral("help")), arguments.sliced(1));
    if (word == QStringLiteral("--version") || word == QStringLiteral("-v")) {
        if (arguments.size() > 1)
            return refuseWords(
                QStringLiteral("%1: unexpected argument “%2”").arg(word, arguments[1]));
        printLine(QCoreApplication::applicationName() + u' '
                  + QCoreApplication::applicationVersion());
        return ExitCode::Done;
    }
    if (const Command *command = commandNamed(word))
        return endOf(word, [&] { return command->run(*command, arguments.sliced(1)); });
    if (word.startsWith(u'-')) {
        const QStringList options = {QStringLiteral("--help"), QStringLiteral("--version")};
        return refuseWords(QStringLiteral("unknown option %1").arg(word)
                           + suggestion(word, options));
    }
    return refuseWords(QStringLiteral("unknown command “%1”").arg(word)
                       + suggestion(word, commandNames()));
}

} // namespace

ExitCode help(const Command &command, const QStringList &arguments)
{
    const QString option = QStringLiteral("--help");
    const QString word = arguments.value(0, option);
    // `help help` adds nothing to the general help.
    if (word == command.name || word == option || word == QStringLiteral("-h")) {
        printLines(helpText().split(u'\n'));
        return ExitCode::Done;
    }
    if (arguments.size() > 1)
        return refuseWords(QStringLiteral("help: unexpected argument “%1”").arg(arguments[1]));
    const Command *explained = commandNamed(word);
    if (!explained)
        return refuseWords(QStringLiteral("help: unknown command “%1”").arg(word)
                           + suggestion(word, commandNames()));
    return endOf(explained->name, [&] { return explained->run(*explained, {option}); });
}

} // namespace pixelplumb::cli

int main(int argc, char *argv[])
{
    using pixelplumb::cli::ExitCode;
    using pixelplumb::cli::sayLine;

    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("pixelplumb-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(PIXELPLUMB_VERSION));
    // Image errors are reported by the commands, with the picture's name.
    QLoggingCategory::setFilterRules(QStringLiteral("qt.gui.imageio*=false"));
    if (const auto refusal = pixelplumb::cli::refusalOfBytes(argc, argv)) {
        sayLine(QStringLiteral("pixelplumb-cli: ") + *refusal);
        return int(ExitCode::Usage);
    }
    try {
        ExitCode code = pixelplumb::cli::run(QCoreApplication::arguments().sliced(1));
        // Unless a command has reported it.
        const auto error = pixelplumb::cli::finishPrinting();
        if (error && code != ExitCode::Usage) {
            sayLine(QStringLiteral("pixelplumb-cli: ") + error->message());
            code = ExitCode::Usage;
        }
        return int(code);
    } catch (const std::bad_alloc &) {
        sayLine(QStringLiteral("pixelplumb-cli: this does not fit into memory"));
    } catch (const std::exception &exception) {
        sayLine(QStringLiteral("pixelplumb-cli: internal error: %1")
                    .arg(QString::fromLocal8Bit(exception.what())));
    } catch (...) {
        sayLine(QStringLiteral("pixelplumb-cli: internal error"));
    }
    return int(ExitCode::Internal);
}
