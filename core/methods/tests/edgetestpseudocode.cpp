// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/tests/edgetestnames.h"
#include "core/methods/tests/edgetestnumbers.h"
#include "core/methods/words/pseudocode.h"
#include "core/scan/tests/edgetestsetup.h"

#include <QStringList>

/// The listings of the methods that test samples. A test runs every line from the box on: the names
/// are those of the numbers' tables, and what is done to one edge, weight or channel is done to the
/// others "likewise".
namespace pixelplumb {

namespace {

using enum Moment;

/// The listing of one form, line by line.
class Listing {
public:
    explicit Listing(const EdgeTestForm &form)
        : m_form(form)
        , m_names(form)
        , m_along(isRowByRow() ? u'x' : u'y')
        , m_across(isRowByRow() ? u'y' : u'x')
    {
    }

    Pseudocode written()
    {
        addSetUp();
        if (m_form.evaluation == Evaluation::Increments)
            addIncrementalLoops();
        else
            addLoops();
        return std::move(m_code);
    }

private:
    bool isRowByRow() const { return m_form.order == LoopOrder::RowByRow; }

    void add(int depth, const QString &text, const std::vector<Moment> &moments,
             LineOf of = LineOf::EveryPrimitive)
    {
        m_code.push_back({.depth = depth, .text = text, .moments = moments, .of = of});
    }
    /// Adds a line that runs where the edges decide.
    void addOfArea(int depth, const QString &text, const std::vector<Moment> &moments)
    {
        add(depth, text, moments, LineOf::Area);
    }
    /// Adds a line for a triangle without area, which only the closed rule draws.
    void addOfSegment(int depth, const QString &text, const std::vector<Moment> &moments)
    {
        add(depth, text, moments, LineOf::Segment);
        for (const FillRule rule : allFillRules) {
            if (rule != FillRule::Closed)
                m_code.back().ruled.push_back({rule, {}});
        }
    }

    /// What is done for line 0, and likewise for the two others.
    QString alike(const QString &pattern, const QString &name) const
    {
        return m_names.filled(pattern, 0)
            + u"; %1 and %2 likewise"_s.arg(m_names.filled(name, 1), m_names.filled(name, 2));
    }
    /// "E₀, E₁, E₂".
    QString three(const QString &pattern) const
    {
        QStringList each;
        for (std::size_t line = 0; line < 3; ++line)
            each.append(m_names.filled(pattern, line));
        return each.join(u", "_s);
    }
    /// The numbers that increments reach: "α, β, γ, R, G, B".
    QString stepped(const QString &weight, const QString &level) const
    {
        QStringList each = {three(weight)};
        for (const QChar channel : channelLetters)
            each.append(QString(level).replace(u'%', channel));
        return each.join(u", "_s);
    }

    void addSetUp()
    {
        add(0, m_names.linesText(), {SetUp});
        if (m_form.inside == InsideTest::Signs) {
            add(0,
                "sidedness₀, sidedness₁, sidedness₂ ← E₀, E₁, E₂ at P₂, P₀, P₁ — the vertex "
                "opposite",
                {SetUp});
            add(0,
                "s ← 1; where sidedness < 0: s ← −1, and a, b, c of that edge change their signs; "
                "F ← s·sidedness",
                {SetUp});
        } else if (m_form.inside != InsideTest::Cramer) {
            add(0, "f_a, f_b, f_c ← f_bc at a, f_ca at b, f_ab at c", {SetUp});
            if (m_form.evaluation == Evaluation::Increments)
                addIncrements();
        }
        addTies();
        if (m_form.visited == VisitedSamples::Frame) {
            add(0, "box ← the whole frame", {SetUp});
        } else {
            add(0,
                "box ← from the smallest to the largest x and y of the vertices, clipped to the "
                "frame",
                {SetUp});
            m_code.back().varied = {{VariantSet().with(Variant::RoundedBox),
                                     "box ← from (int)(x_min + ½) to (int)(x_max − ½), y likewise, "
                                     "clipped to the frame"}};
        }
        addOfSegment(0, "sort the vertices by x, those of equal x by y: P_l, P_m, P_r", {SetUp});
        add(0, "if no sample is to be drawn: done", {Rejected});
    }

    /// What a step along x and one along y add to weights and levels.
    void addIncrements()
    {
        for (const auto &[axis, coefficient] :
             {std::pair(QChar(u'x'), QChar(u'a')), std::pair(QChar(u'y'), QChar(u'b'))}) {
            addOfArea(0,
                      u"Δα_%1 ← %2_bc/f_a; Δβ_%1 and Δγ_%1 likewise"_s.arg(axis).arg(coefficient),
                      {SetUp});
            addOfArea(
                0,
                u"ΔR_%1 ← Δα_%1·R_a + Δβ_%1·R_b + Δγ_%1·R_c; ΔG_%1 and ΔB_%1 likewise"_s.arg(axis),
                {SetUp});
        }
    }

    /// Says which edges give the triangle a sample exactly on them.
    void addTies()
    {
        add(0, tiesText(FillRule::Closed), {SetUp});
        for (const FillRule rule : allFillRules)
            m_code.back().ruled.push_back({rule, tiesText(rule)});
    }

    QString tiesText(FillRule rule) const
    {
        const QString tie = "tie{l}";
        if (rule == FillRule::OffScreenPoint)
            return alike(u"tie{l} ← 1 if %1, else 0"_s.arg(m_names.tieText(rule)), tie);
        return three(tie) + u" ← "_s + ownersText(rule);
    }

