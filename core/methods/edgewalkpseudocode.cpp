// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/edgewalknames.h"
#include "core/methods/pseudocode.h"

/// The listings of the walks between two edges. A test runs every line: L_ij is the current short
/// edge, whose digits take the place of i and j; y becomes R, and m δR, where R is done "likewise".
namespace pixelplumb {

namespace {

using enum Moment;

/// The listing of one form, line by line.
class Listing {
public:
    explicit Listing(const EdgeWalkForm &form)
        : m_form(form)
        , m_names(form)
    {
    }

    Pseudocode written()
    {
        addSetUp();
        add(0, QStringLiteral("for each {span} {c} from %1:").arg(spans(FillRule::Closed)),
            everySpan);
        addRules([this](FillRule rule, FrameOrigin origin) {
            return QStringLiteral("for each {span} {c} from %1:").arg(spans(rule, origin));
        });
        addBounds();
        addSamples();
        for (PseudocodeLine &line : m_code) {
            line.text = m_names.filled(line.text);
            for (VariedLine &varied : line.varied)
                varied.text = m_names.filled(varied.text);
            for (RuledLine &ruled : line.ruled)
                ruled.text = m_names.filled(ruled.text);
        }
        return std::move(m_code);
    }

private:
    const std::vector<Moment> everySpan = {Begin, TakeOver, Span};

    bool isRow() const { return m_form.axis == SpanAxis::Row; }
    bool isDirect() const { return m_form.walk == WalkForm::Direct; }

    void add(int depth, const QString &text, const std::vector<Moment> &moments,
             LineOf of = LineOf::EveryPrimitive)
    {
        m_code.push_back({.depth = depth, .text = text, .moments = moments, .of = of});
    }
    /// What the last line says under the rules that are not closed.
    template <class Text>
    void addRules(const Text &text)
    {
        for (const FillRule rule : {FillRule::HalfOpenColumn, FillRule::TopLeft, FillRule::Open})
            for (const FrameOrigin origin : {FrameOrigin::BottomLeft, FrameOrigin::TopLeft})
                m_code.back().ruled.push_back({rule, text(rule, origin), origin});
    }
    void addVaried(int depth, const QString &text, const std::vector<Moment> &moments,
                   const std::vector<VariedLine> &varied, LineOf of = LineOf::EveryPrimitive)
    {
        add(depth, text, moments, of);
        m_code.back().varied = varied;
    }

    void addSetUp()
    {
        const QString sorted = isRow()
            ? QStringLiteral("sort the vertices by y, the largest first: P₀, P₁, P₂")
            : QStringLiteral("sort the vertices by x: P₀, P₁, P₂");
        addVaried(0, sorted, {SetUp},
                  {{VariantSet().with(Variant::UnsortedColours),
                    sorted + QStringLiteral("; R, G, B stay in the order given")}});
        if (isDirect())
            addDirectSlopes();
        else
            addSlopes();
        if (m_form.rate == ColourRate::Plane)
            addPlane();
        add(0, QStringLiteral("if no sample is to be drawn: done"), {Rejected});
    }

    /// What each span adds along the edges.
    void addSlopes()
    {
        const VariantSet minus = VariantSet().with(Variant::DivisorMinusOne),
                         plus = VariantSet().with(Variant::DivisorPlusOne);
        const auto text = [this](const QString &change, const QString &less) {
            return slope(change, less) + QStringLiteral("; δR_ij, δG_ij and δB_ij likewise");
        };
        addVaried(0, text({}, {}), {SetUp},
                  {{minus, text(QStringLiteral(" − 1"), QStringLiteral(" − 1"))},
                   {plus, text(QStringLiteral(" + 1"), {})},
                   {VariantSet{minus.bits | plus.bits}, text({}, {})}});
    }
    /// The divisor may be changed, and what it must exceed.
    QString slope(const QString &change, const QString &less) const
    {
        const QString width = isRow() ? QStringLiteral("y_i − y_j") : QStringLiteral("x_j − x_i");
        const QString exists = isRow() ? QStringLiteral("y_j < y_i") : QStringLiteral("x_i < x_j");
        return QStringLiteral("for each edge L_ij of L₀₁, L₁₂, L₀₂: m_ij ← ({a}_j − {a}_i)/(%1) if "
                              "%2, else 0")
            .arg(width + change, exists + less);
    }
    /// β is half the distance between the values that y can have, or a quarter between levels.
    void addDirectSlopes()
    {
        add(0,
            slope({}, {})
                + QStringLiteral("; β_ij ← 1/(2·256²·(x_j − x_i)) if x_i < x_j, else 1/(2·256)"),
            {SetUp});
        add(0,
            QStringLiteral("β_C ← 1/(4·256·(x₂ − x₀)) if x₀ < x₂, else 1/(4·256·(y₂ − y₀)) if "
                           "y₀ < y₂, else 0"),
            {SetUp}, LineOf::Segment);
    }

