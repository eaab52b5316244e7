// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/search/shortfallrecord.h"

namespace pixelplumb::search {

namespace {

QString text(std::string_view name)
{
    return QString::fromUtf8(name.data(), qsizetype(name.size()));
}

QString countsText(const Shortfall &shortfall)
{
    QStringList counts;
    const auto add = [&](const char *name, std::int64_t count) {
        if (count != 0)
            counts.append(QStringLiteral("\"%1\": %2").arg(QLatin1String(name)).arg(count));
    };
    add("missing", shortfall.missing);
    add("extra", shortfall.extra);
    add("wrong_bytes", shortfall.wrongBytes);
    add("clamped", shortfall.clamped);
    add("gaps", shortfall.gaps);
    add("overdraw", shortfall.overdraw);
    add("extra_toggles", shortfall.extraToggles);
    add("extra_pictures", shortfall.extraPictures);
    return counts.join(QStringLiteral(", "));
}

QString headingOf(const QString &fileName) { return QStringLiteral(" \"%1\": {").arg(fileName); }

} // namespace

QStringList recordLines(const HardCase &hardCase)
{
    QStringList lines;
    if (hardCase.triangles.empty())
        return lines;
    for (const Arithmetic arithmetic : allArithmetics) {
        for (const FillRule rule : {FillRule::Closed, FillRule::HalfOpenColumn}) {
            const Shortfall shortfall
                = measure(hardCase, {arithmetic, rule, ByteRounding::Nearest});
            if (!shortfall.isNone()) {
                lines.append(QStringLiteral("\"%1 %2 %3\": {%4}")
                                 .arg(hardCase.id, text(nameOf(arithmetic)), text(nameOf(rule)),
                                      countsText(shortfall)));
            }
        }
    }
    return lines;
}

QByteArray recordText(const std::vector<RecordedFile> &files)
{
    QStringList parts;
    for (const RecordedFile &file : files) {
        parts.append(headingOf(file.name) + QStringLiteral("\n  ")
                     + file.lines.join(QStringLiteral(",\n  ")) + QStringLiteral("\n }"));
    }
    return (QStringLiteral("{\n") + parts.join(QStringLiteral(",\n")) + QStringLiteral("\n}\n"))
        .toUtf8();
}

QStringList linesOf(const QByteArray &record, const QString &fileName)
{
    QStringList lines;
    bool inFile = false;
    for (const QByteArray &each : record.split('\n')) {
        const QString line = QString::fromUtf8(each);
        if (line.startsWith(QStringLiteral("  ")) && inFile)
            lines.append(line.endsWith(u',') ? line.mid(2).chopped(1) : line.mid(2));
        else
            inFile = line == headingOf(fileName);
    }
    return lines;
}

} // namespace pixelplumb::search