    void addLoops()
    {
        add(0, u"for each %1 of the box:"_s.arg(m_across), {Begin, Span});
        add(1, u"for each %1 of the box:"_s.arg(m_along), {First, Next, Refused});
        addValues();
        addTest();
        addOfArea(3, colourText(), {First, Next});
        addPixel();
    }

    /// Like currEELS next to currEE on the slide: the numbers at a line's start are kept, and the
    /// next line starts from them.
    void addIncrementalLoops()
    {
        const QString start = isRowByRow() ? u"row"_s : u"column"_s;
        addStart();
        add(0, u"for each %1 of the box:"_s.arg(m_across), {Begin, Span});
        addOfArea(1, u"%1 ← %2 — back at the %3's start"_s.arg(walked(), kept(), start),
                  {Begin, Span});
        add(1, u"for each %1 of the box:"_s.arg(m_along), {First, Next, Refused});
        addTest();
        if (!m_form.isBarycentric())
            addOfArea(3, colourText(), {First, Next});
        addPixel();
        addOfArea(2, u"add %1 to %2"_s.arg(changes(m_along), walked()), {First, Next, Refused});
        addOfArea(1, u"add %1 to %2"_s.arg(changes(m_across), kept()), {Span});
    }

    QString walked() const { return m_form.isBarycentric() ? stepped("{w}", "%") : three("E{l}"); }
    QString kept() const
    {
        return m_form.isBarycentric() ? stepped("{w}_s", "%_s") : three("e{l}");
    }
    /// What one step along an axis adds.
    QString changes(const QString &axis) const
    {
        if (m_form.isBarycentric())
            return stepped(u"Δ{w}_"_s + axis, u"Δ%_"_s + axis);
        return three(axis == u"x"_s ? u"a{l}"_s : u"b{l}"_s);
    }

    /// Evaluates at the box's first sample.
    void addStart()
    {
        const QString value = m_names.lineAt("x_min", "y_min");
        if (!m_form.isBarycentric()) {
            addOfArea(0, alike(u"e{l} ← "_s + value, "e{l}"), {Begin});
            return;
        }
        addOfArea(0, alike(u"{w}_s ← (%1)/f{opp}"_s.arg(value), "{w}_s"), {Begin});
        addOfArea(0, "R_s ← α_s·R_a + β_s·R_b + γ_s·R_c; G_s and B_s likewise", {Begin});
    }

    void addValues()
    {
        const std::vector<Moment> samples = {First, Next, Refused};
        if (m_form.inside == InsideTest::Cramer) {
            for (std::size_t line = 0; line < 3; ++line)
                addOfArea(2, m_names.weightFormula(line).replace(u" = "_s, u" ← "_s), samples);
            return;
        }
        const QString value = m_names.lineAt("x", "y");
        addOfArea(2, alike(u"{value} ← "_s + value, "{value}"), samples);
        if (m_form.isBarycentric())
            addOfArea(2, alike("{w} ← {value}/f{opp}", "{w}"), samples);
    }

    void addTest()
    {
        addOfArea(2, testText(FillRule::Closed), {First, Next, Refused});
        for (const FillRule rule : allFillRules)
            m_code.back().ruled.push_back({rule, testText(rule)});
    }

    /// The colour along a segment, and the pixel in either case.
    void addPixel()
    {
        addOfSegment(2,
                     "if x_l ≤ x ≤ x_r; (x_r − x_l)·(y − y_l) = (y_r − y_l)·(x − x_l); x_l < x_r, "
                     "or y_l ≤ y ≤ y_r: — the segment passes through (x, y)",
                     {First, Next, Refused});
        addOfSegment(
            3,
            "R ← (R_l·(x_r − x_l) + (R_r − R_l)·(x − x_l))/(x_r − x_l) if x_l < x_r, else "
            "(R_l·(y_r − y_l) + (R_r − R_l)·(y − y_l))/(y_r − y_l) if y_l < y_r, else R_l; "
            "G and B likewise",
            {First, Next});
        add(3, "pixel (x, y) ← the bytes of R, G, B", {First, Next});
    }

    QString colourText() const
    {
        return m_names.levelFormula().replace(u'%', u'R').replace(u" = "_s, u" ← "_s)
            + u"; G and B likewise"_s;
    }

    QString testText(FillRule rule) const
    {
        const bool decidesTies = rule != FillRule::Closed && rule != FillRule::Open;
        if (m_form.inside == InsideTest::Cramer)
            return m_names.cramerText(rule);
        const bool isBounded = m_form.inside == InsideTest::UnitInterval;
        const QString name = m_form.inside == InsideTest::Signs ? u"E{l}"_s : u"{w}"_s;
        const bool takesZero = rule == FillRule::Closed;
        QString within = name + (takesZero ? u" ≥ 0"_s : u" > 0"_s);
        if (isBounded)
            within = (takesZero ? u"0 ≤ "_s : u"0 < "_s) + name + u" ≤ 1"_s;
        if (decidesTies)
            within += u", or %1 = 0 and %2"_s.arg(name, m_names.tieText(rule));
        return u"if "_s + alike(within, name) + u':';
    }

    EdgeTestForm m_form;
    EdgeTestNames m_names;
    QString m_along, m_across; ///< the coordinate of the inner loop, and of the outer one
    Pseudocode m_code;
};

} // namespace

Pseudocode edgeTestPseudocode(const EdgeTestForm &form) { return Listing(form).written(); }

} // namespace pixelplumb
