// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "core/grade/bugs/defect.h"
#include "core/lab/counting/operationtable.h"
#include "core/lab/counting/standardexamples.h"
#include "core/methods/method.h"
#include "core/methods/words/listedlines.h"
#include "core/scan/choicenames.h"
#include "core/scene/appearancenames.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

void printNumbers(const QString &title, const std::vector<NumberDescription> &numbers)
{
    if (numbers.empty())
        return;
    printLine(QStringLiteral("  numbers of %1").arg(title));
    for (const NumberDescription &number : numbers) {
        const QString unit = number.unit.isEmpty() ? QString() : QStringLiteral(", ") + number.unit;
        printLine(QStringLiteral("    %1%2: %3").arg(number.title, unit, number.toolTip));
    }
}

QJsonArray jsonOf(const std::vector<NumberDescription> &numbers)
{
    QJsonArray list;
    for (const NumberDescription &number : numbers)
        list.append(QJsonObject{{QStringLiteral("id"), number.id},
                                {QStringLiteral("title"), number.title},
                                {QStringLiteral("unit"), number.unit},
                                {QStringLiteral("meaning"), number.toolTip},
                                {QStringLiteral("formula"), number.formula}});
    return list;
}

/// The share of the set-up in the work for a small triangle, compared with the large one.
void printShares(const Method &method, Arithmetic arithmetic,
                 const std::vector<StandardExample> &examples)
{
    QStringList shares;
    for (const StandardExample &example : examples) {
        const auto counts = countOperations(method, arithmetic, example);
        shares.append(QStringLiteral("%1 % on %2")
                          .arg(100 * counts->setUpShare(), 0, 'f', 1)
                          .arg(example.name.section(QStringLiteral(" in "), 0, 0)));
    }
    printLine(QStringLiteral("    share of the set-up: %1").arg(shares.join(QStringLiteral(", "))));
}

void printOperations(const Method &method)
{
    if (!isCounted(method)) {
        printLine(QStringLiteral("  operations   %1")
                      .arg(countingGap(method, method.arithmetics.front())));
        return;
    }
    const std::vector<StandardExample> examples = standardExamplesFor(method);
    for (const Arithmetic arithmetic : method.arithmetics) {
        const auto counts = countOperations(method, arithmetic, examples.front());
        printLine(QStringLiteral("  operations in %1, %2")
                      .arg(nameText(nameOf(arithmetic)), examples.front().name));
        printLine(QStringLiteral("    %1").arg(countsText(*counts)));
        for (const QString &row : operationTableText(*counts))
            printLine(QStringLiteral("    %1").arg(row));
        printShares(method, arithmetic, examples);
        if (const QString gap = countingGap(method, arithmetic); !gap.isEmpty())
            printLine(QStringLiteral("    %1").arg(gap));
    }
}

QJsonObject jsonOf(const OperationCounts &counts)
{
    QJsonObject object{{QStringLiteral("set-ups"), qint64(counts.primitives)},
                       {QStringLiteral("spans"), qint64(counts.spans)},
                       {QStringLiteral("pixels"), qint64(counts.pixels)},
                       {QStringLiteral("refused"), qint64(counts.refused)}};
    for (const WorkStage stage : allWorkStages) {
        QJsonObject kinds;
        for (const Operation operation : allOperations)
            kinds.insert(nameText(nameOf(operation)), qint64(counts.of(stage, operation)));
        object.insert(nameText(nameOf(stage)), kinds);
    }
    if (counts.edgesOfRows > 0) {
        object.insert(QStringLiteral("edgesLookedAt"), qint64(counts.edgesLookedAt));
        object.insert(QStringLiteral("edgesOfRows"), qint64(counts.edgesOfRows));
    }
    return object;
}

QJsonArray operationsJson(const Method &method)
{
    QJsonArray list;
    for (const StandardExample &example : standardExamplesFor(method)) {
        for (const Arithmetic arithmetic : method.arithmetics) {
            const auto counts = countOperations(method, arithmetic, example);
            if (!counts)
                continue;
            QJsonObject object = jsonOf(*counts);
            object.insert(QStringLiteral("example"), example.name);
            object.insert(QStringLiteral("arithmetic"), nameText(nameOf(arithmetic)));
            object.insert(QStringLiteral("gap"), countingGap(method, arithmetic));
            list.append(object);
        }
    }
    return list;
}

/// A line of the description: "  arithmetics  exact, float32"; none without names.
void printNames(const QString &title, const QStringList &names)
{
    if (!names.isEmpty())
        printLine(title + names.join(QStringLiteral(", ")));
}

void printDescription(const Method &method)
{
    printLine(QStringLiteral("%1: %2").arg(method.id, method.title));
    printLine(QStringLiteral("  %1").arg(method.summary));
    printNames(QStringLiteral("  draws        "), kindsOf(method));
    printLine(QStringLiteral("  source       %1").arg(method.source));
    printNames(QStringLiteral("  arithmetics  "), namesOf(method.arithmetics));
    printNames(QStringLiteral("  true in      "), namesOf(method.stableArithmetics));
    printNames(QStringLiteral("  fill rules   "), namesOf(method.fillRules));
    if (!method.fillRuleReason.isEmpty())
        printLine(QStringLiteral("  no others:   because %1").arg(method.fillRuleReason));
    printNames(QStringLiteral("  effects      "), namesOf(method.effects));
    printNames(QStringLiteral("  beyond colour and clipping in "),
               namesOf(method.shadingArithmetics));
    for (const Variant variant : method.variants) {
        const VariantWords &words = wordsOf(variant, method.spanAxis);
        printLine(
            QStringLiteral("  variant      %1: %2, in place of %3")
                .arg(nameText(nameOf(variant)), nameText(words.printed), nameText(words.right)));
        printLine(QStringLiteral("               %1 (%2)")
                      .arg(nameText(words.fault), nameText(words.source)));
    }
    printNames(QStringLiteral("  remarks      "), method.remarks);
}

