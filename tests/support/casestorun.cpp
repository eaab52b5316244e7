// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/casestorun.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

constexpr const char *variable = "PIXELPLUMB_TEST_CASES";
constexpr std::size_t oneOf = 10;

constexpr std::size_t shareOf(std::size_t all) { return (all + oneOf - 1) / oneOf; }

QByteArray value() { return qEnvironmentVariable(variable, u"1"_s).toLatin1(); }

std::uint32_t seed()
{
    bool isNumber = false;
    const std::uint32_t seed = value().toUInt(&isNumber);
    if (!isNumber)
        qFatal("%s is “%s”; expected all, or a seed", variable, value().constData());
    return seed;
}

/// The generator of a group's own draw, independent of the other groups.
std::mt19937 randomFor(const QString &group)
{
    std::vector<std::uint32_t> words{seed()};
    for (const QChar character : group)
        words.push_back(character.unicode());
    std::seed_seq seeds(words.begin(), words.end());
    return std::mt19937(seeds);
}

} // namespace

bool areAllCasesRun() { return value() == "all"; }

std::vector<std::size_t> placesToRun(const std::vector<QString> &groups)
{
    std::map<QString, std::vector<std::size_t>> placesOf;
    for (std::size_t place = 0; place < groups.size(); ++place)
        placesOf[groups[place]].push_back(place);
    std::vector<std::size_t> run;
    for (auto &[group, places] : placesOf) {
        if (!areAllCasesRun()) {
            // Not std::shuffle, which draws differently in each library.
            std::mt19937 random = randomFor(group);
            for (std::size_t left = places.size(); left > 1; --left)
                std::swap(places[left - 1], places[random() % left]);
            places.resize(shareOf(places.size()));
        }
        run.insert(run.end(), places.begin(), places.end());
    }
    std::ranges::sort(run);
    qInfo("%s=%s: %zu of %zu cases", variable, value().constData(), run.size(), groups.size());
    return run;
}

void drawFewerRandomCases()
{
    if (areAllCasesRun() || qEnvironmentVariableIsSet("RC_PARAMS"))
        return;
    const QByteArray parameters = "max_success=10 seed=" + QByteArray::number(seed());
    qputenv("RC_PARAMS", parameters);
    qInfo("RC_PARAMS=\"%s\"", parameters.constData());
}

} // namespace pixelplumb
