// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/runs/scenerun.h"
#include "core/scan/choicenames.h"
#include "core/scene/scenefile.h"
#include "tests/support/testprogram.h"

#include <QRegularExpression>
#include <QTest>

#include <utility>

namespace tst_waysout {

using namespace pixelplumb;

namespace {

constexpr auto plainTriangle = "'triangle': [[1, 1], [9, 2], [3, 8]], 'colors': ['#ff0000', "
                               "'#00ff00', '#0000ff']";

/// A setting of a scene file; an empty value leaves it open.
struct FileSettings {
    QString fillRule, arithmetic;
    QStringList variants;
};

QByteArray sceneText(const QString &body, const FileSettings &settings)
{
    QString text = u"{ 'pixelplumb': 1, 'frame': { 'width': 12, 'height': 10 }, "_s;
    if (!settings.fillRule.isEmpty())
        text += u"'fillRule': '%1', "_s.arg(settings.fillRule);
    if (!settings.arithmetic.isEmpty())
        text += u"'arithmetic': '%1', "_s.arg(settings.arithmetic);
    if (!settings.variants.isEmpty())
        text += u"'variants': ['%1'], "_s.arg(settings.variants.join(u"', '"_s));
    return QString(text + body + u'}').replace(u'\'', u'"').toUtf8();
}

QStringList bodies()
{
    const QString triangle = QString::fromLatin1(plainTriangle);
    return {u"'primitives': [{ %1 }]"_s.arg(triangle),
            u"'primitives': [{ %1 }]"_s.arg(triangle).replace(u"ff0000"_s, u"ff000080"_s),
            u"'antialiasing': 4, 'primitives': [{ %1 }]"_s.arg(triangle),
            // Depth may be called for, and is not.
            u"'primitives': [{ %1, 'z': [2, 2, 2] }]"_s.arg(triangle),
            // A segment, which calls for its texture under the closed rule alone.
            u"'materials': { 'm': { 'texture': 'checker' } }, 'primitives': [{ "
            "'triangle': [[1, 1], [3, 3], [5, 5]], 'colors': ['#ff0000', "
            "'#ff0000', '#ff0000'], 'material': 'm' }]"_s,
            u"'primitives': [{ 'line': [[1, 1], [9, 4]], 'colors': ['#ff0000', '#00ff00'] }]"_s,
            u"'antialiasing': 'area', 'primitives': [{ 'line': [[1, 1], [9, 4]], "
            "'colors': ['#ff0000', '#00ff00'] }]"_s};
}

/// The settings without those that a way out names: "without the fill rule and the arithmetic".
FileSettings without(const QString &way, FileSettings settings)
{
    if (way.contains(u"the fill rule"_s))
        settings.fillRule.clear();
    if (way.contains(u"the arithmetic"_s))
        settings.arithmetic.clear();
    if (!way.contains(u"the variant"_s))
        return settings;
    const qsizetype all = settings.variants.size();
    settings.variants.removeIf(
        [&](const QString &variant) { return way.contains(u'“' + variant + u'”'); });
    if (settings.variants.size() == all)
        settings.variants.clear();
    return settings;
}

/// Which of the names in a list, "it keeps closed, open", is taken: this one, from 0, or the last.
using Choice = qsizetype;
constexpr Choice longestList = 5; ///< rules and arithmetics

/// One of the names that a list captures; empty if there is none.
QString captured(const QString &text, const char *pattern, Choice choice)
{
    const auto match = QRegularExpression(QString::fromLatin1(pattern)).match(text);
    const QStringList names = match.captured(1).split(u", "_s, Qt::SkipEmptyParts);
    return names.isEmpty() ? QString() : names[std::min(choice, names.size() - 1)];
}

/// The scene of a body with every effect forced off.
Scene allForcedOff(const QString &body, FillRule rule, Arithmetic arithmetic)
{
    Scene scene = readScene(sceneText(body, {}))->scene;
    scene.settings.fillRule = rule;
    scene.settings.arithmetic = arithmetic;
    for (const Effect effect : allEffects)
        scene.appearance.forced[effect] = Forcing::Off;
    return scene;
}

/// What the method that is chosen for the scene objects to.
QString objectionOfItsMethod(Scene scene, const OpenSettings &open)
{
    const Method &method = methodFor(scene, open);
    scene.method = method.id.toStdString();
    scene.settings = settledFor(method, scene.settings, open);
    return objectionTo(scene);
}

/// Does what an objection says, by one of the names in each of its lists.
void follow(const QString &objection, Choice choice, Scene &scene)
{
    ScanSettings &settings = scene.settings;
    const QString other = captured(objection, "; ([a-z0-9-]+(?:, [a-z0-9-]+)*) can(?:,|$)", choice);
    if (!other.isEmpty()) {
        scene.method = other.toStdString();
        const QString not_ = captured(objection, " can, but not (.*)$", 0);
        if (not_.contains(u"fill rule"_s))
            settings.fillRule = methodNamed(other)->fillRules.front();
        if (not_.contains(u"in “"_s))
            settings.arithmetic = Arithmetic::Exact;
        if (not_.contains(u"variants"_s))
            settings.variants = {};
        return;
    }
    if (const QString known = captured(objection, "it knows ([a-z0-9., ]+[a-z0-9])", choice);
        !known.isEmpty())
        settings.arithmetic = *arithmeticNamed(known.toStdString());
    if (const QString kept = captured(objection, "it keeps ([a-z-]+(?:, [a-z-]+)*)", choice);
        !kept.isEmpty())
        settings.fillRule = *fillRuleNamed(kept.toStdString());
    if (const QString able
        = captured(objection, "it can (?:without them and )?in ([a-z0-9., ]+[a-z0-9])", choice);
        !able.isEmpty())
        settings.arithmetic = *arithmeticNamed(able.toStdString());
    if (objection.contains(u"without them"_s))
        settings.variants = {};
    for (const Variant variant : variantsIn(settings.variants)) {
        if (objection.contains(u"knows no variant “"_s + nameText(nameOf(variant))))
            settings.variants = settings.variants.without(variant);
    }
}

QStringList namesWithNone(const auto &choices)
{
    QStringList names = {QString()};
    for (const auto choice : choices)
        names.append(nameText(nameOf(choice)));
    return names;
}

/// None, each alone, and some pairs.
std::vector<QStringList> variantLists()
{
    std::vector<QStringList> lists = {{}};
    for (const Variant variant : allVariants)
        lists.push_back({nameText(nameOf(variant))});
    const std::size_t single = lists.size();
    for (std::size_t i = 1; i + 3 < single; i += 3)
        lists.push_back(lists[i] + lists[i + 3]);
    return lists;
}

} // namespace

/// A refusal names a way out, and the way works, however many settings are in the way.
class TestWaysOut : public QObject {
    Q_OBJECT

private slots:
    void whatNoMethodKeepsSomeMethodDrawsWithoutWhatIsNamed()
    {
        int refused = 0;
        int pairs = 0;
        for (const QString &body : bodies()) {
            for (const QString &rule : namesWithNone(allFillRules)) {
                for (const QString &arithmetic : namesWithNone(allArithmetics)) {
                    for (const QStringList &variants : variantLists()) {
                        const FileSettings settings{rule, arithmetic, variants};
                        const auto reading = readScene(sceneText(body, settings));
                        if (reading)
                            continue;
                        const QString text = reading.error().message();
                        const qsizetype at = text.indexOf(u"; one does "_s);
                        QVERIFY2(at >= 0, qPrintable(text));
                        for (const QString &way : text.mid(at + 11).split(u", or "_s)) {
                            const auto freed = readScene(sceneText(body, without(way, settings)));
                            QVERIFY2(freed, qPrintable(text));
                            QVERIFY2(objectionTo(freed->scene).isEmpty(),
                                     qPrintable(text + u'\n' + objectionTo(freed->scene)));
                            pairs += way.contains(u" and "_s) ? 1 : 0;
                        }
                        ++refused;
                    }
                }
            }
        }
        QVERIFY(refused > 100);
        QVERIFY(pairs > 10);
    }

