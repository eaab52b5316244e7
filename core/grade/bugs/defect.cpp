// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/defect.h"

#include "core/grade/bugs/leveldefect.h"
#include "core/grade/bugs/linedefect.h"
#include "core/grade/bugs/scenedefect.h"
#include "core/grade/bugs/shapedefect.h"
#include "core/grade/bugs/spandefect.h"
#include "core/grade/bugs/walkdefect.h"
#include "core/grade/pictures/picturecause.h"
#include "core/grade/rounding/linechoice.h"
#include "core/grade/scan/programline.h"
#include "core/grade/scan/redrawing.h"
#include "core/scan/choicenames.h"

#include <QHash>

#include <algorithm>
#include <array>

namespace pixelplumb {

namespace {

void appendVariants(std::vector<Defect> &defects, const Scene &scene)
{
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    for (const Variant variant : allVariants) {
        Defect defect{nameText(nameOf(variant)), nameText(wordsOf(variant, method.spanAxis).fault),
                      sentenceOf(variant, method.spanAxis), [variant](Scene &changed) {
                          changed.settings.variants = changed.settings.variants.with(variant);
                          return true;
                      }};
        if (variant == Variant::StayAtZero && drawsNearestPixels(scene)) {
            defect.forAssistant += u" Both pixels are equally near: that alone is no mistake."_s;
            defect.isRightAlone = true;
        }
        appendWhereItApplies(defects, scene, {}, std::move(defect));
    }
}

void appendSettings(std::vector<Defect> &defects, const Scene &scene)
{
    for (const FillRule rule : allFillRules)
        appendWhereItApplies(
            defects, scene, QLatin1String(ruleChoice),
            {u"rule-"_s + nameText(nameOf(rule)),
             u"Look at pixels exactly on an edge, and at neighbours' shared "
             "edges."_s,
             u"The fill rule is %1 in place of %2."_s.arg(
                 nameText(nameOf(rule)), nameText(nameOf(scene.settings.fillRule))),
             [rule](Scene &changed) {
                 changed.settings.fillRule = rule;
                 return true;
             }});
    for (const ByteRounding rounding : allByteRoundings)
        appendWhereItApplies(defects, scene, QLatin1String(roundingChoice),
                             {u"rounding-"_s + nameText(nameOf(rounding)),
                              u"Look at how a colour becomes a byte."_s,
                              rounding == ByteRounding::Nearest
                                  ? u"Levels are rounded to the nearest byte, not cut: ⌊v + ½⌋."_s
                                  : u"Levels are cut to bytes, not rounded: ⌊v⌋ in place of "
                                    "⌊v + ½⌋."_s,
                              [rounding](Scene &changed) {
                                  changed.settings.rounding = rounding;
                                  return true;
                              }});
    for (const Arithmetic arithmetic : allArithmetics)
        appendWhereItApplies(defects, scene, QLatin1String(arithmeticChoice),
                             {u"arithmetic-"_s + nameText(nameOf(arithmetic)),
                              u"What your numbers are kept in decides pixels: how large is the "
                              "error after many additions?"_s,
                              u"It is computed in %1."_s.arg(nameText(nameOf(arithmetic))),
                              [arithmetic](Scene &changed) {
                                  changed.settings.arithmetic = arithmetic;
                                  return true;
                              }});
}

/// Where to look, for each kind of change of a whole picture.
QString questionOf(const QString &kind)
{
    static const QHash<QString, QString> questions = {
        {u"shift"_s, u"Where in the picture is the frame's first pixel?"_s},
        {u"flip"_s,
         u"Which of the picture's rows is written first, and which of the two "
         "coordinates counts rows?"_s},
        {u"stride"_s, u"At which address is the pixel (x, y) written, and where is it read?"_s},
        {u"channels"_s, u"In which order are R, G and B stored?"_s},
        {u"levels"_s, u"Are the bytes in the file those that were computed?"_s},
        {u"mask"_s, u"Which colour is written?"_s},
        {u"background"_s, u"What is in the frame before anything is drawn?"_s},
    };
    return questions.value(kind);
}

void appendPictures(std::vector<Defect> &defects, const Scene &scene)
{
    // Comes first: another background is still possible with it.
    defects.push_back(
        {.id = u"nothing-drawn"_s,
         .forStudent = u"Is the picture that is written the one that was drawn into?"_s,
         .forAssistant = u"Nothing of the scene is drawn."_s,
         .changePicture = ruleOf([](const Picture &, int, int, const Colour &background) {
             return ChangedPixel{background, 0};
         }),
         .leavesOut = true});
    const Picture ofItsSize{scene.frame.width, scene.frame.height, {}, {}};
    for (const PictureChange &change : pictureChangesFor(ofItsSize, scene.frame.background)) {
        const QString id = QString(change.name).toLower().replace(u' ', u'-');
        defects.push_back({id,
                           questionOf(change.kind),
                           change.sentence.isEmpty()
                               ? u"Done to the whole picture: %1."_s.arg(change.name)
                               : change.sentence,
                           {},
                           {},
                           change.pixel,
                           change.isFar,
                           change.kind});
        defects.back().movesPixels = change.movesPixels;
    }
}

/// A scene that can have every defect of its method: two primitives, turned either way, too large
/// for edge functions of 16 bits, with vertices between pixels, two in one column and two in one
/// row, and a level of 255; lines that rise, fall and leave the frame; contours that overlap.
Scene proneScene(const Scene &conventions)
{
    Scene scene = conventions;
    scene.frame.width = 384;
    scene.frame.height = 320;
    constexpr Lattice half = halfPixel;
    const std::array<Vertex, 4> vertices = {{{{5 * half, 7 * half}, {{255, 40, 10}}},
                                             {{649 * half, 7 * half}, {{20, 200, 90}}},
                                             {{649 * half, 489 * half}, {{60, 30, 240}}},
                                             {{9 * half, 571 * half}, {{200, 100, 0}}}}};
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    scene.triangles.clear();
    if (method.draws(PrimitiveKind::Triangle))
        scene.triangles = {{{{vertices[0], vertices[1], vertices[2]}}},
                           {{{vertices[0], vertices[3], vertices[2]}}}};
    const Vertex centre{latticePixel(100, 90), vertices[0].colour};
    const Vertex corner{latticePixel(140, 130), vertices[0].colour};
    const Vertex outside{latticePixel(150, -40), vertices[1].colour};
    const auto shape = [&method, &scene](PrimitiveKind kind, std::vector<Vertex> points,
                                         ShapeFill fill = ShapeFill::Outline) {
        Shape added;
        added.kind = kind;
        added.vertices = std::move(points);
        added.fill = fill;
        if (fill == ShapeFill::EvenOdd)
            added.laterContours = {4};
        if (method.draws(added))
            scene.shapes.push_back(added);
    };
    shape(PrimitiveKind::Line, {vertices[0], vertices[2]});
    shape(PrimitiveKind::Line, {vertices[1], vertices[3]});
    shape(PrimitiveKind::Line, {centre, outside});
    shape(PrimitiveKind::Circle, {centre, corner});
    const auto &[a, b, c, d] = vertices;
    shape(PrimitiveKind::Polygon, {a, b, c, d});
    shape(PrimitiveKind::Polygon, {a, b, c, d}, ShapeFill::NonZero);
    shape(PrimitiveKind::Polygon, {a, b, c, d, centre, corner, outside}, ShapeFill::EvenOdd);
    return scene;
}

} // namespace

QString undoingText()
{
    return u"the variants %1 and %2 cancel each other: the divisor is Δ again"_s.arg(
        nameText(nameOf(Variant::DivisorMinusOne)), nameText(nameOf(Variant::DivisorPlusOne)));
}

Defect redrawnBy(const Redrawing &redrawing, Defect words)
{
    words.redraw = [redrawing](const Scene &scene) { return redrawn(scene, redrawing); };
    words.redrawRange = [redrawing](const Scene &scene, Arithmetic arithmetic) {
        return redrawnRange(scene, redrawing, arithmetic);
    };
    words.redrawing = std::make_shared<const Redrawing>(redrawing);
    return words;
}

Defect drawnLinesBy(const LineBugs &bugs, Defect words)
{
    words.redraw = [bugs](const Scene &scene) { return drawnBy(bugs, scene); };
    words.lines = std::make_shared<const LineBugs>(bugs);
    return words;
}

std::optional<Defect> drawnTogether(const Defect &one, const Defect &other)
{
    if (one.lines && other.lines) {
        const auto both = together(*one.lines, *other.lines);
        return both ? std::optional(drawnLinesBy(*both, one)) : std::nullopt;
    }
    const auto both = one.redrawing && other.redrawing ? together(*one.redrawing, *other.redrawing)
                                                       : std::nullopt;
    return both ? std::optional(redrawnBy(*both, one)) : std::nullopt;
}

bool canBeTogether(const Defect &one, const Defect &other)
{
    const bool isOneChoice = !one.choice.isEmpty() && one.choice == other.choice;
    if (isOneChoice)
        return false;
    const bool areRedrawings
        = one.stage() == DefectStage::Drawing && other.stage() == DefectStage::Drawing;
    if (!areRedrawings)
        return true;
    if (one.lines && other.lines)
        return together(*one.lines, *other.lines).has_value();
    return one.redrawing && other.redrawing
        && together(*one.redrawing, *other.redrawing).has_value();
}

std::vector<Defect> defectsFor(const Scene &scene)
{
    std::vector<Defect> defects;
    appendVariants(defects, scene);
    appendSettings(defects, scene);
    std::ranges::move(sceneDefectsFor(scene), std::back_inserter(defects));
    std::ranges::move(lineDefectsFor(scene), std::back_inserter(defects));
    std::ranges::move(shapeDefectsFor(scene), std::back_inserter(defects));
    std::ranges::move(spanDefectsFor(scene), std::back_inserter(defects));
    std::ranges::move(levelDefectsFor(scene), std::back_inserter(defects));
    appendPictures(defects, scene);
    return defects;
}

std::vector<Defect> defectsUnder(const Scene &conventions)
{
    return defectsFor(proneScene(conventions));
}

std::vector<Defect> ownDefects(std::span<const Defect> known, std::span<const Defect> defects)
{
    std::vector<Defect> own;
    for (const Defect &defect : defects) {
        const auto found = std::ranges::find(known, defect.id, &Defect::id);
        if (found != known.end())
            own.push_back(*found);
    }
    return own;
}

} // namespace pixelplumb