    /// The changes of the colours in the plane through the vertices. A is a number of the set-up.
    void addPlane()
    {
        const auto change = [this](QChar axis) {
            return planeSlope(axis, QStringLiteral("A")).replace(u'%', u'R');
        };
        const QChar along = isRow() ? u'x' : u'y';
        add(0,
            QStringLiteral("ΔR ← %1; ΔG and ΔB likewise — in the plane through the vertices; A is "
                           "twice the area")
                .arg(change(along)),
            {SetUp}, LineOf::Area);
        if (isDirect())
            add(0,
                QStringLiteral("ΔR_x ← %1; ΔG_x and ΔB_x likewise; β_C ← 1/(4·256²·|A|)")
                    .arg(change(u'x')),
                {SetUp}, LineOf::Area);
    }

    /// "⌈x₀⌉ to ⌊x₂⌋": the spans that the rule takes. Rows go from the largest y down.
    QString spans(FillRule rule, FrameOrigin origin = FrameOrigin::BottomLeft) const
    {
        const bool isTopDown
            = isRow() && origin == FrameOrigin::TopLeft && rule == FillRule::TopLeft;
        const bool ownsFirst = rule != FillRule::Open && !isTopDown;
        const bool ownsLast = rule == FillRule::Closed || isTopDown;
        if (isRow())
            return (ownsFirst ? QStringLiteral("⌊y₀⌋") : QStringLiteral("⌈y₀⌉ − 1"))
                + QStringLiteral(" down to ")
                + (ownsLast ? QStringLiteral("⌈y₂⌉") : QStringLiteral("⌊y₂⌋ + 1"));
        return (ownsFirst ? QStringLiteral("⌈x₀⌉") : QStringLiteral("⌊x₀⌋ + 1"))
            + QStringLiteral(" to ")
            + (ownsLast ? QStringLiteral("⌊x₂⌋") : QStringLiteral("⌈x₂⌉ − 1"));
    }

    /// How far the span is from a vertex, which is 0 or a digit or i.
    QString way(const QString &vertex) const
    {
        return (isRow() ? QStringLiteral("({c}%1 − {c})") : QStringLiteral("({c} − {c}%1)"))
            .arg(vertex);
    }
    QString fromVertex(const QString &edge, const QString &vertex, const QString &way) const
    {
        return QStringLiteral("{a}%1 ← {a}%2 + %3·m%1").arg(edge, vertex, way)
            + (isDirect() ? QString() : QStringLiteral("; R, G and B likewise"));
    }

    void addBounds()
    {
        const QString shortEdge = (isRow() ? QStringLiteral("L_ij ← L₀₁ if y > y₁, else L₁₂")
                                           : QStringLiteral("L_ij ← L₀₁ if x < x₁, else L₁₂"));
        const QString longEdge = QStringLiteral("₀₂"), either = QStringLiteral("_ij");
        const auto begun = [this](const QString &edge, const QString &vertex) {
            return fromVertex(edge, vertex, way(vertex));
        };
        if (isDirect()) {
            add(1, begun(longEdge, QStringLiteral("₀")), everySpan);
            add(1, shortEdge, everySpan, LineOf::Area);
            add(1, begun(either, QStringLiteral("_i")), everySpan, LineOf::Area);
        } else {
            addBeginning(QStringLiteral("the first: "), longEdge, QStringLiteral("₀"), {Begin},
                         LineOf::EveryPrimitive);
            add(1, added(longEdge), {TakeOver, Span});
            add(1, shortEdge, everySpan, LineOf::Area);
            addBeginning(QStringLiteral("where it begins: "), either, QStringLiteral("_i"),
                         {Begin, TakeOver}, LineOf::Area);
            add(1, added(either), {Span}, LineOf::Area);
        }
        addOrder();
    }
    QString added(const QString &edge) const
    {
        return QStringLiteral("else: {a}%1 ← {a}%1 + m%1; R, G and B likewise").arg(edge);
    }
    /// Adds the line for an edge's first span; without a pre-step it starts as if its vertex were
    /// on a span.
    void addBeginning(const QString &where, const QString &edge, const QString &vertex,
                      const std::vector<Moment> &moments, LineOf of)
    {
        const QString whole
            = isRow() ? QStringLiteral("(⌊y%1⌋ − y)") : QStringLiteral("(x − ⌈x%1⌉)");
        addVaried(1, where + fromVertex(edge, vertex, way(vertex)), moments,
                  {{VariantSet().with(Variant::NoEdgePreStep),
                    where + fromVertex(edge, vertex, whole.arg(vertex))}},
                  of);
    }

