// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/edgetestdefect.h"

#include "core/grade/scan/programedgetest.h"

namespace pixelplumb {

namespace {

constexpr const char *testQuestion
    = "What sign does each edge function have inside, and is it tested?";
constexpr const char *functionQuestion
    = "Is each edge function 0 at its own two vertices, and twice the area at the third?";
constexpr const char *ownerQuestion = "Which edges own the samples that lie on them?";
constexpr const char *loopQuestion = "Is each sample of the box asked, and with its own numbers?";
constexpr const char *weightQuestion
    = "Are the three weights 1 at their own vertex, 0 at the others, and together 1 everywhere?";
constexpr const char *numberQuestion = "Which of your numbers are whole ones, and should not be?";
constexpr const char *widthQuestion = "How large do your numbers get, and what holds them?";

/// A mistake of the program; in its texts %1 and %2 are those of an edge or of a weight.
struct EdgeTestRow {
    const char *id;
    const char *forStudent;
    const char *forAssistant;
    EdgeTestBugs bugs;
};

using Rows = std::vector<EdgeTestRow>;

const Rows &testRows()
{
    static const Rows rows = {
        {"owned-by-bottom-and-right",
         ownerQuestion,
         "The rule of top and left edges is inverted: samples on an edge belong to bottom and "
         "right "
         "edges.",
         {.owner = EdgeOwner::BottomRight}},
        {"owned-by-bottom-and-left",
         ownerQuestion,
         "Samples on an edge belong to bottom and left edges, as where y is taken to point the "
         "other way.",
         {.owner = EdgeOwner::BottomLeft}},
        {"owned-by-top-and-right",
         ownerQuestion,
         "Samples on an edge belong to top and right edges.",
         {.owner = EdgeOwner::TopRight}},
        {"owned-as-given",
         ownerQuestion,
         "Which edges are top and left is told by their direction as given: of triangles whose "
         "vertices turn clockwise, samples on an edge belong to bottom and right edges.",
         {.owner = EdgeOwner::AsGiven}},
        {"slack-of-one",
         testQuestion,
         "Edges are tested by E ≥ −1 in place of E ≥ 0: samples beside a short edge are drawn.",
         {.slack = EdgeSlack::OfFunction}},
        {"slack-of-half",
         testQuestion,
         "Edges are tested by E > −½ in place of E ≥ 0: samples beside a short edge are drawn.",
         {.slack = EdgeSlack::OfHalf}},
        {"slack-of-a-tenth",
         testQuestion,
         "Edges are tested by E > −0.1 in place of E ≥ 0.",
         {.slack = EdgeSlack::OfTenth}},
        {"slack-of-half-a-pixel",
         testQuestion,
         "Samples up to half a pixel outside an edge are drawn.",
         {.slack = EdgeSlack::OfDistance}},
        {"slack-of-a-hundredth",
         testQuestion,
         "Weights are tested by ≥ −0.01 in place of ≥ 0.",
         {.slack = EdgeSlack::OfWeight}},
        {"row-ends-outside",
         loopQuestion,
         "A row is left at its first sample that is outside: break in place of continue.",
         {.outside = OutsideSample::EndsRow}},
        {"functions-not-set-back",
         loopQuestion,
         "What edge functions are stepped by along a row is not taken back before the next row.",
         {.place = TestedPlace::NotSetBack}},
        {"steps-exchanged",
         loopQuestion,
         "Along a row edge functions are stepped by what belongs to a row more, and from row to "
         "row by what belongs to a column.",
         {.place = TestedPlace::StepsExchanged}},
        {"functions-from-box-corner",
         loopQuestion,
         "Edge functions begin at the corner (x_min, y_min) itself, not at the box' first sample.",
         {.place = TestedPlace::FromBoxCorner}},
        {"edge-functions-cut",
         numberQuestion,
         "Edge functions and twice the area are cast to whole numbers.",
         {.function = EdgeFunctionForm::Cut}},
        {"edge-functions-floored",
         numberQuestion,
         "Edge functions and twice the area are rounded down to whole numbers, as by // in Python.",
         {.function = EdgeFunctionForm::Floored}},
        {"edge-products-cut",
         numberQuestion,
         "The two products of an edge function are each cast to whole numbers.",
         {.function = EdgeFunctionForm::ProductsCut}},
        {"edge-coefficients-cut",
         numberQuestion,
         "a, b and c of a·x + b·y + c are cast to whole numbers.",
         {.function = EdgeFunctionForm::CoefficientsCut}},
        {"edge-products-added",
         functionQuestion,
         "The two products of an edge function are added, not subtracted.",
         {.function = EdgeFunctionForm::ProductsAdded}},
    };
    return rows;
}

const Rows &weightRows()
{
    static const Rows rows = {
        {"weights-not-divided",
         weightQuestion,
         "Edge functions are taken for weights: they are not divided by twice the area.",
         {.divisor = WeightDivisor::Nothing}},
        {"weights-doubled",
         weightQuestion,
         "Edge functions are divided by the area in place of twice the area: weights and colours "
         "are doubled.",
         {.divisor = WeightDivisor::Area}},
        {"weights-whole",
         numberQuestion,
         "Weights are divided as whole numbers: each is 0 but at its own vertex.",
         {.keptWeight = KeptWeight::Whole}},
        {"products-cut",
         numberQuestion,
         "Each product of a weight and a level is cast to a whole number before the three are "
         "added.",
         {.product = WeightedProduct::Cut}},
        {"products-rounded",
         numberQuestion,
         "Each product of a weight and a level is rounded before the three are added.",
         {.product = WeightedProduct::Rounded}},
    };
    return rows;
}

void append(std::vector<Defect> &defects, const QString &id, const char *forStudent,
            const QString &forAssistant, const EdgeTestBugs &bugs)
{
    defects.push_back(
        redrawnBy(redrawingByTests(bugs), {id, QString::fromUtf8(forStudent), forAssistant}));
    if (bugs.owner != EdgeOwner::OfRule)
        defects.back().choice = QString::fromLatin1(ruleChoice);
}

void append(std::vector<Defect> &defects, const Rows &rows)
{
    for (const EdgeTestRow &row : rows)
        append(defects, QString::fromLatin1(row.id), row.forStudent,
               QString::fromUtf8(row.forAssistant), row.bugs);
}

/// "from vertex 0 to vertex 1"
QString endsOf(std::size_t edge)
{
    return u"from vertex %1 to vertex %2"_s.arg(edge % 3).arg((edge + 1) % 3);
}

void appendOfEdge(std::vector<Defect> &defects, std::size_t edge)
{
    const QString name = u"edge-%1"_s.arg(edge);
    const QString opposite = QString::number((edge + 2) % 3);
    EdgeTestBugs bugs;
    bugs.questions[edge] = EdgeQuestion::Nothing;
    append(defects, name + u"-not-tested"_s, testQuestion,
           u"The edge %1 is not tested."_s.arg(endsOf(edge)), bugs);
    bugs.questions[edge] = EdgeQuestion::IsOutside;
    append(defects, name + u"-tested-outside"_s, testQuestion,
           u"The edge %1 is tested with the wrong sign: ≤ 0 in place of ≥ 0."_s.arg(endsOf(edge)),
           bugs);
    bugs = {};
    bugs.values[edge] = EdgeValue::Negated;
    append(defects, name + u"-negated"_s, testQuestion,
           u"The edge function %1 has the wrong sign, in the test and in the weight "
           "of vertex %2."_s.arg(endsOf(edge), opposite),
           bugs);
    for (const std::size_t other : {std::size_t(0), std::size_t(1), std::size_t(2)}) {
        if (other == edge)
            continue;
        bugs.values[edge] = other == (edge + 1) % 3 ? EdgeValue::OfNext : EdgeValue::OfPrevious;
        append(defects, name + u"-is-edge-%1"_s.arg(other), functionQuestion,
               u"In place of the edge function %1 that %2 is computed again, for the "
               "test and for the weight of vertex %3."_s.arg(endsOf(edge), endsOf(other), opposite),
               bugs);
    }
}

void appendOfWeight(std::vector<Defect> &defects, std::size_t vertex)
{
    const auto add = [&](const QString &id, const QString &what, WeightForm form) {
        EdgeTestBugs bugs;
        bugs.weights[vertex] = form;
        append(defects, u"weight-%1"_s.arg(vertex) + id, weightQuestion,
               u"The weight of vertex %1 "_s.arg(vertex) + what, bugs);
    };
    add(u"-missing"_s, u"times its colour is not added."_s, WeightForm::Missing);
    for (const std::size_t other : {std::size_t(0), std::size_t(1), std::size_t(2)}) {
        if (other == vertex)
            continue;
        const std::size_t third = 3 - vertex - other;
        const bool isNext = other == (vertex + 1) % 3;
        add(u"-is-weight-%1"_s.arg(other), u"is that of vertex %1 again."_s.arg(other),
            isNext ? WeightForm::OfNext : WeightForm::OfPrevious);
        add(u"-adds-weight-%1"_s.arg(other),
            u"is 1 minus that of vertex %1, plus that of vertex %2, not minus it."_s.arg(third).arg(
                other),
            isNext ? WeightForm::AddsNext : WeightForm::AddsPrevious);
        add(u"-leaves-weight-%1"_s.arg(other),
            u"is 1 minus that of vertex %1 alone: that of vertex %2 is not "
            "subtracted."_s.arg(third)
                .arg(other),
            isNext ? WeightForm::LeavesNext : WeightForm::LeavesPrevious);
    }
}

} // namespace

bool leavesShort(const Scene &scene)
{
    for (const Triangle &triangle : scene.triangles) {
        const auto [least, greatest] = boundingCornersOf(triangle);
        const Int128 area = Int128(greatest.x - least.x) * (greatest.y - least.y);
        if (area >= (Int128(1) << 15) * unitsPerPixel * unitsPerPixel)
            return true;
    }
    return false;
}

std::vector<Defect> edgeTestDefectsFor(const Scene &scene)
{
    std::vector<Defect> defects;
    for (std::size_t edge = 0; edge < 3; ++edge)
        appendOfEdge(defects, edge);
    append(defects, testRows());
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        appendOfWeight(defects, vertex);
    append(defects, weightRows());
    if (!leavesShort(scene))
        return defects;
    append(defects, u"edge-products-in-16-bits"_s, widthQuestion,
           u"The two products of an edge function are each kept in 16 bits: beyond "
           "±32,767 they wrap before they are subtracted."_s,
           {.function = EdgeFunctionForm::ProductsInShort});
    append(defects, u"edge-functions-in-16-bits"_s, widthQuestion,
           u"Edge functions are kept in 16 bits: beyond ±32,767 they wrap, and "
           "large triangles fall apart."_s,
           {.function = EdgeFunctionForm::InShort});
    return defects;
}

} // namespace pixelplumb
