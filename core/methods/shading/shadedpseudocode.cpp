// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/coefficientlines.h"
#include "core/methods/walklisting.h"

#include <algorithm>
#include <iterator>

/// The listing of a triangle with effects. What its lines name as given comes from elsewhere in the
/// program: texels, light, areas. A carried value v is one that changes over the triangle: its
/// lines are done for each, with its name in place of v.
namespace pixelplumb {

namespace {

using enum Moment;

/// Makes the lines of a form. Where vertices are not walked along, P₀, P₁ and P₂ stay as given, and
/// l, m and r are the sorted ones.
class ShadedListing {
public:
    ShadedListing(InterpolationForm form, WalkCoverage coverage)
        : m_form(form)
        , m_walk{.rate = isBilinear(form) ? ColourRate::Bilinear : ColourRate::Plane}
        , m_coverage(coverage)
    {
    }

    Pseudocode lines()
    {
        addGiven();
        addColour(LineOf::Area, "₀");
        addWalk([](WalkListing &walk) { walk.addSorting(); });
        addColour(LineOf::Segment, isBilinear(m_form) ? "₀" : "_l");
        addCarried();
        addWalk([](WalkListing &walk) { walk.addSlopes(); });
        add(0, "if no sample is to be drawn: done", {Rejected});
        addOneSample();
        addAreas();
        addSamples();
        return std::move(m_code);
    }

private:
    using Samplings = std::vector<Antialiasing>;
    static inline const Samplings one = {Antialiasing::None}, byArea = {Antialiasing::Area},
                                  several = {Antialiasing::Samples4, Antialiasing::Samples16};
    static inline const std::vector<Moment> everySpan = {Begin, TakeOver, Span},
                                            written = {First, Next},
                                            visited = {First, Next, Refused};

    PseudocodeLine &add(int depth, const QString &text, const std::vector<Moment> &moments,
                        LineOf of = LineOf::EveryPrimitive)
    {
        m_code.push_back({.depth = depth,
                          .text = text,
                          .moments = moments,
                          .antialiasing = m_samplings,
                          .of = of});
        return m_code.back();
    }
    void addFor(Effect effect, int depth, const QString &text,
                const std::vector<Moment> &moments = {SetUp}, LineOf of = LineOf::EveryPrimitive)
    {
        add(depth, text, moments, of).effect = effect;
    }
    template <class Write>
    void addWalk(const Write &write)
    {
        WalkListing walk(m_walk, m_coverage, WalkValues::Carried);
        write(walk);
        if (!isBilinear(m_form))
            walk.nameSortedVerticesByLetters();
        for (PseudocodeLine &line : walk.written()) {
            line.antialiasing = m_samplings;
            line.varied.clear(); // variants and effects exclude each other
            m_code.push_back(std::move(line));
        }
    }

    void addGiven()
    {
        addFor(Effect::Perspective, 0,
               "given: h, 1 where the vertices' w differ and something that they divide does, else "
               "0");
        addFor(Effect::Depth, 0,
               "given: level(z), z as the depth buffer keeps it: z, or ⌊z·(2ⁿ − 1) + ½⌋ within 0 … "
               "2ⁿ − 1; z_near, where no triangle is in front yet, is greater than all");
        addFor(Effect::Texture, 0, "given: texel(u, v), the texture's colour there");
        addFor(Effect::Light, 0,
               "given: light(R, G, B, N, p), the bytes of ambient and, of each light, the diffuse "
               "and specular term");
        m_samplings = byArea;
        add(0,
            "given: area(x, y), of the triangle in the pixel's square; share(a, x, y) = ⌊a·area + "
            "½⌋",
            {SetUp});
        add(0,
            "given: rows(x), the first and last row of the frame whose squares the triangle meets, "
            "and of those that lie in it",
            {SetUp});
        m_samplings = several;
        add(0,
            "given: edge(x, y), 1 where an edge of a triangle meets the pixel's square, else 0; "
            "way(k), from sample k − 1 of a pixel to sample k, and from its centre to sample 1",
            {SetUp});
        m_samplings.clear();
    }

