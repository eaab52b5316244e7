// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/console.h"
#include "core/compare/contest.h"
#include "core/scan/choicenames.h"
#include "core/scene/scenefile.h"
#include "core/scene/text/colourtext.h"

#include <QJsonDocument>
#include <QProcess>
#include <QStringList>

#include <algorithm>

namespace pixelplumb::cli {

namespace {

const QString methodsPlace = u"--methods"_s;
const QString truthWord = u"truth"_s;

QStringList contenderNames() { return QStringList{truthWord} + methodIds(); }

/// Applies one word after the method's name to the settings.
void apply(const QString &place, const QString &word, Contender &contender)
{
    const std::string name = word.toStdString();
    if (const auto rule = fillRuleNamed(name)) {
        contender.settings.fillRule = *rule;
        return;
    }
    if (contender.isTruth())
        refuseUnknown(place, u"fill rule of the truth"_s, word, namesOf(allFillRules));
    if (const auto arithmetic = arithmeticNamed(name)) {
        contender.settings.arithmetic = *arithmetic;
        return;
    }
    if (const auto variant = variantNamed(name)) {
        contender.settings.variants = contender.settings.variants.with(*variant);
        return;
    }
    refuseUnknown(place, u"arithmetic, fill rule or variant"_s, word,
                  namesOf(allArithmetics) + namesOf(allFillRules) + namesOf(allVariants));
}

} // namespace

Contender contenderNamed(const QString &place, const QString &entry, const ScanSettings &ofScene)
{
    const QStringList words = entry.trimmed().split(u':');
    Contender contender{nullptr, ofScene};
    if (words.front() != truthWord) {
        const Method *method = methodNamed(words.front());
        if (!method)
            refuseUnknown(place, u"method"_s, words.front(), contenderNames());
        contender = contenderFor(*method, ofScene);
    }
    for (const QString &word : words.sliced(1))
        apply(place, word, contender);
    if (!contender.isTruth()) {
        const QString refusal = contender.method->refusal(contender.settings);
        if (!refusal.isEmpty())
            refuse({place, refusal, {}});
    }
    return contender;
}

std::vector<Contender> contendersNamed(const QString &list, const ScanSettings &ofScene)
{
    const QStringList entries = list.split(u',');
    const auto count = std::size_t(entries.size());
    if (count < fewestContenders || count > mostContenders)
        refuse({methodsPlace, count == 1 ? u"1 contender"_s : u"%1 contenders"_s.arg(count),
                u"%1 to %2, separated by commas"_s.arg(fewestContenders).arg(mostContenders)});
    std::vector<Contender> contenders;
    for (const QString &entry : entries)
        contenders.push_back(contenderNamed(methodsPlace, entry, ofScene));
    return contenders;
}

namespace {

constexpr QLatin1String programPrefix("program:");

bool namesContender(const QString &word)
{
    const QString first = word.section(u':', 0, 0);
    return first == truthWord || methodNamed(first) != nullptr;
}

/// The program in a word of the command line; `place` is for errors.
StudentProgram programNamed(const QString &place, const QString &word)
{
    const QStringList command = QProcess::splitCommand(word.sliced(programPrefix.size()));
    if (command.isEmpty())
        refuse({place, u"“%1” names no program"_s.arg(word),
                u"“program:COMMAND”: the program and its arguments, such as “program:python3 "
                "scan.py”"_s});
    return required(studentProgramOf(command));
}

/// The kinds a method draws: "circles and ellipses".
QString drawnText(const Method &method)
{
    QStringList kinds;
    for (const PrimitiveKind kind : method.kinds)
        kinds += nameOf(kind) + u's';
    return kinds.join(u" and "_s);
}

/// The kind of the primitives in random scenes.
PrimitiveKind searchedKind(const Method &method)
{
    return method.draws(PrimitiveKind::Triangle) ? PrimitiveKind::Triangle : PrimitiveKind::Line;
}

QString placeText(const LatticePoint &place)
{
    const auto number
        = [](Lattice coordinate) { return toText(Quantity::rational(coordinate, unitsPerPixel)); };
    return withMinus(u"(%1, %2)"_s.arg(number(place.x), number(place.y)));
}

/// Refuses a method of whose primitives there are no random scenes.
void refuseToSearch(const Method &method, const QString &place)
{
    if (method.draws(PrimitiveKind::Triangle) || method.draws(PrimitiveKind::Line))
        return;
    refuse({place,
            u"method “%1” draws %2, of which there are no random scenes"_s.arg(method.id,
                                                                               drawnText(method)),
            u"a method that draws triangles or lines"_s});
}

} // namespace

bool Sides::hasProgram() const { return std::ranges::any_of(sources, &PictureSource::isProgram); }

QStringList primitiveLines(const Scene &scene)
{
    QStringList lines;
    const auto add = [&](const QString &kind, std::span<const Vertex> vertices) {
        QStringList places;
        for (const Vertex &vertex : vertices)
            places += placeText(vertex.position) + u' ' + colourText(vertex.colour);
        lines += kind + u' ' + places.join(u", "_s);
    };
    for (const Triangle &triangle : scene.triangles)
        add(u"triangle"_s, triangle.vertices);
    for (const Shape &shape : scene.shapes)
        add(nameOf(shape.kind), shape.vertices);
    return lines;
}

QString undrawnText(const UndrawnScene &undrawn)
{
    return u"%1: %2: %3"_s.arg(primitiveLines(undrawn.scene).join(u"; "_s), undrawn.source,
                               undrawn.why.message());
}

QJsonObject undrawnJson(const UndrawnScene &undrawn)
{
    return {{u"scene"_s, QJsonDocument::fromJson(writeScene(undrawn.scene)).object()},
            {u"source"_s, undrawn.source},
            {u"why"_s, undrawn.why.message()}};
}

QString sideMeaning()
{
    return u"method[:arithmetic[:fill-rule[:variant...]]], truth[:fill-rule], a defect's name, as "
           "diagnose gives it, or “program:COMMAND”, as try runs it"_s;
}

Sides sidesOf(const CommandLine &line, const QStringList &places)
{
    const qsizetype count = places.size();
    const TrialTerms terms = chosenTerms(line);
    const bool hasProgram = std::ranges::any_of(
        line.arguments(), [](const QString &word) { return word.startsWith(programPrefix); });
    if (!hasProgram)
        refuseProgramOptions(line);
    Scene conventions = underOptions(line, {}, u"--method"_s);
    std::vector<std::optional<Contender>> contenders{std::size_t(count)};
    for (qsizetype i = 0; i < count; ++i) {
        const QString word = line.argument(i);
        if (!namesContender(word))
            continue;
        contenders[std::size_t(i)] = contenderNamed(places[i], word, conventions.settings);
    }
    // A named method also stands for the other side's, and must draw the kinds in question.
    Contender method = contenderFor(*methodNamed(QString::fromStdString(conventions.method)),
                                    conventions.settings);
    for (const auto &contender : contenders) {
        if (contender && !contender->isTruth()) {
            method = *contender;
            break;
        }
    }
    Sides sides;
    sides.conventions = sceneFor(conventions, method);
    sides.conventions.settings.variants = {};
    if (count == 1 && contenders[0]) // the truth has its own rule
        sides.conventions.settings.fillRule = contenders[0]->settings.fillRule;
    refuseToSearch(*method.method, places[0]);
    for (qsizetype i = 0; i < count; ++i) {
        const auto &contender = contenders[std::size_t(i)];
        if (contender && !contender->isTruth()
            && !contender->method->draws(searchedKind(*method.method)))
            refuse({places[i],
                    u"“%1” draws %2, “%3” draws %4"_s.arg(
                        contender->method->id, drawnText(*contender->method), method.method->id,
                        drawnText(*method.method)),
                    u"methods that draw the same primitives"_s});
    }
    for (qsizetype i = 0; i < count; ++i) {
        if (contenders[std::size_t(i)]) {
            sides.sources.push_back(sourceOf(*contenders[std::size_t(i)]));
            continue;
        }
        const QString word = line.argument(i);
        if (word.startsWith(programPrefix)) {
            sides.sources.push_back(sourceOf(programNamed(places[i], word), terms));
            sides.sources.back().name = word.sliced(programPrefix.size());
            continue;
        }
        QStringList ids;
        for (const Defect &defect : defectsUnder(sides.conventions))
            ids += defect.id;
        if (!ids.contains(word))
            refuseUnknownAmongMany(
                places[i], u"method, truth or defect"_s, word, ids + methodIds(),
                u"a method, truth, program:COMMAND or a defect that “methods %1” names"_s.arg(
                    method.method->id));
        sides.sources.push_back(sourceOf(word, method));
    }
    return sides;
}

} // namespace pixelplumb::cli
