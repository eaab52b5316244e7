<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>pixelplumb::ColumnTablePanel</name>
    <message numerus="yes">
        <source>%n columns</source>
        <translation>
            <numerusform>%n column</numerusform>
            <numerusform>%n columns</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rows</source>
        <translation>
            <numerusform>%n row</numerusform>
            <numerusform>%n rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n step</numerusform>
            <numerusform>%n steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n primitives</source>
        <translation>
            <numerusform>%n primitive</numerusform>
            <numerusform>%n primitives</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::ComparePane</name>
    <message numerus="yes">
        <source>%n pixels, shown finished</source>
        <translation>
            <numerusform>%n pixel, shown finished</numerusform>
            <numerusform>%n pixels, shown finished</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pixels: %1 missing, %2 extra, %3 in another colour</source>
        <translation>
            <numerusform>%n pixel: %1 missing, %2 extra, %3 in another colour</numerusform>
            <numerusform>%n pixels: %1 missing, %2 extra, %3 in another colour</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%4 of %n pixels so far: %1 missing, %2 extra, %3 in another colour</source>
        <translation>
            <numerusform>%4 of %n pixel so far: %1 missing, %2 extra, %3 in another colour</numerusform>
            <numerusform>%4 of %n pixels so far: %1 missing, %2 extra, %3 in another colour</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::DiagnosisView</name>
    <message numerus="yes">
        <source>%n sets of known bugs produce this picture:</source>
        <translation>
            <numerusform>Exactly one set of known bugs produces this picture:</numerusform>
            <numerusform>%n sets of known bugs produce this picture:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> · except for %n pixels that rounding or an edge may decide</source>
        <translation>
            <numerusform> · except for %n pixel that rounding or an edge may decide</numerusform>
            <numerusform> · except for %n pixels that rounding or an edge may decide</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> · %n pixels remain unexplained</source>
        <translation>
            <numerusform> · %n pixel remains unexplained</numerusform>
            <numerusform> · %n pixels remain unexplained</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::EffectsText</name>
    <message numerus="yes">
        <source>%n pixels change, marked on the canvas</source>
        <translation>
            <numerusform>%n pixel changes, marked on the canvas</numerusform>
            <numerusform>%n pixels change, marked on the canvas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::FrameDialog</name>
    <message numerus="yes">
        <source>%1 pixels</source>
        <translation>
            <numerusform>%1 pixel</numerusform>
            <numerusform>%1 pixels</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::MotionPanel</name>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>once</numerusform>
            <numerusform>%n times</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::MotionView</name>
    <message numerus="yes">
        <source>%n pixels came or went</source>
        <translation>
            <numerusform>%n pixel came or went</numerusform>
            <numerusform>%n pixels came or went</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pixels of the truth are missing</source>
        <translation>
            <numerusform>%n pixel of the truth is missing</numerusform>
            <numerusform>%n pixels of the truth are missing</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::OverdrawOverlay</name>
    <message numerus="yes">
        <source>%n pixels</source>
        <translation>
            <numerusform>%n pixel</numerusform>
            <numerusform>%n pixels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>once</numerusform>
            <numerusform>%n times</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n gaps</source>
        <translation>
            <numerusform>%n gap</numerusform>
            <numerusform>%n gaps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::PerformanceText</name>
    <message numerus="yes">
        <source>%1 triangles</source>
        <translation>
            <numerusform>%1 triangle</numerusform>
            <numerusform>%1 triangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 pixels</source>
        <translation>
            <numerusform>%1 pixel</numerusform>
            <numerusform>%1 pixels</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::PixelHistoryModel</name>
    <message numerus="yes">
        <source>and %n more that refuse it</source>
        <translation>
            <numerusform>and %n more that refuses it</numerusform>
            <numerusform>and %n more that refuse it</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::PrimitivesPanel</name>
    <message numerus="yes">
        <source>%n primitives</source>
        <translation>
            <numerusform>%n primitive</numerusform>
            <numerusform>%n primitives</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, and %n hidden that the numbers leave out</source>
        <translation>
            <numerusform>, and %n hidden that the numbers leave out</numerusform>
            <numerusform>, and %n hidden that the numbers leave out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> and %n solids</source>
        <translation>
            <numerusform> and %n solid</numerusform>
            <numerusform> and %n solids</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::ProjectionPanel</name>
    <message numerus="yes">
        <source>The scene&apos;s solids become %n triangles.</source>
        <translation>
            <numerusform>The scene&apos;s solids become %n triangle.</numerusform>
            <numerusform>The scene&apos;s solids become %n triangles.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::RunNotes</name>
    <message numerus="yes">
        <source>and %n more numbers are taken as the nearest of 1/256 px or 2^-24</source>
        <translation>
            <numerusform>and %n more number is taken as the nearest of 1/256 px or 2^-24</numerusform>
            <numerusform>and %n more numbers are taken as the nearest of 1/256 px or 2^-24</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::SceneDocument</name>
    <message numerus="yes">
        <source>%n waiting vertices dropped: “%1” draws another kind of primitive. Undo brings them back.</source>
        <translation>
            <numerusform>%n waiting vertex dropped: “%1” draws another kind of primitive. Undo brings it back.</numerusform>
            <numerusform>%n waiting vertices dropped: “%1” draws another kind of primitive. Undo brings them back.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::SceneExports</name>
    <message numerus="yes">
        <source>%n more primitives leave it alone</source>
        <translation>
            <numerusform>%n more primitive leaves it alone</numerusform>
            <numerusform>%n more primitives leave it alone</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::SceneTracer</name>
    <message numerus="yes">
        <source>%n triangles</source>
        <translation>
            <numerusform>%n triangle</numerusform>
            <numerusform>%n triangles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::SubmissionPanel</name>
    <message numerus="yes">
        <source>%n pixels</source>
        <translation>
            <numerusform>%n pixel</numerusform>
            <numerusform>%n pixels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Wrong: %n pixels differ.</source>
        <translation>
            <numerusform>Wrong: %n pixel differs.</numerusform>
            <numerusform>Wrong: %n pixels differ.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Right within the leeway: %n pixels differ as a right program&apos;s may.</source>
        <translation>
            <numerusform>Right within the leeway: %n pixel differs as a right program&apos;s may.</numerusform>
            <numerusform>Right within the leeway: %n pixels differ as a right program&apos;s may.</numerusform>
        </translation>
    </message>
</context>
</TS>