QString areaText(const PseudocodeLine &line)
{
    return line.of == LineOf::Segment ? QStringLiteral("triangles without area")
                                      : QStringLiteral("triangles with area");
}

/// When a line is present: "   [closed; triangles without area]".
QString conditionText(const ListedLine &listed)
{
    const PseudocodeLine &line = listed.line;
    QStringList conditions;
    if (!listed.where.isEmpty())
        conditions.append(listed.where);
    if (line.effect)
        conditions.append(nameText(nameOf(*line.effect)));
    if (!line.antialiasing.empty())
        conditions.append(QStringLiteral("antialiasing ")
                          + namesOf(line.antialiasing).join(QStringLiteral(", ")));
    if (line.of != LineOf::EveryPrimitive)
        conditions.append(areaText(line));
    return conditions.empty()
        ? QString()
        : QStringLiteral("   [%1]").arg(conditions.join(QStringLiteral("; ")));
}

QJsonArray jsonOf(const std::vector<ListedLine> &code)
{
    QJsonArray list;
    for (const auto &[line, where] : code) {
        QJsonObject object{{QStringLiteral("depth"), line.depth},
                           {QStringLiteral("text"), line.text}};
        if (!where.isEmpty())
            object.insert(QStringLiteral("where"), where);
        if (line.effect)
            object.insert(QStringLiteral("effect"), nameText(nameOf(*line.effect)));
        if (!line.antialiasing.empty())
            object.insert(QStringLiteral("antialiasing"),
                          QJsonArray::fromStringList(namesOf(line.antialiasing)));
        if (line.of != LineOf::EveryPrimitive)
            object.insert(QStringLiteral("of"), areaText(line));
        list.append(object);
    }
    return list;
}

/// Prints the lines indented, each with its condition.
void printPseudocode(const QString &title, const std::vector<ListedLine> &code)
{
    if (code.empty())
        return;
    printLine(QStringLiteral("  %1").arg(title));
    for (const ListedLine &listed : code)
        printLine(QString(4 + 4 * listed.line.depth, u' ') + listed.line.text
                  + conditionText(listed));
}

/// Under the conventions that a scene has if it names none.
std::vector<Defect> defectsOf(const Method &method)
{
    Scene conventions;
    conventions.method = method.id.toStdString();
    conventions.settings = method.adapted(conventions.settings);
    return defectsUnder(conventions);
}

void printDefects(const Method &method)
{
    printLine(QStringLiteral("  known defects"));
    int shifts = 0;
    for (const Defect &defect : defectsOf(method)) {
        if (defect.id.startsWith(QLatin1String("shifted-by-")))
            ++shifts;
        else
            printLine(QStringLiteral("    %1  %2").arg(defect.id, -28).arg(defect.forAssistant));
    }
    printLine(QStringLiteral("    %1  %2 more: the whole picture is shifted by some pixels.")
                  .arg(QStringLiteral("shifted-by-…"), -28)
                  .arg(shifts));
}

QJsonArray defectsJson(const Method &method)
{
    QJsonArray array;
    for (const Defect &defect : defectsOf(method))
        array.append(QJsonObject{{QStringLiteral("id"), defect.id},
                                 {QStringLiteral("student"), defect.forStudent},
                                 {QStringLiteral("assistant"), defect.forAssistant}});
    return array;
}

} // namespace

QStringList kindsOf(const Method &method)
{
    QStringList kinds;
    for (const PrimitiveKind kind : method.kinds)
        kinds.append(nameOf(kind));
    return kinds;
}

QJsonObject methodJson(const Method &method)
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
        {QStringLiteral("effects"), QJsonArray::fromStringList(namesOf(method.effects))},
        {QStringLiteral("variants"), QJsonArray::fromStringList(namesOf(method.variants))},
        {QStringLiteral("remarks"), QJsonArray::fromStringList(method.remarks)}};
}

void printWholeMethod(const Method &method)
{
    printDescription(method);
    printPseudocode(QStringLiteral("what it does"),
                    underRules(method.pseudocode, method.fillRules));
    printPseudocode(QStringLiteral("with effects beyond colour"),
                    underRules(method.shadedPseudocode, method.fillRules));
    printNumbers(QStringLiteral("the set-up"), method.numbers.setUp);
    printNumbers(QStringLiteral("a span"), method.numbers.span);
    printNumbers(QStringLiteral("a sample"), method.numbers.sample);
    printOperations(method);
    printDefects(method);
}

QJsonObject wholeMethodJson(const Method &method)
{
    QJsonObject object = methodJson(method);
    object.insert(QStringLiteral("fillRuleReason"), method.fillRuleReason);
    object.insert(QStringLiteral("pseudocode"),
                  jsonOf(underRules(method.pseudocode, method.fillRules)));
    object.insert(QStringLiteral("shadedPseudocode"),
                  jsonOf(underRules(method.shadedPseudocode, method.fillRules)));
    object.insert(QStringLiteral("setUpNumbers"), jsonOf(method.numbers.setUp));
    object.insert(QStringLiteral("spanNumbers"), jsonOf(method.numbers.span));
    object.insert(QStringLiteral("sampleNumbers"), jsonOf(method.numbers.sample));
    object.insert(QStringLiteral("operations"), operationsJson(method));
    object.insert(QStringLiteral("defects"), defectsJson(method));
    return object;
}

} // namespace pixelplumb::cli
