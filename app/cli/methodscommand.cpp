// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/options.h"

#include <QJsonArray>

namespace pixelplumb::cli {

namespace {

/// Prints the methods, one per line, aligned.
void printMethods()
{
    std::vector<QStringList> rows;
    for (const Method &method : methods())
        rows.push_back({method.id, u"%1 (%2)"_s.arg(method.title, kindsOf(method).join(u", "_s))});
    printLines(alignedRows(rows, [](qsizetype) { return true; }));
}

} // namespace

ExitCode listMethods(const Command &command, const QStringList &arguments)
{
    CommandLine line(
        command,
        {{u"NAME"_s,
          u"the method to describe: source, rules, effects, numbers, operations, known defects"_s,
          Positional::Presence::Optional}});
    line.addJsonOption();
    line.parse(arguments);
    if (const QString name = line.argument(0); !name.isEmpty()) {
        const Method *method = methodNamed(name);
        if (!method)
            refuseUnknown(u"NAME"_s, u"method"_s, name, methodIds());
        line.asksForJson() ? printJson(wholeMethodJson(*method)) : printWholeMethod(*method);
    } else if (line.asksForJson()) {
        QJsonArray list;
        for (const Method &each : methods())
            list.append(methodJson(each));
        printJson(list);
    } else {
        printMethods();
    }
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
