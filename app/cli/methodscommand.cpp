// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/methodreport.h"
#include "app/cli/suggestion.h"

#include <QJsonArray>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

/// Prints the methods, one per line, aligned.
void printMethods()
{
    qsizetype widest = 0;
    for (const Method &method : methods())
        widest = std::max(widest, method.id.size());
    for (const Method &method : methods()) {
        printLine(QStringLiteral("%1  %2 (%3)")
                      .arg(method.id.leftJustified(widest), method.title,
                           kindsOf(method).join(QStringLiteral(", "))));
    }
}

QStringList methodNames()
{
    QStringList names;
    for (const Method &method : methods())
        names.append(method.id);
    return names;
}

} // namespace

ExitCode listMethods(const Command &command, const QStringList &arguments)
{
    const QString jsonOption = QStringLiteral("json");
    CommandLine line(
        command,
        {{QStringLiteral("NAME"),
          QStringLiteral("the method to describe: source, rules, effects, numbers, operations, "
                         "known defects"),
          Positional::Presence::Optional}});
    line.addOption({jsonOption, QStringLiteral("Print JSON.")});
    if (const auto ended = line.parse(arguments))
        return *ended;
    if (const QString name = line.argument(0); !name.isEmpty()) {
        const Method *method = methodNamed(name);
        if (!method)
            return line.refuse(
                unknownName(QStringLiteral("NAME"), QStringLiteral("method"), name, methodNames()));
        if (line.isSet(jsonOption))
            printJson(QJsonDocument(jsonOfWhole(*method)));
        else
            printWholeMethod(*method);
        return ExitCode::Done;
    }
    if (!line.isSet(jsonOption)) {
        printMethods();
        return ExitCode::Done;
    }
    QJsonArray list;
    for (const Method &method : methods())
        list.append(jsonOf(method));
    printJson(QJsonDocument(list));
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
