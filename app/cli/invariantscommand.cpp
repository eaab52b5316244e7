// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "core/grade/hunt/allowance.h"
#include "core/grade/hunt/invariants.h"
#include "core/methods/method.h"
#include "core/scan/choicenames.h"
#include "core/scene/scenefile.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

/// Which invariants are broken, and which even with rounding allowed for.
struct Findings {
    std::vector<BrokenInvariant> broken;
    std::vector<BrokenInvariant> brokenBeyondRounding;
    Arithmetic tolerance = Arithmetic::Float32;

    bool mayBeRounding(Invariant invariant) const
    {
        return std::ranges::find(brokenBeyondRounding, invariant, &BrokenInvariant::invariant)
            == brokenBeyondRounding.end();
    }
};

QStringList invariantLines(const Findings &findings)
{
    QStringList lines;
    for (const Invariant invariant : allInvariants) {
        const auto found
            = std::ranges::find(findings.broken, invariant, &BrokenInvariant::invariant);
        const bool holds = found == findings.broken.end();
        lines += u"%1  %2: %3"_s.arg(holds ? u"holds "_s : u"broken"_s, nameOf(invariant),
                                     sentenceOf(invariant));
        if (!holds)
            lines += u"        "_s
                + QString::fromUtf8(QJsonDocument(QJsonDocument::fromJson(writeScene(found->scene))
                                                      .object()[u"primitives"_s]
                                                      .toArray())
                                        .toJson(QJsonDocument::Compact));
        if (!holds && findings.mayBeRounding(invariant))
            lines
                += u"        only on samples that lie on an edge or that the rounding of %1 leaves "
                   "open: another fill rule or rounding does it, too"_s.arg(
                       nameText(nameOf(findings.tolerance)));
    }
    return lines;
}

QJsonObject invariantsJson(const InvariantReport &report, const Findings &findings)
{
    QJsonArray array;
    for (const BrokenInvariant &each : findings.broken)
        array.append(
            QJsonObject{{u"invariant"_s, nameOf(each.invariant)},
                        {u"mayBeRounding"_s, findings.mayBeRounding(each.invariant)},
                        {u"scene"_s, QJsonDocument::fromJson(writeScene(each.scene)).object()}});
    QJsonObject object{{u"checked"_s, qint64(report.checked)},
                       {u"undrawn"_s, qint64(report.undrawn)},
                       {u"broken"_s, array}};
    if (report.firstUndrawn)
        object.insert(u"firstUndrawn"_s, undrawnJson(*report.firstUndrawn));
    return object;
}

} // namespace

ExitCode invariants(const Command &command, const QStringList &arguments)
{
    const QString place = u"DRAWER"_s;
    CommandLine line(command, {{place, sideMeaning()}});
    addSeedOption(line, u"triangles"_s);
    line.addJsonOption();
    addToleranceOption(line);
    addProgramOptions(line);
    addSettingOptions(line);
    line.parse(arguments);
    const auto seed = chosenSeed(line);
    const Margin margin{Leeway::Edges, chosenTolerance(line)}; // invariants hold under every rule
    const Sides sides = sidesOf(line, {place});
    if (!methodNamed(QString::fromStdString(sides.conventions.method))
             ->draws(PrimitiveKind::Triangle))
        refuse(InputError{place, u"draws lines"_s, u"a method that draws triangles"_s});
    constexpr int pairs = 60;
    const PictureSource &source = sides.sources.front();
    const InvariantReport report = checkInvariants(source, sides.conventions, seed, pairs);
    if (report.undrawn > 0)
        sayLine(u"%1 could not draw all of %2 of %3 pairs of triangles; the first: %4"_s.arg(
            source.name, QString::number(report.undrawn),
            QString::number(report.checked + report.undrawn), undrawnText(*report.firstUndrawn)));
    const QStringList confinement = sides.hasProgram() ? confinementLines() : QStringList();
    if (report.checked == 0 && !line.asksForJson()) {
        for (const QString &each : confinement)
            sayLine(each);
        return ExitCode::FallsShort;
    }
    Findings findings{report.broken, {}, margin.tolerance};
    if (!report.broken.empty())
        findings.brokenBeyondRounding
            = checkInvariants(allowingFor(margin, source), sides.conventions, seed, pairs).broken;
    if (line.asksForJson()) {
        QJsonObject object = invariantsJson(report, findings);
        if (sides.hasProgram())
            addConfinement(object);
        printJson(object);
    } else {
        printLines(invariantLines(findings) + confinement);
    }
    return report.broken.empty() && report.undrawn == 0 ? ExitCode::Done : ExitCode::FallsShort;
}

} // namespace pixelplumb::cli