    void addColour(LineOf of, const QString &first)
    {
        add(0, u"R, G, B, A ← R#, G#, B#, 255"_s.replace(u'#', first), {SetUp}, of);
        for (const auto &[effect, value] :
             {std::pair(Effect::Blending, u'A'), std::pair(Effect::Depth, u'z')})
            addFor(effect, 0, QString(QChar(value)) + u" ← "_s + QChar(value) + first, {SetUp}, of);
    }

    /// A value that is the same at all vertices is not carried, so that no rounding changes it.
    void addCarried()
    {
        const QString first = isBilinear(m_form) ? "₀" : "_l",
                      last = isBilinear(m_form) ? "₂" : "_r";
        const auto addIfUnequal = [&](Effect effect, const QStringList &names) {
            QStringList unequal, unequalEnds;
            for (const QString &name : names) {
                unequal += u"%₀ ≠ %₁, or %₁ ≠ %₂"_s.replace(u'%', name);
                for (const QChar axis : {u'x', u'y'})
                    unequalEnds += u"%# ≠ %& and @# ≠ @&"_s.replace(u'%', name)
                                       .replace(u'@', axis)
                                       .replace(u'#', first)
                                       .replace(u'&', last);
            }
            const QString carry = u": carry "_s + names.join(u", "_s);
            addFor(effect, 0, u"if "_s + unequal.join(u", or "_s) + carry, {SetUp}, LineOf::Area);
            addFor(effect, 0, u"if "_s + unequalEnds.join(u", or "_s) + carry, {SetUp},
                   LineOf::Segment);
        };
        addIfUnequal(Effect::SmoothColour, {u"R"_s, u"G"_s, u"B"_s});
        addIfUnequal(Effect::Blending, {u"A"_s});
        addIfUnequal(Effect::Depth, {u"z"_s});
        addFor(Effect::Texture, 0, "carry u, v");
        addFor(Effect::Light, 0, "carry N_x, N_y, N_z, p_x, p_y, p_z");
        addFor(Effect::Perspective, 0,
               isBilinear(m_form) ? u"q, q₀, q₁, q₂ ← 1, 1, 1, 1 — q is 1/w"_s
                                  : u"q, q₀, q₁, q₂, q_l, q_r ← 1, 1, 1, 1, 1, 1 — q is 1/w"_s);
        addFor(Effect::Perspective, 0, "if h = 1: carry q");
        addFor(Effect::Perspective, 0, "if h = 1:");
        const QString divided = "for each carried value v but z: ";
        const LineOf all = isBilinear(m_form) ? LineOf::EveryPrimitive : LineOf::Area;
        addFor(Effect::Perspective, 1, divided + u"v₀, v₁, v₂ ← v₀/w₀, v₁/w₁, v₂/w₂"_s, {SetUp},
               all);
        if (all == LineOf::Area)
            addFor(Effect::Perspective, 1, divided + u"v_l, v_r ← v_l/w_l, v_r/w_r"_s, {SetUp},
                   LineOf::Segment);
    }

    /// What is linear in x and y: each value itself, or the weights. Of a segment it goes along x,
    /// or along y where it is upright.
    void addCoefficients(int depth)
    {
        if (isBilinear(m_form))
            return;
        for (const QString &line : coefficientLines(m_form, u"each carried value v"_s))
            add(depth, line, {SetUp}, LineOf::Area);
        add(depth,
            "a_s, b_s, c_s ← 1/(x_r − x_l), 0, −x_l/(x_r − x_l) if x_l < x_r, else 0, 1/(y_r − "
            "y_l), "
            "−y_l/(y_r − y_l) if y_l < y_r, else 0, 0, 0",
            {SetUp}, LineOf::Segment);
        if (m_form == InterpolationForm::Plane)
            add(depth,
                "for each carried value v: a_v, b_v, c_v ← (v_r − v_l)·a_s, (v_r − v_l)·b_s, v_l "
                "+ (v_r − v_l)·c_s",
                {SetUp}, LineOf::Segment);
    }

    void addRates(int depth)
    {
        if (isBilinear(m_form))
            add(depth,
                "for each carried value v: Δv ← (v_T − v_B)/(y_T − y_B) if y_T ≠ y_B, else 0",
                everySpan);
    }

