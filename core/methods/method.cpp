// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"

#include "core/methods/columnscan.h"

#include <algorithm>

namespace pixelplumb {

namespace {

template <class Choice>
QString namesOf(const std::vector<Choice> &choices)
{
    QStringList names;
    for (const Choice choice : choices) {
        const std::string_view name = nameOf(choice);
        names.append(QString::fromUtf8(name.data(), qsizetype(name.size())));
    }
    return names.join(QStringLiteral(", "));
}

QString quoted(std::string_view name)
{
    return u'“' + QString::fromUtf8(name.data(), qsizetype(name.size())) + u'”';
}

} // namespace

bool Method::supports(Arithmetic arithmetic) const
{
    return std::ranges::find(arithmetics, arithmetic) != arithmetics.end();
}

bool Method::supports(FillRule rule) const
{
    return std::ranges::find(fillRules, rule) != fillRules.end();
}

QString Method::refusal(const ScanSettings &settings) const
{
    if (!supports(settings.arithmetic))
        return QStringLiteral("method “%1” does not compute in %2; it knows %3")
            .arg(id, quoted(nameOf(settings.arithmetic)), namesOf(arithmetics));
    if (!supports(settings.fillRule))
        return QStringLiteral("method “%1” cannot keep the fill rule %2; it keeps %3")
            .arg(id, quoted(nameOf(settings.fillRule)), namesOf(fillRules));
    return {};
}

std::span<const Method> methods()
{
    static const std::array<Method, 1> table = {columnScanMethod()};
    return table;
}

const Method *methodNamed(QStringView id)
{
    const auto found
        = std::ranges::find_if(methods(), [id](const Method &method) { return method.id == id; });
    return found != methods().end() ? &*found : nullptr;
}

} // namespace pixelplumb
