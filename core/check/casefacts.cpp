// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casefacts.h"

namespace pixelplumb {

QString numbersText(std::span<const std::int64_t> values)
{
    QStringList texts;
    for (const std::int64_t value : values)
        texts.append(QString::number(value));
    return texts.join(u' ');
}

void compare(QStringList &shortfalls, const QString &what, const QString &found,
             const QString &expected)
{
    if (found != expected)
        shortfalls.append(u"%1 %2 instead of %3"_s.arg(what, found, expected));
}

void compare(QStringList &shortfalls, const QString &what, std::int64_t found,
             std::optional<std::int64_t> expected)
{
    if (expected)
        compare(shortfalls, what, QString::number(found), QString::number(*expected));
}

void comparePicture(QStringList &shortfalls, const ExpectedFacts &facts, const CasePicture &picture)
{
    compare(shortfalls, "pixel count", picture.pixelCount(), facts.pixelCount);
    if (!facts.spanHash.isEmpty())
        compare(shortfalls, "span hash", QString::fromLatin1(picture.spanHash()),
                QString::fromLatin1(facts.spanHash));
    if (!facts.pixelHash.isEmpty())
        compare(shortfalls, "pixel hash", QString::fromLatin1(picture.pixelHash()),
                QString::fromLatin1(facts.pixelHash));
    if (!facts.colourHash.isEmpty())
        compare(shortfalls, "colour hash", QString::fromLatin1(picture.colourHash()),
                QString::fromLatin1(facts.colourHash));
    if (facts.channelSums)
        compare(shortfalls, "channel sums", numbersText(picture.channelSums()),
                numbersText(*facts.channelSums));
}

void addCoverage(CoverageTimes &times, const CasePicture &picture)
{
    picture.forEachWritten([&](std::int64_t x, std::int64_t y) { ++times[{x, y}]; });
}

std::map<int, std::int64_t> histogramOf(const CoverageTimes &times)
{
    std::map<int, std::int64_t> histogram;
    for (const auto &[pixel, count] : times)
        ++histogram[count];
    return histogram;
}

void compareHistogram(QStringList &shortfalls, const std::map<int, std::int64_t> &found,
                      const std::map<int, std::int64_t> &expected)
{
    const auto text = [](const std::map<int, std::int64_t> &histogram) {
        QStringList parts;
        for (const auto &[times, count] : histogram)
            parts.append(u"%1×%2"_s.arg(times).arg(count));
        return parts.isEmpty() ? u"nothing"_s : parts.join(u' ');
    };
    compare(shortfalls, "coverage (times×pixels)", text(found), text(expected));
}

} // namespace pixelplumb
