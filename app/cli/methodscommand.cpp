// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "core/methods/method.h"
#include "core/scan/choicenames.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace pixelplumb::cli {

namespace {

QStringList kindsOf(const Method &method)
{
    QStringList kinds;
    for (const PrimitiveKind kind : method.kinds)
        kinds.append(nameOf(kind));
    return kinds;
}

QJsonObject jsonOf(const Method &method)
{
    return {
        {QStringLiteral("id"), method.id},
        {QStringLiteral("family"), titleOf(method.family)},
        {QStringLiteral("draws"), QJsonArray::fromStringList(kindsOf(method))},
        {QStringLiteral("stable"), QJsonArray::fromStringList(namesOf(method.stableArithmetics))},
        {QStringLiteral("title"), method.title},
        {QStringLiteral("summary"), method.summary},
        {QStringLiteral("source"), method.source},
        {QStringLiteral("arithmetics"), QJsonArray::fromStringList(namesOf(method.arithmetics))},
        {QStringLiteral("fillRules"), QJsonArray::fromStringList(namesOf(method.fillRules))},
        {QStringLiteral("effects"), QJsonArray::fromStringList(method.effects)}};
}

void printMethod(const Method &method)
{
    const QString separator = QStringLiteral(", ");
    printLine(QStringLiteral("%1: %2").arg(method.id, method.title));
    printLine(QStringLiteral("  %1").arg(method.summary));
    printLine(QStringLiteral("  draws        %1").arg(kindsOf(method).join(separator)));
    printLine(QStringLiteral("  source       %1").arg(method.source));
    printLine(QStringLiteral("  arithmetics  %1").arg(namesOf(method.arithmetics).join(separator)));
    if (!method.stableArithmetics.empty())
        printLine(QStringLiteral("  true in      %1")
                      .arg(namesOf(method.stableArithmetics).join(separator)));
    printLine(QStringLiteral("  fill rules   %1").arg(namesOf(method.fillRules).join(separator)));
    if (!method.fillRuleReason.isEmpty())
        printLine(QStringLiteral("  no others:   %1").arg(method.fillRuleReason));
    printLine(QStringLiteral("  effects      %1").arg(method.effects.join(separator)));
}

} // namespace

ExitCode listMethods(const Command &command, const QStringList &arguments)
{
    const QString jsonOption = QStringLiteral("json");
    CommandLine line(command, {});
    line.addOption({jsonOption, QStringLiteral("Print JSON.")});
    if (const auto ended = line.parse(arguments))
        return *ended;
    QJsonArray list;
    for (const Method &method : methods()) {
        if (line.isSet(jsonOption))
            list.append(jsonOf(method));
        else
            printMethod(method);
    }
    if (line.isSet(jsonOption))
        printLine(QString::fromUtf8(QJsonDocument(list).toJson().chopped(1)));
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
