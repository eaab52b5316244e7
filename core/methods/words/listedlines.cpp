// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/words/listedlines.h"

#include "core/frame/framenames.h"
#include "core/scan/choicenames.h"

#include <QStringList>

#include <algorithm>

namespace pixelplumb {

namespace {

/// In frames of which origins a text stands, for each rule.
using Places = std::vector<std::vector<FrameOrigin>>;

QString originText(FrameOrigin origin) { return u"origin "_s + nameText(nameOf(origin)); }

QString whereText(const Places &places, const std::vector<FillRule> &rules)
{
    if (std::ranges::all_of(places, [&](const auto &origins) { return origins == places[0]; }))
        return places[0].size() == 1 ? originText(places[0].front()) : QString();
    QStringList text;
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const QString rule = nameText(nameOf(rules[i]));
        if (places[i].size() == allFrameOrigins.size())
            text.append(rule);
        else if (!places[i].empty())
            text.append(rule + u" with "_s + originText(places[i].front()));
    }
    return text.join(u", "_s);
}

} // namespace

std::vector<ListedLine> underRules(const Pseudocode &code, const std::vector<FillRule> &rules)
{
    std::vector<ListedLine> listed;
    for (const PseudocodeLine &line : code) {
        std::vector<QString> texts;
        std::vector<Places> places; // of each text
        for (std::size_t i = 0; i < rules.size(); ++i) {
            for (const FrameOrigin origin : allFrameOrigins) {
                for (const PseudocodeLine &ruled : underRule({line}, rules[i], origin)) {
                    const auto known
                        = std::size_t(std::ranges::find(texts, ruled.text) - texts.begin());
                    if (known == texts.size()) {
                        texts.push_back(ruled.text);
                        places.emplace_back(rules.size());
                    }
                    places[known][i].push_back(origin);
                }
            }
        }
        for (std::size_t i = 0; i < texts.size(); ++i) {
            listed.push_back({line, whereText(places[i], rules)});
            listed.back().line.text = texts[i];
        }
    }
    return listed;
}

} // namespace pixelplumb