    /// Each value at a sample; in the bilinear form from the column's bound where a run of rows
    /// begins.
    void addValues(int depth, const QString &begins, const QString &goesOn)
    {
        if (isBilinear(m_form)) {
            add(depth, begins + u"for each carried value v: v_w ← v_B + (y − y_B)·Δv"_s, visited);
            add(depth, goesOn + u"for each carried value v: v_w ← v_w + Δv"_s, visited);
            add(depth, "for each carried value v: v ← v_w", visited);
        } else if (m_form == InterpolationForm::Plane) {
            add(depth, "for each carried value v: v ← a_v·x + b_v·y + c_v", visited);
        } else {
            add(depth, "α ← a_α·x + b_α·y + c_α; β and γ likewise", visited, LineOf::Area);
            add(depth, "for each carried value v: v ← α·v₀ + β·v₁ + γ·v₂", visited, LineOf::Area);
            add(depth, "α, β ← −a_s·x + −b_s·y + (1 − c_s), a_s·x + b_s·y + c_s", visited,
                LineOf::Segment);
            add(depth, "for each carried value v: v ← α·v_l + β·v_r", visited, LineOf::Segment);
        }
    }

    /// What the effects do at a sample, with the depths and the pixel that are the sample's.
    void addEffects(int depth, const QString &near, const QString &pixel)
    {
        addFor(Effect::Depth, depth, "z_level ← level(z)", visited);
        addFor(Effect::Depth, depth, u"if z_level > %1: on to the next row"_s.arg(near), visited);
        addFor(Effect::Depth, depth, near + u" ← z_level"_s, written);
        addFor(Effect::Perspective, depth, "for each carried value v but z and q: v ← v/q",
               written);
        add(depth, "R_s, G_s, B_s ← the bytes of R, G, B", written);
        addFor(Effect::Texture, depth, "R_t, G_t, B_t ← texel(u, v)", written);
        addFor(Effect::Texture, depth, "R_s ← ⌊R_s·R_t/255 + ½⌋; G_s and B_s likewise", written);
        addFor(Effect::Light, depth,
               "R_s, G_s, B_s ← light(R_s, G_s, B_s, N_x, N_y, N_z, p_x, p_y, p_z)", written);
        const QString under = u"R_d, G_d, B_d ← "_s + pixel,
                      blended = "R_s ← ⌊(R_s·a + R_d·(255 − a))/255 + ½⌋; G_s and B_s likewise";
        if (m_samplings == byArea) {
            add(depth, "a ← the byte of A", written);
            add(depth, "a ← share(a, x, y)", written);
            add(depth, under, written);
            add(depth, blended, written);
            return;
        }
        for (const QString &line : {u"a ← the byte of A"_s, under, blended})
            addFor(Effect::Blending, depth, line, written);
    }

    void addOneSample()
    {
        m_samplings = one;
        const auto first = std::ptrdiff_t(m_code.size());
        addCoefficients(0);
        addWalk([](WalkListing &walk) { walk.addSpans(); });
        addRates(1);
        addWalk([](WalkListing &walk) { walk.addSamples(); });
        addValues(2, "the first: ", "else: ");
        addEffects(2, "z_near[x, y]", "pixel (x, y)");
        add(2, pixelLine, written);
        // A segment has no area.
        for (PseudocodeLine line :
             linesOf(LineOf::Segment, {m_code.begin() + first, m_code.end()})) {
            line.of = LineOf::Segment;
            line.antialiasing = byArea;
            m_code.push_back(std::move(line));
        }
    }

