// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/comparecontenders.h"

#include "app/cli/suggestion.h"
#include "core/compare/contest.h"
#include "core/scan/choicenames.h"

#include <QStringList>

namespace pixelplumb::cli {

namespace {

const QString methodsOption = QStringLiteral("--methods");
const QString truthWord = QStringLiteral("truth");

QStringList contenderNames()
{
    QStringList names = {truthWord};
    for (const Method &method : methods())
        names.append(method.id);
    return names;
}

/// Applies one word after the method's name to the settings.
std::optional<InputError> apply(const QString &place, const QString &word, Contender &contender)
{
    const std::string name = word.toStdString();
    if (const auto rule = fillRuleNamed(name)) {
        contender.settings.fillRule = *rule;
        return std::nullopt;
    }
    if (contender.isTruth())
        return unknownName(place, QStringLiteral("fill rule of the truth"), word,
                           namesOf(allFillRules));
    if (const auto arithmetic = arithmeticNamed(name)) {
        contender.settings.arithmetic = *arithmetic;
        return std::nullopt;
    }
    if (const auto variant = variantNamed(name)) {
        contender.settings.variants = contender.settings.variants.with(*variant);
        return std::nullopt;
    }
    return unknownName(place, QStringLiteral("arithmetic, fill rule or variant"), word,
                       namesOf(allArithmetics) + namesOf(allFillRules) + namesOf(allVariants));
}

} // namespace

Result<Contender> contenderNamed(const QString &place, const QString &entry,
                                 const ScanSettings &ofScene)
{
    const QStringList words = entry.trimmed().split(u':');
    Contender contender{nullptr, ofScene};
    if (words.front() != truthWord) {
        const Method *method = methodNamed(words.front());
        if (!method)
            return unknownName(place, QStringLiteral("method"), words.front(), contenderNames());
        contender = contenderFor(*method, ofScene);
    }
    for (const QString &word : words.sliced(1)) {
        if (const auto error = apply(place, word, contender))
            return *error;
    }
    if (!contender.isTruth()) {
        const QString refusal = contender.method->refusal(contender.settings);
        if (!refusal.isEmpty())
            return InputError{place, refusal, {}};
    }
    return contender;
}

Result<std::vector<Contender>> contendersNamed(const QString &list, const ScanSettings &ofScene)
{
    const QStringList entries = list.split(u',');
    const auto count = std::size_t(entries.size());
    if (count < fewestContenders || count > mostContenders)
        return InputError{methodsOption,
                          count == 1 ? QStringLiteral("1 contender")
                                     : QStringLiteral("%1 contenders").arg(count),
                          QStringLiteral("%1 to %2, separated by commas")
                              .arg(fewestContenders)
                              .arg(mostContenders)};
    std::vector<Contender> contenders;
    for (const QString &entry : entries) {
        const Result<Contender> contender = contenderNamed(methodsOption, entry, ofScene);
        if (!contender)
            return contender.error();
        contenders.push_back(*contender);
    }
    return contenders;
}

} // namespace pixelplumb::cli
