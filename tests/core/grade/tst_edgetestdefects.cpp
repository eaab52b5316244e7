// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/diagnosis.h"
#include "tests/support/casestorun.h"
#include "tests/support/scenes/probescenes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace tst_edgetestdefects {

using namespace pixelplumb;

namespace {

/// The mistake in a student's edge tests.
enum class TestMistake {
    None,
    SecondNotTested,
    SecondTestedOutside,
    SecondNegated,
    ThirdIsSecond,
    StrictByWeights, ///< w > 0, the third weight being 1 minus the others
    SlackOfOne,
    SlackOfHalf,
    SlackOfTenth,
    RowEndsOutside,
    BoxOfTwo,
    BoxWithoutStart,
    BoxWithoutEnd,
    StepsExchanged,
    ProductsAdded,
    FunctionsCut,
    FunctionsFloored,
    NotDivided,
    DividedByHalf,
    DividedByTwice,
    WholeWeights,
    ThirdWeightAdds,
    ThirdWeightIsFirst,
    ThirdWeightMissing,
    ProductsCut,
};

/// From ⌈least⌉ to ⌊greatest⌋ or, as many programs have it, from ⌊least⌋ to ⌈greatest⌉.
enum class TestedBox { Inward, Outward };

struct Point {
    double x = 0, y = 0;
};

/// Draws one triangle in doubles, by the slides and without any core code; pixels are painted
/// whether they are in the frame or not.
class StudentTriangle {
public:
    StudentTriangle(const Triangle &triangle, TestMistake mistake, TestedBox box)
        : m_mistake(mistake)
        , m_box(box)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const LatticePoint &at = triangle.vertices[i].position;
            m_points[i]
                = {double(at.x) / double(unitsPerPixel), double(at.y) / double(unitsPerPixel)};
            m_colours[i] = triangle.vertices[i].colour;
        }
        m_area = edge(0, m_points[2]);
        if (is(TestMistake::FunctionsCut))
            m_area = std::trunc(m_area);
        if (is(TestMistake::FunctionsFloored))
            m_area = std::floor(m_area);
    }

    void paintOn(Picture &picture) const
    {
        const std::size_t boxed = is(TestMistake::BoxOfTwo) ? 2 : 3;
        Point least = m_points[0];
        Point greatest = m_points[0];
        for (std::size_t i = 1; i < boxed; ++i) {
            least = {std::min(least.x, m_points[i].x), std::min(least.y, m_points[i].y)};
            greatest = {std::max(greatest.x, m_points[i].x), std::max(greatest.y, m_points[i].y)};
        }
        const int late = is(TestMistake::BoxWithoutStart) ? 1 : 0;
        const int early = is(TestMistake::BoxWithoutEnd) ? 1 : 0;
        const int left = firstOf(least.x) + late;
        const int bottom = firstOf(least.y) + late;
        for (int y = bottom; y <= lastOf(greatest.y) - early; ++y) {
            for (int x = left; x <= lastOf(greatest.x) - early; ++x) {
                Point at{double(x), double(y)};
                if (is(TestMistake::StepsExchanged))
                    at = {double(left + (y - bottom)), double(bottom + (x - left))};
                const std::array<double, 3> e = functionsAt(at);
                if (isInside(e))
                    paint(picture, x, y, e);
                else if (is(TestMistake::RowEndsOutside))
                    break;
            }
        }
    }

