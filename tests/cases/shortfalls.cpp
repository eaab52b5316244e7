// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cases/shortfalls.h"

#include "core/check/casecheck.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <set>

namespace pixelplumb::shortfalls {

namespace {

/// The key of the record's first member, which is not a case file.
const QString aboutKey = u"about"_s;
const QString aboutText
    = u"By case and shortfall: every method, arithmetic and fill rule that is not claimed stable "
      u"and "
      "falls short; counts are pixels, summed over triangles, frames or places. tests_project "
      "shortfalls writes this file."_s;

QString countsText(const Counts &shortfall)
{
    QStringList counts;
    const auto add = [&](std::int64_t count, const char *what) {
        if (count != 0)
            counts.append(u"%1 %2"_s.arg(count).arg(QLatin1String(what)));
    };
    add(shortfall.missing, "missing");
    add(shortfall.extra, "extra");
    add(shortfall.wrongBytes, "in another colour");
    add(shortfall.gaps, "gaps");
    add(shortfall.overdraw, "overdrawn");
    add(std::max<std::int64_t>(0, shortfall.extraToggles), "toggles too many");
    add(std::max<std::int64_t>(0, -shortfall.extraToggles), "toggles too few");
    add(shortfall.extraPictures, "pictures too many");
    return counts.join(u", "_s);
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
    return texts.join(u", "_s);
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

std::int64_t togglesBetween(const std::vector<QRgb> &before, const std::vector<QRgb> &after)
{
    std::int64_t toggles = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
        toggles += (before[i] != 0) != (after[i] != 0) ? 1 : 0;
    return toggles;
}

std::vector<int> coverageOf(const Pictures &pictures)
{
    std::vector<int> times(pictures.front().size());
    for (const std::vector<QRgb> &picture : pictures) {
        for (std::size_t i = 0; i < times.size(); ++i)
            times[i] += picture[i] != 0 ? 1 : 0;
    }
    return times;
}

} // namespace

Pictures picturesOf(const HardCase &hardCase, const ScanSettings &settings, const Drawing &drawing)
{
    Pictures pictures;
    const auto draw = [&](const Triangle &triangle, const FrameSpec &canvas) {
        CasePicture picture(canvas, settings.fillRule);
        picture.draw(triangle, settings, drawing);
        std::vector<QRgb> &pixels
            = pictures.emplace_back(std::size_t(canvas.width) * std::size_t(canvas.height), 0U);
        picture.forEachWritten([&](std::int64_t x, std::int64_t y) {
            pixels[std::size_t((y - canvas.firstRow) * canvas.width + x - canvas.firstColumn)]
                = packed(picture.colourAt(x, y));
        });
    };
    if (hardCase.kind != HardCaseKind::Translation) {
        for (const Triangle &triangle : hardCase.triangles)
            draw(triangle, hardCase.canvas);
        return pictures;
    }
    for (const auto &[right, up] : hardCase.offsets) {
        Triangle triangle = hardCase.triangles.front();
        for (Vertex &vertex : triangle.vertices) {
            vertex.position.x += right * unitsPerPixel;
            vertex.position.y += up * unitsPerPixel;
        }
        FrameSpec canvas = hardCase.canvas;
        canvas.firstColumn += std::int32_t(right);
        canvas.firstRow += std::int32_t(up);
        draw(triangle, canvas);
    }
    return pictures;
}

Counts countsOf(const HardCase &hardCase, const Pictures &drawn, const Pictures &truth)
{
    Counts counts;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        for (std::size_t k = 0; k < drawn[i].size(); ++k) {
            const QRgb pixel = drawn[i][k], expected = truth[i][k];
            counts.missing += pixel == 0 && expected != 0 ? 1 : 0;
            counts.extra += pixel != 0 && expected == 0 ? 1 : 0;
            counts.wrongBytes += pixel != 0 && expected != 0 && pixel != expected ? 1 : 0;
        }
        if (hardCase.kind == HardCaseKind::Sequence && i > 0)
            counts.extraToggles
                += togglesBetween(drawn[i - 1], drawn[i]) - togglesBetween(truth[i - 1], truth[i]);
    }
    if (hardCase.kind == HardCaseKind::Mesh) {
        const std::vector<int> times = coverageOf(drawn), trueTimes = coverageOf(truth);
        for (std::size_t i = 0; i < times.size(); ++i) {
            counts.gaps += times[i] == 0 && trueTimes[i] > 0 ? 1 : 0;
            counts.overdraw += std::max(0, times[i] - trueTimes[i]);
        }
    }
    if (hardCase.kind == HardCaseKind::Translation)
        counts.extraPictures = std::int64_t(std::set(drawn.begin(), drawn.end()).size()) - 1;
    return counts;
}

CaseRecord shortfallsOf(const HardCase &hardCase, QStringView methodId)
{
    CaseRecord record;
    for (const auto &[rule, facts] : hardCase.facts) {
        const Pictures truth
            = picturesOf(hardCase, {Arithmetic::Exact, rule, ByteRounding::Nearest}, drawTruly);
        for (const Contender &contender : contendersFor(hardCase, rule, methodId)) {
            const QString text = hardCase.triangles.empty()
                ? shapeText(hardCase, contender)
                : countsText(countsOf(hardCase,
                                      picturesOf(hardCase, contender.settings,
                                                 drawingBy(*contender.method, Kernels::Plain)),
                                      truth));
            if (!text.isEmpty())
                record[text].append(contender.name());
        }
    }
    for (auto &[text, contenders] : record)
        contenders.sort();
    return record;
}

QByteArray textOf(const Record &record)
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

Record readRecord(const QByteArray &text)
{
    Record record;
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
                lines.append(id + u": "_s + contender + u": "_s + what);
        }
    }
    lines.sort();
    return lines;
}

} // namespace pixelplumb::shortfalls
