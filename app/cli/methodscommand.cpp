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

namespace pixelplumb::cli {

namespace {

/// The kinds of primitive the method draws: "triangle", …
QStringList kindsOf(const Method &method)
{
    QStringList kinds;
    for (const PrimitiveKind kind : method.kinds)
        kinds.append(nameOf(kind));
    return kinds;
}

void printNumbers(const QString &title, const std::vector<NumberDescription> &numbers)
{
    if (!numbers.empty())
        printLine(u"  numbers of %1"_s.arg(title));
    for (const NumberDescription &number : numbers) {
        const QString unit = number.unit.isEmpty() ? QString() : u", "_s + number.unit;
        printLine(u"    %1%2: %3"_s.arg(number.title, unit, number.toolTip));
    }
}

QJsonArray jsonOf(const std::vector<NumberDescription> &numbers)
{
    QJsonArray list;
    for (const NumberDescription &number : numbers)
        list.append(QJsonObject{{u"id"_s, number.id},
                                {u"title"_s, number.title},
                                {u"unit"_s, number.unit},
                                {u"meaning"_s, number.toolTip},
                                {u"formula"_s, number.formula}});
    return list;
}

/// The share of the set-up in the work for a small triangle, compared with the large one.
void printShares(const Method &method, Arithmetic arithmetic,
                 const std::vector<StandardExample> &examples)
{
    QStringList shares;
    for (const StandardExample &example : examples) {
        const auto counts = countOperations(method, arithmetic, example);
        shares.append(u"%1 % on %2"_s.arg(100 * counts->setUpShare(), 0, 'f', 1)
                          .arg(example.name.section(u" in "_s, 0, 0)));
    }
    printLine(u"    share of the set-up: %1"_s.arg(shares.join(u", "_s)));
}

void printOperations(const Method &method)
{
    if (!isCounted(method)) {
        printLine(u"  operations   %1"_s.arg(countingGap(method, method.arithmetics.front())));
        return;
    }
    const auto examples = standardExamplesFor(method);
    for (const Arithmetic arithmetic : method.arithmetics) {
        const auto counts = countOperations(method, arithmetic, examples.front());
        printLine(
            u"  operations in %1, %2"_s.arg(nameText(nameOf(arithmetic)), examples.front().name));
        printLine(u"    %1"_s.arg(countsText(*counts)));
        for (const QString &row : operationTableText(*counts))
            printLine(u"    %1"_s.arg(row));
        printShares(method, arithmetic, examples);
        if (const QString gap = countingGap(method, arithmetic); !gap.isEmpty())
            printLine(u"    %1"_s.arg(gap));
    }
}

QJsonObject jsonOf(const OperationCounts &counts)
{
    QJsonObject object{{u"set-ups"_s, qint64(counts.primitives)},
                       {u"spans"_s, qint64(counts.spans)},
                       {u"pixels"_s, qint64(counts.pixels)},
                       {u"refused"_s, qint64(counts.refused)}};
    for (const WorkStage stage : allWorkStages) {
        QJsonObject kinds;
        for (const Operation operation : allOperations)
            kinds.insert(nameText(nameOf(operation)), qint64(counts.of(stage, operation)));
        object.insert(nameText(nameOf(stage)), kinds);
    }
    if (counts.edgesOfRows > 0) {
        object.insert(u"edgesLookedAt"_s, qint64(counts.edgesLookedAt));
        object.insert(u"edgesOfRows"_s, qint64(counts.edgesOfRows));
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
            object.insert(u"example"_s, example.name);
            object.insert(u"arithmetic"_s, nameText(nameOf(arithmetic)));
            object.insert(u"gap"_s, countingGap(method, arithmetic));
            list.append(object);
        }
    }
    return list;
}

void printDescription(const Method &method)
{
    // "  arithmetics  exact, float32"; no line without names.
    const auto printNames = [](const QString &title, const QStringList &names) {
        if (!names.isEmpty())
            printLine(title + names.join(u", "_s));
    };
    printLine(u"%1: %2"_s.arg(method.id, method.title));
    printLine(u"  %1"_s.arg(method.summary));
    printNames(u"  draws        "_s, kindsOf(method));
    printLine(u"  source       %1"_s.arg(method.source));
    printNames(u"  arithmetics  "_s, namesOf(method.arithmetics));
    printNames(u"  true in      "_s, namesOf(method.stableArithmetics));
    printNames(u"  fill rules   "_s, namesOf(method.fillRules));
    if (!method.fillRuleReason.isEmpty())
        printLine(u"  no others:   because %1"_s.arg(method.fillRuleReason));
    printNames(u"  effects      "_s, namesOf(method.effects));
    printNames(u"  beyond colour and clipping in "_s, namesOf(method.shadingArithmetics));
    for (const Variant variant : method.variants) {
        const VariantWords &words = wordsOf(variant, method.spanAxis);
        printLine(u"  variant      %1: %2, in place of %3"_s.arg(
            nameText(nameOf(variant)), nameText(words.printed), nameText(words.right)));
        printLine(u"               %1 (%2)"_s.arg(nameText(words.fault), nameText(words.source)));
    }
    printNames(u"  remarks      "_s, method.remarks);
}

/// When a line is present: {"where": "closed", "of": "triangles without area"}; empty: always.
QJsonObject conditionsOf(const ListedLine &listed)
{
    const PseudocodeLine &line = listed.line;
    QJsonObject conditions;
    if (!listed.where.isEmpty())
        conditions.insert(u"where"_s, listed.where);
    if (line.effect)
        conditions.insert(u"effect"_s, nameText(nameOf(*line.effect)));
    if (!line.antialiasing.empty())
        conditions.insert(u"antialiasing"_s,
                          QJsonArray::fromStringList(namesOf(line.antialiasing)));
    if (line.of != LineOf::EveryPrimitive)
        conditions.insert(u"of"_s,
                          line.of == LineOf::Segment ? u"triangles without area"_s
                                                     : u"triangles with area"_s);
    return conditions;
}

QJsonArray jsonOf(const std::vector<ListedLine> &code)
{
    QJsonArray list;
    for (const ListedLine &listed : code) {
        QJsonObject object = conditionsOf(listed);
        object.insert(u"depth"_s, listed.line.depth);
        object.insert(u"text"_s, listed.line.text);
        list.append(object);
    }
    return list;
}

/// Prints the lines indented, each with its conditions: "   [closed; triangles without area]".
void printPseudocode(const QString &title, const std::vector<ListedLine> &code)
{
    if (code.empty())
        return;
    printLine(u"  %1"_s.arg(title));
    for (const ListedLine &listed : code) {
        const QJsonObject conditions = conditionsOf(listed);
        QStringList words;
        for (const QString &kind : {u"where"_s, u"effect"_s, u"antialiasing"_s, u"of"_s}) {
            if (const QJsonValue value = conditions.value(kind); value.isArray())
                words += kind + u' ' + value.toVariant().toStringList().join(u", "_s);
            else if (value.isString())
                words += value.toString();
        }
        const QString shown = words.isEmpty() ? QString() : u"   [%1]"_s.arg(words.join(u"; "_s));
        printLine(QString(4 + 4 * listed.line.depth, u' ') + listed.line.text + shown);
    }
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
    printLine(u"  known defects"_s);
    int shifts = 0;
    for (const Defect &defect : defectsOf(method)) {
        if (defect.id.startsWith("shifted-by-"_L1))
            ++shifts;
        else
            printLine(u"    %1  %2"_s.arg(defect.id, -28).arg(defect.forAssistant));
    }
    printLine(u"    %1  %2 more: the whole picture is shifted by some pixels."_s
                  .arg(u"shifted-by-…"_s, -28)
                  .arg(shifts));
}

/// The entry for a method in the list of methods.
QJsonObject methodJson(const Method &method)
{
    return {{u"id"_s, method.id},
            {u"family"_s, titleOf(method.family)},
            {u"draws"_s, QJsonArray::fromStringList(kindsOf(method))},
            {u"stable"_s, QJsonArray::fromStringList(namesOf(method.stableArithmetics))},
            {u"title"_s, method.title},
            {u"summary"_s, method.summary},
            {u"source"_s, method.source},
            {u"arithmetics"_s, QJsonArray::fromStringList(namesOf(method.arithmetics))},
            {u"fillRules"_s, QJsonArray::fromStringList(namesOf(method.fillRules))},
            {u"effects"_s, QJsonArray::fromStringList(namesOf(method.effects))},
            {u"variants"_s, QJsonArray::fromStringList(namesOf(method.variants))},
            {u"remarks"_s, QJsonArray::fromStringList(method.remarks)}};
}

void printWholeMethod(const Method &method)
{
    printDescription(method);
    printPseudocode(u"what it does"_s, underRules(method.pseudocode, method.fillRules));
    printPseudocode(u"with effects beyond colour"_s,
                    underRules(method.shadedPseudocode, method.fillRules));
    printNumbers(u"the set-up"_s, method.numbers.setUp);
    printNumbers(u"a span"_s, method.numbers.span);
    printNumbers(u"a sample"_s, method.numbers.sample);
    printOperations(method);
    printDefects(method);
}

QJsonObject wholeMethodJson(const Method &method)
{
    QJsonObject object = methodJson(method);
    object.insert(u"fillRuleReason"_s, method.fillRuleReason);
    object.insert(u"pseudocode"_s, jsonOf(underRules(method.pseudocode, method.fillRules)));
    object.insert(u"shadedPseudocode"_s,
                  jsonOf(underRules(method.shadedPseudocode, method.fillRules)));
    object.insert(u"setUpNumbers"_s, jsonOf(method.numbers.setUp));
    object.insert(u"spanNumbers"_s, jsonOf(method.numbers.span));
    object.insert(u"sampleNumbers"_s, jsonOf(method.numbers.sample));
    object.insert(u"operations"_s, operationsJson(method));
    QJsonArray defects;
    for (const Defect &defect : defectsOf(method))
        defects.append(QJsonObject{{u"id"_s, defect.id},
                                   {u"student"_s, defect.forStudent},
                                   {u"assistant"_s, defect.forAssistant}});
    object.insert(u"defects"_s, defects);
    return object;
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
        return ExitCode::Done;
    }
    QJsonArray list;
    std::vector<QStringList> rows;
    for (const Method &each : methods()) {
        list.append(methodJson(each));
        rows.push_back({each.id, u"%1 (%2)"_s.arg(each.title, kindsOf(each).join(u", "_s))});
    }
    line.asksForJson() ? printJson(list)
                       : printLines(alignedRows(rows, [](qsizetype) { return true; }));
    return ExitCode::Done;
}

} // namespace pixelplumb::cli
