// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/search/shortfallrecord.h"

#include "core/check/casecheck.h"
#include "tests/search/measure.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace pixelplumb::search {

namespace {

/// The key of the record's first member, which is not a case file.
const QString aboutKey = QStringLiteral("about");
const QString aboutText = QStringLiteral(
    "By case and shortfall: every method, arithmetic and fill rule that is not claimed stable and "
    "falls short; counts are pixels, summed over triangles, frames or places. recordshortfalls "
    "writes this file.");

QString countsText(const Shortfall &shortfall)
{
    QStringList counts;
    const auto add = [&](std::int64_t count, const char *what) {
        if (count != 0)
            counts.append(QStringLiteral("%1 %2").arg(count).arg(QLatin1String(what)));
    };
    add(shortfall.missing, "missing");
    add(shortfall.extra, "extra");
    add(shortfall.wrongBytes, "in another colour");
    add(shortfall.gaps, "gaps");
    add(shortfall.overdraw, "overdrawn");
    add(std::max<std::int64_t>(0, shortfall.extraToggles), "toggles too many");
    add(std::max<std::int64_t>(0, -shortfall.extraToggles), "toggles too few");
    add(shortfall.extraPictures, "pictures too many");
    return counts.join(QStringLiteral(", "));
}

/// What the facts of a case of lines or other shapes say first: how many pixels differ. For a line,
/// also those of its reverse.
QString shapeText(const HardCase &hardCase, const Contender &contender)
{
    const CaseReport report = checkCase(hardCase, {contender});
    QStringList texts;
    for (const ContenderVerdict &verdict : report.verdicts) {
        if (verdict.outcome != CaseOutcome::FellShort)
            continue;
        const auto isOfReverse
            = [](const QString &remark) { return remark.startsWith(QLatin1String("reversed: ")); };
        const auto reverse = std::ranges::find_if(verdict.remarks, isOfReverse);
        if (reverse != verdict.remarks.begin())
            texts.append(verdict.remarks.front());
        if (reverse != verdict.remarks.end())
            texts.append(*reverse);
    }
    return texts.join(QStringLiteral(", "));
}

bool draws(const Method &method, const HardCase &hardCase)
{
    return hardCase.shapes.empty() ? method.draws(PrimitiveKind::Triangle)
                                   : method.draws(hardCase.shapes.front());
}

std::vector<Contender> contendersFor(const HardCase &hardCase, FillRule rule, QStringView methodId)
{
    std::vector<Contender> contenders;
    for (const Method &method : methods()) {
        if (!draws(method, hardCase) || !method.supports(rule))
            continue;
        if (!methodId.isEmpty() && method.id != methodId)
            continue;
        for (const Arithmetic arithmetic : method.arithmetics) {
            if (!method.isStableIn(arithmetic))
                contenders.push_back({&method, {arithmetic, rule, ByteRounding::Nearest}});
        }
    }
    return contenders;
}

QByteArray jsonString(const QString &text)
{
    // The text of an array of this single string, without the brackets.
    return QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact).chopped(1).mid(1);
}

} // namespace

CaseRecord shortfallsOf(const HardCase &hardCase, QStringView methodId)
{
    CaseRecord record;
    for (const auto &[rule, facts] : hardCase.facts) {
        const CaseTruth truth(hardCase, rule);
        for (const Contender &contender : contendersFor(hardCase, rule, methodId)) {
            const QString text = hardCase.triangles.empty()
                ? shapeText(hardCase, contender)
                : countsText(truth.shortfallOf(drawingBy(*contender.method, Kernels::Plain),
                                               contender.settings));
            if (!text.isEmpty())
                record[text].append(contender.name());
        }
    }
    for (auto &[text, contenders] : record)
        contenders.sort();
    return record;
}

QByteArray textOf(const ShortfallRecord &record)
{
    QByteArray text = "{\n" + jsonString(aboutKey) + ": " + jsonString(aboutText);
    for (const auto &[file, cases] : record) {
        text += ",\n" + jsonString(file) + ": {";
        QByteArray betweenCases = "\n";
        for (const auto &[id, shortfalls] : cases) {
            if (shortfalls.empty())
                continue;
            text += betweenCases + " " + jsonString(id) + ": {";
            betweenCases = ",\n";
            QByteArray between = "\n";
            for (const auto &[what, contenders] : shortfalls) {
                text += between + "  " + jsonString(what) + ": "
                    + QJsonDocument(QJsonArray::fromStringList(contenders))
                          .toJson(QJsonDocument::Compact);
                between = ",\n";
            }
            text += "}";
        }
        text += "}";
    }
    return text + "\n}\n";
}

ShortfallRecord readRecord(const QByteArray &text)
{
    ShortfallRecord record;
    const QJsonObject files = QJsonDocument::fromJson(text).object();
    for (const QString &file : files.keys()) {
        const QJsonObject cases = files[file].toObject();
        for (const QString &id : cases.keys()) {
            const QJsonObject shortfalls = cases[id].toObject();
            for (const QString &what : shortfalls.keys())
                record[file][id][what] = shortfalls[what].toVariant().toStringList();
        }
    }
    return record;
}

QStringList linesOf(const FileRecord &file)
{
    QStringList lines;
    for (const auto &[id, shortfalls] : file) {
        for (const auto &[what, contenders] : shortfalls) {
            for (const QString &contender : contenders)
                lines.append(id + QStringLiteral(": ") + contender + QStringLiteral(": ") + what);
        }
    }
    lines.sort();
    return lines;
}

} // namespace pixelplumb::search