    /// Tells the two bounds apart. Only the closed rule draws where rounding or a variant takes the
    /// edges past each other.
    void addOrder()
    {
        const QString alike = isDirect() ? QString() : QStringLiteral("; R, G and B likewise");
        const auto ordered = [&](const QString &condition) {
            return QStringLiteral("{a}_{lo}, {a}_{hi} ← {a}_ij, {a}₀₂ if %1, else {a}₀₂, {a}_ij")
                       .arg(condition)
                + alike;
        };
        const QString compared = QStringLiteral("{a}_ij ≤ {a}₀₂");
        const QString area
            = QStringLiteral(" — A is twice the area, above 0 where L₀₂ has the larger {a}");
        add(1, ordered(compared), everySpan, LineOf::Area);
        for (const Variant variant :
             {Variant::NoEdgePreStep, Variant::DivisorMinusOne, Variant::DivisorPlusOne})
            m_code.back().varied.push_back(
                {VariantSet().with(variant),
                 ordered(QStringLiteral("{a}_ij < {a}₀₂, or {a}_ij = {a}₀₂ and A > 0")) + area});
        addRules([&](FillRule, FrameOrigin) { return ordered(QStringLiteral("A > 0")) + area; });
        add(1,
            QStringLiteral("{a}_{lo}, {a}_{hi} ← {a}₀, {a}₂ if {c}₀ = {c}₂, else {a}₀₂, {a}₀₂")
                + alike,
            everySpan, LineOf::Segment);
        if (!isDirect())
            return;
        add(1, QStringLiteral("β_B, β_T ← β_ij, β₀₂ if %1, else β₀₂, β_ij").arg(compared),
            everySpan, LineOf::Area);
        add(1, QStringLiteral("β_B, β_T ← β₀₂, β₀₂"), everySpan, LineOf::Segment);
    }

    void addSamples()
    {
        const LineOf hasRate
            = m_form.rate == ColourRate::Plane ? LineOf::Segment : LineOf::EveryPrimitive;
        if (!isDirect())
            add(1,
                QStringLiteral("ΔR ← (R_{hi} − R_{lo})/({a}_{hi} − {a}_{lo}) if {a}_{lo} < "
                               "{a}_{hi}, else 0; ΔG and ΔB likewise"),
                everySpan, hasRate);
        add(1, QStringLiteral("for each {across} {a} from %1:").arg(samples(FillRule::Closed)),
            {First, Next});
        addRules([this](FillRule rule, FrameOrigin) {
            return QStringLiteral("for each {across} {a} from %1:").arg(samples(rule));
        });
        if (isDirect()) {
            add(2, QStringLiteral("R ← R₀ + (x − x₀)·ΔR_x + (y − y₀)·ΔR; G and B likewise"),
                {First, Next}, LineOf::Area);
            add(2,
                QStringLiteral("R ← R₀ + (R₂ − R₀)·(x − x₀)/(x₂ − x₀) if x₀ < x₂, else R₀ + (R₂ − "
                               "R₀)·(y − y₀)/(y₂ − y₀) if y₀ < y₂, else R₀; G and B likewise"),
                {First, Next}, LineOf::Segment);
            add(2,
                QStringLiteral("pixel (x, y) ← the bytes of R + β_C, G + β_C, B + β_C — β_C: so "
                               "that no rounding takes a half away"),
                {First, Next});
            return;
        }
        addVaried(2,
                  QStringLiteral("the first: R ← R_{lo} + ({a} − {a}_{lo})·ΔR; G and B likewise"),
                  {First},
                  {{VariantSet().with(Variant::NoColourPreStep),
                    QStringLiteral("the first: R ← R_{lo}; G and B likewise")}});
        add(2, QStringLiteral("else: R ← R + ΔR; G and B likewise"), {Next});
        add(2, QStringLiteral("pixel (x, y) ← the bytes of R, G, B"), {First, Next});
    }

    /// "⌈y_B⌉ to ⌊y_T⌋": the samples that the rule takes, each bound moved by its bias.
    QString samples(FillRule rule) const
    {
        const Interval interval = columnIntervals(rule).rows;
        return m_names.biased(m_names.coveredSample(SpanBound::Lower, interval))
            + QStringLiteral(" to ")
            + m_names.biased(m_names.coveredSample(SpanBound::Upper, interval));
    }

    EdgeWalkForm m_form;
    EdgeWalkNames m_names;
    Pseudocode m_code;
};

} // namespace

Pseudocode edgeWalkPseudocode(const EdgeWalkForm &form) { return Listing(form).written(); }

} // namespace pixelplumb
