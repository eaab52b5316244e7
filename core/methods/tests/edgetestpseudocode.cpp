// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framenames.h"
#include "core/methods/tests/edgetestnames.h"
#include "core/methods/tests/edgetestnumbers.h"
#include "core/methods/words/pseudocode.h"
#include "core/scan/tests/edgetestsetup.h"

#include <QStringList>

/// The listings of the methods that test samples. A test runs every line: the names are those of
/// the numbers' tables, and what is done to one edge, weight or channel is done to the others
/// "likewise".
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
        if (m_form.inside == InsideTest::Cramer) {
            add(0, "x_AC, y_AC, x_BC, y_BC ← x_A − x_C, y_A − y_C, x_B − x_C, y_B − y_C", {SetUp});
            add(0, "D ← x_AC·y_BC − x_BC·y_AC — the determinant", {SetUp});
        } else {
            addLines();
        }
        addTies();
        addBox();
        addOfSegment(0, "sort the vertices by x, those of equal x by y: P_l, P_m, P_r", {SetUp});
        add(0, "if no sample is to be drawn: done", {Rejected});
    }

    /// The equations of the edges, and their values at the opposite vertices.
    void addLines()
    {
        const auto addAlike = [this](const QString &pattern, const QString &name) {
            add(0, alike(pattern, name), {SetUp});
        };
        if (m_form.line == LineForm::Solved)
            addAlike("q{l} ← x{from}·y{to} − y{from}·x{to}", "q{l}");
        const QString named = "{value}: " + m_names.coefficients("%{l}");
        addAlike(named + u" ← "_s + m_names.coefficientsText(), "{value}");
        if (m_form.line == LineForm::CanonicalEnd)
            addAlike("{value}: u{l}, v{l} ← x{from}, y{from} if x{from} < x{to}, or x{from} = "
                     "x{to} and y{from} < y{to}, else x{to}, y{to}",
                     "{value}");
        const QString opposite = m_names.lineAt("x{opp}", "y{opp}");
        if (m_form.isBarycentric()) {
            addAlike(u"f{opp} ← "_s + opposite, "f{opp}");
            if (m_form.evaluation == Evaluation::Increments)
                addIncrements();
            return;
        }
        addAlike(u"sidedness{l} ← "_s + opposite, "sidedness{l}");
        addAlike("s{l} ← −1 if sidedness{l} < 0, else 1", "s{l}");
        const QString turned = m_names.coefficients("s{l}·%{l}");
        addAlike(u"%1, F{l} ← %2, s{l}·sidedness{l}"_s.arg(named, turned), "{value}");
    }

    /// The samples to visit.
    void addBox()
    {
        if (m_form.visited == VisitedSamples::Frame)
            return add(0, "box ← the whole frame", {SetUp});
        const QString x = u"(%1)"_s.arg(three(m_form.isBarycentric() ? "x{opp}" : "x{from}"));
        const QString box = "box ← x from %1 to %2, y likewise, clipped to the frame";
        add(0, box.arg(u"⌈min%1⌉"_s.arg(x), u"⌊max%1⌋"_s.arg(x)), {SetUp});
        const QString rounded = box.arg(u"(int)(min%1 + ½)"_s.arg(x), u"(int)(max%1 − ½)"_s.arg(x));
        m_code.back().varied
            = {{VariantSet().with(Variant::RoundedBox), rounded + u" — x and y of the scene"_s}};
    }

    /// What a step along x and one along y add to weights and levels.
    void addIncrements()
    {
        const QString level = "ΔR_%1 ← Δα_%1·R_a + Δβ_%1·R_b + Δγ_%1·R_c; ΔG_%1 and ΔB_%1 likewise";
        addOfArea(0, "Δα_x ← a_bc/f_a; Δβ_x and Δγ_x likewise", {SetUp});
        addOfArea(0, level.arg("x"), {SetUp});
        addOfArea(0, "Δα_y ← b_bc/f_a; Δβ_y and Δγ_y likewise", {SetUp});
        addOfArea(0, level.arg("y"), {SetUp});
    }

    /// Says which edges give the triangle a sample exactly on them; under the closed and the open
    /// rule all are alike.
    void addTies()
    {
        const auto addForPoint = [this](const QString &text) {
            add(0, {}, {SetUp});
            m_code.back().ruled = {{FillRule::OffScreenPoint, text}};
        };
        addForPoint("given: x_r, y_r of the off-screen point r");
        for (std::size_t line = 0; line < 3; ++line) {
            const QString value = u"{value}(r) ← "_s + m_names.valueAt(line, "x_r", "y_r");
            if (m_form.inside == InsideTest::Cramer)
                addForPoint(m_names.filled(value, line));
            else if (line == 0)
                addForPoint(alike(value, "{value}(r)"));
        }
        add(0, {}, {SetUp});
        const QString tie = "tie{l} ← 1 if %1, else 0";
        for (const FillRule rule :
             {FillRule::OffScreenPoint, FillRule::HalfOpenColumn, FillRule::TopLeft}) {
            for (const FrameOrigin origin : allFrameOrigins) {
                const QString ties = alike(tie.arg(m_names.tieCondition(rule, origin)), "tie{l}");
                m_code.back().ruled.push_back(
                    {rule, ties + EdgeTestNames::tieRemark(rule), origin});
            }
        }
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
        addStart();
        add(0, u"for each %1 of the box:"_s.arg(m_across), {Begin, Span});
        const QString back
            = "%1 ← %2 — back at the " + (isRowByRow() ? u"row's start"_s : u"column's start"_s);
        addOfArea(1, back.arg(walked(), kept()), {Begin, Span});
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
            within += u", or %1 = 0 and tie{l} = 1"_s.arg(name);
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