    /// The parts of pixels: what has no sample in the triangle has the values of its plane.
    void addAreas()
    {
        m_samplings = byArea;
        const auto first = m_code.size();
        addCoefficients(0);
        add(0, "for each column x of the frame from ⌊%₀ + ½⌋ to ⌈%₂ − ½⌉:", everySpan);
        m_code.back()
            .text.replace(u"%₀"_s, isBilinear(m_form) ? u"x₀"_s : u"x_l"_s)
            .replace(u"%₂"_s, isBilinear(m_form) ? u"x₂"_s : u"x_r"_s);
        add(1, "y_first, y_last, y_in, y_out ← rows(x)", everySpan);
        if (isBilinear(m_form)) {
            addWalk([](WalkListing &walk) {
                walk.add(1, walk.longBoundFromVertex(), everySpan);
                walk.add(1, "L_ij ← L₁₂ if x₀ = x₁, or x ≥ x₁ and x₁ < x₂, else L₀₁", everySpan);
                walk.add(1, walk.shortBoundFromVertex(), everySpan);
                walk.add(1, walk.orderedByArea(), everySpan);
            });
            addRates(1);
            add(1,
                "if y_T = y_B by fractions: for each carried value v: Δv ← ((v₂ − v₀)·(x₁ − x₀) − "
                "(v₁ "
                "− v₀)·(x₂ − x₀))/S — in fractions it is the plane's",
                everySpan);
        }
        add(1, "for each row y of the frame from y_first to y_last:", visited);
        add(2, "f ← area(x, y)", visited);
        add(2, "if f = 0: on to the next row", visited);
        addValues(2, "if y ≤ y_in, or y > y_out: ", "else: ");
        addFor(Effect::Perspective, 2,
               "if q ≤ 0: on to the next row — beyond the horizon of the triangle's plane",
               visited);
        addEffects(2, "z_near[x, y]", "pixel (x, y)");
        add(2, pixelLine, written);
        // Those of segments stand above.
        const auto begin = m_code.begin() + std::ptrdiff_t(first);
        m_code.erase(
            std::remove_if(begin, m_code.end(),
                           [](const PseudocodeLine &line) { return line.of == LineOf::Segment; }),
            m_code.end());
        for (std::size_t i = first; i < m_code.size(); ++i)
            m_code[i].of = LineOf::Area;
    }

    /// As with one sample, for each sample of a pixel: the triangle moves the other way.
    void addSamples()
    {
        m_samplings = several;
        add(0,
            "for each sample k from 0 to n: — k = 0 is the centre of the pixels that no edge "
            "meets, "
            "the others are of those that one meets",
            everySpan);
        add(1, "d_x, d_y ← way(k)", {SetUp});
        add(1,
            "x₀, x₁, x₂ ← x₀ − d_x, x₁ − d_x, x₂ − d_x; y₀, y₁, y₂ ← y₀ − d_y, y₁ − d_y, y₂ − d_y",
            {SetUp}, LineOf::Area);
        if (!isBilinear(m_form))
            add(1,
                "x_l, x_m, x_r ← x_l − d_x, x_m − d_x, x_r − d_x; y_l, y_m, y_r ← y_l − d_y, y_m − "
                "d_y, y_r − d_y",
                {SetUp}, LineOf::Area);
        addCoefficients(1);
        addWalk([](WalkListing &walk) { walk.addSpans(1); });
        addRates(2);
        if (isBilinear(m_form))
            add(2, "t ← 0", everySpan);
        addWalk([](WalkListing &walk) { walk.addSamples(2); });
        add(3, "e ← edge(x, y)", visited);
        const QString others = "if e = 0 and k > 0, or e = 1 and k = 0: ";
        add(3, others + (isBilinear(m_form) ? u"t ← 0; "_s : QString()) + u"on to the next row"_s,
            visited);
        addValues(3, "if t = 0: ", "else: ");
        if (isBilinear(m_form))
            add(3, "t ← 1", visited);
        addEffects(3, "z_near[k, x, y]", "R[k, x, y], G[k, x, y], B[k, x, y]");
        add(3, "R[k, x, y], G[k, x, y], B[k, x, y] ← R_s, G_s, B_s", written);
        add(3, "if k = 0: " + pixelLine, written);
        add(3,
            "else: pixel (x, y) ← the mean of its samples — ⌊(R[1, x, y] + … + R[n, x, y])/n + ½⌋; "
            "G and B likewise",
            written);
    }

    const QString pixelLine = "pixel (x, y) ← the bytes of R_s, G_s, B_s";
    InterpolationForm m_form;
    EdgeWalkForm m_walk;
    WalkCoverage m_coverage;
    Samplings m_samplings; ///< those under which the next lines exist
    Pseudocode m_code;
};

} // namespace

Pseudocode shadedPseudocode(InterpolationForm form)
{
    return ShadedListing(form, WalkCoverage::Exact).lines();
}

Pseudocode shadedColumnScanPseudocode()
{
    return ShadedListing(InterpolationForm::Bilinear, WalkCoverage::AsComputed).lines();
}

} // namespace pixelplumb
