// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/shading/interpolationnames.h"
#include "core/methods/walklisting.h"

#include <algorithm>
#include <iterator>

namespace pixelplumb {

namespace {

using enum Moment;

/// What is computed once for every value that the vertices carry.
QString coefficientsText(InterpolationForm form)
{
    switch (form) {
    case InterpolationForm::Bilinear:
    case InterpolationForm::BilinearRows:
        return u"δ ← what each {span} adds to it along L₀₁, L₁₂ and L₀₂"_s;
    case InterpolationForm::Plane:
        return u"a, b, c ← of the plane through its values at the three vertices — "
               "on a segment, along it"_s;
    case InterpolationForm::Barycentric:
        break;
    }
    return u"a, b, c ← of each weight α, β, γ: 1 at its own vertex, 0 at the others "
           "— on a segment, along it"_s;
}

/// How each sample gets its values.
Pseudocode valueLines(InterpolationForm form)
{
    if (isBilinear(form))
        return {{2, "the first: each value v ← v_{lo}, moved on to this sample", {First}},
                {2, "else: v ← v + Δv", {Next}}};
    if (form == InterpolationForm::Plane)
        return {{2, "each value v ← a·x + b·y + c", {First, Next}}};
    return {{2, "α, β, γ ← a·x + b·y + c, of each its own", {First, Next}},
            {2,
             "each value v ← α·v₀ + β·v₁ + γ·v₂; a colour, alpha or z that is the same at all "
             "three: v ← v₀",
             {First, Next}}};
}

/// The vertices keep their names where only the walk along the edges needs their order.
QString sortingText(InterpolationForm form)
{
    if (!isBilinear(form))
        return u"the edges from left to right: one long, two short ones that meet in "
               "the middle vertex"_s;
    return axisOf(form) == SpanAxis::Row
        ? u"sort the vertices by y, the largest first, those of equal y by x: P₀, P₁, P₂"_s
        : u"sort the vertices by x, those of equal x by y: P₀, P₁, P₂"_s;
}

Pseudocode columnLines(InterpolationForm form)
{
    Pseudocode code = {
        {0, sortingText(form), {SetUp}},
        {0,
         isBilinear(form) ? u"m ← the slopes of L₀₁, L₁₂ and L₀₂"_s
                          : u"m ← the slopes of the three edges"_s,
         {SetUp}},
        {0, u"of each value that is carried: "_s + coefficientsText(form), {SetUp}},
        {0, "if no sample is to be drawn: done", {Rejected}},
        {0,
         isBilinear(form) ? u"for each {span} that the fill rule takes, with L₀₁ up to P₁, with "
                            "L₁₂ from there, and L₀₂:"_s
                          : u"for each {span} that the fill rule takes, with the long edge and, "
                            "up to the middle vertex and from there, a short one:"_s,
         {Begin, Span}},
        {1, "where an edge begins: its {a} in this {span}, from its vertex", {Begin}},
        {1, "else: {a}_{lo} ← {a}_{lo} + m_{lo}, {a}_{hi} ← {a}_{hi} + m_{hi}, exactly", {Span}}};
    if (isBilinear(form))
        code.push_back({1,
                        "of each value: v_{lo} and v_{hi} likewise, and if {a}_{lo} < {a}_{hi}: Δv "
                        "← (v_{hi} − v_{lo})/({a}_{hi} − {a}_{lo})",
                        {Begin, Span}});
    code.push_back({1,
                    "for each {across} from {a}_{lo} to {a}_{hi} that the fill rule takes:",
                    {First, Next}});
    return code;
}

/// Fills in the letters of the form's axis.
Pseudocode inLettersOf(InterpolationForm form, Pseudocode code)
{
    const EdgeWalkNames names = walkNames(form);
    for (PseudocodeLine &line : code)
        line.text = names.filled(line.text);
    return code;
}

/// Where the vertices have one colour, rounding must not change it.
QString oneColourText() { return "R₀ = R₁ = R₂ and G₀ = G₁ = G₂ and B₀ = B₁ = B₂"; }

/// What is linear in x and y: each value itself, or the three weights. The vertices are those that
/// are given, and the operations in the kernel's order, so that floats agree, too.
void addCoefficients(WalkListing &listing, InterpolationForm form)
{
    const auto add = [&listing](int depth, const QString &text) {
        listing.add(depth, text, {SetUp}, LineOf::Area);
    };
    if (form == InterpolationForm::Barycentric) {
        add(0,
            "A_α, B_α ← y₂ − y₁, x₁ − x₂; C_α ← −A_α·x₁ − B_α·y₁; k_α ← 1/(A_α·x₀ + B_α·y₀ + "
            "C_α)");
        add(0,
            "A_β, B_β ← y₀ − y₂, x₂ − x₀; C_β ← −A_β·x₂ − B_β·y₂; k_β ← 1/(A_β·x₁ + B_β·y₁ + "
            "C_β)");
        add(0,
            "A_γ, B_γ ← y₁ − y₀, x₀ − x₁; C_γ ← −A_γ·x₀ − B_γ·y₀; k_γ ← 1/(A_γ·x₂ + B_γ·y₂ + "
            "C_γ)");
        add(0,
            "a_α ← k_α·A_α; a_β and a_γ likewise; b_α ← k_α·B_α; b_β and b_γ likewise; c_α ← "
            "k_α·C_α; c_β and c_γ likewise");
        return;
    }
    add(0, "C ← (x₁ − x₀)·(y₂ − y₀) − (y₁ − y₀)·(x₂ − x₀)");
    add(0,
        "for each value v of R, G, B: A_v ← (y₁ − y₀)·(v₂ − v₀) − (v₁ − v₀)·(y₂ − y₀); B_v ← (v₁ − "
        "v₀)·(x₂ − x₀) − (x₁ − x₀)·(v₂ − v₀); D_v ← −(A_v·x₀ + B_v·y₀ + C·v₀)");
    add(0, "for each value v of R, G, B: a_v, b_v, c_v ← −A_v/C, −B_v/C, −D_v/C");
    add(0, u"if %1:"_s.arg(oneColourText()));
    add(1, "for each value v of R, G, B: a_v, b_v, c_v ← 0, 0, v₀");
}

Pseudocode withSamples(Pseudocode code, InterpolationForm form)
{
    const std::vector<Moment> samples = {First, Next};
    const auto add = [&](const QString &text, LineOf of) {
        code.push_back({.depth = 2, .text = text, .moments = samples, .of = of});
    };
    if (form == InterpolationForm::Barycentric) {
        add("α ← a_α·x + b_α·y + c_α; β and γ likewise", LineOf::Area);
        add("R ← α·R₀ + β·R₁ + γ·R₂; G and B likewise", LineOf::Area);
        add(u"if %1: R ← R₀; G and B likewise"_s.arg(oneColourText()), LineOf::Area);
    } else {
        add("for each value v of R, G, B: v ← a_v·x + b_v·y + c_v", LineOf::Area);
    }
    add("R ← R_l + (x − x_l)·((R_r − R_l)/(x_r − x_l)) if x_l < x_r, else R_l + (y − y_l)·((R_r − "
        "R_l)/(y_r − y_l)) if y_l < y_r, else R_l; G and B likewise",
        LineOf::Segment);
    add("pixel (x, y) ← the bytes of R, G, B", LineOf::EveryPrimitive);
    return code;
}

} // namespace

Pseudocode interpolationPseudocode(InterpolationForm form)
{
    if (isBilinear(form))
        return walkPseudocode({.axis = axisOf(form)}, WalkCoverage::Exact);
    WalkListing listing({.rate = ColourRate::Plane}, WalkCoverage::Exact);
    listing.addSorting();
    listing.addSlopes();
    listing.nameSortedVerticesByLetters();
    addCoefficients(listing, form);
    listing.addRejection();
    WalkListing loops({.rate = ColourRate::Plane}, WalkCoverage::Exact);
    loops.addSpans();
    loops.addSamples();
    loops.nameSortedVerticesByLetters();
    Pseudocode code = listing.written();
    std::ranges::move(loops.written(), std::back_inserter(code));
    return withSamples(std::move(code), form);
}

Pseudocode shadedPseudocode(InterpolationForm form)
{
    const std::vector<Antialiasing> one = {Antialiasing::None};
    const std::vector<Antialiasing> several = {Antialiasing::Samples4, Antialiasing::Samples16};
    const std::vector<Antialiasing> area = {Antialiasing::Area};

    Pseudocode code = columnLines(form);
    const auto columns = std::ranges::find_if(code, [](const PseudocodeLine &line) {
        return line.text.startsWith(u"for each {span}"_s);
    });
    PseudocodeLine everyColumn = *columns;
    columns->antialiasing = one;
    everyColumn.text.replace(
        u"that the fill rule takes"_s,
        u"in which a sample, or a part of a pixel's square, is the triangle's"_s);
    everyColumn.antialiasing
        = {Antialiasing::Samples4, Antialiasing::Samples16, Antialiasing::Area};
    code.insert(columns + 1, everyColumn);
    code.insert(code.begin() + 2,
                {0,
                 "divide what the vertices carry by their w, but for z and a colour or alpha that "
                 "is the same at all of them; 1/w is carried, too, as 1 if nothing is divided",
                 {SetUp},
                 Effect::Perspective});
    const std::vector<Moment> atSamples = {First, Next, Refused};
    code.back().antialiasing = one;
    const auto appendLoop
        = [&](const QString &text, const std::vector<Antialiasing> &antialiasing) {
              code.push_back({1, text, atSamples});
              code.back().antialiasing = antialiasing;
          };
    appendLoop("for each sample of the {span} that lies in the triangle by the fill rule, the "
               "centre of a pixel, or of one that an edge meets its 4 or 16:",
               several);
    appendLoop("for each {across} in which the triangle covers a part of the pixel's square:",
               area);
    for (PseudocodeLine line : valueLines(form)) {
        // A sample hidden by the depth test has its values, too.
        line.moments.push_back(Refused);
        if (isBilinear(form))
            line.antialiasing = one;
        code.push_back(line);
    }
    if (isBilinear(form)) {
        code.push_back({2, "each value v ← that of its plane here", atSamples});
        code.back().antialiasing = everyColumn.antialiasing;
    }
    code.push_back(
        {2,
         "if 1/w ≤ 0: on to the next sample — it lies beyond the horizon of the triangle's plane",
         atSamples, Effect::Perspective});
    code.back().antialiasing = area;
    const auto append = [&](const QString &text, std::optional<Effect> effect,
                            const std::vector<Antialiasing> &antialiasing = {}) {
        code.push_back({2, text, {First, Next}, effect});
        code.back().antialiasing = antialiasing;
    };
    code.push_back({2,
                    "if z is greater than the depth that stands here: on to the next sample; else "
                    "the depth ← z",
                    atSamples, Effect::Depth});
    append("each value v that was divided ← (v/w)/(1/w)", Effect::Perspective);
    append("colour ← the bytes of R, G, B", {});
    append("colour ← ⌊colour·t/255 + ½⌋ with the texel t at (u, v)", Effect::Texture);
    append("colour ← ambient and, of each light, the diffuse and specular term", Effect::Light);
    const auto blended = u"colour ← ⌊(colour·a + %1·(255 − a))/255 + ½⌋"_s;
    const QString overPixel = blended.arg(u"pixel"_s);
    const auto ofAlpha = u" — a is the byte of A"_s;
    append(overPixel + ofAlpha, Effect::Blending, one);
    append(blended.arg(u"sample"_s) + ofAlpha, Effect::Blending, several);
    append("a ← ⌊a·area + ½⌋ — area is the covered part of the pixel's square, a was the byte of "
           "A, 255 where nothing is blended",
           {}, area);
    append(overPixel, {}, area);
    append("pixel (x, y) ← colour", {}, {Antialiasing::None, Antialiasing::Area});
    append("sample ← colour; pixel (x, y) ← the mean of its samples, ⌊Σ/n + ½⌋", {}, several);
    return inLettersOf(form, std::move(code));
}

} // namespace pixelplumb