    void ofWhatIsForcedOffNoMoreSettingsAreNamedThanAreInTheWay()
    {
        int refused = 0;
        int single = 0;
        for (const QString &body : bodies()) {
            for (const FillRule rule : allFillRules) {
                for (const Arithmetic arithmetic : allArithmetics) {
                    const Scene scene = allForcedOff(body, rule, arithmetic);
                    const OpenSettings none = {true, false, false};
                    if (objectionOfItsMethod(scene, none).isEmpty())
                        continue;
                    const QString text = refusalOfAll(scene, none);
                    for (const OpenSettings &open :
                         {OpenSettings{true, true, false}, OpenSettings{true, false, true}}) {
                        if (!objectionOfItsMethod(scene, open).isEmpty())
                            continue;
                        QVERIFY2(text.contains(open.fillRule ? u"without the fill rule"
                                                             : u"without the arithmetic"),
                                 qPrintable(text));
                        QVERIFY2(!text.contains(u"without the fill rule and"), qPrintable(text));
                        ++single;
                    }
                    ++refused;
                }
            }
        }
        QVERIFY(refused > 2);
        QVERIFY(single > 2);
    }

    void whatAMethodObjectsToIsNamedAtOnce()
    {
        int refused = 0;
        int several = 0;
        for (const QString &body : bodies()) {
            const auto reading = readScene(sceneText(body, {}));
            QVERIFY(reading);
            for (const Method &method : methods()) {
                if (!method.draws(reading->scene.hasTriangles() ? PrimitiveKind::Triangle
                                                                : PrimitiveKind::Line))
                    continue;
                for (const FillRule rule : allFillRules) {
                    for (const Arithmetic arithmetic : allArithmetics) {
                        for (const QStringList &variants : variantLists()) {
                            Scene scene = reading->scene;
                            scene.method = method.id.toStdString();
                            scene.settings.fillRule = rule;
                            scene.settings.arithmetic = arithmetic;
                            for (const QString &variant : variants)
                                scene.settings.variants = scene.settings.variants.with(
                                    *variantNamed(variant.toStdString()));
                            const QString objection = objectionTo(scene);
                            if (objection.isEmpty())
                                continue;
                            Scene last;
                            for (Choice choice = 0; choice < longestList; ++choice) {
                                Scene followed = scene;
                                follow(objection, choice, followed);
                                if (followed == std::exchange(last, followed))
                                    break; // the end of each list
                                const QString then = objectionTo(followed);
                                QVERIFY2(then.isEmpty(),
                                         qPrintable(method.id + u' ' + objection
                                                    + u"\nthen, by choice %1, %2"_s.arg(choice).arg(
                                                        then)));
                            }
                            ++refused;
                            several += objection.contains(u"It also"_s) ? 1 : 0;
                        }
                    }
                }
            }
        }
        QVERIFY(refused > 1000);
        QVERIFY(several > 100);
    }
};

PIXELPLUMB_TEST(TestWaysOut)

} // namespace tst_waysout

#include "tst_waysout.moc"
