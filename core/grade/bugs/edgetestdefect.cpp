// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/edgetestdefect.h"

#include "core/grade/bugs/walkdefect.h"
#include "core/grade/scan/programedgetest.h"
#include "core/number/integer.h"

namespace pixelplumb {

namespace {

constexpr std::array<std::size_t, 3> vertexIndices = {0, 1, 2};

constexpr const char *testQuestion
    = "What sign does each edge function have inside, and is it tested?";
constexpr const char *functionQuestion
    = "Is each edge function 0 at its own two vertices, and twice the area at the third?";
constexpr const char *ownerQuestion = "Which edges own the samples that lie on them?";
constexpr const char *loopQuestion = "Is each sample of the box asked, and with its own numbers?";
constexpr const char *weightQuestion
    = "Are the three weights 1 at their own vertex, 0 at the others, and together 1 everywhere?";
constexpr const char *numberQuestion = "Which of your numbers are whole ones, and should not be?";

class Defects {
public:
    void add(const QString &id, const char *forStudent, const QString &forAssistant,
             const ProgramEdgeTest &program)
    {
        m_defects.push_back(redrawnBy(redrawingByTests(program, LevelOverflow::Clamps),
                                      {id, QString::fromUtf8(forStudent), forAssistant}));
        if (program.owner != EdgeOwner::OfRule)
            m_defects.back().choice = QString::fromLatin1(ruleChoice);
    }
    void add(const char *id, const char *forStudent, const char *forAssistant,
             const ProgramEdgeTest &program)
    {
        add(QString::fromLatin1(id), forStudent, QString::fromUtf8(forAssistant), program);
    }
    std::vector<Defect> take() { return std::move(m_defects); }

private:
    std::vector<Defect> m_defects;
};

/// "from vertex 0 to vertex 1"
QString endsOf(std::size_t edge)
{
    return QStringLiteral("from vertex %1 to vertex %2").arg(edge).arg((edge + 1) % 3);
}

void appendOfEdge(Defects &defects, std::size_t edge)
{
    const QString name = QStringLiteral("edge-%1").arg(edge);
    const std::size_t opposite = (edge + 2) % 3;
    ProgramEdgeTest program;
    program.questions[edge] = EdgeQuestion::Nothing;
    defects.add(name + QStringLiteral("-not-tested"), testQuestion,
                QStringLiteral("The edge %1 is not tested.").arg(endsOf(edge)), program);
    program.questions[edge] = EdgeQuestion::IsOutside;
    defects.add(name + QStringLiteral("-tested-outside"), testQuestion,
                QStringLiteral("The edge %1 is tested with the wrong sign: ≤ 0 in place of ≥ 0.")
                    .arg(endsOf(edge)),
                program);
    defects.add(name + QStringLiteral("-negated"), testQuestion,
                QStringLiteral("The edge function %1 has the wrong sign, in the test and in the "
                               "weight of vertex %2.")
                    .arg(endsOf(edge))
                    .arg(opposite),
                {.change = [edge](EdgeFunctions &functions) {
                    functions.values[edge] = -functions.values[edge];
                }});
    for (const std::size_t other : vertexIndices) {
        if (other == edge)
            continue;
        defects.add(name + QStringLiteral("-is-edge-%1").arg(other), functionQuestion,
                    QStringLiteral("In place of the edge function %1 that %2 is computed again, "
                                   "for the test and for the weight of vertex %3.")
                        .arg(endsOf(edge), endsOf(other))
                        .arg(opposite),
                    {.change = [edge, other](EdgeFunctions &functions) {
                        functions.values[edge] = functions.values[other];
                    }});
    }
}

void appendOfWeight(Defects &defects, std::size_t vertex)
{
    const QString name = QStringLiteral("weight-%1").arg(vertex);
    const auto add = [&](const QString &id, const QString &forAssistant,
                         const std::function<void(VertexWeights & weights)> &weigh) {
        defects.add(name + id, weightQuestion,
                    QStringLiteral("The weight of vertex %1 ").arg(vertex) + forAssistant,
                    {.weigh = weigh});
    };
    add(QStringLiteral("-missing"), QStringLiteral("times its colour is not added."),
        [vertex](VertexWeights &weights) { weights.numerators[vertex] = 0; });
    for (const std::size_t other : vertexIndices) {
        if (other == vertex)
            continue;
        const std::size_t third = 3 - vertex - other;
        add(QStringLiteral("-is-weight-%1").arg(other),
            QStringLiteral("is that of vertex %1 again.").arg(other),
            [vertex, other](VertexWeights &weights) {
                weights.numerators[vertex] = weights.numerators[other];
            });
        add(QStringLiteral("-adds-weight-%1").arg(other),
            QStringLiteral("is 1 minus that of vertex %1, plus that of vertex %2, not minus it.")
                .arg(third)
                .arg(other),
            [vertex, other](VertexWeights &weights) {
                weights.numerators[vertex] += 2 * weights.numerators[other];
            });
        add(QStringLiteral("-leaves-weight-%1").arg(other),
            QStringLiteral("is 1 minus that of vertex %1 alone: that of vertex %2 is not "
                           "subtracted.")
                .arg(third)
                .arg(other),
            [vertex, other](VertexWeights &weights) {
                weights.numerators[vertex] += weights.numerators[other];
            });
    }
}

void appendWeights(Defects &defects)
{
    defects.add("weights-not-divided", weightQuestion,
                "Edge functions are taken for weights: they are not divided by twice the area.",
                {.weigh = [](VertexWeights &weights) { weights.denominator = squarePixel; }});
    defects.add("weights-doubled", weightQuestion,
                "Edge functions are divided by the area in place of twice the area: weights and "
                "colours are doubled.",
                {.weigh = [](VertexWeights &weights) {
                    for (Int128 &numerator : weights.numerators)
                        numerator *= 2;
                }});
    defects.add("weights-whole", numberQuestion,
                "Weights are divided as whole numbers: each is 0 but at its own vertex.",
                {.weigh = [](VertexWeights &weights) {
                    for (Int128 &numerator : weights.numerators)
                        numerator = numerator / weights.denominator * weights.denominator;
                }});
    defects.add("products-cut", numberQuestion,
                "Each product of a weight and a level is cast to a whole number before the three "
                "are added.",
                {.product = WeightedProduct::Cut});
    defects.add("products-rounded", numberQuestion,
                "Each product of a weight and a level is rounded before the three are added.",
                {.product = WeightedProduct::Rounded});
}

void appendFunctions(Defects &defects)
{
    const auto whole = [](Int128 square) { return square / squarePixel * squarePixel; };
    defects.add(
        "edge-functions-cut", numberQuestion,
        "Edge functions and twice the area are cast to whole numbers.",
        {.function = [whole](const LatticePoint &from, const LatticePoint &to,
                             const LatticePoint &at) { return whole(doubledArea(from, to, at)); }});
    defects.add(
        "edge-functions-floored", numberQuestion,
        "Edge functions and twice the area are rounded down to whole numbers, as by // in "
        "Python.",
        {.function = [](const LatticePoint &from, const LatticePoint &to, const LatticePoint &at) {
            return floorDivide<Int128>(doubledArea(from, to, at), squarePixel) * squarePixel;
        }});
    defects.add("edge-products-cut", numberQuestion,
                "The two products of an edge function are each cast to whole numbers.",
                {.function = [whole](const LatticePoint &from, const LatticePoint &to,
                                     const LatticePoint &at) {
                    return whole(Int128(to.x - from.x) * (at.y - from.y))
                        - whole(Int128(to.y - from.y) * (at.x - from.x));
                }});
    defects.add("edge-coefficients-cut", numberQuestion,
                "a, b and c of a·x + b·y + c are cast to whole numbers.",
                {.function = [whole](const LatticePoint &from, const LatticePoint &to,
                                     const LatticePoint &at) {
                    const Int128 a = from.y - to.y;
                    const Int128 b = to.x - from.x;
                    const Int128 c = -(a * from.x + b * from.y);
                    const auto cut
                        = [](Int128 length) { return length / unitsPerPixel * unitsPerPixel; };
                    return cut(a) * at.x + cut(b) * at.y + whole(c);
                }});
    defects.add(
        "edge-products-added", functionQuestion,
        "The two products of an edge function are added, not subtracted.",
        {.function = [](const LatticePoint &from, const LatticePoint &to, const LatticePoint &at) {
            return Int128(to.x - from.x) * (at.y - from.y)
                + Int128(to.y - from.y) * (at.x - from.x);
        }});
}

void appendTests(Defects &defects)
{
    defects.add("owned-by-bottom-and-right", ownerQuestion,
                "The rule of top and left edges is inverted: samples on an edge belong to bottom "
                "and right edges.",
                {.owner = EdgeOwner::BottomRight});
    defects.add("owned-by-bottom-and-left", ownerQuestion,
                "Samples on an edge belong to bottom and left edges, as where y is taken to point "
                "the other way.",
                {.owner = EdgeOwner::BottomLeft});
    defects.add("owned-by-top-and-right", ownerQuestion,
                "Samples on an edge belong to top and right edges.",
                {.owner = EdgeOwner::TopRight});
    defects.add("slack-of-one", testQuestion,
                "Edges are tested by E ≥ −1 in place of E ≥ 0: samples beside a short edge are "
                "drawn.",
                {.slack = EdgeSlack::OfFunction});
    defects.add("slack-of-half", testQuestion,
                "Edges are tested by E > −½ in place of E ≥ 0: samples beside a short edge are "
                "drawn.",
                {.slack = EdgeSlack::OfHalf});
    defects.add("slack-of-a-tenth", testQuestion, "Edges are tested by E > −0.1 in place of E ≥ 0.",
                {.slack = EdgeSlack::OfTenth});
    defects.add("slack-of-half-a-pixel", testQuestion,
                "Samples up to half a pixel outside an edge are drawn.",
                {.slack = EdgeSlack::OfDistance});
    defects.add("slack-of-a-hundredth", testQuestion,
                "Weights are tested by ≥ −0.01 in place of ≥ 0.", {.slack = EdgeSlack::OfWeight});
    defects.add("row-ends-outside", loopQuestion,
                "A row is left at its first sample that is outside: break in place of continue.",
                {.outside = OutsideSample::EndsRow});
}

/// Mistakes in edge functions that are stepped from sample to sample.
void appendSteps(Defects &defects)
{
    defects.add("functions-not-set-back", loopQuestion,
                "What edge functions are stepped by along a row is not taken back before the next "
                "row.",
                {.place = [](const Triangle &, const SampleBox &box, const LatticePoint &sample) {
                    const Lattice rows = sample.y - box.firstY * unitsPerPixel;
                    return LatticePoint{sample.x + (box.endX - box.firstX) * rows, sample.y};
                }});
    defects.add(
        "steps-exchanged", loopQuestion,
        "Along a row edge functions are stepped by what belongs to a row more, and from "
        "row to row by what belongs to a column.",
        {.place = [](const Triangle &, const SampleBox &box, const LatticePoint &sample) {
            const LatticePoint corner = latticePixel(box.firstX, box.firstY);
            return LatticePoint{corner.x + (sample.y - corner.y), corner.y + (sample.x - corner.x)};
        }});
    defects.add(
        "functions-from-box-corner", loopQuestion,
        "Edge functions begin at the corner (x_min, y_min) itself, not at the box' first "
        "sample.",
        {.place = [](const Triangle &triangle, const SampleBox &box, const LatticePoint &sample) {
            const LatticePoint least = boundingCornersOf(triangle).first;
            const LatticePoint corner = latticePixel(box.firstX, box.firstY);
            return LatticePoint{sample.x - corner.x + least.x, sample.y - corner.y + least.y};
        }});
}

} // namespace

std::vector<Defect> edgeTestDefects()
{
    Defects defects;
    for (const std::size_t edge : vertexIndices)
        appendOfEdge(defects, edge);
    appendTests(defects);
    appendSteps(defects);
    appendFunctions(defects);
    for (const std::size_t vertex : vertexIndices)
        appendOfWeight(defects, vertex);
    appendWeights(defects);
    return defects.take();
}

} // namespace pixelplumb