private:
    bool is(TestMistake mistake) const { return m_mistake == mistake; }

    int firstOf(double least) const
    {
        return int(m_box == TestedBox::Inward ? std::ceil(least) : std::floor(least));
    }
    int lastOf(double greatest) const
    {
        return int(m_box == TestedBox::Inward ? std::floor(greatest) : std::ceil(greatest));
    }

    double edge(std::size_t from, const Point &at) const
    {
        const Point &a = m_points[from];
        const Point &b = m_points[(from + 1) % 3];
        const double one = (b.x - a.x) * (at.y - a.y);
        const double other = (b.y - a.y) * (at.x - a.x);
        return is(TestMistake::ProductsAdded) ? one + other : one - other;
    }
    std::array<double, 3> functionsAt(const Point &at) const
    {
        std::array<double, 3> e = {edge(0, at), edge(1, at), edge(2, at)};
        if (is(TestMistake::FunctionsCut))
            std::ranges::transform(e, e.begin(), [](double value) { return std::trunc(value); });
        if (is(TestMistake::FunctionsFloored))
            std::ranges::transform(e, e.begin(), [](double value) { return std::floor(value); });
        if (is(TestMistake::SecondNegated))
            e[1] = -e[1];
        if (is(TestMistake::ThirdIsSecond))
            e[2] = e[1];
        return e;
    }
    bool isInside(const std::array<double, 3> &e) const
    {
        if (is(TestMistake::StrictByWeights)) {
            const double first = e[1] / m_area;
            const double second = e[2] / m_area;
            return first > 0 && second > 0 && 1 - first - second > 0;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            double value = m_area < 0 ? -e[i] : e[i];
            if (is(TestMistake::SecondNotTested) && i == 1)
                continue;
            if (is(TestMistake::SecondTestedOutside) && i == 1)
                value = -value;
            const bool isOutside = is(TestMistake::SlackOfHalf) ? value <= -0.5
                : is(TestMistake::SlackOfTenth)                 ? value <= -0.1
                                                : value < (is(TestMistake::SlackOfOne) ? -1 : 0);
            if (isOutside)
                return false;
        }
        return true;
    }
    std::array<double, 3> weightsOf(const std::array<double, 3> &e) const
    {
        double divisor = m_area;
        if (is(TestMistake::NotDivided))
            divisor = m_area < 0 ? -1 : 1;
        if (is(TestMistake::DividedByHalf))
            divisor = m_area / 2;
        if (is(TestMistake::DividedByTwice))
            divisor = m_area * 2;
        std::array<double, 3> w = {e[1] / divisor, e[2] / divisor, e[0] / divisor};
        if (is(TestMistake::WholeWeights))
            std::ranges::transform(w, w.begin(), [](double weight) { return std::trunc(weight); });
        if (is(TestMistake::ThirdWeightAdds))
            w[2] = 1 - w[0] + w[1];
        if (is(TestMistake::ThirdWeightIsFirst))
            w[2] = w[0];
        if (is(TestMistake::ThirdWeightMissing))
            w[2] = 0;
        return w;
    }
    void paint(Picture &picture, int x, int y, const std::array<double, 3> &e) const
    {
        if (x < 0 || y < 0 || x >= picture.width || y >= picture.height)
            return;
        const std::array<double, 3> w = weightsOf(e);
        const std::size_t place = picture.placeOf(x, picture.height - 1 - y);
        picture.covered[place] = 1;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            double level = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double product = w[i] * m_colours[i].channels[channel];
                level += is(TestMistake::ProductsCut) ? std::trunc(product) : product;
            }
            picture.colours[place].channels[channel]
                = std::uint8_t(std::clamp(std::floor(level + 0.5), 0.0, 255.0));
        }
    }

    TestMistake m_mistake;
    TestedBox m_box;
    std::array<Point, 3> m_points;
    std::array<Colour, 3> m_colours;
    double m_area = 0;
};

Picture studentPicture(const Scene &scene, TestMistake mistake, TestedBox box = TestedBox::Inward)
{
    Scene empty = scene;
    empty.triangles.clear();
    Picture picture = pictureOf(empty);
    for (const Triangle &triangle : scene.triangles)
        StudentTriangle(triangle, mistake, box).paintOn(picture);
    return picture;
}

QStringList methods()
{
    return {QStringLiteral("edge-equations"), QStringLiteral("barycentric-rectangle")};
}

void addMethods()
{
    QTest::addColumn<QString>("method");
    for (const QString &method : methods())
        QTest::newRow(qPrintable(method)) << method;
}

/// The diagnosis of a program with a mistake, from its pictures of the method's sheet.
Diagnosis diagnosed(const QString &method, TestMistake mistake)
{
    std::vector<Submission> submissions;
    for (const Scene &scene : probeSheet(method))
        submissions.push_back({scene, studentPicture(scene, mistake)});
    return *diagnose(submissions);
}

} // namespace

/// The defects of edge tests match a program that was not written for them, in doubles.
class TestEdgeTestDefects : public QObject {
    Q_OBJECT

private slots:
    void aRightProgramIsNotCalledWrong_data() { addMethods(); }
    void aRightProgramIsNotCalledWrong()
    {
        QFETCH(QString, method);
        QVERIFY(diagnosed(method, TestMistake::None).verdict != DiagnosisVerdict::Wrong);
    }

    void theSheetNamesTheMistakeOfAProgram_data()
    {
        struct Mistaken {
            QString method;
            const char *id;
            TestMistake mistake;
        };
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("id");
        QTest::addColumn<int>("mistake");
        constexpr std::pair<const char *, TestMistake> mistakes[]
            = {{"edge-1-not-tested", TestMistake::SecondNotTested},
               {"edge-1-tested-outside", TestMistake::SecondTestedOutside},
               {"edge-1-negated", TestMistake::SecondNegated},
               {"edge-2-is-edge-1", TestMistake::ThirdIsSecond},
               {"slack-of-one", TestMistake::SlackOfOne},
               {"slack-of-half", TestMistake::SlackOfHalf},
               {"slack-of-a-tenth", TestMistake::SlackOfTenth},
               {"row-ends-outside", TestMistake::RowEndsOutside},
               {"box-of-vertices-0-and-1", TestMistake::BoxOfTwo},
               {"box-starts-missing", TestMistake::BoxWithoutStart},
               {"box-ends-missing", TestMistake::BoxWithoutEnd},
               {"steps-exchanged", TestMistake::StepsExchanged},
               {"edge-products-added", TestMistake::ProductsAdded},
               {"edge-functions-cut", TestMistake::FunctionsCut},
               {"edge-functions-floored", TestMistake::FunctionsFloored},
               {"weights-not-divided", TestMistake::NotDivided},
               {"weights-doubled", TestMistake::DividedByHalf},
               {"levels-halved", TestMistake::DividedByTwice},
               {"weights-whole", TestMistake::WholeWeights},
               {"weight-2-adds-weight-1", TestMistake::ThirdWeightAdds},
               {"weight-2-is-weight-0", TestMistake::ThirdWeightIsFirst},
               {"weight-2-missing", TestMistake::ThirdWeightMissing},
               {"products-cut", TestMistake::ProductsCut}};
        std::vector<Mistaken> all;
        for (const QString &method : methods()) {
            for (const auto &[id, mistake] : mistakes)
                all.push_back({method, id, mistake});
        }
        for (const Mistaken &each : casesToRun(all, &Mistaken::method))
            QTest::addRow("%s of %s", each.id, qPrintable(each.method))
                << each.method << QString::fromLatin1(each.id) << int(each.mistake);
    }
    void theSheetNamesTheMistakeOfAProgram()
    {
        QFETCH(QString, method);
        QFETCH(QString, id);
        QFETCH(int, mistake);

        const Diagnosis diagnosis = diagnosed(method, TestMistake(mistake));

        QVERIFY(diagnosis.isExplained());
        QCOMPARE(diagnosis.candidates.front().ids(), QStringList(id));
        QVERIFY(std::ranges::none_of(
            diagnosis.candidates.begin() + 1, diagnosis.candidates.end(),
            [](const DiagnosisCandidate &other) { return other.defects.size() == 1; }));
    }

    /// Some samples on an edge are drawn, because the third weight is rounded.
    void aStrictTestIsWrongThoughRoundingDecidesSomeSamples_data() { addMethods(); }
    void aStrictTestIsWrongThoughRoundingDecidesSomeSamples()
    {
        QFETCH(QString, method);

        const Diagnosis diagnosis = diagnosed(method, TestMistake::StrictByWeights);

        QCOMPARE(nameOf(diagnosis.verdict), QStringLiteral("wrong"));
        const DiagnosisCandidate &named = diagnosis.candidates.front();
        QCOMPARE(named.ids(), QStringList(QStringLiteral("rule-open")));
        QVERIFY(named.undecidable > 0);
        QVERIFY(2 * named.undecidable < diagnosis.differing);
    }

    void anOutwardBoxWithAMistakeIsFoundButNotReported_data()
    {
        QTest::addColumn<int>("mistake");
        QTest::newRow("edge-1-not-tested") << int(TestMistake::SecondNotTested);
        QTest::newRow("edge-1-tested-outside") << int(TestMistake::SecondTestedOutside);
    }
    void anOutwardBoxWithAMistakeIsFoundButNotReported()
    {
        QFETCH(int, mistake);
        std::vector<Submission> submissions;
        for (const Scene &scene : probeSheet(QStringLiteral("edge-equations")))
            submissions.push_back(
                {scene, studentPicture(scene, TestMistake(mistake), TestedBox::Outward)});

        const Diagnosis diagnosis = *diagnose(submissions);

        QVERIFY(diagnosis.isExplained());
        const DiagnosisCandidate &named = diagnosis.candidates.front();
        QCOMPARE(named.rightAlone(), QStringList(QStringLiteral("box-outward")));
        QStringList mistakes = named.ids();
        mistakes.removeAll(QStringLiteral("box-outward"));
        QCOMPARE(mistakes, QStringList(QString::fromLatin1(QTest::currentDataTag())));
        QCOMPARE(named.sentences(&Defect::forStudent).size(), 1);
    }

    /// Some programs keep the lowest eight bits of a level that fits no byte.
    void missingClampingIsReportedNextToTheMistake()
    {
        const std::vector<Scene> scenes = probeSheet(QStringLiteral("edge-equations"));
        std::vector<Defect> pair;
        for (const Defect &defect : defectsFor(scenes.front())) {
            if (defect.id == QStringLiteral("weights-doubled")
                || defect.id == QStringLiteral("levels-wrap"))
                pair.push_back(defect);
        }
        QCOMPARE(pair.size(), std::size_t(2));
        std::vector<Submission> submissions;
        for (const Scene &scene : scenes)
            submissions.push_back({scene, pictureWith(scene, pair)});

        const Diagnosis diagnosis = *diagnose(submissions);

        QVERIFY(diagnosis.isExplained());
        QCOMPARE(diagnosis.candidates.front().rightAlone(),
                 QStringList(QStringLiteral("levels-wrap")));
        QCOMPARE(diagnosis.candidates.front().defects.size(), std::size_t(2));
    }
};

PIXELPLUMB_TEST(TestEdgeTestDefects)

} // namespace tst_edgetestdefects

#include "tst_edgetestdefects.moc"
