<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>core</name>
    <message>
        <source>triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>bezier</source>
        <translation>Bézierkurve</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>Polygon</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>triangle3</source>
        <translation>3D-Dreieck</translation>
    </message>
    <message>
        <source>polygon3</source>
        <translation>3D-Polygon</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>patch</source>
        <translation>Flächenstück</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>Row %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>Step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>part %1</source>
        <translation>Teil %1</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>Kante %1</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>Dreieck %1</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>extra</source>
        <translation>überzählig</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>undecidable</source>
        <translation>unentscheidbar</translation>
    </message>
    <message>
        <source>right</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>falsch</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>smooth colour</source>
        <translation>Farbverlauf</translation>
    </message>
    <message>
        <source>clipping</source>
        <translation>Clipping</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>blending</source>
        <translation>Überblendung</translation>
    </message>
    <message>
        <source>antialiasing</source>
        <translation>Kantenglättung</translation>
    </message>
    <message>
        <source>called for</source>
        <translation>gefordert</translation>
    </message>
    <message>
        <source>not called for</source>
        <translation>nicht gefordert</translation>
    </message>
    <message>
        <source>not ruled out</source>
        <translation>nicht ausgeschlossen</translation>
    </message>
    <message>
        <source>tie rule</source>
        <translation>Grenzfallregel</translation>
    </message>
    <message>
        <source>kind not drawn</source>
        <translation>Art nicht gezeichnet</translation>
    </message>
    <message>
        <source>rounding</source>
        <translation>Rundung</translation>
    </message>
    <message>
        <source>drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>precision</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Triangles, stable forms</source>
        <translation>Dreiecke, stabile Formen</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Polygons</source>
        <translation>Polygone</translation>
    </message>
    <message>
        <source>Points and text</source>
        <translation>Punkte und Text</translation>
    </message>
    <message>
        <source>Vertices and edges</source>
        <translation>Eckpunkte und Kanten</translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation>Umschließendes Rechteck</translation>
    </message>
    <message>
        <source>Half-planes and normals</source>
        <translation>Halbebenen und Normalen</translation>
    </message>
    <message>
        <source>Half-plane of E₀</source>
        <translation>Halbebene von E₀</translation>
    </message>
    <message>
        <source>Half-plane of E₁</source>
        <translation>Halbebene von E₁</translation>
    </message>
    <message>
        <source>Half-plane of E₂</source>
        <translation>Halbebene von E₂</translation>
    </message>
    <message>
        <source>Weights in the cells</source>
        <translation>Gewichte in den Zellen</translation>
    </message>
    <message>
        <source>R G B in the cells</source>
        <translation>R G B in den Zellen</translation>
    </message>
    <message>
        <source>Barycentric axes and points</source>
        <translation>Baryzentrische Achsen und Punkte</translation>
    </message>
    <message>
        <source>Affine map: weights stay</source>
        <translation>Affine Abbildung: Gewichte bleiben</translation>
    </message>
    <message>
        <source>Contour lines of R</source>
        <translation>Höhenlinien von R</translation>
    </message>
    <message>
        <source>Contour lines of G</source>
        <translation>Höhenlinien von G</translation>
    </message>
    <message>
        <source>Contour lines of B</source>
        <translation>Höhenlinien von B</translation>
    </message>
    <message>
        <source>Triangles of a polygon</source>
        <translation>Dreiecke eines Polygons</translation>
    </message>
    <message>
        <source>Edge table</source>
        <translation>Kantentabelle</translation>
    </message>
    <message>
        <source>Decision of the step</source>
        <translation>Entscheidung des Schritts</translation>
    </message>
    <message>
        <source>Brightness by direction</source>
        <translation>Helligkeit nach Richtung</translation>
    </message>
    <message>
        <source>Sampling points</source>
        <translation>Abtastpunkte</translation>
    </message>
    <message>
        <source>Addresses in memory</source>
        <translation>Adressen im Speicher</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>projecting</source>
        <translation>Projizieren</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>recording in exact numbers</source>
        <translation>Aufzeichnen in exakten Zahlen</translation>
    </message>
    <message>
        <source>judging</source>
        <translation>Beurteilen</translation>
    </message>
    <message>
        <source>explaining</source>
        <translation>Erklären</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>checking</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>divisions</source>
        <translation>Divisionen</translation>
    </message>
    <message>
        <source>roundings</source>
        <translation>Rundungen</translation>
    </message>
    <message>
        <source>float additions</source>
        <translation>Gleitkomma-Additionen</translation>
    </message>
    <message>
        <source>integer additions</source>
        <translation>ganzzahlige Additionen</translation>
    </message>
    <message>
        <source>multiplications</source>
        <translation>Multiplikationen</translation>
    </message>
    <message>
        <source>comparisons</source>
        <translation>Vergleiche</translation>
    </message>
    <message>
        <source>conversions</source>
        <translation>Umwandlungen</translation>
    </message>
    <message>
        <source>functions</source>
        <translation>Funktionen</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>%1 set-up</source>
        <translation>%1 Vorbereitung</translation>
    </message>
    <message>
        <source>%1 set-ups</source>
        <translation>%1 Vorbereitungen</translation>
    </message>
    <message>
        <source>%1 span</source>
        <translation>%1 Spanne</translation>
    </message>
    <message>
        <source>%1 spans</source>
        <translation>%1 Spannen</translation>
    </message>
    <message>
        <source>%1 pixel</source>
        <translation>%1 Pixel</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 Pixel</translation>
    </message>
    <message>
        <source>%1 sample refused</source>
        <translation>%1 Abtastpunkt abgewiesen</translation>
    </message>
    <message>
        <source>%1 samples refused</source>
        <translation>%1 Abtastpunkte abgewiesen</translation>
    </message>
    <message>
        <source>%1 operation</source>
        <translation>%1 Operation</translation>
    </message>
    <message>
        <source>%1 operations</source>
        <translation>%1 Operationen</translation>
    </message>
    <message>
        <source>%1 of %2 edges looked at</source>
        <translation>%1 von %2 Kanten angesehen</translation>
    </message>
    <message>
        <source>wrong pixels</source>
        <translation>falsche Pixel</translation>
    </message>
    <message>
        <source>wrong coverage</source>
        <translation>falsche Überdeckung</translation>
    </message>
    <message>
        <source>wrong colours</source>
        <translation>falsche Farben</translation>
    </message>
    <message>
        <source>largest error of a byte</source>
        <translation>größter Fehler eines Bytes</translation>
    </message>
    <message>
        <source>largest error before rounding</source>
        <translation>größter Fehler vor dem Runden</translation>
    </message>
    <message>
        <source>RMS error before rounding</source>
        <translation>mittlerer quadratischer Fehler vor dem Runden</translation>
    </message>
    <message>
        <source>farthest missed sample</source>
        <translation>fernster verfehlter Abtastpunkt</translation>
    </message>
    <message>
        <source>levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Random, whole pixels</source>
        <translation>Zufällig, ganze Pixel</translation>
    </message>
    <message>
        <source>Slivers</source>
        <translation>Splitter</translation>
    </message>
    <message>
        <source>Ties</source>
        <translation>Grenzfälle</translation>
    </message>
    <message>
        <source>Far from the origin</source>
        <translation>Fern vom Ursprung</translation>
    </message>
    <message>
        <source>Small triangles</source>
        <translation>Kleine Dreiecke</translation>
    </message>
    <message>
        <source>Large triangles</source>
        <translation>Große Dreiecke</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Own scene</source>
        <translation>Eigene Szene</translation>
    </message>
    <message>
        <source>Hard cases</source>
        <translation>Schwierige Fälle</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>at most one level</source>
        <translation>höchstens eine Stufe</translation>
    </message>
    <message>
        <source>at most %1 wrong pixels per million</source>
        <translation>höchstens %1 falsche Pixel von einer Million</translation>
    </message>
    <message>
        <source>%1 ms a frame</source>
        <translation>%1 ms je Bild</translation>
    </message>
    <message>
        <source>plain kernel %1 ns a pixel</source>
        <translation>einfach %1 ns je Pixel</translation>
    </message>
    <message>
        <source>The time is that of the plain kernel, the one that is stepped through, on one thread:</source>
        <translation>Die Zeit ist die des einfachen Kerns, den die Schritte durchgehen, auf einem Thread:</translation>
    </message>
    <message>
        <source>median of %1 rounds %2 ns a pixel, the middle half %3 … %4, over %5 px of triangles, each as often as it is written.</source>
        <translation>Median von %1 Runden %2 ns je Pixel, mittlere Hälfte %3 … %4, über %5 px von Dreiecken, jedes so oft gezählt, wie es geschrieben wird.</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>etwa %1 min</translation>
    </message>
    <message>
        <source>%1 %, about %2 s left</source>
        <translation>%1 %, noch etwa %2 s</translation>
    </message>
    <message>
        <source>%1 %, about %2 min left</source>
        <translation>%1 %, noch etwa %2 min</translation>
    </message>
    <message>
        <source>Triangle %1</source>
        <translation>Dreieck %1</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Linie %1</translation>
    </message>
    <message>
        <source>Circle %1</source>
        <translation>Kreis %1</translation>
    </message>
    <message>
        <source>Ellipse %1</source>
        <translation>Ellipse %1</translation>
    </message>
    <message>
        <source>Bezier %1</source>
        <translation>Bézierkurve %1</translation>
    </message>
    <message>
        <source>Polygon %1</source>
        <translation>Polygon %1</translation>
    </message>
    <message>
        <source>Text %1</source>
        <translation>Text %1</translation>
    </message>
    <message>
        <source>set-up</source>
        <translation>Vorbereitung</translation>
    </message>
    <message>
        <source>Pixel (%1, %2)</source>
        <translation>Pixel (%1, %2)</translation>
    </message>
    <message>
        <source>Sample (%1, %2), refused</source>
        <translation>Abtastpunkt (%1, %2), abgewiesen</translation>
    </message>
    <message>
        <source>is not seen: the camera&apos;s eye is at its target, or up is where it looks</source>
        <translation>wird nicht gesehen: Das Auge der Kamera ist an ihrem Ziel, oder oben ist, wohin sie blickt</translation>
    </message>
    <message>
        <source>has no part beyond the near plane</source>
        <translation>hat keinen Teil hinter der vorderen Ebene</translation>
    </message>
    <message>
        <source>has a corner that the camera takes nowhere</source>
        <translation>hat eine Ecke, die die Kamera nirgendwohin bringt</translation>
    </message>
    <message>
        <source>has a corner beyond ±%1^%2 px</source>
        <translation>hat eine Ecke jenseits von ±%1^%2 px</translation>
    </message>
    <message>
        <source>has a corner with a number beyond ±%1^%2</source>
        <translation>hat eine Ecke mit einer Zahl jenseits von ±%1^%2</translation>
    </message>
    <message>
        <source>agreed</source>
        <translation>einig</translation>
    </message>
    <message>
        <source>right in coverage</source>
        <translation>richtig in der Abdeckung</translation>
    </message>
    <message>
        <source>cannot be graded</source>
        <translation>nicht zu bewerten</translation>
    </message>
    <message>
        <source>Piece %1</source>
        <translation>Stück %1</translation>
    </message>
    <message>
        <source>piece %1</source>
        <translation>Stück %1</translation>
    </message>
    <message>
        <source>Walks the columns between two edges and colours the samples from y_B to y_T that the fill rule takes, all by adding increments.</source>
        <translation>Geht durch die Spalten zwischen zwei Kanten und färbt die Abtastpunkte von y_B bis y_T, die die Füllregel nimmt, alles durch Addieren von Zuwächsen.</translation>
    </message>
    <message>
        <source>Walks the rows between two edges, the largest y first, switches in the third edge at the middle vertex, and colours the samples from x_L to x_R that the fill rule takes, trapezoid by trapezoid, all by adding increments.</source>
        <translation>Geht zwischen zwei Kanten durch die Zeilen, das größte y zuerst, wechselt am mittleren Eckpunkt auf die dritte Kante und färbt die Abtastpunkte von x_L bis x_R, die die Füllregel nimmt, ein Trapez nach dem anderen, alles durch Addieren von Zuwächsen.</translation>
    </message>
    <message>
        <source>Evaluates E = a·x + b·y + c of the three edges at every sample of the clipped bounding box, with the sides flipped to be positive inside; where the slide draws E &gt; 0 alone, E = 0 is left to the fill rule.</source>
        <translation>Wertet E = a·x + b·y + c der drei Kanten an jedem Abtastpunkt des beschnittenen umschließenden Rechtecks aus, die Seiten so gedreht, dass sie innen positiv sind; wo die Folie nur bei E &gt; 0 zeichnet, entscheidet über E = 0 die Füllregel.</translation>
    </message>
    <message>
        <source>Adds a to each edge function along a row and b from row to row, so that a sample costs three additions and rounding errors add up.</source>
        <translation>Addiert in einer Zeile a zu jeder Kantenfunktion und von Zeile zu Zeile b: Ein Abtastpunkt kostet drei Additionen, und Rundungsfehler summieren sich.</translation>
    </message>
    <message>
        <source>Solves A and B of each edge from its two points with C = −1 chosen; an edge whose line passes through (0, 0) has no such solution and gets C = 0.</source>
        <translation>Berechnet A und B jeder Kante aus ihren zwei Punkten mit gewähltem C = −1; eine Kante, deren Gerade durch (0, 0) geht, hat keine solche Lösung und bekommt C = 0.</translation>
    </message>
    <message>
        <source>Computes α, β and γ for every pixel of the frame and draws it if all three lie within [0, 1]; a sample on an edge is left to the fill rule.</source>
        <translation>Berechnet α, β und γ für jedes Pixel der Bildfläche und zeichnet es, wenn alle drei in [0, 1] liegen; ein Abtastpunkt auf einer Kante bleibt der Füllregel überlassen.</translation>
    </message>
    <message>
        <source>The same for the samples between the smallest and the largest x and y of the vertices alone.</source>
        <translation>Dasselbe nur für die Abtastpunkte zwischen dem kleinsten und dem größten x und y der Eckpunkte.</translation>
    </message>
    <message>
        <source>Adds to the weights and to the colour from sample to sample, and tests them against 0 alone.</source>
        <translation>Addiert von Abtastpunkt zu Abtastpunkt zu den Gewichten und zur Farbe und prüft die Gewichte nur gegen 0.</translation>
    </message>
    <message>
        <source>Solves P = C + u·(A − C) + v·(B − C) by determinants and draws if u ≥ 0, v ≥ 0 and u + v ≤ 1; a sample on an edge is left to the fill rule.</source>
        <translation>Löst P = C + u·(A − C) + v·(B − C) mit Determinanten und zeichnet, wenn u ≥ 0, v ≥ 0 und u + v ≤ 1; ein Abtastpunkt auf einer Kante bleibt der Füllregel überlassen.</translation>
    </message>
    <message>
        <source>Gives a sample exactly on an edge to the triangle on the side of the off-screen point r: f_bc(a)·f_bc(r) &gt; 0; an edge whose line passes through r is given to neither side.</source>
        <translation>Gibt einen Abtastpunkt genau auf einer Kante dem Dreieck auf der Seite des Punktes r außerhalb des Bildes: f_bc(a)·f_bc(r) &gt; 0; eine Kante, deren Gerade durch r geht, bekommt keine der beiden Seiten.</translation>
    </message>
    <message>
        <source>Draws the three edges as lines of whole pixels and fills each column from the smallest to the largest y of them: pixels nearest to an edge are painted on whichever side of it they lie, those of a shared edge twice.</source>
        <translation>Zeichnet die drei Kanten als Linien aus ganzen Pixeln und füllt jede Spalte vom kleinsten bis zum größten y davon: Die Pixel nächst einer Kante werden gemalt, auf welcher Seite auch immer sie liegen, die einer gemeinsamen Kante zweimal.</translation>
    </message>
    <message>
        <source>Computes y₀ + (x − x₀)·m and the plane&apos;s colours in float64 and moves them by half the distance between their possible values before rounding: no wrong pixel, proved for triangles in boxes of up to 2^24 px², such as 4096 × 4096; beyond, integers take over and the set-up says so.</source>
        <translation>Berechnet y₀ + (x − x₀)·m und die Farben der Ebene in float64 und verschiebt sie vor dem Runden um den halben Abstand ihrer möglichen Werte: kein falsches Pixel, bewiesen für Dreiecke in Rechtecken bis 2^24 px², etwa 4096 × 4096; darüber übernehmen ganze Zahlen, und die Vorbereitung sagt es.</translation>
    </message>
    <message>
        <source>The assignment&apos;s increments with ΔR computed once from the plane through the three vertices, so that slivers cannot blow it up.</source>
        <translation>Die Zuwächse der Aufgabe, aber ΔR einmal aus der Ebene durch die drei Eckpunkte berechnet, so dass schmale Dreiecke es nicht aufblähen.</translation>
    </message>
    <message>
        <source>Walks the rows between two edges, the largest y first, with ΔR computed once from the plane through the three vertices, so that short rows cannot blow it up.</source>
        <translation>Geht zwischen zwei Kanten durch die Zeilen, das größte y zuerst, mit ΔR einmal aus der Ebene durch die drei Eckpunkte berechnet, so dass kurze Zeilen es nicht aufblähen.</translation>
    </message>
    <message>
        <source>Evaluates every edge from its end point that is smaller in (x, y) order and flips the sign, so that the two triangles of a shared edge see the same number in any arithmetic; in exact arithmetic all are integers.</source>
        <translation>Wertet jede Kante von ihrem in der Ordnung (x, y) kleineren Endpunkt aus und dreht das Vorzeichen, so dass die zwei Dreiecke einer gemeinsamen Kante in jeder Arithmetik dieselbe Zahl sehen; in exakter Arithmetik sind alle ganz.</translation>
    </message>
    <message>
        <source>Evaluates each edge function from one of its vertices, so that the products stay small far from the origin; in float64 they are exact up to 2^15 px.</source>
        <translation>Wertet jede Kantenfunktion von einem ihrer Eckpunkte aus, so dass die Produkte auch fern vom Ursprung klein bleiben; in float64 sind sie bis 2^15 px exakt.</translation>
    </message>
    <message>
        <source>Interpolates along both edges and then along the column, each by adding a rate; what is covered is exact.</source>
        <translation>Interpoliert entlang beider Kanten und dann entlang der Spalte, beides durch Addieren einer Rate; die Überdeckung ist exakt.</translation>
    </message>
    <message>
        <source>Interpolates along the left and the right edge and then along the row, each by adding a rate; what is covered is exact.</source>
        <translation>Interpoliert entlang der linken und der rechten Kante und dann entlang der Zeile, beides durch Addieren einer Rate; die Überdeckung ist exakt.</translation>
    </message>
    <message>
        <source>Evaluates v = a·x + b·y + c of the plane through the three values at each sample; what is covered is exact.</source>
        <translation>Wertet v = a·x + b·y + c der Ebene durch die drei Werte an jedem Abtastpunkt aus; die Überdeckung ist exakt.</translation>
    </message>
    <message>
        <source>Weights the three vertices&apos; values with α, β and γ at each sample; what is covered is exact.</source>
        <translation>Gewichtet an jedem Abtastpunkt die Werte der drei Eckpunkte mit α, β und γ; die Überdeckung ist exakt.</translation>
    </message>
    <message>
        <source>Walks along the longer side and adds the slope at each step; the pixel is the nearest one.</source>
        <translation>Geht die längere Seite entlang und addiert bei jedem Schritt die Steigung; gezeichnet wird das nächste Pixel.</translation>
    </message>
    <message>
        <source>Computes y = m·x + b for each column and rounds it by (int)(y + ½): steep lines have gaps, vertical ones no m.</source>
        <translation>Berechnet y = m·x + b für jede Spalte und rundet mit (int)(y + ½): Steile Linien haben Lücken, senkrechte kein m.</translation>
    </message>
    <message>
        <source>Computes P(t) = P₀ + t·(P₁ − P₀) for t in steps of one pixel of the longer side, or less, and writes the pixel nearest to each point.</source>
        <translation>Berechnet P(t) = P₀ + t·(P₁ − P₀) für t in Schritten von einem Pixel der längeren Seite oder weniger und schreibt das Pixel, das jedem Punkt am nächsten ist.</translation>
    </message>
    <message>
        <source>Steps from the end of smaller x (of a steep line, of smaller y) by the sign of an integer; p_k &lt; 0 stays, so that a tie steps across.</source>
        <translation>Geht vom Ende mit kleinerem x (einer steilen Linie: mit kleinerem y) nach dem Vorzeichen einer ganzen Zahl; p_k &lt; 0 bleibt, so dass ein Grenzfall quer weitergeht.</translation>
    </message>
    <message>
        <source>Bresenham&apos;s decisions from any lattice point to any other, ties to the pixel of larger y or x whether the line rises or falls.</source>
        <translation>Bresenhams Entscheidungen zwischen beliebigen Gitterpunkten; Grenzfälle gehen zum Pixel mit größerem y oder x, ob die Linie steigt oder fällt.</translation>
    </message>
    <message>
        <source>Steps through an octant by the sign of F at midpoints, a whole number of quarters, and mirrors each pixel into the other seven; of unequal radii through two arcs of a quarter, each into three.</source>
        <translation>Geht durch einen Oktanten nach dem Vorzeichen von F an Mittelpunkten, einer ganzen Zahl von Vierteln, und spiegelt jedes Pixel in die anderen sieben; bei ungleichen Radien durch zwei Bögen eines Viertels, je in drei.</translation>
    </message>
    <message>
        <source>Computes y = ±√(r² − x²) for each column; there are gaps where the curve is steep.</source>
        <translation>Berechnet y = ±√(r² − x²) für jede Spalte; wo die Kurve steil ist, bleiben Lücken.</translation>
    </message>
    <message>
        <source>Goes round in steps of one pixel of arc and writes the pixel nearest to each point (r cos θ, r sin θ).</source>
        <translation>Geht in Schritten von einem Pixel Bogenlänge herum und schreibt das Pixel, das jedem Punkt (r cos θ, r sin θ) am nächsten ist.</translation>
    </message>
    <message>
        <source>On each row, writes the samples between the two places where the row meets the curve.</source>
        <translation>Schreibt in jeder Zeile die Abtastpunkte zwischen den zwei Stellen, an denen die Zeile die Kurve trifft.</translation>
    </message>
    <message>
        <source>Halves the curve by de Casteljau&apos;s algorithm until each piece has no pixels but those of its two ends, and writes these: thin as a line, the pixels nearer than ½ px by |Δx| + |Δy|.</source>
        <translation>Halbiert die Kurve nach de Casteljau, bis jedes Stück keine Pixel als die seiner beiden Enden hat, und schreibt diese: dünn wie eine Linie, die Pixel, die näher als ½ px sind, gemessen als |Δx| + |Δy|.</translation>
    </message>
    <message>
        <source>Closes a path of Bézier pieces, takes each as a chain of chords, and fills these by parity or winding number; the truth is that of the curves themselves.</source>
        <translation>Schließt einen Pfad aus Béziers, nimmt jede als Kette von Sehnen und füllt diese nach Parität oder Windungszahl; die Wahrheit ist die der Kurven selbst.</translation>
    </message>
    <message>
        <source>Intersects each row with the active edges, sorts the crossings in x, and fills by their parity or winding number.</source>
        <translation>Schneidet jede Zeile mit den aktiven Kanten, ordnet die Schnittpunkte nach x und füllt nach ihrer Parität oder Windungszahl.</translation>
    </message>
    <message>
        <source>Breaks a convex polygon into the triangles that its first vertex makes with its edges, and fills each row by row.</source>
        <translation>Zerlegt ein konvexes Polygon in die Dreiecke, die sein erster Eckpunkt mit seinen Kanten bildet, und füllt jedes Zeile für Zeile.</translation>
    </message>
    <message>
        <source>Breaks a polygon that does not cross itself into the triangles of its constrained Delaunay triangulation, and fills each row by row.</source>
        <translation>Zerlegt ein Polygon, das sich nicht selbst schneidet, in die Dreiecke seiner Delaunay-Triangulierung mit erzwungenen Kanten und füllt jedes Zeile für Zeile.</translation>
    </message>
    <message>
        <source>Breaks any polygon into triangles, also one that crosses itself: crossings become vertices, moved to the nearest multiple of 1/256 px, by which a sample beside an edge may change its side.</source>
        <translation>Zerlegt jedes Polygon in Dreiecke, auch eines, das sich selbst schneidet: Schnittpunkte werden Eckpunkte, verschoben auf das nächste Vielfache von 1/256 px, wodurch ein Abtastpunkt neben einer Kante die Seite wechseln kann.</translation>
    </message>
    <message>
        <source>Draws each edge as a line by Bresenham&apos;s decisions between any two points of the lattice; a pixel in which two edges meet is written by both.</source>
        <translation>Zeichnet jede Kante als Linie mit Bresenhams Entscheidungen zwischen beliebigen Gitterpunkten; ein Pixel, in dem zwei Kanten zusammentreffen, schreiben beide.</translation>
    </message>
    <message>
        <source>Takes the outlines of the glyphs from a font and fills them as one polygon by winding number.</source>
        <translation>Nimmt die Umrisse der Zeichen aus einer Schrift und füllt sie als ein Polygon nach der Windungszahl.</translation>
    </message>
    <message>
        <source>Takes a line as the rectangle one pixel wide, a curve as a strip of quadrilaterals, and blends it by the area that it has of each pixel, equally bright in every direction, or by 4 or 16 samples, as the scene&apos;s antialiasing asks. Where it asks for none, one sample decides a pixel: stairs.</source>
        <translation>Nimmt eine Linie als das Rechteck von einem Pixel Breite, eine Kurve als Streifen von Vierecken, und mischt sie nach der Fläche, die sie von jedem Pixel hat, in jeder Richtung gleich hell, oder nach 4 oder 16 Abtastpunkten, wie das Antialiasing der Szene es verlangt. Verlangt sie keines, entscheidet ein Abtastpunkt über ein Pixel: Treppen.</translation>
    </message>
    <message>
        <source>Writes the colour of each point to the address addr = y·width + x, counted from the frame&apos;s first pixel.</source>
        <translation>Schreibt die Farbe jedes Punktes an die Adresse addr = y·width + x, vom ersten Pixel des Rahmens an gezählt.</translation>
    </message>
    <message>
        <source>Column scan</source>
        <translation>Spaltenrasterung</translation>
    </message>
    <message>
        <source>Row edge walking</source>
        <translation>Kantenlauf zeilenweise</translation>
    </message>
    <message>
        <source>Edge equations</source>
        <translation>Kantengleichungen</translation>
    </message>
    <message>
        <source>Edge equations, incremental</source>
        <translation>Kantengleichungen, inkrementell</translation>
    </message>
    <message>
        <source>Edge equations, solved system</source>
        <translation>Kantengleichungen, gelöstes System</translation>
    </message>
    <message>
        <source>Barycentric, all pixels</source>
        <translation>Baryzentrisch, alle Pixel</translation>
    </message>
    <message>
        <source>Barycentric, bounding rectangle</source>
        <translation>Baryzentrisch, umgebendes Rechteck</translation>
    </message>
    <message>
        <source>Barycentric, incremental</source>
        <translation>Baryzentrisch, inkrementell</translation>
    </message>
    <message>
        <source>Barycentric, Cramer&apos;s rule</source>
        <translation>Baryzentrisch, Cramersche Regel</translation>
    </message>
    <message>
        <source>Barycentric, off-screen point</source>
        <translation>Baryzentrisch, Punkt außerhalb</translation>
    </message>
    <message>
        <source>Midpoint outline, filled</source>
        <translation>Umriss mit Mittelpunktverfahren, gefüllt</translation>
    </message>
    <message>
        <source>Column scan, half-quantum bias</source>
        <translation>Spaltenrasterung, um ein halbes Quant versetzt</translation>
    </message>
    <message>
        <source>Column scan, constant ΔR</source>
        <translation>Spaltenrasterung, konstantes ΔR</translation>
    </message>
    <message>
        <source>Row edge walking, constant ΔR</source>
        <translation>Kantenlauf zeilenweise, konstantes ΔR</translation>
    </message>
    <message>
        <source>Edge equations, canonical end</source>
        <translation>Kantengleichungen, kanonisches Ende</translation>
    </message>
    <message>
        <source>Barycentric, relative</source>
        <translation>Baryzentrisch, relativ</translation>
    </message>
    <message>
        <source>Bilinear interpolation</source>
        <translation>Bilineare Interpolation</translation>
    </message>
    <message>
        <source>Bilinear interpolation by rows</source>
        <translation>Bilineare Interpolation nach Zeilen</translation>
    </message>
    <message>
        <source>Plane equation</source>
        <translation>Ebenengleichung</translation>
    </message>
    <message>
        <source>Barycentric interpolation</source>
        <translation>Baryzentrische Interpolation</translation>
    </message>
    <message>
        <source>Line: DDA</source>
        <translation>Linie: DDA</translation>
    </message>
    <message>
        <source>Line: y = m·x + b</source>
        <translation>Linie: y = m·x + b</translation>
    </message>
    <message>
        <source>Line: P(t)</source>
        <translation>Linie: P(t)</translation>
    </message>
    <message>
        <source>Line: Bresenham</source>
        <translation>Linie: Bresenham</translation>
    </message>
    <message>
        <source>Line: Bresenham, sub-pixel ends</source>
        <translation>Linie: Bresenham, Enden zwischen Pixeln</translation>
    </message>
    <message>
        <source>Circle: midpoint</source>
        <translation>Kreis: Mittelpunktverfahren</translation>
    </message>
    <message>
        <source>Circle: y = ±√(r² − x²)</source>
        <translation>Kreis: y = ±√(r² − x²)</translation>
    </message>
    <message>
        <source>Circle: (r cos θ, r sin θ)</source>
        <translation>Kreis: (r cos θ, r sin θ)</translation>
    </message>
    <message>
        <source>Circle: filled by spans</source>
        <translation>Kreis: in Zeilen gefüllt</translation>
    </message>
    <message>
        <source>Bézier: subdivision</source>
        <translation>Bézier: Unterteilung</translation>
    </message>
    <message>
        <source>Bézier path: filled</source>
        <translation>Bézierpfad: gefüllt</translation>
    </message>
    <message>
        <source>Line or curve: one pixel wide</source>
        <translation>Linie oder Kurve: ein Pixel breit</translation>
    </message>
    <message>
        <source>Polygon by parity</source>
        <translation>Polygon nach Parität</translation>
    </message>
    <message>
        <source>Convex polygon as a fan</source>
        <translation>Konvexes Polygon als Fächer</translation>
    </message>
    <message>
        <source>Polygon by Delaunay triangulation</source>
        <translation>Polygon mit Delaunay-Triangulierung</translation>
    </message>
    <message>
        <source>Polygon by tessellation</source>
        <translation>Polygon mit Tessellation</translation>
    </message>
    <message>
        <source>Polygon outline</source>
        <translation>Polygonumriss</translation>
    </message>
    <message>
        <source>Points by address</source>
        <translation>Punkte nach Adresse</translation>
    </message>
    <message>
        <source>Text as outlines</source>
        <translation>Text als Umrisse</translation>
    </message>
    <message>
        <source>first half</source>
        <translation>erste Hälfte</translation>
    </message>
    <message>
        <source>second half</source>
        <translation>zweite Hälfte</translation>
    </message>
    <message>
        <source>first trapezoid</source>
        <translation>erstes Trapez</translation>
    </message>
    <message>
        <source>second trapezoid</source>
        <translation>zweites Trapez</translation>
    </message>
    <message>
        <source>pictures right</source>
        <translation>Bilder richtig</translation>
    </message>
    <message>
        <source>breaks runs</source>
        <translation>verletzt runs</translation>
    </message>
    <message>
        <source>breaks bounds</source>
        <translation>verletzt bounds</translation>
    </message>
    <message>
        <source>breaks range</source>
        <translation>verletzt range</translation>
    </message>
    <message>
        <source>breaks corners</source>
        <translation>verletzt corners</translation>
    </message>
    <message>
        <source>breaks count</source>
        <translation>verletzt count</translation>
    </message>
    <message>
        <source>breaks order</source>
        <translation>verletzt order</translation>
    </message>
    <message>
        <source>breaks translation</source>
        <translation>verletzt translation</translation>
    </message>
    <message>
        <source>breaks once</source>
        <translation>verletzt once</translation>
    </message>
    <message>
        <source>did not draw what invariants ask</source>
        <translation>zeichnete nicht, was die Invarianten fragen</translation>
    </message>
    <message>
        <source>right within leeway</source>
        <translation>richtig im Spielraum</translation>
    </message>
    <message>
        <source>right within leeway in coverage</source>
        <translation>richtig im Spielraum in der Abdeckung</translation>
    </message>
    <message>
        <source>pictures right within leeway</source>
        <translation>Bilder richtig im Spielraum</translation>
    </message>
    <message>
        <source>Random, %1 px</source>
        <translation>Zufällig, %1 px</translation>
    </message>
    <message>
        <source>half</source>
        <translation>Hälfte</translation>
    </message>
    <message>
        <source>trapezoid</source>
        <translation>Trapez</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>first R</source>
        <translation>erstes R</translation>
    </message>
    <message>
        <source>first G</source>
        <translation>erstes G</translation>
    </message>
    <message>
        <source>first B</source>
        <translation>erstes B</translation>
    </message>
    <message>
        <source>first C</source>
        <translation>erstes C</translation>
    </message>
    <message>
        <source>first row</source>
        <translation>erste Zeile</translation>
    </message>
    <message>
        <source>last row</source>
        <translation>letzte Zeile</translation>
    </message>
    <message>
        <source>first column</source>
        <translation>erste Spalte</translation>
    </message>
    <message>
        <source>last column</source>
        <translation>letzte Spalte</translation>
    </message>
    <message>
        <source>the first row</source>
        <translation>die erste Zeile</translation>
    </message>
    <message>
        <source>the last row</source>
        <translation>die letzte Zeile</translation>
    </message>
    <message>
        <source>the first column</source>
        <translation>die erste Spalte</translation>
    </message>
    <message>
        <source>the last column</source>
        <translation>die letzte Spalte</translation>
    </message>
    <message>
        <source>the number of pixels</source>
        <translation>die Anzahl der Pixel</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>half-open-column</source>
        <translation>Spalte halboffen</translation>
    </message>
    <message>
        <source>top-left</source>
        <translation>oben-links</translation>
    </message>
    <message>
        <source>off-screen-point</source>
        <translation>Punkt außen</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>gerundet</translation>
    </message>
    <message>
        <source>truncate</source>
        <translation>gekappt</translation>
    </message>
    <message>
        <source>Sorted by x: P₀ = vertex %1 (%2, %3), P₁ = vertex %4 (%5, %6), P₂ = vertex %7 (%8, %9).</source>
        <translation>Nach x sortiert: P₀ = Eckpunkt %1 (%2, %3), P₁ = Eckpunkt %4 (%5, %6), P₂ = Eckpunkt %7 (%8, %9).</translation>
    </message>
    <message>
        <source>Sorted by y, the largest first: P₀ = vertex %1 (%2, %3), P₁ = vertex %4 (%5, %6), P₂ = vertex %7 (%8, %9).</source>
        <translation>Nach y sortiert, das größte zuerst: P₀ = Eckpunkt %1 (%2, %3), P₁ = Eckpunkt %4 (%5, %6), P₂ = Eckpunkt %7 (%8, %9).</translation>
    </message>
    <message>
        <source>Sorted by y, the largest first: P₀ = (%1, %2), P₂ = (%3, %4).</source>
        <translation>Nach y sortiert, das größte zuerst: P₀ = (%1, %2), P₂ = (%3, %4).</translation>
    </message>
    <message>
        <source>It has no area: the closed rule paints the samples on its segment, coloured along L₀₂.</source>
        <translation>Es hat keine Fläche: Die geschlossene Regel malt die Abtastpunkte auf seiner Strecke, gefärbt entlang L₀₂.</translation>
    </message>
    <message>
        <source>It has no area: its vertices lie on one line, and only a triangle under the closed rule is drawn as a segment.</source>
        <translation>Es hat keine Fläche: Die Eckpunkte liegen auf einer Geraden, und nur ein Dreieck unter der geschlossenen Regel wird als Strecke gezeichnet.</translation>
    </message>
    <message>
        <source>It lies outside the frame.</source>
        <translation>Es liegt außerhalb der Bildfläche.</translation>
    </message>
    <message>
        <source>Nothing is drawn.</source>
        <translation>Nichts wird gezeichnet.</translation>
    </message>
    <message>
        <source>It reaches into the frame, but by the run&apos;s tests no sample of the frame belongs to it.</source>
        <translation>Es reicht in die Bildfläche, aber nach den Prüfungen des Laufs gehört ihm kein Abtastpunkt der Bildfläche.</translation>
    </message>
    <message>
        <source>All coordinates are counted from the centre of pixel (%1, %2): ½ px less than the scene&apos;s.</source>
        <translation>Alle Koordinaten zählen von der Mitte des Pixels (%1, %2) aus: ½ px weniger als in der Szene.</translation>
    </message>
    <message>
        <source>The bounds are equal, so there is no change to spread between them, and no Δ.</source>
        <translation>Die Grenzen sind gleich, also gibt es zwischen ihnen keine Änderung zu verteilen und kein Δ.</translation>
    </message>
    <message>
        <source>Each level is computed from P₀ anew.</source>
        <translation>Jede Farbstufe wird von P₀ aus neu berechnet.</translation>
    </message>
    <message>
        <source>L₀₁ and L₁₂ give y_B, L₀₂ gives y_T.</source>
        <translation>L₀₁ und L₁₂ geben y_B, L₀₂ gibt y_T.</translation>
    </message>
    <message>
        <source>L₀₂ gives y_B, L₀₁ and L₁₂ give y_T.</source>
        <translation>L₀₂ gibt y_B, L₀₁ und L₁₂ geben y_T.</translation>
    </message>
    <message>
        <source>x₀ = x₁: L₀₁ has no slope, and the first half is skipped.</source>
        <translation>x₀ = x₁: L₀₁ hat keine Steigung, und die erste Hälfte wird übersprungen.</translation>
    </message>
    <message>
        <source>x₁ = x₂: L₁₂ has no slope, and the second half is one column at most.</source>
        <translation>x₁ = x₂: L₁₂ hat keine Steigung, und die zweite Hälfte ist höchstens eine Spalte.</translation>
    </message>
    <message>
        <source>The scan starts in the second half, between L₁₂ and L₀₂.</source>
        <translation>Die Rasterung beginnt in der zweiten Hälfte, zwischen L₁₂ und L₀₂.</translation>
    </message>
    <message>
        <source>At x₁ the scan stops tracking L₀₁ and starts L₁₂ at P₁.</source>
        <translation>Bei x₁ verlässt die Rasterung L₀₁ und beginnt L₁₂ bei P₁.</translation>
    </message>
    <message>
        <source>Between y_B = %1 and y_T = %2 the fill rule takes no sample of the frame.</source>
        <translation>Zwischen y_B = %1 und y_T = %2 nimmt die Füllregel keinen Abtastpunkt der Bildfläche.</translation>
    </message>
    <message>
        <source>y_B = %1 and y_T = %2 have just the row %3 between them, exactly on an edge, and the fill rule does not take it.</source>
        <translation>Zwischen y_B = %1 und y_T = %2 liegt nur die Zeile %3, genau auf einer Kante, und die Füllregel nimmt sie nicht.</translation>
    </message>
    <message>
        <source>y_B = %1 and y_T = %2 have just the rows %3 and %4 between them, exactly on edges, and the fill rule takes neither.</source>
        <translation>Zwischen y_B = %1 und y_T = %2 liegen nur die Zeilen %3 und %4, genau auf Kanten, und die Füllregel nimmt keine davon.</translation>
    </message>
    <message>
        <source>y_B = %1 and y_T = %2 cover the row %3.</source>
        <translation>y_B = %1 und y_T = %2 bedecken die Zeile %3.</translation>
    </message>
    <message>
        <source>y_B = %1 and y_T = %2 cover the rows %3 to %4.</source>
        <translation>y_B = %1 und y_T = %2 bedecken die Zeilen %3 bis %4.</translation>
    </message>
    <message>
        <source>Without a pre-step, an edge that begins here has its vertex&apos;s values, wherever between two columns the vertex lies.</source>
        <translation>Ohne Vorschritt hat eine Kante, die hier beginnt, die Werte ihres Eckpunkts, wo auch immer er zwischen zwei Spalten liegt.</translation>
    </message>
    <message>
        <source>Without a pre-step, the first row has the colours of y_B: (⌈y_B⌉ − y_B)·Δ is left out.</source>
        <translation>Ohne Vorschritt hat die erste Zeile die Farben von y_B: (⌈y_B⌉ − y_B)·Δ fehlt.</translation>
    </message>
    <message>
        <source>The column&apos;s first pixel takes the starting values of R, G and B.</source>
        <translation>Das erste Pixel der Spalte bekommt die Anfangswerte von R, G und B.</translation>
    </message>
    <message>
        <source>The next row: each level changes by its Δ.</source>
        <translation>Die nächste Zeile: Jede Farbstufe ändert sich um ihr Δ.</translation>
    </message>
    <message>
        <source>the second half comes first: L₁₂ and L₀₂</source>
        <translation>die zweite Hälfte kommt zuerst: L₁₂ und L₀₂</translation>
    </message>
    <message>
        <source>x₁ reached: L₁₂ takes over from L₀₁</source>
        <translation>x₁ erreicht: L₁₂ löst L₀₁ ab</translation>
    </message>
    <message>
        <source>L₀₁ and L₁₂ give x_L, L₀₂ gives x_R.</source>
        <translation>L₀₁ und L₁₂ geben x_L, L₀₂ gibt x_R.</translation>
    </message>
    <message>
        <source>L₀₂ gives x_L, L₀₁ and L₁₂ give x_R.</source>
        <translation>L₀₂ gibt x_L, L₀₁ und L₁₂ geben x_R.</translation>
    </message>
    <message>
        <source>y₀ = y₁: L₀₁ has no slope, and the first trapezoid is skipped.</source>
        <translation>y₀ = y₁: L₀₁ hat keine Steigung, und das erste Trapez wird übersprungen.</translation>
    </message>
    <message>
        <source>y₁ = y₂: L₁₂ has no slope, and the second trapezoid is one row at most.</source>
        <translation>y₁ = y₂: L₁₂ hat keine Steigung, und das zweite Trapez ist höchstens eine Zeile.</translation>
    </message>
    <message>
        <source>The scan starts in the second trapezoid, between L₁₂ and L₀₂.</source>
        <translation>Die Rasterung beginnt im zweiten Trapez, zwischen L₁₂ und L₀₂.</translation>
    </message>
    <message>
        <source>At y₁ the scan stops tracking L₀₁ and starts L₁₂ at P₁.</source>
        <translation>Bei y₁ verlässt die Rasterung L₀₁ und beginnt L₁₂ bei P₁.</translation>
    </message>
    <message>
        <source>Between x_L = %1 and x_R = %2 the fill rule takes no sample of the frame.</source>
        <translation>Zwischen x_L = %1 und x_R = %2 nimmt die Füllregel keinen Abtastpunkt der Bildfläche.</translation>
    </message>
    <message>
        <source>x_L = %1 and x_R = %2 have just the column %3 between them, exactly on an edge, and the fill rule does not take it.</source>
        <translation>Zwischen x_L = %1 und x_R = %2 liegt nur die Spalte %3, genau auf einer Kante, und die Füllregel nimmt sie nicht.</translation>
    </message>
    <message>
        <source>x_L = %1 and x_R = %2 have just the columns %3 and %4 between them, exactly on edges, and the fill rule takes neither.</source>
        <translation>Zwischen x_L = %1 und x_R = %2 liegen nur die Spalten %3 und %4, genau auf Kanten, und die Füllregel nimmt keine davon.</translation>
    </message>
    <message>
        <source>x_L = %1 and x_R = %2 cover the column %3.</source>
        <translation>x_L = %1 und x_R = %2 bedecken die Spalte %3.</translation>
    </message>
    <message>
        <source>x_L = %1 and x_R = %2 cover the columns %3 to %4.</source>
        <translation>x_L = %1 und x_R = %2 bedecken die Spalten %3 bis %4.</translation>
    </message>
    <message>
        <source>Without a pre-step, an edge that begins here has its vertex&apos;s values, wherever between two rows the vertex lies.</source>
        <translation>Ohne Vorschritt hat eine Kante, die hier beginnt, die Werte ihres Eckpunkts, wo auch immer er zwischen zwei Zeilen liegt.</translation>
    </message>
    <message>
        <source>Without a pre-step, the first column has the colours of x_L: (⌈x_L⌉ − x_L)·Δ is left out.</source>
        <translation>Ohne Vorschritt hat die erste Spalte die Farben von x_L: (⌈x_L⌉ − x_L)·Δ fehlt.</translation>
    </message>
    <message>
        <source>The row&apos;s first pixel takes the starting values of R, G and B.</source>
        <translation>Das erste Pixel der Zeile bekommt die Anfangswerte von R, G und B.</translation>
    </message>
    <message>
        <source>The next column: each level changes by its Δ.</source>
        <translation>Die nächste Spalte: Jede Farbstufe ändert sich um ihr Δ.</translation>
    </message>
    <message>
        <source>the second trapezoid comes first: L₁₂ and L₀₂</source>
        <translation>das zweite Trapez kommt zuerst: L₁₂ und L₀₂</translation>
    </message>
    <message>
        <source>y₁ reached: L₁₂ takes over from L₀₁</source>
        <translation>y₁ erreicht: L₁₂ löst L₀₁ ab</translation>
    </message>
    <message>
        <source>In English: %1</source>
        <translation>Auf Englisch: %1</translation>
    </message>
    <message>
        <source>All agree.</source>
        <translation>Alle stimmen überein.</translation>
    </message>
    <message>
        <source>The sample lies exactly on an edge, where the fill rules disagree.</source>
        <translation>Der Abtastpunkt liegt genau auf einer Kante, wo die Füllregeln sich unterscheiden.</translation>
    </message>
    <message>
        <source>One of the methods does not draw the kind of primitive that covers this pixel.</source>
        <translation>Eines der Verfahren zeichnet die Art von Primitiv nicht, die dieses Pixel bedeckt.</translation>
    </message>
    <message>
        <source>The coverage is the same, but a level close to a rounding limit was rounded the other way.</source>
        <translation>Die Abdeckung ist dieselbe, aber eine Farbstufe nahe der Rundungsgrenze wurde zur anderen Seite gerundet.</translation>
    </message>
    <message>
        <source>The number type can represent the exact value, but the accumulated increments missed it.</source>
        <translation>Der Zahlentyp kann den exakten Wert darstellen, aber die Summe der Zuwächse hat ihn verfehlt.</translation>
    </message>
    <message>
        <source>The number type cannot represent the deciding value closely enough.</source>
        <translation>Der Zahlentyp kann den entscheidenden Wert nicht genau genug darstellen.</translation>
    </message>
    <message>
        <source>The method itself differs from the truth, even in exact arithmetic.</source>
        <translation>Das Verfahren selbst weicht von der Wahrheit ab, auch in exakter Arithmetik.</translation>
    </message>
    <message>
        <source>The recording reached its limit before this pixel.</source>
        <translation>Die Aufzeichnung erreichte ihre Grenze vor diesem Pixel.</translation>
    </message>
    <message>
        <source>tri</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>the first R</source>
        <translation>das erste R</translation>
    </message>
    <message>
        <source>the first G</source>
        <translation>das erste G</translation>
    </message>
    <message>
        <source>the first B</source>
        <translation>das erste B</translation>
    </message>
    <message>
        <source>the triangle has vertex colours that differ</source>
        <translation>die Eckpunkte des Dreiecks haben verschiedene Farben</translation>
    </message>
    <message>
        <source>what is drawn lies within the frame</source>
        <translation>was gezeichnet wird, liegt in der Bildfläche</translation>
    </message>
    <message>
        <source>fewer than two triangles are drawn in the frame</source>
        <translation>in der Bildfläche werden weniger als zwei Dreiecke gezeichnet</translation>
    </message>
    <message>
        <source>w is the same at the vertices of every triangle</source>
        <translation>w ist an den Eckpunkten jedes Dreiecks gleich</translation>
    </message>
    <message>
        <source>no triangle has a material with a texture</source>
        <translation>kein Dreieck hat ein Material mit Textur</translation>
    </message>
    <message>
        <source>no light is on</source>
        <translation>kein Licht ist an</translation>
    </message>
    <message>
        <source>every alpha is %1: opaque</source>
        <translation>jedes Alpha ist %1: deckend</translation>
    </message>
    <message>
        <source>the scene asks for one sample a pixel</source>
        <translation>die Szene verlangt einen Abtastpunkt je Pixel</translation>
    </message>
    <message>
        <source>there is no triangle, and nothing else has a depth</source>
        <translation>es gibt kein Dreieck, und nichts anderes hat eine Tiefe</translation>
    </message>
    <message>
        <source>there is no triangle, and nothing else has w</source>
        <translation>es gibt kein Dreieck, und nichts anderes hat w</translation>
    </message>
    <message>
        <source>there is no triangle, and nothing else has a texture</source>
        <translation>es gibt kein Dreieck, und nichts anderes hat eine Textur</translation>
    </message>
    <message>
        <source>there is no triangle, and nothing else has normals</source>
        <translation>es gibt kein Dreieck, und nichts anderes hat Normalen</translation>
    </message>
    <message>
        <source>there is no triangle, and nothing else has an alpha</source>
        <translation>es gibt kein Dreieck, und nichts anderes hat ein Alpha</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Colours: light, dark or system.</source>
        <translation>Farben: light (hell), dark (dunkel) oder system.</translation>
    </message>
    <message>
        <source>Start with the first &lt;steps&gt; steps done.</source>
        <translation>Mit den ersten &lt;steps&gt; Schritten beginnen.</translation>
    </message>
    <message>
        <source>Start as column &lt;x&gt; is entered.</source>
        <translation>Beim Betreten der Spalte &lt;x&gt; beginnen.</translation>
    </message>
    <message>
        <source>Draw by this method.</source>
        <translation>Mit diesem Verfahren zeichnen.</translation>
    </message>
    <message>
        <source>Instead of the scene&apos;s, one of: %1.</source>
        <translation>Anstelle dessen, was die Szene sagt, eines von: %1.</translation>
    </message>
    <message>
        <source>See and step through triangle scan conversion.</source>
        <translation>Die Rasterung von Dreiecken sehen und Schritt für Schritt durchgehen.</translation>
    </message>
    <message>
        <source>A scene file to open, or a folder of results of pixelplumb-cli grade, to look through in Grading.</source>
        <translation>Eine Szenendatei, die geöffnet wird, oder ein Ordner mit Ergebnissen von pixelplumb-cli grade, der in „Bewertung“ durchgesehen wird.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::AccuracyLab</name>
    <message>
        <source>Accuracy lab</source>
        <translation>Genauigkeitslabor</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Machine, compiler and command to reproduce this</source>
        <translation>Rechner, Compiler und der Befehl, der es wiederholt</translation>
    </message>
    <message>
        <source>Open Results</source>
        <translation>Ergebnisse öffnen</translation>
    </message>
    <message>
        <source>Save the Results</source>
        <translation>Ergebnisse speichern</translation>
    </message>
    <message>
        <source>Results of the lab (*.json)</source>
        <translation>Ergebnisse des Labors (*.json)</translation>
    </message>
    <message>
        <source>Save the Table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation>CSV-Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>There is no command because the scene was not saved when it was measured. Save it and run the lab again.</source>
        <translation>Es gibt keinen Befehl: Die Szene war in keiner Datei, als gemessen wurde. Erst speichern, dann noch einmal messen.</translation>
    </message>
    <message>
        <source>The command is on the clipboard.</source>
        <translation>Der Befehl ist in der Zwischenablage.</translation>
    </message>
    <message>
        <source>Cancelled before anything was timed; the earlier results stay.</source>
        <translation>Abgebrochen, bevor etwas gemessen war: Die vorigen Ergebnisse bleiben.</translation>
    </message>
    <message>
        <source>The first pictures are being judged.</source>
        <translation>Die ersten Bilder werden beurteilt.</translation>
    </message>
    <message>
        <source>These are the results of the previous run, until this run has times for this family.</source>
        <translation>Ergebnisse von vor diesem Lauf, bis er Zeiten dieser Familie hat.</translation>
    </message>
    <message>
        <source>There is no wrong pixel to look at here.</source>
        <translation>Hier gibt es kein falsches Pixel anzusehen.</translation>
    </message>
    <message>
        <source>The table is in front: choose the tab of a chart.</source>
        <translation>Vorn steht eine Tabelle: erst den Reiter eines Diagramms wählen.</translation>
    </message>
    <message>
        <source>Save the Chart</source>
        <translation>Diagramm speichern</translation>
    </message>
    <message>
        <source>SVG drawings (*.svg);;PNG pictures (*.png)</source>
        <translation>SVG-Zeichnungen (*.svg);;PNG-Bilder (*.png)</translation>
    </message>
</context>
<context>
    <name>pixelplumb::AgreementView</name>
    <message>
        <source>Agreement map</source>
        <translation>Karte der Übereinstimmung</translation>
    </message>
    <message>
        <source>How many agree on each pixel. A click tells the reason.</source>
        <translation>Wie viele bei jedem Pixel übereinstimmen. Ein Klick nennt den Grund.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::Canvas</name>
    <message>
        <source>Canvas</source>
        <translation>Zeichenfläche</translation>
    </message>
    <message>
        <source>The frame with its triangles. A click places a vertex or, with the tool Inspect, picks a pixel. Arrows move the picked pixel, Enter places a vertex there, brackets choose a vertex, Control with arrows moves it, C changes its colour.</source>
        <translation>Die Bildfläche mit ihren Dreiecken. Ein Klick setzt einen Eckpunkt oder wählt mit dem Werkzeug Prüfen ein Pixel. Pfeiltasten bewegen das gewählte Pixel, die Eingabetaste setzt dort einen Eckpunkt, eckige Klammern wählen einen Eckpunkt, Strg mit Pfeiltasten bewegt ihn, C ändert seine Farbe.</translation>
    </message>
    <message>
        <source>waiting vertex %1 at %2</source>
        <translation>wartender Eckpunkt %1 bei %2</translation>
    </message>
    <message>
        <source>vertex %1 of %2 %3 at %4</source>
        <translation>Eckpunkt %1 von %2 %3 bei %4</translation>
    </message>
    <message>
        <source>image of vertex %1 at %2</source>
        <translation>Bild des Eckpunkts %1 bei %2</translation>
    </message>
    <message>
        <source>pixel (%1, %2)</source>
        <translation>Pixel (%1, %2)</translation>
    </message>
    <message>
        <source>no pixel is picked</source>
        <translation>kein Pixel ist gewählt</translation>
    </message>
    <message>
        <source>%1 (vertex %2)</source>
        <translation>%1 (Eckpunkt %2)</translation>
    </message>
    <message>
        <source>Still the picture of %1</source>
        <translation>Noch das Bild von %1</translation>
    </message>
    <message>
        <source>Truth: the exact picture</source>
        <translation>Wahrheit: das exakte Bild</translation>
    </message>
    <message>
        <source>Marked: the student&apos;s picture</source>
        <translation>Markiert: das abgegebene Bild</translation>
    </message>
    <message>
        <source>Finished picture; the first %L1 steps are recorded</source>
        <translation>Fertiges Bild; aufgezeichnet sind die ersten %L1 Schritte</translation>
    </message>
    <message>
        <source>More than %1 in view: outlines and handles show only under the pointer and for the current triangle</source>
        <translation>Umrisse und Griffe nur unter dem Zeiger und beim aktuellen: über %1 im Blick</translation>
    </message>
    <message>
        <source>The truth is hidden while Predict asks</source>
        <translation>Die Wahrheit ist verborgen, solange „Vorhersagen“ fragt</translation>
    </message>
    <message>
        <source>P0 (centre)</source>
        <translation>P0 (Mitte)</translation>
    </message>
    <message>
        <source>P1 (corner of its box)</source>
        <translation>P1 (Ecke des Rechtecks)</translation>
    </message>
    <message>
        <source>move image</source>
        <translation>Bild des Dreiecks verschieben</translation>
    </message>
    <message>
        <source>The student&apos;s picture (S); hold Shift for the expected one</source>
        <translation>Das eingereichte Bild (S); Umschalt halten für das erwartete</translation>
    </message>
    <message>
        <source>Two coordinates are needed: x; y.</source>
        <translation>Zwei Koordinaten werden gebraucht: x; y.</translation>
    </message>
    <message>
        <source>Vertex coordinates</source>
        <translation>Koordinaten des Eckpunkts</translation>
    </message>
    <message>
        <source>x; y in px: whole numbers, decimals and fractions such as 53/2</source>
        <translation>x; y in px: ganze Zahlen, Dezimalzahlen mit Punkt und Brüche wie 53/2</translation>
    </message>
    <message>
        <source>Expected picture</source>
        <translation>Erwartetes Bild</translation>
    </message>
</context>
<context>
    <name>pixelplumb::CanvasMenu</name>
    <message>
        <source>Vertex &amp;colour…</source>
        <translation>&amp;Farbe des Eckpunkts …</translation>
    </message>
    <message>
        <source>&amp;Coordinates…</source>
        <translation>&amp;Koordinaten …</translation>
    </message>
    <message>
        <source>&amp;Text…</source>
        <translation>&amp;Text …</translation>
    </message>
    <message>
        <source>&amp;Hide %1</source>
        <translation>%1 &amp;ausblenden</translation>
    </message>
    <message>
        <source>&amp;Delete vertex</source>
        <translation>Eckpunkt &amp;löschen</translation>
    </message>
    <message>
        <source>&amp;Delete %1</source>
        <translation>%1 &amp;löschen</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>The characters that are drawn:</source>
        <translation>Die Zeichen, die gezeichnet werden:</translation>
    </message>
</context>
<context>
    <name>pixelplumb::ColourButton</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>“%1” has an opacity</source>
        <translation>„%1“ hat eine Deckkraft</translation>
    </message>
    <message>
        <source>#rrggbb in hexadecimal digits</source>
        <translation>#rrggbb in hexadezimalen Ziffern</translation>
    </message>
</context>
<context>
    <name>pixelplumb::ColumnTable</name>
    <message>
        <source>Columns of the scan</source>
        <translation>Spalten der Rasterung</translation>
    </message>
    <message>
        <source>A row for each column; the highlighted row is the current column.</source>
        <translation>Je Spalte eine Zeile; die markierte Zeile ist die aktuelle Spalte.</translation>
    </message>
    <message>
        <source>No row is of the chosen kind.</source>
        <translation>Keine Zeile ist von der gewählten Art.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Show the column and its half</source>
        <translation>Die Spalte und ihre Hälfte zeigen</translation>
    </message>
    <message>
        <source>Span</source>
        <translation>Spanne</translation>
    </message>
    <message>
        <source>Show where the edges meet the column, and its rows</source>
        <translation>Zeigen, wo die Kanten die Spalte treffen, und ihre Zeilen</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>Entscheidung</translation>
    </message>
    <message>
        <source>Show the numbers that decide the samples</source>
        <translation>Die Zahlen zeigen, die über die Abtastpunkte entscheiden</translation>
    </message>
    <message>
        <source>Edge colours</source>
        <translation>Kantenfarben</translation>
    </message>
    <message>
        <source>ΔR ΔG ΔB</source>
        <translation>ΔR ΔG ΔB</translation>
    </message>
    <message>
        <source>Show the change from sample to sample</source>
        <translation>Die Änderung von Abtastpunkt zu Abtastpunkt zeigen</translation>
    </message>
    <message>
        <source>First R G B</source>
        <translation>Erste R G B</translation>
    </message>
    <message>
        <source>Show the levels at the first pixel</source>
        <translation>Die Farbwerte am ersten Pixel zeigen</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>Show beside each what the same run gives in exact numbers</source>
        <translation>Neben jeder zeigen, was derselbe Lauf in exakten Zahlen ergibt</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Show used minus exact beside each</source>
        <translation>Neben jeder die benutzte minus die exakte zeigen</translation>
    </message>
    <message>
        <source>Copy rows</source>
        <translation>Zeilen kopieren</translation>
    </message>
    <message>
        <source>Copy all rows shown</source>
        <translation>Alle gezeigten Zeilen kopieren</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Beside each number</source>
        <translation>Neben jeder Zahl</translation>
    </message>
    <message>
        <source>Show the levels at both edges and where the colours start</source>
        <translation>Die Farbwerte an beiden Kanten zeigen und wo die Farben beginnen</translation>
    </message>
</context>
<context>
    <name>pixelplumb::ColumnTableModel</name>
    <message>
        <source>%1 exact</source>
        <translation>%1 exakt</translation>
    </message>
    <message>
        <source>%1 error</source>
        <translation>%1 Fehler</translation>
    </message>
</context>
<context>
    <name>pixelplumb::ColumnTablePanel</name>
    <message>
        <source>Rows of the table</source>
        <translation>Zeilen der Tabelle</translation>
    </message>
    <message>
        <source>Show all rows, or those in which a sample lies on an edge (=), a level went outside 0 … 255 (^), or a pixel differs from the truth (?, !, c)</source>
        <translation>Alle Zeilen zeigen oder nur die, in denen ein Abtastpunkt auf einer Kante liegt (=), ein Farbwert 0 … 255 verließ (^) oder ein Pixel von der Wahrheit abweicht (?, !, c)</translation>
    </message>
    <message>
        <source>all rows</source>
        <translation>alle Zeilen</translation>
    </message>
    <message>
        <source>ties =</source>
        <translation>Grenzfälle =</translation>
    </message>
    <message>
        <source>clamps ^</source>
        <translation>begrenzt ^</translation>
    </message>
    <message>
        <source>errors ? ! c</source>
        <translation>Fehler ? ! c</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message numerus="yes">
        <source>%n columns</source>
        <translation>
            <numerusform>%n Spalte</numerusform>
            <numerusform>%n Spalten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rows</source>
        <translation>
            <numerusform>%n Zeile</numerusform>
            <numerusform>%n Zeilen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>%n primitives</source>
        <translation>
            <numerusform>%n Primitiv</numerusform>
            <numerusform>%n Primitive</numerusform>
        </translation>
    </message>
    <message>
        <source>recording ended at its limit</source>
        <translation>Aufzeichnung endete an ihrer Grenze</translation>
    </message>
    <message>
        <source>? hidden by Predict</source>
        <translation>? verborgen</translation>
    </message>
</context>
<context>
    <name>pixelplumb::ComparePane</name>
    <message>
        <source>Method of pane %1</source>
        <translation>Verfahren der Ansicht %1</translation>
    </message>
    <message>
        <source>Arithmetic of pane %1</source>
        <translation>Arithmetik der Ansicht %1</translation>
    </message>
    <message>
        <source>Fill rule of pane %1</source>
        <translation>Füllregel der Ansicht %1</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>Wahrheit</translation>
    </message>
    <message>
        <source>Picture of pane %1</source>
        <translation>Bild der Ansicht %1</translation>
    </message>
    <message>
        <source>Draws nothing of this scene.</source>
        <translation>Zeichnet nichts von dieser Szene.</translation>
    </message>
    <message numerus="yes">
        <source>%n pixels, shown finished</source>
        <translation>
            <numerusform>%n Pixel, fertig gezeigt</numerusform>
            <numerusform>%n Pixel, fertig gezeigt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pixels: %1 missing, %2 extra, %3 in another colour</source>
        <translation>
            <numerusform>%n Pixel: %1 fehlen, %2 überzählig, %3 in anderer Farbe</numerusform>
            <numerusform>%n Pixel: %1 fehlen, %2 überzählig, %3 in anderer Farbe</numerusform>
        </translation>
    </message>
    <message>
        <source>; %1 undrawn, of other kinds</source>
        <translation>; %1 ungezeichnet, von anderer Art</translation>
    </message>
    <message>
        <source>; with %1</source>
        <translation>; mit %1</translation>
    </message>
    <message numerus="yes">
        <source>%4 of %n pixels so far: %1 missing, %2 extra, %3 in another colour</source>
        <translation>
            <numerusform>%4 von %n Pixel bisher: %1 fehlen, %2 zu viel, %3 in anderer Farbe</numerusform>
            <numerusform>%4 von %n Pixeln bisher: %1 fehlen, %2 zu viel, %3 in anderer Farbe</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 missing</source>
        <translation>%1 fehlen</translation>
    </message>
    <message>
        <source>%1 extra</source>
        <translation>%1 zu viel</translation>
    </message>
    <message>
        <source>%1 wrong colour</source>
        <translation>%1 andere Farbe</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>correct so far</source>
        <translation>bisher richtig</translation>
    </message>
</context>
<context>
    <name>pixelplumb::ComparePanel</name>
    <message>
        <source>Why the picked pixel differs</source>
        <translation>Warum das gewählte Pixel abweicht</translation>
    </message>
    <message>
        <source>Take the last pane away</source>
        <translation>Die letzte Ansicht entfernen</translation>
    </message>
    <message>
        <source>Add a pane, four at most</source>
        <translation>Eine Ansicht hinzufügen, höchstens vier</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the whole frame in every pane</source>
        <translation>In jeder Ansicht die ganze Bildfläche zeigen</translation>
    </message>
    <message>
        <source>The comparison was cancelled. Change a pane or the scene to start it again.</source>
        <translation>Der Vergleich wurde abgebrochen. Er beginnt neu, wenn sich eine Ansicht oder die Szene ändert.</translation>
    </message>
    <message>
        <source>The scene is being drawn.</source>
        <translation>Die Szene wird gezeichnet.</translation>
    </message>
    <message>
        <source>The comparison does not fit into memory. Make the frame smaller.</source>
        <translation>Der Vergleich passt nicht in den Speicher. Eine kleinere Bildfläche passt eher.</translation>
    </message>
    <message>
        <source>Nothing is compared yet.</source>
        <translation>Noch ist nichts verglichen.</translation>
    </message>
    <message>
        <source>All agree on every pixel.</source>
        <translation>Bei jedem Pixel stimmen alle überein.</translation>
    </message>
    <message>
        <source>Pixels that differ: %1. Click one in the picture “Finished” to see why.</source>
        <translation>Abweichende Pixel: %1. Ein Klick auf eines im Bild „Fertig“ nennt den Grund.</translation>
    </message>
    <message>
        <source>Pixel (%1, %2): all agree. Pixels that differ: %3; click one in the picture “Finished” to see why.</source>
        <translation>Pixel (%1, %2): Alle stimmen überein. Abweichende Pixel: %3; ein Klick auf eines im Bild „Fertig“ nennt den Grund.</translation>
    </message>
    <message>
        <source>Pixel (%1, %2): %3 of %4 agree. %5: %6</source>
        <translation>Pixel (%1, %2): %3 von %4 stimmen überein. %5: %6</translation>
    </message>
    <message>
        <source>not drawn</source>
        <translation>nicht gezeichnet</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 and %2, apart from colour: %3</source>
        <translation>%1 und %2 neben der Farbe: %3</translation>
    </message>
    <message>
        <source>Progress of the comparison</source>
        <translation>Fortschritt des Vergleichs</translation>
    </message>
    <message>
        <source>all agree</source>
        <translation>alle einig</translation>
    </message>
    <message>
        <source>none agree</source>
        <translation>keine einig</translation>
    </message>
    <message>
        <source>%1 agree</source>
        <translation>%1 einig</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Where the finished pictures agree</source>
        <translation>Wo die fertigen Bilder übereinstimmen</translation>
    </message>
</context>
<context>
    <name>pixelplumb::DefectStepper</name>
    <message>
        <source>defect %1</source>
        <translation>Defekt %1</translation>
    </message>
</context>
<context>
    <name>pixelplumb::DiagnosisView</name>
    <message>
        <source>Wrong.</source>
        <translation>Falsch.</translation>
    </message>
    <message>
        <source>The search for defects ended in an error: %1.</source>
        <translation>Die Suche nach Defekten endete mit einem Fehler: %1.</translation>
    </message>
    <message>
        <source>Sets that only come near were looked for in %1 of %2 columns or rows: a nearer one may be missing.</source>
        <translation>Mengen, die nur nahe kommen, wurden in %1 von %2 Spalten oder Zeilen gesucht: eine nähere kann fehlen.</translation>
    </message>
    <message>
        <source>No known bug explains it.</source>
        <translation>Kein bekannter Defekt kommt in die Nähe.</translation>
    </message>
    <message>
        <source>No known bug explains it; the nearest ones:</source>
        <translation>Kein bekannter Defekt erklärt es; die nächsten:</translation>
    </message>
    <message numerus="yes">
        <source>%n sets of known bugs produce this picture:</source>
        <translation>
            <numerusform>Eine Menge bekannter Defekte zeichnet genau dieses Bild:</numerusform>
            <numerusform>%n Mengen bekannter Defekte zeichnen genau dieses Bild:</numerusform>
        </translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>Naming the bug</source>
        <translation>Benennen des Fehlers</translation>
    </message>
    <message>
        <source>Name the &amp;bug</source>
        <translation>&amp;Fehler benennen</translation>
    </message>
    <message>
        <source>Find the one or two known defects that draw exactly this picture</source>
        <translation>Die bekannten Defekte finden, einen oder zwei, die genau dieses Bild zeichnen</translation>
    </message>
    <message>
        <source>Sets of defects that are tried</source>
        <translation>Mengen von Defekten, die erprobt werden</translation>
    </message>
    <message>
        <source>Whose words</source>
        <translation>Wessen Worte</translation>
    </message>
    <message>
        <source>Who reads it. Student: where to look. Assistant: what the program does.</source>
        <translation>Für wen. Studierende: wo zu suchen ist. Betreuung: was getan wurde.</translation>
    </message>
    <message>
        <source>student</source>
        <translation>Studierende</translation>
    </message>
    <message>
        <source>assistant</source>
        <translation>Betreuung</translation>
    </message>
    <message>
        <source>What the diagnosis says</source>
        <translation>Was die Diagnose sagt</translation>
    </message>
    <message>
        <source>Sets of defects</source>
        <translation>Mengen von Defekten</translation>
    </message>
    <message>
        <source>What the chosen defects are</source>
        <translation>Was die gewählten Defekte sind</translation>
    </message>
    <message>
        <source>Step through it</source>
        <translation>In Schritten ansehen</translation>
    </message>
    <message>
        <source>Run the scene with these defects in Step, from the first step that differs from the right run. If no run can have these defects, show that step of the right run. Alt+Left: back</source>
        <translation>Die Szene mit diesen Defekten unter „Schritte“ laufen lassen, ab dem ersten Schritt, der vom richtigen Lauf abweicht. Kann kein Lauf diese Defekte haben, wird jener Schritt des richtigen Laufs gezeigt. Alt+Links: zurück</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>The same, with the right run beside it in Compare</source>
        <translation>Dasselbe mit dem richtigen Lauf daneben im Vergleich</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Back to the scene without defects</source>
        <translation>Zurück zur Szene ohne Defekte</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>The diagnosis does not fit into memory.</source>
        <translation>Die Diagnose passt nicht in den Speicher.</translation>
    </message>
    <message>
        <source>First wrong number: step %1, %2: %3.</source>
        <translation>Erste falsche Zahl: Schritt %1, %2: %3.</translation>
    </message>
    <message>
        <source>Right: no pixel differs, so there is no bug to name.</source>
        <translation>Richtig: Kein Pixel weicht ab, also gibt es keinen Programmfehler zu benennen.</translation>
    </message>
    <message>
        <source>Right within the leeway: every pixel that differs may do so in a right program.</source>
        <translation>Richtig innerhalb des Spielraums: Jedes abweichende Pixel darf in einem richtigen Programm abweichen.</translation>
    </message>
    <message>
        <source>Known bugs produce this picture, except for pixels that rounding or an edge may decide:</source>
        <translation>Bekannte Programmfehler zeichnen dieses Bild, bis auf Pixel, die Rundung oder Kante entscheiden darf:</translation>
    </message>
    <message numerus="yes">
        <source> · except for %n pixels that rounding or an edge may decide</source>
        <translation>
            <numerusform> · bis auf %n Pixel, das Rundung oder Kante entscheiden darf</numerusform>
            <numerusform> · bis auf %n Pixel, die Rundung oder Kante entscheiden darf</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> · %n pixels remain unexplained</source>
        <translation>
            <numerusform> · %n Pixel bleibt unerklärt</numerusform>
            <numerusform> · %n Pixel bleiben unerklärt</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::DifferenceOpening</name>
    <message>
        <source>Drawn to the end: every pixel is as in the truth.</source>
        <translation>Bis zum Ende gezeichnet: Jedes Pixel ist wie in der Wahrheit.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::EditMenu</name>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Wieder&amp;holen</translation>
    </message>
    <message>
        <source>Dra&amp;w</source>
        <translation>&amp;Zeichnen</translation>
    </message>
    <message>
        <source>draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>A click places a vertex, a drag moves one (P)</source>
        <translation>Ein Klick setzt einen Eckpunkt, Ziehen bewegt einen (P)</translation>
    </message>
    <message>
        <source>&amp;Inspect</source>
        <translation>&amp;Prüfen</translation>
    </message>
    <message>
        <source>inspect</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>A click picks the pixel and leaves the scene alone (V)</source>
        <translation>Ein Klick wählt das Pixel und lässt die Szene, wie sie ist (V)</translation>
    </message>
    <message>
        <source>&amp;Copy the picked pixel</source>
        <translation>Gewähltes Pixel &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the raster (&amp;ASCII)</source>
        <translation>R&amp;aster kopieren (ASCII)</translation>
    </message>
    <message>
        <source>&amp;Paste a student&apos;s picture</source>
        <translation>Abgegebenes Bild &amp;einfügen</translation>
    </message>
    <message>
        <source>Add a &amp;triangle…</source>
        <translation>&amp;Dreieck hinzufügen …</translation>
    </message>
    <message>
        <source>Chan&amp;ge the current triangle…</source>
        <translation>Aktuelles Dreieck ä&amp;ndern …</translation>
    </message>
    <message>
        <source>Close the pol&amp;ygon</source>
        <translation>P&amp;olygon schließen</translation>
    </message>
    <message>
        <source>Colour of the &amp;next vertex…</source>
        <translation>Farbe des nä&amp;chsten Eckpunkts …</translation>
    </message>
    <message>
        <source>Colour &amp;of the selected vertex…</source>
        <translation>&amp;Farbe des gewählten Eckpunkts …</translation>
    </message>
    <message>
        <source>&amp;Delete the selected primitive</source>
        <translation>Gewähltes Primitiv &amp;löschen</translation>
    </message>
    <message>
        <source>&amp;Hide the selected primitive</source>
        <translation>Gewähltes Primitiv au&amp;sblenden</translation>
    </message>
    <message>
        <source>Keeps the primitive and does not draw it (the Primitives panel shows it again)</source>
        <translation>Behält das Primitiv und zeichnet es nicht (der Bereich Primitive blendet es wieder ein)</translation>
    </message>
    <message>
        <source>Show all hidden primiti&amp;ves</source>
        <translation>Alle ausgeblendeten Primitive zei&amp;gen</translation>
    </message>
    <message>
        <source>The triangle of the selected vertex; where none is selected, the one that the current step draws</source>
        <translation>Das Dreieck des gewählten Eckpunkts; ist keiner gewählt, das, das der aktuelle Schritt zeichnet</translation>
    </message>
    <message>
        <source>C&amp;lear all primitives</source>
        <translation>Alle Primi&amp;tive entfernen</translation>
    </message>
    <message>
        <source>Triangle %1</source>
        <translation>Dreieck %1</translation>
    </message>
    <message>
        <source>&amp;Frame…</source>
        <translation>&amp;Bildfläche …</translation>
    </message>
    <message>
        <source>&amp;Snap to</source>
        <translation>E&amp;inrasten auf</translation>
    </message>
    <message>
        <source>whole &amp;pixels</source>
        <translation>ganze &amp;Pixel</translation>
    </message>
    <message>
        <source>&amp;sixteenths of a pixel</source>
        <translation>&amp;sechzehntel Pixel</translation>
    </message>
    <message>
        <source>1/&amp;256 pixel</source>
        <translation>1/&amp;256 Pixel</translation>
    </message>
    <message>
        <source>Colour of the Vertex</source>
        <translation>Farbe des Eckpunkts</translation>
    </message>
    <message>
        <source>Colour of the Next Vertex</source>
        <translation>Farbe des nächsten Eckpunkts</translation>
    </message>
    <message>
        <source>Copy the last m&amp;essage</source>
        <translation>Letzte &amp;Meldung kopieren</translation>
    </message>
    <message>
        <source>Copies the last note shown over the canvas, even after it has gone</source>
        <translation>Was zuletzt über der Zeichenfläche gemeldet wurde, auch wenn es verschwunden ist</translation>
    </message>
    <message>
        <source>Ca&amp;mera, light and materials…</source>
        <translation>Kamera, Licht &amp;und Materialien …</translation>
    </message>
    <message>
        <source>Marks on the canvas what differs in the clipboard&apos;s picture, or raster of “#” and “.” (Ctrl+V)</source>
        <translation>Markiert auf der Zeichenfläche, was im Bild oder im Raster aus „#“ und „.“ in der Zwischenablage abweicht (Strg+V)</translation>
    </message>
</context>
<context>
    <name>pixelplumb::EffectsPanel</name>
    <message>
        <source>Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>What is forced, and what that changes</source>
        <translation>Was erzwungen ist und was das ändert</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Draw the scene repeatedly with each effect on and off, while all other effects are as called for; by the plain kernels</source>
        <translation>Die Szene wieder und wieder mit jedem Effekt an und aus zeichnen, alle anderen wie gefordert, mit den einfachen Kernen</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>switch</source>
        <translation>Schalter</translation>
    </message>
    <message>
        <source>primitives</source>
        <translation>Primitive</translation>
    </message>
    <message>
        <source>pixels at most</source>
        <translation>Pixel höchstens</translation>
    </message>
    <message>
        <source>ns a pixel</source>
        <translation>ns je Pixel</translation>
    </message>
    <message>
        <source>operations a pixel</source>
        <translation>Operationen je Pixel</translation>
    </message>
    <message>
        <source>times as long</source>
        <translation>mal so lange</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>Grund (englisch)</translation>
    </message>
    <message>
        <source>How much longer drawing takes with the effect than without it, for each pixel written</source>
        <translation>Wie viel länger das Zeichnen mit ihm dauert als ohne, je geschriebenes Pixel</translation>
    </message>
    <message>
        <source>With the effect on, for each pixel written: depths read and written, divisions by 1/w, texels read, normals made unit length, blends, samples</source>
        <translation>Mit ihm, je geschriebenes Pixel: Tiefen gelesen und geschrieben, Divisionen durch 1/w, Texel gelesen, Normalen auf Länge 1 gebracht, Überblendungen, Abtastpunkte</translation>
    </message>
    <message>
        <source>Time with ÷ time without; interquartile range</source>
        <translation>Mit ihm gegenüber ohne ihn, und wozwischen eine Hälfte der Messungen liegt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>The frame&apos;s border limits every loop, at no cost; what lies in front of the near plane cannot be drawn</source>
        <translation>Der Rand der Bildfläche begrenzt jede Schleife, ohne Kosten; was vor der vorderen Ebene liegt, hat in der Bildfläche keinen Platz</translation>
    </message>
    <message>
        <source>Switch of %1</source>
        <translation>Schalter für %1</translation>
    </message>
    <message>
        <source>as called for</source>
        <translation>wie gefordert</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>The plan does not fit into memory.</source>
        <translation>Der Plan passt nicht in den Speicher.</translation>
    </message>
    <message>
        <source>Antialiasing that the scene asks for</source>
        <translation>Antialiasing, das die Szene verlangt</translation>
    </message>
    <message>
        <source>The antialiasing that the scene asks for: samples per pixel, or the exact area. Only pixels that an edge crosses have more than one sample</source>
        <translation>Antialiasing, das die Szene verlangt: Abtastpunkte eines Pixels oder die genaue Fläche; nur Pixel, durch die eine Kante geht, haben mehr als einen</translation>
    </message>
    <message>
        <source>exact area</source>
        <translation>genaue Fläche</translation>
    </message>
    <message>
        <source>1 sample</source>
        <translation>1 Abtastpunkt</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 Abtastpunkte</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Fortschritt der Messung</translation>
    </message>
</context>
<context>
    <name>pixelplumb::EffectsText</name>
    <message>
        <source>%1 off</source>
        <translation>%1 aus</translation>
    </message>
    <message>
        <source>%1 on</source>
        <translation>%1 an</translation>
    </message>
    <message>
        <source>%1 on, where there is none to switch on</source>
        <translation>%1 an, wo es nichts anzuschalten gibt</translation>
    </message>
    <message>
        <source>No pixel needs %1 here. That the plan calls for it is a defect, unless its values differ by less than a byte.</source>
        <translation>Kein Pixel braucht hier %1: Dass es gefordert ist, ist ein Defekt des Plans, es sei denn, seine Werte unterscheiden sich um weniger als ein Byte.</translation>
    </message>
    <message>
        <source>A defect: %1 is not called for, and pixels change without it.</source>
        <translation>Ein Defekt: %1 ist nicht gefordert, und ohne ändern sich Pixel.</translation>
    </message>
    <message>
        <source>A defect: %1 is not called for, and pixels change with it.</source>
        <translation>Ein Defekt: %1 ist nicht gefordert, und damit ändern sich Pixel.</translation>
    </message>
    <message>
        <source>no pixel changes</source>
        <translation>kein Pixel ändert sich</translation>
    </message>
    <message numerus="yes">
        <source>%n pixels change, marked on the canvas</source>
        <translation>
            <numerusform>%n Pixel ändert sich, auf der Zeichenfläche markiert</numerusform>
            <numerusform>%n Pixel ändern sich, auf der Zeichenfläche markiert</numerusform>
        </translation>
    </message>
    <message>
        <source>Forced: %1; %2.</source>
        <translation>Erzwungen: %1; %2.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::ErrorScale</name>
    <message>
        <source>0, proved</source>
        <translation>0, bewiesen</translation>
    </message>
    <message>
        <source>0, observed</source>
        <translation>0, beobachtet</translation>
    </message>
    <message>
        <source>0, tested</source>
        <translation>0, getestet</translation>
    </message>
</context>
<context>
    <name>pixelplumb::Examples</name>
    <message>
        <source>Circles and ellipses by the midpoint</source>
        <translation>Kreise und Ellipsen mit dem Mittelpunktverfahren</translation>
    </message>
    <message>
        <source>Two triangles cross: depth decides pixel by pixel</source>
        <translation>Zwei Dreiecke durcheinander: Die Tiefe entscheidet Pixel für Pixel</translation>
    </message>
    <message>
        <source>Bézier curves, halved until their pieces are straight</source>
        <translation>Bézierkurven, halbiert, bis ihre Stücke gerade sind</translation>
    </message>
    <message>
        <source>The assignment: one triangle, column by column</source>
        <translation>Die Aufgabe: ein Dreieck, Spalte für Spalte</translation>
    </message>
    <message>
        <source>Lines are equally bright in all directions: strokes drawn by area</source>
        <translation>Linien in allen Richtungen, die gleich hell sind: Striche nach Fläche</translation>
    </message>
    <message>
        <source>Closed paths of Bézier curves, filled along their chords</source>
        <translation>Geschlossene Wege aus Bézierkurven, entlang ihrer Sehnen gefüllt</translation>
    </message>
    <message>
        <source>Transparent triangles: the drawing order shows</source>
        <translation>Durchsichtige Dreiecke: Die Reihenfolge des Zeichnens ist zu sehen</translation>
    </message>
    <message>
        <source>Bresenham&apos;s line in every octant, and the course&apos;s own example from (20, 41) to (30, 44)</source>
        <translation>Bresenhams Linie in jedem Oktanten, und das Beispiel des Kurses von (20, 41) nach (30, 44)</translation>
    </message>
    <message>
        <source>A sphere of triangles lit by two lights: Phong shading</source>
        <translation>Eine Kugel aus Dreiecken im Licht zweier Lampen: Phong</translation>
    </message>
    <message>
        <source>An icosahedron from an OBJ file, with flat shading</source>
        <translation>Ein Ikosaeder aus einer OBJ-Datei, flach schattiert</translation>
    </message>
    <message>
        <source>A moving sliver: in float32 other pixels flicker than in the truth</source>
        <translation>Ein Splitter, der sich bewegt: float32 lässt seine Pixel anders flimmern als die Wahrheit</translation>
    </message>
    <message>
        <source>A free-form surface, cut into triangles as finely as needed</source>
        <translation>Eine Freiformfläche, so fein wie nötig in Dreiecke zerlegt</translation>
    </message>
    <message>
        <source>The edges of polygons as Bresenham&apos;s lines</source>
        <translation>Die Kanten von Polygonen als Bresenhams Linien</translation>
    </message>
    <message>
        <source>A star that crosses itself: even-odd beside non-zero</source>
        <translation>Ein Stern, der sich selbst kreuzt: gerade-ungerade neben ungleich null</translation>
    </message>
    <message>
        <source>One triangle in space, and each step that takes it to the screen</source>
        <translation>Ein Dreieck im Raum: jeder Schritt seines Weges auf den Bildschirm</translation>
    </message>
    <message>
        <source>Two triangles share an edge: which one draws its pixels under each fill rule</source>
        <translation>Zwei Dreiecke an einer Kante: wem ihre Pixel nach welcher Füllregel gehören</translation>
    </message>
    <message>
        <source>A triangle thinner than a pixel: missing and extra pixels in float32</source>
        <translation>Ein Dreieck, dünner als ein Pixel, in float32: Lücken und Überzähliges</translation>
    </message>
    <message>
        <source>Thin triangles without gaps: sixteen samples per pixel</source>
        <translation>Dünne Dreiecke, ganz durch sechzehn Abtastpunkte je Pixel</translation>
    </message>
    <message>
        <source>Far from the origin, increments in float32 have no effect</source>
        <translation>Fern vom Ursprung stehen die Inkremente von float32 still</translation>
    </message>
    <message>
        <source>Steep lines by y = mx + b have gaps: why there are octants</source>
        <translation>Steile Linien mit y = mx + b: Lücken, und wozu es Oktanten gibt</translation>
    </message>
    <message>
        <source>Letters are polygons: outlines filled by parity</source>
        <translation>Buchstaben sind Polygone: Umrisse, nach Parität gefüllt</translation>
    </message>
    <message>
        <source>A chequered plane: what perspective correction corrects</source>
        <translation>Eine karierte Ebene: was die Perspektivkorrektur verbessert</translation>
    </message>
    <message>
        <source>Samples lie exactly on an edge whose slope is not a binary fraction</source>
        <translation>Abtastpunkte genau auf einer Kante, deren Steigung kein Binärbruch ist</translation>
    </message>
    <message>
        <source>Vertical and horizontal edges, where a quotient divides by zero</source>
        <translation>Senkrechte und waagrechte Kanten, bei denen Quotienten keinen Wert haben</translation>
    </message>
</context>
<context>
    <name>pixelplumb::ExamplesDialog</name>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Hard case: %1</source>
        <translation>Schwieriger Fall: %1</translation>
    </message>
    <message>
        <source>Hard cases: %1 (%2)</source>
        <translation>Schwierige Fälle: %1 (%2)</translation>
    </message>
    <message>
        <source>Picture to be drawn</source>
        <translation>Bild wird noch gezeichnet</translation>
    </message>
    <message>
        <source>Picture is being drawn…</source>
        <translation>Bild wird gerade gezeichnet …</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
</context>
<context>
    <name>pixelplumb::FileMenu</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Exa&amp;mples…</source>
        <translation>&amp;Beispiele …</translation>
    </message>
    <message>
        <source>Open the &amp;first scene</source>
        <translation>&amp;Erste Szene öffnen</translation>
    </message>
    <message>
        <source>Open student&apos;s p&amp;icture…</source>
        <translation>&amp;Abgegebenes Bild öffnen …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Re&amp;vert to the file</source>
        <translation>Auf Datei &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Been&amp;den</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>Ex&amp;portieren</translation>
    </message>
    <message>
        <source>&amp;Annotated grid (SVG)…</source>
        <translation>Beschriftetes &amp;Gitter (SVG) …</translation>
    </message>
    <message>
        <source>&amp;Columns (CSV)…</source>
        <translation>&amp;Spalten (CSV) …</translation>
    </message>
    <message>
        <source>Columns (&amp;JSON)…</source>
        <translation>Spalten (&amp;JSON) …</translation>
    </message>
    <message>
        <source>Pi&amp;xels (CSV)…</source>
        <translation>&amp;Pixel (CSV) …</translation>
    </message>
    <message>
        <source>Pixels (JS&amp;ON)…</source>
        <translation>Pixel (JS&amp;ON) …</translation>
    </message>
    <message>
        <source>&amp;Raster (ASCII text)…</source>
        <translation>&amp;Raster (ASCII-Text) …</translation>
    </message>
    <message>
        <source>Ro&amp;ws (CSV)…</source>
        <translation>&amp;Zeilen (CSV) …</translation>
    </message>
    <message>
        <source>Rows (&amp;JSON)…</source>
        <translation>Zeilen (&amp;JSON) …</translation>
    </message>
    <message>
        <source>&amp;Steps (CSV)…</source>
        <translation>&amp;Schritte (CSV) …</translation>
    </message>
    <message>
        <source>Steps (&amp;JSON)…</source>
        <translation>Schritte (&amp;JSON) …</translation>
    </message>
    <message>
        <source>&amp;PNG of the finished picture…</source>
        <translation>PNG des fertigen &amp;Bildes …</translation>
    </message>
    <message>
        <source>PNG as &amp;drawn so far…</source>
        <translation>PNG &amp;des bisher Gezeichneten …</translation>
    </message>
</context>
<context>
    <name>pixelplumb::FormulaHtml</name>
    <message>
        <source>smaller-y edge</source>
        <translation>Kante mit kleinerem y</translation>
    </message>
    <message>
        <source>larger-y edge</source>
        <translation>Kante mit größerem y</translation>
    </message>
    <message>
        <source>left edge</source>
        <translation>linke Kante</translation>
    </message>
    <message>
        <source>right edge</source>
        <translation>rechte Kante</translation>
    </message>
    <message>
        <source>exact %1</source>
        <translation>exakt %1</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>Fehler %1</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
</context>
<context>
    <name>pixelplumb::FormulaPanel</name>
    <message>
        <source>a column</source>
        <translation>eine Spalte</translation>
    </message>
    <message>
        <source>a row</source>
        <translation>eine Zeile</translation>
    </message>
    <message>
        <source>a step</source>
        <translation>einen Schritt</translation>
    </message>
    <message>
        <source>Nothing is drawn</source>
        <translation>Nichts ist gezeichnet</translation>
    </message>
    <message>
        <source>Before the first step</source>
        <translation>Vor dem ersten Schritt</translation>
    </message>
    <message>
        <source>Nothing is drawn yet. Step forward by %1 or by a pixel: the buttons above, or the Step menu with its keys.</source>
        <translation>Noch ist nichts gezeichnet. Um %1 oder um ein Pixel vorgehen: mit den Knöpfen oben oder im Menü Schritt mit seinen Tasten.</translation>
    </message>
    <message>
        <source>Formulas of the current step</source>
        <translation>Formeln des aktuellen Schritts</translation>
    </message>
    <message>
        <source>Formulas</source>
        <translation>Formeln</translation>
    </message>
    <message>
        <source>Recording the run</source>
        <translation>Der Lauf wird aufgezeichnet</translation>
    </message>
</context>
<context>
    <name>pixelplumb::FrameDialog</name>
    <message>
        <source>Frame</source>
        <translation>Bildfläche</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>H&amp;intergrund</translation>
    </message>
    <message>
        <source>lower left, y upward</source>
        <translation>unten links, y nach oben</translation>
    </message>
    <message>
        <source>upper left, y downward</source>
        <translation>oben links, y nach unten</translation>
    </message>
    <message>
        <source>&amp;Origin</source>
        <translation>&amp;Ursprung</translation>
    </message>
    <message>
        <source>at (x, y)</source>
        <translation>bei (x, y)</translation>
    </message>
    <message>
        <source>at (x + ½, y + ½)</source>
        <translation>bei (x + ½, y + ½)</translation>
    </message>
    <message>
        <source>&amp;Pixels are sampled</source>
        <translation>&amp;Pixel werden abgetastet</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message numerus="yes">
        <source>%1 pixels</source>
        <translation>
            <numerusform>%1 Pixel</numerusform>
            <numerusform>%1 Pixel</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 pixels are too many: at most %2 fit. Make a side smaller.</source>
        <translation>%1 Pixel sind zu viele: höchstens %2 passen. Eine Seite muss kürzer werden.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::FramePainter</name>
    <message>
        <source>off-screen point</source>
        <translation>Punkt außerhalb</translation>
    </message>
</context>
<context>
    <name>pixelplumb::FrameText</name>
    <message>
        <source>frame %1 of %2 of the motion</source>
        <translation>Bild %1 von %2 der Bewegung</translation>
    </message>
</context>
<context>
    <name>pixelplumb::GoToDialog</name>
    <message>
        <source>&amp;Pixel, row or step</source>
        <translation>&amp;Pixel, Zeile oder Schritt</translation>
    </message>
    <message>
        <source>27 19   a pixel;   27   a row;   #611   a step</source>
        <translation>27 19   ein Pixel;   27   eine Zeile;   #611   ein Schritt</translation>
    </message>
    <message>
        <source>Type two numbers for a pixel, one for a row, # and one for a step.</source>
        <translation>Zwei Zahlen stehen für ein Pixel, eine für eine Zeile, # mit einer für einen Schritt.</translation>
    </message>
    <message>
        <source>There is no row %1.</source>
        <translation>Nichts hat eine Zeile %1.</translation>
    </message>
    <message>
        <source>Goes to row %1.</source>
        <translation>Geht zu Zeile %1.</translation>
    </message>
    <message>
        <source>&amp;Pixel, step of the shape or step of the run</source>
        <translation>&amp;Pixel, Schritt der Form oder Schritt des Laufs</translation>
    </message>
    <message>
        <source>27 19   a pixel;   27   a shape&apos;s step;   #611   a step</source>
        <translation>27 19   ein Pixel;   27   ein Schritt der Form;   #611   ein Schritt</translation>
    </message>
    <message>
        <source>Type two numbers for a pixel, one for a shape&apos;s step, # and one for a step of the run.</source>
        <translation>Zwei Zahlen stehen für ein Pixel, eine für einen Schritt der Form, # mit einer für einen Schritt des Laufs.</translation>
    </message>
    <message>
        <source>The shape has no step %1.</source>
        <translation>Nichts hat einen eigenen Schritt %1.</translation>
    </message>
    <message>
        <source>Goes to the shape&apos;s step %1.</source>
        <translation>Geht zum Schritt %1 der Form.</translation>
    </message>
    <message>
        <source>&amp;Pixel, column or step</source>
        <translation>&amp;Pixel, Spalte oder Schritt</translation>
    </message>
    <message>
        <source>27 19   a pixel;   27   a column;   #611   a step</source>
        <translation>27 19   ein Pixel;   27   eine Spalte;   #611   ein Schritt</translation>
    </message>
    <message>
        <source>Type two numbers for a pixel, one for a column, # and one for a step.</source>
        <translation>Zwei Zahlen stehen für ein Pixel, eine für eine Spalte, # mit einer für einen Schritt.</translation>
    </message>
    <message>
        <source>There is no column %1.</source>
        <translation>Nichts hat eine Spalte %1.</translation>
    </message>
    <message>
        <source>Goes to column %1.</source>
        <translation>Geht zu Spalte %1.</translation>
    </message>
    <message>
        <source>Go To</source>
        <translation>Gehe zu</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Los</translation>
    </message>
    <message>
        <source>There is no run yet.</source>
        <translation>Noch gibt es keinen Lauf.</translation>
    </message>
    <message>
        <source>The frame&apos;s pixels are (%1, %2) … (%3, %4).</source>
        <translation>Die Pixel der Bildfläche sind (%1, %2) … (%3, %4).</translation>
    </message>
    <message>
        <source>The last step is %1.</source>
        <translation>Der letzte Schritt ist %1.</translation>
    </message>
    <message>
        <source>Picks pixel (%1, %2); time stands still.</source>
        <translation>Wählt Pixel (%1, %2); die Zeit steht still.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::GradeDialog</name>
    <message>
        <source>Grade a Folder</source>
        <translation>Einen Ordner bewerten</translation>
    </message>
    <message>
        <source>&amp;Submissions folder</source>
        <translation>Ordner der &amp;Abgaben</translation>
    </message>
    <message>
        <source>&amp;Assignment file</source>
        <translation>Datei der Auf&amp;gabe</translation>
    </message>
    <message>
        <source>&amp;Results folder</source>
        <translation>Ordner der &amp;Ergebnisse</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Wählen: %1</translation>
    </message>
    <message>
        <source>The Assignment</source>
        <translation>Die Aufgabe</translation>
    </message>
    <message>
        <source>Assignments (*.json);;All files (*)</source>
        <translation>Aufgaben (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>A Folder</source>
        <translation>Ein Ordner</translation>
    </message>
    <message>
        <source>as the assignment says</source>
        <translation>wie die Aufgabe sagt</translation>
    </message>
    <message>
        <source>&amp;Leeway</source>
        <translation>S&amp;pielraum</translation>
    </message>
    <message>
        <source>&amp;Grade by the window&apos;s scene: one task, 5 points</source>
        <translation>Nach der &amp;Szene im Fenster bewerten: eine Aufgabe, 5 Punkte</translation>
    </message>
    <message>
        <source>Each student has drawn the scene that is open now; there is no assignment file</source>
        <translation>Alle haben die Szene gezeichnet, die gerade offen ist; es gibt keine Aufgabendatei</translation>
    </message>
    <message>
        <source>Grad&amp;e</source>
        <translation>&amp;Bewerten</translation>
    </message>
    <message>
        <source>What is graded by what</source>
        <translation>Was wonach bewertet wird</translation>
    </message>
    <message>
        <source>&lt;p&gt;The submissions folder holds one picture, or one folder, for each student.&lt;/p&gt;&lt;p&gt;An assignment is a JSON file that names the scenes to be drawn and their points (&lt;a href=&quot;assignment-file.md&quot;&gt;how to write one&lt;/a&gt;).&lt;/p&gt;</source>
        <translation>&lt;p&gt;Der Ordner der Abgaben enthält für jede Person ein Bild oder einen Ordner.&lt;/p&gt;&lt;p&gt;Eine Aufgabe ist eine JSON-Datei, die die zu zeichnenden Szenen und ihre Punkte nennt (&lt;a href=&quot;assignment-file.md&quot;&gt;wie man eine schreibt&lt;/a&gt;).&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>pixelplumb::GradeReviewPane</name>
    <message>
        <source>The scene whose picture is shown</source>
        <translation>Die Szene, deren Bild gezeigt wird</translation>
    </message>
    <message>
        <source>What the student is told</source>
        <translation>Was die Studierenden erfahren</translation>
    </message>
    <message>
        <source>Your comment, for the student; it is saved as you leave the field</source>
        <translation>Der eigene Kommentar zur Abgabe; er wird beim Verlassen des Feldes gespeichert</translation>
    </message>
    <message>
        <source>comment (C); Escape: back to the table</source>
        <translation>Kommentar (C); Escape: zurück zur Tabelle</translation>
    </message>
    <message>
        <source>Accept (A)</source>
        <translation>Annehmen (A)</translation>
    </message>
    <message>
        <source>This grade is reviewed and goes out as it is (A)</source>
        <translation>Diese Bewertung ist geprüft und geht so hinaus (A)</translation>
    </message>
    <message>
        <source>Copy to all with this bug</source>
        <translation>Für alle mit diesem Fehler</translation>
    </message>
    <message>
        <source>Give every submission of the same cause this comment</source>
        <translation>Jeder Abgabe mit derselben Ursache diesen Kommentar geben</translation>
    </message>
    <message>
        <source>What explains the pictures, for you, not for the student</source>
        <translation>Was die Bilder erklärt, für Sie, nicht für die Studierenden</translation>
    </message>
    <message>
        <source>What was done, for you</source>
        <translation>Was geschehen ist, für Sie</translation>
    </message>
    <message>
        <source>Points that replace those of the checks; leave it empty to keep theirs</source>
        <translation>Punkte statt derer der Prüfungen; leer gelten deren</translation>
    </message>
    <message>
        <source>Your reason for changing the points, for the student; without a reason they do not change</source>
        <translation>Warum andere Punkte, für den Studenten; ohne Grund gelten sie nicht</translation>
    </message>
    <message>
        <source>why these points (needed)</source>
        <translation>warum diese Punkte (nötig)</translation>
    </message>
    <message>
        <source>%1 keeps the points of the checks: %2 were typed without a reason.</source>
        <translation>%1 behält die Punkte der Prüfungen: %2 wurden ohne Begründung eingegeben.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
</context>
<context>
    <name>pixelplumb::GradeTable</name>
    <message>
        <source>Submissions</source>
        <translation>Abgaben</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>defects</source>
        <translation>Defekte (englisch)</translation>
    </message>
    <message>
        <source>comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>Right within the leeway: every pixel that differs is one that the leeway leaves open.</source>
        <translation>Richtig innerhalb des Spielraums: Jedes abweichende Pixel ist eines, das der Spielraum offen lässt.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::Gradebook</name>
    <message>
        <source>Reading grades</source>
        <translation>Lesen der Bewertungen</translation>
    </message>
    <message>
        <source>The grades do not fit into memory.</source>
        <translation>Die Bewertungen passen nicht in den Speicher.</translation>
    </message>
    <message>
        <source>No grades: %1</source>
        <translation>Keine Bewertungen: %1</translation>
    </message>
    <message>
        <source>Grading</source>
        <translation>Bewerten</translation>
    </message>
    <message>
        <source>The grading does not fit into memory.</source>
        <translation>Die Bewertung passt nicht in den Speicher.</translation>
    </message>
    <message>
        <source>Nothing is graded: %1</source>
        <translation>Nichts ist bewertet: %1</translation>
    </message>
    <message>
        <source>Writing reports</source>
        <translation>Schreiben der Berichte</translation>
    </message>
    <message>
        <source>The reports were not written: %1</source>
        <translation>Die Berichte wurden nicht geschrieben: %1</translation>
    </message>
    <message>
        <source>The reports with your comments are written to %1.</source>
        <translation>Die Berichte mit Ihren Kommentaren sind in %1 geschrieben.</translation>
    </message>
    <message>
        <source>Cancelled. What is graded stays, and the next run continues from there.</source>
        <translation>Abgebrochen; was bewertet ist, bleibt, und die Bewertung geht von dort weiter.</translation>
    </message>
    <message>
        <source>Your review is not saved: %1</source>
        <translation>Was gesagt wurde, ist nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Other runs are still grading into %1; the last one to finish writes the reports.</source>
        <translation>In %1 bewerten noch andere Läufe; der letzte schreibt die Berichte.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::GradingPanel</name>
    <message>
        <source>Open results…</source>
        <translation>Ergebnisse öffnen …</translation>
    </message>
    <message>
        <source>Open a folder of results: of this window or of pixelplumb-cli grade</source>
        <translation>Einen Ordner mit Ergebnissen von pixelplumb-cli grade öffnen</translation>
    </message>
    <message>
        <source>Grade a folder…</source>
        <translation>Ordner bewerten …</translation>
    </message>
    <message>
        <source>Grade a folder of submissions by an assignment or by this scene</source>
        <translation>Die Abgaben eines Ordners nach einer Aufgabe bewerten</translation>
    </message>
    <message>
        <source>Write reports</source>
        <translation>Berichte schreiben</translation>
    </message>
    <message>
        <source>Write the reports again, with your comments: for Gradescope and others, the table and the page</source>
        <translation>Die Berichte für Gradescope und andere, die Tabelle und die Seite mit den Kommentaren neu schreiben</translation>
    </message>
    <message>
        <source>Submissions that are graded</source>
        <translation>Abgaben, die bewertet sind</translation>
    </message>
    <message>
        <source>Show the submissions that contain these words</source>
        <translation>Die Abgaben zeigen, in denen diese Wörter stehen</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Show one cause&apos;s submissions</source>
        <translation>Die Abgaben mit einer Ursache zeigen</translation>
    </message>
    <message>
        <source>Open Results</source>
        <translation>Ergebnisse öffnen</translation>
    </message>
    <message>
        <source>all causes</source>
        <translation>alle Ursachen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Open a folder of results, or grade a folder of submissions.</source>
        <translation>Einen Ordner mit Ergebnissen öffnen oder einen Ordner mit Abgaben bewerten.</translation>
    </message>
    <message>
        <source>, %1 more without a grade</source>
        <translation>, %1 weitere ohne Bewertung</translation>
    </message>
    <message>
        <source>%1 of %2 accepted%3 · J, K: next, previous · A: accept · C: comment · %4</source>
        <translation>%1 von %2 angenommen%3 · J, K: weiter, zurück · A: annehmen · C: Kommentar · %4</translation>
    </message>
    <message>
        <source>What programs could do that ran in no sandbox</source>
        <translation>Was Programme tun konnten, die in keiner Sandbox liefen</translation>
    </message>
    <message>
        <source>No sandbox (%1): programs could use the network, read and change files, and end processes, as far as their user may.</source>
        <translation>Keine Sandbox (%1): Programme konnten das Netz benutzen, Dateien lesen und ändern und Prozesse beenden, soweit ihr Benutzer das darf.</translation>
    </message>
    <message>
        <source>The window&apos;s scene</source>
        <translation>Die Szene im Fenster</translation>
    </message>
    <message>
        <source>Nothing is graded: %1</source>
        <translation>Nichts ist bewertet: %1</translation>
    </message>
</context>
<context>
    <name>pixelplumb::HardCasePicture</name>
    <message>
        <source>%1 missing</source>
        <translation>%1 fehlen</translation>
    </message>
    <message>
        <source>%1 extra</source>
        <translation>%1 überzählig</translation>
    </message>
    <message>
        <source>%1 in another colour</source>
        <translation>%1 in anderer Farbe</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>richtig</translation>
    </message>
</context>
<context>
    <name>pixelplumb::HardCasesDetails</name>
    <message>
        <source>The chosen case</source>
        <translation>Der gewählte Fall</translation>
    </message>
    <message>
        <source>Name of the case</source>
        <translation>Name des Falls</translation>
    </message>
    <message>
        <source>Choose a case.</source>
        <translation>Einen Fall wählen.</translation>
    </message>
    <message>
        <source>A click opens the case at the first pixel that differs.</source>
        <translation>Ein Klick öffnet den Fall beim ersten Pixel, das abweicht.</translation>
    </message>
    <message>
        <source>Open at the first pixel that differs</source>
        <translation>Beim ersten abweichenden Pixel öffnen</translation>
    </message>
    <message>
        <source>Whose pictures they are</source>
        <translation>Wessen Bilder es sind</translation>
    </message>
    <message>
        <source>What the case stresses, and why it goes wrong</source>
        <translation>Was der Fall beansprucht und warum er misslingt</translation>
    </message>
    <message>
        <source>%v of %m methods</source>
        <translation>%v von %m Verfahren</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>About the chosen case</source>
        <translation>Über den gewählten Fall</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Opens the case at the first pixel that differs</source>
        <translation>Öffnet den Fall beim ersten Pixel, das abweicht</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Neben</translation>
    </message>
    <message>
        <source>Opens the case and compares exact, float32 and float64</source>
        <translation>Öffnet den Fall und vergleicht exact, float32 und float64</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Opens the case and plots the error of the bounds</source>
        <translation>Öffnet den Fall und zeichnet den Fehler der Grenzen</translation>
    </message>
    <message>
        <source>Being drawn by the current method.</source>
        <translation>Wird mit dem aktuellen Verfahren gezeichnet.</translation>
    </message>
    <message>
        <source>Left: %1: %2. Right: the truth.</source>
        <translation>Links: %1: %2. Rechts: die Wahrheit.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::HardCasesPanel</name>
    <message>
        <source>Hard cases by family</source>
        <translation>Schwierige Fälle nach Familien</translation>
    </message>
    <message>
        <source>current method | truth</source>
        <translation>aktuelles Verfahren | Wahrheit</translation>
    </message>
    <message>
        <source>case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>The file of hard cases %1 is not part of this program.</source>
        <translation>Die Datei der schwierigen Fälle %1 ist nicht Teil dieses Programms.</translation>
    </message>
    <message>
        <source>not drawn yet</source>
        <translation>noch nicht gezeichnet</translation>
    </message>
</context>
<context>
    <name>pixelplumb::HardCasesVerdicts</name>
    <message>
        <source>the case has no facts under its rules</source>
        <translation>der Fall kennt unter seinen Regeln keine Tatsachen</translation>
    </message>
    <message>
        <source>right under every rule that the case knows</source>
        <translation>richtig unter jeder Regel, die der Fall kennt</translation>
    </message>
    <message>
        <source>How each method handles this case</source>
        <translation>Wie jedes Verfahren bei dem Fall abschneidet</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>the method does not compute in it</source>
        <translation>das Verfahren rechnet nicht darin</translation>
    </message>
</context>
<context>
    <name>pixelplumb::HelpMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>&amp;What&apos;s This?</source>
        <translation>&amp;Was ist das?</translation>
    </message>
    <message>
        <source>The next click explains the part that is clicked (Shift+F1)</source>
        <translation>Der nächste Klick sagt, wozu da ist, was er trifft (Umschalt+F1)</translation>
    </message>
    <message>
        <source>&amp;About Pixelplumb</source>
        <translation>Ü&amp;ber Pixelplumb</translation>
    </message>
    <message>
        <source>About Pixelplumb</source>
        <translation>Über Pixelplumb</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Pixelplumb %1&lt;/h3&gt;&lt;p&gt;See, step through, measure and grade triangle scan conversion.&lt;/p&gt;&lt;p&gt;Qt %2, %3, %4&lt;/p&gt;&lt;p&gt;Licence: GPL-3.0-or-later. Pixelplumb uses no network and sends no data.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Pixelplumb %1&lt;/h3&gt;&lt;p&gt;Die Rasterung von Dreiecken sehen, Schritt für Schritt durchgehen, messen und bewerten.&lt;/p&gt;&lt;p&gt;Qt %2, %3, %4&lt;/p&gt;&lt;p&gt;Lizenz: GPL-3.0-or-later. Pixelplumb benutzt kein Netz und sendet keine Daten.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>pixelplumb::JobBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>pixelplumb::KeySheet</name>
    <message>
        <source>in the canvas</source>
        <translation>auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Read the pixel, its painter and the nearest edge</source>
        <translation>Das Pixel, seinen Urheber und die nächste Kante ablesen</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klicken</translation>
    </message>
    <message>
        <source>Place a vertex</source>
        <translation>Einen Eckpunkt setzen</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Drag a vertex</source>
        <translation>Einen Eckpunkt ziehen</translation>
    </message>
    <message>
        <source>Move it</source>
        <translation>Ihn bewegen</translation>
    </message>
    <message>
        <source>Double click on a vertex</source>
        <translation>Doppelklick auf einen Eckpunkt</translation>
    </message>
    <message>
        <source>Choose its colour</source>
        <translation>Seine Farbe wählen</translation>
    </message>
    <message>
        <source>Click on a vertex</source>
        <translation>Klick auf einen Eckpunkt</translation>
    </message>
    <message>
        <source>Select it; once more, or while a figure is drawn, place the next vertex on it</source>
        <translation>Ihn wählen; noch einmal, oder während eine Figur gezeichnet wird, den nächsten Eckpunkt auf ihn setzen</translation>
    </message>
    <message>
        <source>Click, drag</source>
        <translation>Klicken, ziehen</translation>
    </message>
    <message>
        <source>Pick the pixel</source>
        <translation>Das Pixel wählen</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>Pick the pixel; on a vertex, its menu</source>
        <translation>Das Pixel wählen; auf einem Eckpunkt dessen Menü</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Vergrößern und verkleinern</translation>
    </message>
    <message>
        <source>Middle drag, Ctrl+drag</source>
        <translation>Mit der mittleren Taste oder Strg ziehen</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Den Ausschnitt bewegen</translation>
    </message>
    <message>
        <source>Click, drag on the ruler</source>
        <translation>Auf dem Lineal klicken, ziehen</translation>
    </message>
    <message>
        <source>Go to the column</source>
        <translation>Zur Spalte gehen</translation>
    </message>
    <message>
        <source>Right or double click on the ruler</source>
        <translation>Rechts- oder Doppelklick auf das Lineal</translation>
    </message>
    <message>
        <source>Breakpoint on the column</source>
        <translation>Haltepunkt auf der Spalte</translation>
    </message>
    <message>
        <source>Hold Shift alone</source>
        <translation>Umschalt allein halten</translation>
    </message>
    <message>
        <source>See the truth, or what a student should have drawn, after %1 s</source>
        <translation>Nach %1 s die Wahrheit sehen, oder was hätte gezeichnet werden sollen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Cancel the drag, or discard unfinished vertices</source>
        <translation>Das Ziehen abbrechen oder unfertige Eckpunkte verwerfen</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>Mouse, in the canvas</source>
        <translation>Maus, auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>Keys, in the canvas</source>
        <translation>Tasten, auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>Move the picked pixel</source>
        <translation>Das gewählte Pixel bewegen</translation>
    </message>
    <message>
        <source>Enter, Ins</source>
        <translation>Eingabe, Einfg</translation>
    </message>
    <message>
        <source>Place a vertex at the picked pixel (Ctrl+G goes to one by its numbers)</source>
        <translation>Einen Eckpunkt auf das gewählte Pixel setzen (Strg+G geht nach Zahlen zu einem Pixel)</translation>
    </message>
    <message>
        <source>[, ]</source>
        <translation>[, ]</translation>
    </message>
    <message>
        <source>Select the previous, the next vertex</source>
        <translation>Den vorigen, den nächsten Eckpunkt auswählen</translation>
    </message>
    <message>
        <source>Ctrl+arrows</source>
        <translation>Strg+Pfeile</translation>
    </message>
    <message>
        <source>Move the selected vertex</source>
        <translation>Den ausgewählten Eckpunkt bewegen</translation>
    </message>
    <message>
        <source>Enter, C</source>
        <translation>Eingabe, C</translation>
    </message>
    <message>
        <source>Colour of the selected vertex</source>
        <translation>Farbe des ausgewählten Eckpunkts</translation>
    </message>
    <message>
        <source>Discard the unfinished vertices; no vertex is selected then</source>
        <translation>Wartende Eckpunkte aufgeben; danach ist keiner ausgewählt</translation>
    </message>
    <message>
        <source>+, −, 0</source>
        <translation>+, −, 0</translation>
    </message>
    <message>
        <source>Zoom in, out, see the whole frame</source>
        <translation>Vergrößern, verkleinern, die ganze Bildfläche sehen</translation>
    </message>
    <message>
        <source>Shift+arrows</source>
        <translation>Umschalt+Pfeile</translation>
    </message>
</context>
<context>
    <name>pixelplumb::LabAnswers</name>
    <message>
        <source>proof</source>
        <translation>Beweis</translation>
    </message>
    <message>
        <source>proof and test</source>
        <translation>Beweis und Test</translation>
    </message>
    <message>
        <source>measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>nobody</source>
        <translation>niemand</translation>
    </message>
    <message>
        <source>The cheapest contender for each budget</source>
        <translation>Der billigste Kandidat für jede Vorgabe</translation>
    </message>
    <message>
        <source>budget</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>cheapest contender</source>
        <translation>billigster Kandidat</translation>
    </message>
    <message>
        <source>known by</source>
        <translation>bekannt durch</translation>
    </message>
    <message>
        <source>ns a pixel</source>
        <translation>ns je Pixel</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>What is asked for</source>
        <translation>Was verlangt ist</translation>
    </message>
    <message>
        <source>The fastest contender that meets this limit on this family of triangles</source>
        <translation>Wer es auf dieser Familie von Dreiecken in der kürzesten Zeit gibt</translation>
    </message>
    <message>
        <source>Whether it is proved, or only observed in this study. Tests check that a SIMD kernel writes what the proved plain kernel writes</source>
        <translation>Ob es bewiesen ist oder in dieser Studie nur nie anders gesehen wurde. Von einem SIMD-Kern ist getestet, dass er schreibt, was der bewiesene einfache schreibt</translation>
    </message>
    <message>
        <source>The median of all rounds</source>
        <translation>Der Median aller Runden</translation>
    </message>
</context>
<context>
    <name>pixelplumb::LabCharts</name>
    <message>
        <source>Whose misses</source>
        <translation>Wessen Verfehltes</translation>
    </message>
    <message>
        <source>What accuracy costs here</source>
        <translation>Was Genauigkeit hier kostet</translation>
    </message>
    <message>
        <source>Charts of the lab</source>
        <translation>Diagramme des Labors</translation>
    </message>
    <message>
        <source>Cost and error</source>
        <translation>Kosten und Fehler</translation>
    </message>
    <message>
        <source>Every contender by what it costs and what it gets wrong</source>
        <translation>Jeder Kandidat nach dem, was er kostet, und dem, was er falsch macht</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>The same in figures, sorted by any column</source>
        <translation>Dasselbe in Zahlen, nach jeder Spalte sortierbar</translation>
    </message>
    <message>
        <source>Budgets</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>The cheapest contender that is accurate enough</source>
        <translation>Der billigste Kandidat, der genau genug ist</translation>
    </message>
    <message>
        <source>Misses</source>
        <translation>Verfehltes</translation>
    </message>
    <message>
        <source>How far missed samples lie from the boundary</source>
        <translation>Wie weit verfehlte Abtastpunkte vom Rand liegen</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>What effects cost and what they mend</source>
        <translation>Was Effekte kosten und was sie verbessern</translation>
    </message>
</context>
<context>
    <name>pixelplumb::LabControls</name>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Judge and time every contender</source>
        <translation>Jeden Kandidaten beurteilen und messen</translation>
    </message>
    <message>
        <source>Extent of the study</source>
        <translation>Umfang der Studie</translation>
    </message>
    <message>
        <source>Quick: fifteen contenders, 20 seconds. Full: every method in every arithmetic, five minutes</source>
        <translation>Schnell: fünfzehn Kandidaten, 20 Sekunden. Ganz: jedes Verfahren in jeder Arithmetik, fünf Minuten</translation>
    </message>
    <message>
        <source>quick</source>
        <translation>schnell</translation>
    </message>
    <message>
        <source>full</source>
        <translation>ganz</translation>
    </message>
    <message>
        <source>Family of triangles</source>
        <translation>Familie von Dreiecken</translation>
    </message>
    <message>
        <source>Which triangles: each kind ranks the methods differently, so they are never averaged</source>
        <translation>Welche Dreiecke: Jede Art reiht die Verfahren anders, darum werden sie nie gemittelt</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Which error the chart shows</source>
        <translation>Welchen Fehler das Diagramm zeigt</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Files of the lab</source>
        <translation>Dateien des Labors</translation>
    </message>
    <message>
        <source>&amp;Open results …</source>
        <translation>Ergebnisse ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>&amp;Save results …</source>
        <translation>Ergebnisse &amp;speichern …</translation>
    </message>
    <message>
        <source>Save as a &amp;table, CSV …</source>
        <translation>Als &amp;Tabelle speichern, CSV …</translation>
    </message>
    <message>
        <source>Copy the co&amp;mmand that does it again</source>
        <translation>&amp;Befehl kopieren, der es wiederholt</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Fortschritt der Studie</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>End the study and keep what it has</source>
        <translation>Die Studie beenden und behalten, was sie hat</translation>
    </message>
    <message>
        <source>Save and open results; charts as figures</source>
        <translation>Ergebnisse speichern und öffnen; Diagramme als Abbildungen</translation>
    </message>
    <message>
        <source>Save the chart, SVG or &amp;PNG …</source>
        <translation>Diagramm speichern, SVG oder &amp;PNG …</translation>
    </message>
</context>
<context>
    <name>pixelplumb::LabEffects</name>
    <message>
        <source>%1 to %2 in the middle half of the rounds</source>
        <translation>%1 bis %2 in der mittleren Hälfte der Runden</translation>
    </message>
    <message>
        <source>What effects cost and what they mend</source>
        <translation>Was Effekte kosten und was sie verbessern</translation>
    </message>
    <message>
        <source>scene, and how it is drawn</source>
        <translation>Szene, und wie sie gezeichnet ist</translation>
    </message>
    <message>
        <source>arithmetic</source>
        <translation>Arithmetik</translation>
    </message>
    <message>
        <source>ns a pixel</source>
        <translation>ns je Pixel</translation>
    </message>
    <message>
        <source>× first</source>
        <translation>× erste</translation>
    </message>
    <message>
        <source>error, levels</source>
        <translation>Fehler, Stufen</translation>
    </message>
    <message>
        <source>wrong pixels</source>
        <translation>falsche Pixel</translation>
    </message>
    <message>
        <source>off the surface</source>
        <translation>von der Fläche</translation>
    </message>
    <message>
        <source>brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>The median of all rounds, by the plain kernels</source>
        <translation>Der Median aller Runden, mit den einfachen Kernen</translation>
    </message>
    <message>
        <source>Root of the mean square over pixels and channels, from the exact area or from the truth of all effects</source>
        <translation>Wurzel aus dem mittleren Quadrat über Pixel und Kanäle, gegen die exakte Fläche oder die Wahrheit aller Effekte</translation>
    </message>
    <message>
        <source>Pixels in other bytes than that</source>
        <translation>Pixel mit anderen Bytes als dort</translation>
    </message>
    <message>
        <source>Largest distance of the triangles from the surface</source>
        <translation>Größter Abstand der Dreiecke von der Fläche</translation>
    </message>
    <message>
        <source>How bright a line is for each pixel of its length: 1 is one pixel of white; beside the lines&apos; heading, least to greatest of all directions</source>
        <translation>Wie hell eine Linie je Pixel ihrer Länge ist: 1 ist ein weißes Pixel; neben der Überschrift der Linien das Geringste bis Größte aller Richtungen</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1, over %2</source>
        <translation>%1, über %2</translation>
    </message>
    <message>
        <source>Beside the first row of the scene in the same arithmetic: the median of the rounds&apos; own ratios, which differs from the ratio of the medians where the machine did other work</source>
        <translation>Neben der ersten Zeile der Szene in derselben Arithmetik: der Median der Verhältnisse der einzelnen Runden, der vom Verhältnis der Mediane abweicht, wenn der Rechner anderes zu tun hatte</translation>
    </message>
</context>
<context>
    <name>pixelplumb::LabFiles</name>
    <message>
        <source>%1 was not opened: %2</source>
        <translation>%1 wurde nicht geöffnet: %2</translation>
    </message>
    <message>
        <source>%1 was not written: it was read, and would be replaced.</source>
        <translation>%1 wurde nicht geschrieben: Es wurde gelesen und würde ersetzt.</translation>
    </message>
    <message>
        <source>%1 was not written: %2</source>
        <translation>%1 wurde nicht geschrieben: %2</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>Results of the lab (*.json);;All files (*)</source>
        <translation>Ergebnisse des Labors (*.json);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>pixelplumb::LabFilterMenu</name>
    <message>
        <source>plain kernels</source>
        <translation>einfache Kerne</translation>
    </message>
    <message>
        <source>SIMD kernels</source>
        <translation>SIMD-Kerne</translation>
    </message>
    <message>
        <source>other renderers</source>
        <translation>andere Programme</translation>
    </message>
    <message>
        <source>Who is shown</source>
        <translation>Wer gezeigt wird</translation>
    </message>
    <message>
        <source>Choose what charts and table show: arithmetics, kernels, methods. The best are the best of those shown.</source>
        <translation>Wählt, wen Diagramme und Tabelle zeigen: Arithmetiken, Kerne, Verfahren. Bester ist der beste der gezeigten.</translation>
    </message>
    <message>
        <source>straight loops</source>
        <translation>schlichte Schleifen</translation>
    </message>
    <message>
        <source>Show: all</source>
        <translation>Zeigen: alle</translation>
    </message>
    <message>
        <source>Show: some</source>
        <translation>Zeigen: einige</translation>
    </message>
</context>
<context>
    <name>pixelplumb::LabPlot</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>pixelplumb::LabTable</name>
    <message>
        <source>Contenders</source>
        <translation>Kandidaten</translation>
    </message>
    <message>
        <source>ns a pixel</source>
        <translation>ns je Pixel</translation>
    </message>
    <message>
        <source>the median of all rounds</source>
        <translation>der Median aller Runden</translation>
    </message>
    <message>
        <source>times assignment&apos;s</source>
        <translation>mal Aufgabe</translation>
    </message>
    <message>
        <source>time relative to the assignment&apos;s method, the column scan in float32</source>
        <translation>wie viele Male die Zeit des Verfahrens der Aufgabe, der Spaltenrasterung in float32</translation>
    </message>
    <message>
        <source>times straight loop</source>
        <translation>mal schlichte Schleife</translation>
    </message>
    <message>
        <source>time relative to the shortest hand-written loop that draws the same pixels; up to 1.3 is fair</source>
        <translation>wie viele Male die Zeit der kürzesten von Hand geschriebenen Schleife für dieselben Pixel; bis 1.3 ist angemessen</translation>
    </message>
    <message>
        <source>spread, %</source>
        <translation>Streuung, %</translation>
    </message>
    <message>
        <source>the middle half of all rounds, relative to their median</source>
        <translation>die mittlere Hälfte aller Runden, von ihrem Median</translation>
    </message>
    <message>
        <source>missing ?</source>
        <translation>fehlend ?</translation>
    </message>
    <message>
        <source>samples inside that are not painted</source>
        <translation>Abtastpunkte innen, die nicht gezeichnet sind</translation>
    </message>
    <message>
        <source>extra !</source>
        <translation>überzählig !</translation>
    </message>
    <message>
        <source>samples outside that are painted</source>
        <translation>Abtastpunkte außen, die gezeichnet sind</translation>
    </message>
    <message>
        <source>ties =</source>
        <translation>Grenzfälle =</translation>
    </message>
    <message>
        <source>samples exactly on the boundary that are missing or extra</source>
        <translation>Abtastpunkte genau auf dem Rand, die fehlen oder überzählig sind</translation>
    </message>
    <message>
        <source>colours c</source>
        <translation>Farben c</translation>
    </message>
    <message>
        <source>pixels that are there in another colour</source>
        <translation>Pixel, die da sind, in anderer Farbe</translation>
    </message>
    <message>
        <source>levels off</source>
        <translation>Stufen daneben</translation>
    </message>
    <message>
        <source>the largest error of a byte</source>
        <translation>der größte Fehler eines Bytes</translation>
    </message>
    <message>
        <source>method, arithmetic, kernel</source>
        <translation>Verfahren, Arithmetik, Kern</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>set-up, ns</source>
        <translation>Vorbereitung, ns</translation>
    </message>
    <message>
        <source>the time before a triangle&apos;s first column, divided among its pixels; fitted over all families</source>
        <translation>was ein Dreieck vor seiner ersten Spalte braucht, auf seine Pixel verteilt: aus einem Ausgleich über alle Familien</translation>
    </message>
    <message>
        <source>columns, ns</source>
        <translation>Spalten, ns</translation>
    </message>
    <message>
        <source>the time of a column or a row, divided among its pixels; fitted over all families</source>
        <translation>was eine Spalte oder Zeile braucht, auf ihre Pixel verteilt: aus einem Ausgleich über alle Familien</translation>
    </message>
    <message>
        <source>pixel, ns</source>
        <translation>Pixel, ns</translation>
    </message>
    <message>
        <source>the time of a pixel by itself; fitted over all families</source>
        <translation>was ein Pixel selbst braucht: aus einem Ausgleich über alle Familien</translation>
    </message>
    <message>
        <source>wrong per million</source>
        <translation>falsch je Million</translation>
    </message>
    <message>
        <source>wrong pixels per million: those that differ from the truth</source>
        <translation>falsche Pixel je Million: die von der Wahrheit abweichen</translation>
    </message>
</context>
<context>
    <name>pixelplumb::LabText</name>
    <message>
        <source>%1 of %2 pixels wrong</source>
        <translation>%1 von %2 Pixeln falsch</translation>
    </message>
    <message>
        <source>: %1 missing, %2 extra, ties %3 missing and %4 extra, %5 in another byte</source>
        <translation>: %1 fehlend, %2 überzählig, Grenzfälle %3 fehlend und %4 überzählig, %5 mit anderem Byte</translation>
    </message>
    <message>
        <source> (off by %1 at most)</source>
        <translation> (höchstens %1 daneben)</translation>
    </message>
    <message>
        <source>no error, by proof: %1</source>
        <translation>kein Fehler, nach Beweis: %1</translation>
    </message>
    <message>
        <source>no error: proved for the plain kernel. Tests check that this SIMD kernel writes the same bytes; this is not proved</source>
        <translation>kein Fehler: bewiesen vom einfachen Kern; dass dieser SIMD-Kern dieselben Bytes schreibt, ist getestet, nicht bewiesen</translation>
    </message>
    <message>
        <source>no error observed over %1 pixels; nothing is proved</source>
        <translation>kein Fehler über %1 Pixel beobachtet; nichts ist bewiesen</translation>
    </message>
    <message>
        <source>Click: opens the scene of its first wrong pixel (%1, %2) here and in Compare; unsaved changes are asked about first</source>
        <translation>Klick: öffnet die Szene seines ersten falschen Pixels (%1, %2) hier und im Vergleich; nach ungespeicherten Änderungen wird erst gefragt</translation>
    </message>
    <message>
        <source>%1 ns a pixel</source>
        <translation>%1 ns je Pixel</translation>
    </message>
    <message>
        <source>, ×%1 the assignment&apos;s method</source>
        <translation>, ×%1 das Verfahren der Aufgabe</translation>
    </message>
    <message>
        <source>its straight loop: %1 ns a pixel</source>
        <translation>seine schlichte Schleife: %1 ns je Pixel</translation>
    </message>
    <message>
        <source>&lt;b&gt;!&lt;/b&gt; %1 times its straight loop: more than the fair 1.3</source>
        <translation>&lt;b&gt;!&lt;/b&gt; %1 mal seine schlichte Schleife: mehr als die angemessenen 1.3</translation>
    </message>
    <message>
        <source>no plain kernel shown is as exact in less time</source>
        <translation>keiner der gezeigten einfachen Kerne ist für weniger Zeit so genau</translation>
    </message>
    <message>
        <source>no SIMD kernel shown is as exact in less time</source>
        <translation>keiner der gezeigten SIMD-Kerne ist für weniger Zeit so genau</translation>
    </message>
    <message>
        <source>these triangles are judged and not timed</source>
        <translation>diese Dreiecke werden beurteilt und nicht gemessen</translation>
    </message>
    <message>
        <source>not timed</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>its time is measured once all of this family are judged</source>
        <translation>seine Zeit kommt, wenn alle dieser Familie beurteilt sind</translation>
    </message>
    <message>
        <source>No error was seen in the pixels that were drawn. There may be errors elsewhere.</source>
        <translation>Über den gezeichneten Pixeln wurde kein Fehler gesehen. Anderswo kann es welche geben.</translation>
    </message>
    <message>
        <source>SIMD kernels of methods that are proved to make no error. Tests check that the SIMD kernel writes the same bytes as the proved plain kernel.</source>
        <translation>SIMD-Kerne von Verfahren, die bewiesen keinen Fehler machen: Dass der SIMD-Kern dieselben Bytes schreibt wie der bewiesene einfache, ist getestet.</translation>
    </message>
    <message>
        <source>It is proved that there is no error anywhere, for the triangles that the dot names.</source>
        <translation>Dass es nirgends einen Fehler gibt, ist bewiesen, für die Dreiecke, die der Punkt nennt.</translation>
    </message>
    <message>
        <source>The shortest hand-written loop that draws the same pixels in the same arithmetic. If a method&apos;s dot is near this loop, the method costs only what its arithmetic costs.</source>
        <translation>Die kürzeste von Hand geschriebene Schleife, die dieselben Pixel in derselben Arithmetik zeichnet. Ein Verfahren, dessen Punkt nahe bei seiner Schleife liegt, kostet, was seine Arithmetik kostet.</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>abgelehnt: %1</translation>
    </message>
    <message>
        <source>took too long: %1</source>
        <translation>dauerte zu lange: %1</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>misslungen: %1</translation>
    </message>
    <message>
        <source>(save the scene to get its command)</source>
        <translation>(erst die Szene speichern, dann gibt es ihren Befehl)</translation>
    </message>
    <message>
        <source>per million</source>
        <translation>je Million</translation>
    </message>
    <message>
        <source>%1 per million</source>
        <translation>%1 je Million</translation>
    </message>
    <message>
        <source>%1 takes %2× the time, %3 wrong</source>
        <translation>%1 braucht das %2-fache der Zeit, %3 falsch</translation>
    </message>
    <message>
        <source>Column scan, relative to float32 (%1 wrong pixels per million): %2.</source>
        <translation>Spaltenrasterung, verglichen mit float32 (%1 falsche Pixel je Million): %2.</translation>
    </message>
    <message>
        <source>Press Run to time fifteen contenders and count their wrong pixels (%1).</source>
        <translation>„Messen“ misst die Zeit von fünfzehn Kandidaten und zählt ihre falschen Pixel (%1).</translation>
    </message>
    <message>
        <source>Press Run to time every method in every arithmetic and count its wrong pixels (%1).</source>
        <translation>„Messen“ misst die Zeit jedes Verfahrens in jeder Arithmetik und zählt seine falschen Pixel (%1).</translation>
    </message>
</context>
<context>
    <name>pixelplumb::LayersMenu</name>
    <message>
        <source>&amp;Layers</source>
        <translation>Über&amp;lagerungen</translation>
    </message>
    <message>
        <source>&amp;Hide all layers</source>
        <translation>Alle Überlagerungen &amp;ausblenden</translation>
    </message>
    <message>
        <source>&amp;Reset the affine map</source>
        <translation>&amp;Erste affine Abbildung wieder</translation>
    </message>
    <message>
        <source>Nothing to show: %1.</source>
        <translation>Nichts zu zeigen: %1.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::LeewayBox</name>
    <message>
        <source>Leeway: which pixels may differ in a right picture</source>
        <translation>Spielraum: welche Pixel in einem richtigen Bild abweichen dürfen</translation>
    </message>
    <message>
        <source>strict: no pixel</source>
        <translation>strict: kein Pixel</translation>
    </message>
    <message>
        <source>strict: no pixel may differ; the scene&apos;s fill rule decides every pixel</source>
        <translation>strict: Kein Pixel darf abweichen; die Füllregel der Szene entscheidet jedes Pixel</translation>
    </message>
    <message>
        <source>rule: rounding</source>
        <translation>rule: Rundung</translation>
    </message>
    <message>
        <source>rule: only pixels that rounding may decide; the scene&apos;s fill rule decides all others</source>
        <translation>rule: nur Pixel, die Rundung entscheiden darf; alle anderen entscheidet die Füllregel der Szene</translation>
    </message>
    <message>
        <source>edges: any fill rule</source>
        <translation>edges: jede Füllregel</translation>
    </message>
    <message>
        <source>edges: also every pixel exactly on an edge, so any fill rule is right</source>
        <translation>edges: auch jedes Pixel genau auf einer Kante, also ist jede Füllregel richtig</translation>
    </message>
    <message>
        <source>once: any rule, no gaps</source>
        <translation>once: lückenlos</translation>
    </message>
    <message>
        <source>once: as edges, but a pixel on a shared edge is drawn by exactly one triangle</source>
        <translation>once: wie edges, aber ein Pixel auf einer gemeinsamen Kante zeichnet genau ein Dreieck</translation>
    </message>
</context>
<context>
    <name>pixelplumb::LookDialog</name>
    <message>
        <source>Camera, Light and Materials</source>
        <translation>Kamera, Licht und Materialien</translation>
    </message>
    <message>
        <source>Add a &amp;light</source>
        <translation>&amp;Licht hinzufügen</translation>
    </message>
    <message>
        <source>Add a &amp;material</source>
        <translation>&amp;Material hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Removes the selected light, or the selected material if no primitive names it or one after it</source>
        <translation>Entfernt das gewählte Licht, oder das gewählte Material, wenn kein Primitiv dieses oder ein späteres nennt</translation>
    </message>
    <message>
        <source>How the scene is seen. An empty value stands for the default beside it.</source>
        <translation>Wie die Szene gesehen wird. Ein leerer Wert steht für den Standardwert daneben.</translation>
    </message>
    <message>
        <source>Settings and their values</source>
        <translation>Einstellungen und ihre Werte</translation>
    </message>
</context>
<context>
    <name>pixelplumb::MainWindow</name>
    <message>
        <source>Next vertex</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour of the next vertex</source>
        <translation>Farbe des nächsten Eckpunkts</translation>
    </message>
    <message>
        <source>Tools and stepper</source>
        <translation>Werkzeuge und Schritte</translation>
    </message>
    <message>
        <source>Colour of the Vertex</source>
        <translation>Farbe des Eckpunkts</translation>
    </message>
    <message>
        <source>%1[*] — Pixelplumb</source>
        <translation>%1[*] — Pixelplumb</translation>
    </message>
    <message>
        <source>The program ended without saving a scene, last changed %1.</source>
        <translation>Das Programm endete, ohne eine Szene zu speichern, zuletzt geändert %1.</translation>
    </message>
    <message>
        <source>The program ended without saving “%1”, last changed %2.</source>
        <translation>Das Programm endete, ohne „%1“ zu speichern, zuletzt geändert %2.</translation>
    </message>
    <message>
        <source>Unsaved Scene</source>
        <translation>Nicht gespeicherte Szene</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>F10: the next column</source>
        <translation>F10: die nächste Spalte</translation>
    </message>
    <message>
        <source>F11: the next pixel</source>
        <translation>F11: das nächste Pixel</translation>
    </message>
    <message>
        <source>P: draw; a click places a vertex</source>
        <translation>P: Zeichnen; ein Klick setzt einen Eckpunkt</translation>
    </message>
    <message>
        <source>V: inspect; a click picks a pixel</source>
        <translation>V: Prüfen; ein Klick wählt ein Pixel</translation>
    </message>
    <message>
        <source>“%1” is an assignment, not a scene.</source>
        <translation>„%1“ ist eine Aufgabe, keine Szene.</translation>
    </message>
    <message>
        <source>A folder of submissions is graded by it.</source>
        <translation>Nach ihr wird ein Ordner von Abgaben bewertet.</translation>
    </message>
    <message>
        <source>&amp;Grade a folder…</source>
        <translation>&amp;Ordner bewerten …</translation>
    </message>
    <message>
        <source>“%1” is a scene, not an assignment.</source>
        <translation>„%1“ ist eine Szene, keine Aufgabe.</translation>
    </message>
    <message>
        <source>&amp;Open the scene</source>
        <translation>Szene ö&amp;ffnen</translation>
    </message>
    <message>
        <source>The recovered scene has no file yet: save it to keep it.</source>
        <translation>Die wiederhergestellte Szene hat noch keine Datei: Speichern, um sie zu behalten.</translation>
    </message>
    <message>
        <source>An assignment names the scenes that submissions draw, and what each is worth. Without one, this scene can be the only task, for 5 points.</source>
        <translation>Eine Aufgabe nennt die Szenen, die Abgaben zeichnen, und was jede zählt. Ohne eine kann diese Szene die einzige Aufgabe sein, für 5 Punkte.</translation>
    </message>
    <message>
        <source>&amp;Grade by this scene</source>
        <translation>Nach dieser Szene &amp;bewerten</translation>
    </message>
    <message>
        <source>Method and view</source>
        <translation>Verfahren und Ansicht</translation>
    </message>
</context>
<context>
    <name>pixelplumb::Manual</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>manual.md</source>
        <translation>manual_de.md</translation>
    </message>
    <message>
        <source>Terms</source>
        <translation>Begriffe (englisch)</translation>
    </message>
    <message>
        <source>Scene files</source>
        <translation>Szenendateien (englisch)</translation>
    </message>
    <message>
        <source>Assignments</source>
        <translation>Aufgaben (englisch)</translation>
    </message>
    <message>
        <source>Students&apos; programs</source>
        <translation>Programme von Studierenden (englisch)</translation>
    </message>
    <message>
        <source>Misprints of the course texts</source>
        <translation>Druckfehler der Kurstexte (englisch)</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen (englisch)</translation>
    </message>
    <message>
        <source>Proofs</source>
        <translation>Beweise (englisch)</translation>
    </message>
</context>
<context>
    <name>pixelplumb::Measuring</name>
    <message>
        <source>Waiting for another measurement …</source>
        <translation>Wartet auf eine andere Messung …</translation>
    </message>
    <message>
        <source>Measuring …</source>
        <translation>Misst …</translation>
    </message>
</context>
<context>
    <name>pixelplumb::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>No message</source>
        <translation>Keine Meldung</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Die Meldung schließen</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
</context>
<context>
    <name>pixelplumb::MethodBar</name>
    <message>
        <source>The method %1</source>
        <translation>Das Verfahren: %1</translation>
    </message>
    <message>
        <source>Integer quotient and remainder: nothing is rounded before the byte</source>
        <translation>Ganzzahliger Quotient und Rest: Vor dem Byte wird nichts gerundet</translation>
    </message>
    <message>
        <source>Binary floating point, 24 bits of precision</source>
        <translation>Binäres Gleitkomma, 24 Bit Genauigkeit</translation>
    </message>
    <message>
        <source>Binary floating point, 53 bits of precision</source>
        <translation>Binäres Gleitkomma, 53 Bit Genauigkeit</translation>
    </message>
    <message>
        <source>Fixed point in 32 bits, 16 after the point</source>
        <translation>Festkomma in 32 Bit, davon 16 nach dem Komma</translation>
    </message>
    <message>
        <source>Fixed point in 64 bits, 32 after the point</source>
        <translation>Festkomma in 64 Bit, davon 32 nach dem Komma</translation>
    </message>
    <message>
        <source>A sample on an edge belongs to the triangle: ⌈y_B⌉ … ⌊y_T⌋</source>
        <translation>Ein Abtastpunkt auf einer Kante gehört zum Dreieck: ⌈y_B⌉ … ⌊y_T⌋</translation>
    </message>
    <message>
        <source>Watertight: ⌈y_B⌉ … ⌈y_T⌉−1, columns ⌈x₀⌉ … ⌈x₂⌉−1</source>
        <translation>Lückenlos: ⌈y_B⌉ … ⌈y_T⌉−1, Spalten ⌈x₀⌉ … ⌈x₂⌉−1</translation>
    </message>
    <message>
        <source>A sample on a top or left edge belongs to the triangle (Direct3D)</source>
        <translation>Ein Abtastpunkt auf einer oberen oder linken Kante gehört zum Dreieck (Direct3D)</translation>
    </message>
    <message>
        <source>A sample on an edge belongs to the side of an off-screen point</source>
        <translation>Ein Abtastpunkt auf einer Kante gehört zur Seite eines Punkts außerhalb</translation>
    </message>
    <message>
        <source>A sample on an edge belongs to neither side: ⌊y_B⌋+1 … ⌈y_T⌉−1</source>
        <translation>Ein Abtastpunkt auf einer Kante gehört niemandem: ⌊y_B⌋+1 … ⌈y_T⌉−1</translation>
    </message>
    <message>
        <source>The byte of a colour level v is ⌊v + ½⌋</source>
        <translation>Das Byte eines Farbwerts v ist ⌊v + ½⌋</translation>
    </message>
    <message>
        <source>The byte of a colour level v is ⌊v⌋</source>
        <translation>Das Byte eines Farbwerts v ist ⌊v⌋</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Arithmetic</source>
        <translation>Arithmetik</translation>
    </message>
    <message>
        <source>What the increments are computed in</source>
        <translation>Worin die Inkremente berechnet werden</translation>
    </message>
    <message>
        <source>Fill rule</source>
        <translation>Füllregel</translation>
    </message>
    <message>
        <source>Which side owns a sample that lies exactly on an edge</source>
        <translation>Wem ein Abtastpunkt gehört, der genau auf einer Kante liegt</translation>
    </message>
    <message>
        <source>Rounding</source>
        <translation>Rundung</translation>
    </message>
    <message>
        <source>How a colour level becomes a byte</source>
        <translation>Wie ein Farbwert zu einem Byte wird</translation>
    </message>
</context>
<context>
    <name>pixelplumb::MethodMenu</name>
    <message>
        <source>The method %1</source>
        <translation>Das Verfahren: %1</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Verfahren</translation>
    </message>
    <message>
        <source>Misprints and &amp;typical mistakes</source>
        <translation>Druckfehler und &amp;typische Fehler</translation>
    </message>
    <message>
        <source>%1, in place of %2. %3
%4</source>
        <translation>%1 anstelle von %2. %3
%4</translation>
    </message>
</context>
<context>
    <name>pixelplumb::MethodPanel</name>
    <message>
        <source>This method</source>
        <translation>Dieses Verfahren</translation>
    </message>
    <message>
        <source>What the method does, line by line</source>
        <translation>Was das Verfahren tut, Zeile für Zeile</translation>
    </message>
</context>
<context>
    <name>pixelplumb::MissPlot</name>
    <message>
        <source>nearer than %1 px</source>
        <translation>näher als %1 px</translation>
    </message>
    <message>
        <source>farther than %1 px</source>
        <translation>ferner als %1 px</translation>
    </message>
    <message>
        <source>%1 to %2 px</source>
        <translation>%1 bis %2 px</translation>
    </message>
    <message>
        <source>Distances of missed samples from the boundary</source>
        <translation>Abstände verfehlter Abtastpunkte vom Rand</translation>
    </message>
    <message>
        <source>missing, %1 inside</source>
        <translation>fehlend, %1 innen</translation>
    </message>
    <message>
        <source>extra, %1 outside</source>
        <translation>überzählig, %1 außen</translation>
    </message>
    <message>
        <source>ties, missing: exactly on the boundary</source>
        <translation>Grenzfälle, fehlend: genau auf dem Rand</translation>
    </message>
    <message>
        <source>ties, extra: exactly on the boundary</source>
        <translation>Grenzfälle, überzählig: genau auf dem Rand</translation>
    </message>
    <message>
        <source>? px inside   ←   =   →   ! px outside</source>
        <translation>? px innen   ←   =   →   ! px außen</translation>
    </message>
    <message>
        <source>? missing, px inside   ←   = on the boundary   →   ! extra, px outside</source>
        <translation>? fehlend, px innen   ←   = auf dem Rand   →   ! überzählig, px außen</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Abtastpunkte</translation>
    </message>
    <message>
        <source>Nothing is known about this contender here.</source>
        <translation>Hier ist über diesen Kandidaten nichts bekannt.</translation>
    </message>
    <message>
        <source>No sample is missed.</source>
        <translation>Kein Abtastpunkt ist verfehlt.</translation>
    </message>
    <message>
        <source>? missing</source>
        <translation>? fehlend</translation>
    </message>
    <message>
        <source>= ties</source>
        <translation>= Grenzfälle</translation>
    </message>
    <message>
        <source>! extra</source>
        <translation>! überzählig</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
</context>
<context>
    <name>pixelplumb::MotionPanel</name>
    <message>
        <source>Motion along x, px</source>
        <translation>Bewegung in x, px</translation>
    </message>
    <message>
        <source>Motion along y, px</source>
        <translation>Bewegung in y, px</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Einzelbilder</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Let the scene move</source>
        <translation>Die Szene sich bewegen lassen</translation>
    </message>
    <message>
        <source>Stand still</source>
        <translation>Stillstehen</translation>
    </message>
    <message>
        <source>Let the scene stand still</source>
        <translation>Die Szene stillstehen lassen</translation>
    </message>
    <message>
        <source>Current frame</source>
        <translation>Aktuelles Einzelbild</translation>
    </message>
    <message>
        <source>Play the motion</source>
        <translation>Die Bewegung abspielen</translation>
    </message>
    <message>
        <source>What flickers</source>
        <translation>Was flimmert</translation>
    </message>
    <message>
        <source>Pixels frame by frame</source>
        <translation>Pixel Bild für Bild</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>All triangles and shapes move by (x, y) px from the first frame to the last; saved with the scene</source>
        <translation>Alle Dreiecke und Formen bewegen sich vom ersten bis zum letzten Bild um (x, y) px; mit der Szene gespeichert</translation>
    </message>
    <message>
        <source>Move by x</source>
        <translation>Bewegen um x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>px in</source>
        <translation>px in</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bildern</translation>
    </message>
    <message>
        <source>Show one frame after the other, over and over</source>
        <translation>Ein Bild nach dem anderen zeigen, immer wieder</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>in truth</source>
        <translation>in Wahrheit</translation>
    </message>
    <message>
        <source>came or went</source>
        <translation>Wechsel</translation>
    </message>
    <message>
        <source>“%1” is no distance: expected px, such as 4, 0.5 or 1/3.</source>
        <translation>„%1“ ist kein Abstand: Erwartet werden px wie 4, 0.5 oder 1/3.</translation>
    </message>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>einmal</numerusform>
            <numerusform>%n Mal</numerusform>
        </translation>
    </message>
    <message>
        <source>The scene stands still. Move it by a few pixels in many frames: pixels that flicker are counted.</source>
        <translation>Die Szene steht still. Bewegt sie sich um einige Pixel in vielen Bildern, ist zu sehen, was ohne Grund kommt und geht.</translation>
    </message>
    <message>
        <source>The method %1.</source>
        <translation>Das Verfahren: %1.</translation>
    </message>
    <message>
        <source>The frames are being drawn.</source>
        <translation>Die Bilder werden gezeichnet.</translation>
    </message>
    <message>
        <source>Over %1 frames pixels toggle %2; in the truth, %3.</source>
        <translation>Über %1 Bilder wechseln Pixel %2; exakt gerechnet %3.</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>play</source>
        <translation>abspielen</translation>
    </message>
</context>
<context>
    <name>pixelplumb::MotionView</name>
    <message>
        <source>The current frame</source>
        <translation>Das aktuelle Einzelbild</translation>
    </message>
    <message numerus="yes">
        <source>%n pixels came or went</source>
        <translation>
            <numerusform>%n Pixel kam oder ging</numerusform>
            <numerusform>%n Pixel kamen oder gingen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pixels of the truth are missing</source>
        <translation>
            <numerusform>%n Pixel der Wahrheit fehlt</numerusform>
            <numerusform>%n Pixel der Wahrheit fehlen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::NumberToolTip</name>
    <message>
        <source>unit: %1</source>
        <translation>Einheit: %1</translation>
    </message>
    <message>
        <source>exact %1</source>
        <translation>exakt %1</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>Fehler %1</translation>
    </message>
</context>
<context>
    <name>pixelplumb::OperationPanel</name>
    <message>
        <source>Operations</source>
        <translation>Operationen</translation>
    </message>
    <message>
        <source>What was counted</source>
        <translation>Was gezählt wurde</translation>
    </message>
    <message>
        <source>Operations by kind</source>
        <translation>Operationen nach Art</translation>
    </message>
    <message>
        <source>The arithmetic operations of the method, counted while it draws this scene: on average for each set-up, span and sample, and in total. Whole pixel coordinates and the clamp to a byte are not counted.</source>
        <translation>Was die Zahlen des Verfahrens tun, gezählt, während sie diese Szene zeichnen: im Mittel einer Vorbereitung, einer Spanne und eines Abtastpunkts, und alle zusammen. Ganze Pixelkoordinaten und die Begrenzung auf ein Byte sind nicht gezählt.</translation>
    </message>
    <message>
        <source>a set-up</source>
        <translation>je Vorbereitung</translation>
    </message>
    <message>
        <source>a span</source>
        <translation>je Spanne</translation>
    </message>
    <message>
        <source>a sample</source>
        <translation>je Abtastpunkt</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>The scene is being drawn.</source>
        <translation>Die Szene wird gezeichnet.</translation>
    </message>
    <message>
        <source>The count does not fit into memory. Make the frame smaller.</source>
        <translation>Die Zählung passt nicht in den Speicher. Eine kleinere Bildfläche passt eher.</translation>
    </message>
    <message>
        <source>%1 in %2: %3; the set-up is %4 % of them.</source>
        <translation>%1 in %2: %3; davon Vorbereitung %4 %.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::OverdrawOverlay</name>
    <message>
        <source>Overdraw: the scene is being drawn</source>
        <translation>Mehrfachzeichnung: Die Szene wird gezeichnet</translation>
    </message>
    <message>
        <source>Overdraw: every pixel once, no gap</source>
        <translation>Mehrfachzeichnung: jedes Pixel einmal, keine Lücke</translation>
    </message>
    <message>
        <source>Overdraw: %1 twice or more, %2 at most; %3</source>
        <translation>Mehrfachzeichnung: %1 zweimal oder öfter, höchstens %2; %3</translation>
    </message>
    <message numerus="yes">
        <source>%n pixels</source>
        <translation>
            <numerusform>%n Pixel</numerusform>
            <numerusform>%n Pixel</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>einmal</numerusform>
            <numerusform>%n Mal</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n gaps</source>
        <translation>
            <numerusform>%n Lücke</numerusform>
            <numerusform>%n Lücken</numerusform>
        </translation>
    </message>
    <message>
        <source>Overdraw is hidden while Predict asks</source>
        <translation>Die Mehrfachzeichnung ist verborgen, solange „Vorhersagen“ fragt</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PanelDock</name>
    <message>
        <source>This panel shows the finished picture. Predict hides it until the run has come to its end (F5), or Predict is closed.</source>
        <translation>Hier steht das fertige Bild. „Vorhersagen“ verdeckt es, bis der Lauf am Ende ist (F5) oder „Vorhersagen“ geschlossen wird.</translation>
    </message>
    <message>
        <source>Finish the run</source>
        <translation>Bis zum Ende laufen</translation>
    </message>
    <message>
        <source>Goes to the end, where nothing is left to predict</source>
        <translation>Geht ans Ende, wo nichts mehr vorherzusagen ist</translation>
    </message>
</context>
<context>
    <name>pixelplumb::ParetoPlot</name>
    <message>
        <source>Nothing is judged here yet.</source>
        <translation>Noch ist hier nichts beurteilt.</translation>
    </message>
    <message>
        <source>%1 ns</source>
        <translation>%1 ns</translation>
    </message>
    <message>
        <source>cost, ns a pixel: not known yet</source>
        <translation>Kosten, ns je Pixel: noch nicht bekannt</translation>
    </message>
    <message>
        <source>cost, ns a pixel</source>
        <translation>Kosten, ns je Pixel</translation>
    </message>
    <message>
        <source>times the assignment&apos;s method (column scan, float32)</source>
        <translation>mal das Verfahren der Aufgabe (Spaltenrasterung, float32)</translation>
    </message>
    <message>
        <source>best plain kernels</source>
        <translation>beste einfache Kerne</translation>
    </message>
    <message>
        <source>best SIMD kernels</source>
        <translation>beste SIMD-Kerne</translation>
    </message>
    <message>
        <source>The frontier: no plain kernel, which draws one pixel at a time, is as exact in less time than those on this line.</source>
        <translation>Die Front: Von den einfachen Kernen, die ein Pixel nach dem anderen zeichnen, ist keiner für weniger Zeit so genau wie die auf dieser Linie.</translation>
    </message>
    <message>
        <source>The frontier of the SIMD kernels, which draw several pixels at once. They are compared only with each other: they are faster because of how they are programmed, not because of what they compute.</source>
        <translation>Die Front der SIMD-Kerne, die mehrere Pixel auf einmal zeichnen. Sie werden unter sich verglichen: Schneller macht sie, wie sie programmiert sind, nicht, was sie berechnen.</translation>
    </message>
    <message>
        <source>SIMD kernel</source>
        <translation>SIMD-Kern</translation>
    </message>
    <message>
        <source>A kernel that draws several pixels at once, by SIMD instructions. Tests check that it writes the same bytes as the plain kernel.</source>
        <translation>Ein Kern, der mit SIMD-Befehlen mehrere Pixel auf einmal zeichnet. Es ist getestet, dass er dieselben Bytes schreibt wie der einfache Kern.</translation>
    </message>
    <message>
        <source>another renderer</source>
        <translation>ein anderes Programm</translation>
    </message>
    <message>
        <source>Code by others, measured in the same benchmark.</source>
        <translation>Code anderer, vom Benchmark neben unserem gemessen.</translation>
    </message>
    <message>
        <source>straight loop</source>
        <translation>schlichte Schleife</translation>
    </message>
    <message>
        <source>over 1.3 × its loop</source>
        <translation>über 1.3 × seine Schleife</translation>
    </message>
    <message>
        <source>It takes more than 1.3 times as long as its straight loop, so part of its cost is how it is programmed, not what it computes.</source>
        <translation>Braucht mehr als 1.3-mal die Zeit seiner schlichten Schleife: Ein Teil seiner Kosten ist, wie er programmiert ist, nicht, was er berechnet.</translation>
    </message>
    <message>
        <source>not timed (yet)</source>
        <translation>(noch) nicht gemessen</translation>
    </message>
    <message>
        <source>Its error is known but its time is not yet: it waits at the left.</source>
        <translation>Sein Fehler ist bekannt, seine Zeit nicht: Er wartet links.</translation>
    </message>
    <message>
        <source>Cost against error</source>
        <translation>Kosten gegen Fehler</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PerformancePanel</name>
    <message>
        <source>Performance</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Draw the scene repeatedly by the plain and the fast kernels in turn, and time memset beside them</source>
        <translation>Die Szene wieder und wieder mit den einfachen und den schnellen Kernen im Wechsel zeichnen, neben memset</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Fortschritt der Messung</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Zeiten</translation>
    </message>
    <message>
        <source>speed: relative to the plain kernel; of memset: how close the time is to memset over as many pixels</source>
        <translation>Tempo: wie viele Male das des einfachen Kerns; von memset: wie nahe die Zeit der von memset über ebenso viele Pixel kommt</translation>
    </message>
    <message>
        <source>Fast kernels used</source>
        <translation>Benutzte schnelle Kerne</translation>
    </message>
    <message>
        <source>Fast kernels, and why</source>
        <translation>Schnelle Kerne, und warum</translation>
    </message>
    <message>
        <source>The measurement was cancelled.</source>
        <translation>Die Messung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The scene is being drawn.</source>
        <translation>Die Szene wird gezeichnet.</translation>
    </message>
    <message>
        <source>The measurement does not fit into memory. Make the frame smaller.</source>
        <translation>Die Messung passt nicht in den Speicher. Eine kleinere Bildfläche passt eher.</translation>
    </message>
    <message>
        <source>Known after a measurement.</source>
        <translation>Nach einer Messung bekannt.</translation>
    </message>
    <message>
        <source>Press Measure to draw this scene repeatedly for about a second.</source>
        <translation>„Messen“ zeichnet diese Szene etwa eine Sekunde lang immer wieder.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PerformanceText</name>
    <message>
        <source>ns a pixel</source>
        <translation>ns je Pixel</translation>
    </message>
    <message>
        <source>ns a triangle</source>
        <translation>ns je Dreieck</translation>
    </message>
    <message>
        <source>quartiles</source>
        <translation>Quartile</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>of memset</source>
        <translation>von memset</translation>
    </message>
    <message>
        <source>plain kernel</source>
        <translation>einfacher Kern</translation>
    </message>
    <message>
        <source>fast, %1</source>
        <translation>schnell, %1</translation>
    </message>
    <message>
        <source>fast, %1 threads</source>
        <translation>schnell, %1 Threads</translation>
    </message>
    <message>
        <source>memory: memset</source>
        <translation>Speicher: memset</translation>
    </message>
    <message>
        <source>, colours: %1</source>
        <translation>, Farben: %1</translation>
    </message>
    <message>
        <source>The scene has no triangles to draw.</source>
        <translation>Die Szene hat keine Dreiecke zu zeichnen.</translation>
    </message>
    <message>
        <source>The scene&apos;s triangles cover no pixel of the frame.</source>
        <translation>Die Dreiecke der Szene überdecken kein Pixel der Bildfläche.</translation>
    </message>
    <message numerus="yes">
        <source>%1 triangles</source>
        <translation>
            <numerusform>%1 Dreieck</numerusform>
            <numerusform>%1 Dreiecke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 pixels</source>
        <translation>
            <numerusform>%1 Pixel</numerusform>
            <numerusform>%1 Pixel</numerusform>
        </translation>
    </message>
    <message>
        <source>Column scan, %1, %2: %3, %4 written. Medians of %5 rounds. %6</source>
        <translation>Spaltenrasterung, %1, %2: %3, %4 geschrieben. Mediane von %5 Runden. %6</translation>
    </message>
    <message>
        <source>Both kernels draw the same bytes.</source>
        <translation>Beide Kerne zeichnen dieselben Bytes.</translation>
    </message>
    <message>
        <source>The kernels draw different bytes!</source>
        <translation>Die Kerne zeichnen verschiedene Bytes!</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PixelGrid</name>
    <message>
        <source>Pixel grid</source>
        <translation>Pixelraster</translation>
    </message>
    <message>
        <source>The pixels around the picked one appear here.</source>
        <translation>Hier erscheinen die Pixel um das gewählte.</translation>
    </message>
    <message>
        <source>Pixel (%1, %2)</source>
        <translation>Pixel (%1, %2)</translation>
    </message>
    <message>
        <source>outside the frame</source>
        <translation>außerhalb der Bildfläche</translation>
    </message>
    <message>
        <source>shown %1</source>
        <translation>gezeigt %1</translation>
    </message>
    <message>
        <source>truth %1, when all is drawn</source>
        <translation>Wahrheit %1, wenn alles gezeichnet ist</translation>
    </message>
    <message>
        <source>not covered by triangle %1</source>
        <translation>nicht von Dreieck %1 überdeckt</translation>
    </message>
    <message>
        <source>true levels in triangle %1:</source>
        <translation>wahre Farbwerte in Dreieck %1:</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>Zeile %1</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PixelHistoryModel</name>
    <message>
        <source>%1 wrote it</source>
        <translation>%1 schrieb es</translation>
    </message>
    <message>
        <source>%1 will write it</source>
        <translation>%1 wird es schreiben</translation>
    </message>
    <message>
        <source>%1 is hidden or refused</source>
        <translation>%1 ist verdeckt oder abgewiesen</translation>
    </message>
    <message>
        <source>%1 missed it</source>
        <translation>%1 verfehlte es</translation>
    </message>
    <message>
        <source>%1 refuses it</source>
        <translation>%1 weist es ab</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>covered in part</source>
        <translation>teilweise überdeckt</translation>
    </message>
    <message>
        <source>not covered</source>
        <translation>nicht überdeckt</translation>
    </message>
    <message>
        <source>base %1</source>
        <translation>Grundfarbe %1</translation>
    </message>
    <message>
        <source>→ %1</source>
        <translation>→ %1</translation>
    </message>
    <message>
        <source>→ %1 clamped to %2</source>
        <translation>→ %1 auf %2 begrenzt</translation>
    </message>
    <message>
        <source>truth %1, error %2</source>
        <translation>Wahrheit %1, Fehler %2</translation>
    </message>
    <message>
        <source>exact %1, error %2</source>
        <translation>exakt %1, Fehler %2</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>Kante %1</translation>
    </message>
    <message>
        <source>%1 px along column</source>
        <translation>%1 px entlang der Spalte</translation>
    </message>
    <message>
        <source>%1 px along row</source>
        <translation>%1 px entlang der Zeile</translation>
    </message>
    <message>
        <source>on it: accepts</source>
        <translation>auf ihr: nimmt an</translation>
    </message>
    <message>
        <source>on it: refuses</source>
        <translation>auf ihr: weist ab</translation>
    </message>
    <message>
        <source>accepts</source>
        <translation>nimmt an</translation>
    </message>
    <message>
        <source>refuses</source>
        <translation>weist ab</translation>
    </message>
    <message>
        <source>%1 px from the edge</source>
        <translation>%1 px von der Kante</translation>
    </message>
    <message numerus="yes">
        <source>and %n more that refuse it</source>
        <translation>
            <numerusform>und %n weiteres, das es abweist</numerusform>
            <numerusform>und %n weitere, die es abweisen</numerusform>
        </translation>
    </message>
    <message>
        <source>the centre inside</source>
        <translation>Mitte innerhalb</translation>
    </message>
    <message>
        <source>the centre outside</source>
        <translation>Mitte außerhalb</translation>
    </message>
    <message>
        <source>in truth, edge %1</source>
        <translation>in Wahrheit, Kante %1</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PixelHistoryPanel</name>
    <message>
        <source>History of the picked pixel</source>
        <translation>Geschichte des gewählten Pixels</translation>
    </message>
    <message>
        <source>◀ Write</source>
        <translation>◀ Schreiben</translation>
    </message>
    <message>
        <source>Run back to the previous write of the picked pixel</source>
        <translation>Zurück zum vorigen Schreiben des gewählten Pixels laufen</translation>
    </message>
    <message>
        <source>Write ▶</source>
        <translation>Schreiben ▶</translation>
    </message>
    <message>
        <source>Run on to the next write of the picked pixel</source>
        <translation>Vor zum nächsten Schreiben des gewählten Pixels laufen</translation>
    </message>
    <message>
        <source>Attempts of the triangles</source>
        <translation>Versuche der Dreiecke</translation>
    </message>
    <message>
        <source>&lt;b&gt;(%1, %2)&lt;/b&gt; is still ahead: predict it</source>
        <translation>&lt;b&gt;(%1, %2)&lt;/b&gt; steht noch bevor: Es kann vorhergesagt werden</translation>
    </message>
    <message>
        <source>truth %1</source>
        <translation>Wahrheit %1</translation>
    </message>
    <message>
        <source>what becomes of it is still ahead: predict it</source>
        <translation>was aus ihm wird, liegt noch voraus: vorhersagen</translation>
    </message>
    <message>
        <source>&lt;b&gt;No pixel is picked&lt;/b&gt;</source>
        <translation>&lt;b&gt;Kein Pixel ist gewählt&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Click one in the pixel grid, or on the canvas with the tool Inspect.</source>
        <translation>Eines im Pixelraster anklicken oder mit dem Werkzeug „Prüfen“ auf der Zeichenfläche.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PlacingHint</name>
    <message>
        <source>Click three points on the canvas to draw a triangle</source>
        <translation>Drei Punkte auf der Zeichenfläche anklicken, um ein Dreieck zu zeichnen</translation>
    </message>
    <message>
        <source>Click to draw a point</source>
        <translation>Klicken, um einen Punkt zu zeichnen</translation>
    </message>
    <message>
        <source>Click two points to draw a line</source>
        <translation>Zwei Punkte anklicken, um eine Linie zu zeichnen</translation>
    </message>
    <message>
        <source>Click the centre and a corner of the box around the ellipse</source>
        <translation>Den Mittelpunkt und eine Ecke des Rechtecks um die Ellipse anklicken</translation>
    </message>
    <message>
        <source>Click four control points to draw a curve</source>
        <translation>Vier Kontrollpunkte anklicken, um eine Kurve zu zeichnen</translation>
    </message>
    <message>
        <source>Click the corners of a polygon, then its first corner again</source>
        <translation>Die Ecken eines Polygons anklicken, dann die erste noch einmal</translation>
    </message>
    <message>
        <source>Click where the text begins</source>
        <translation>Dort klicken, wo der Text beginnt</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>circles</source>
        <translation>Kreise</translation>
    </message>
    <message>
        <source>ellipses</source>
        <translation>Ellipsen</translation>
    </message>
    <message>
        <source>curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>polygons</source>
        <translation>Polygone</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>outlined %1</source>
        <translation>Umrisse: %1</translation>
    </message>
    <message>
        <source>filled %1</source>
        <translation>gefüllte %1</translation>
    </message>
    <message>
        <source>All primitives are hidden: Edit ▸ Show all hidden primitives.</source>
        <translation>Alle Primitive sind ausgeblendet: Bearbeiten ▸ Alle ausgeblendeten Primitive zeigen.</translation>
    </message>
    <message>
        <source>%1 draws %2; this scene has none. %3 draws what is here.</source>
        <translation>%1 zeichnet %2; diese Szene hat keine. %3 zeichnet, was da ist.</translation>
    </message>
    <message>
        <source>%1. Every number of every step appears here.</source>
        <translation>%1. Jede Zahl jedes Schritts erscheint hier.</translation>
    </message>
    <message>
        <source>The method drew nothing of this scene.</source>
        <translation>Das Verfahren hat von dieser Szene nichts gezeichnet.</translation>
    </message>
    <message>
        <source>Click the corner of the box around it</source>
        <translation>Die Ecke des Rechtecks darum anklicken</translation>
    </message>
    <message>
        <source>Click the next corner, or the first one to close the polygon</source>
        <translation>Die nächste Ecke anklicken, oder die erste, um das Polygon zu schließen</translation>
    </message>
    <message>
        <source>Click the second point</source>
        <translation>Den zweiten Punkt anklicken</translation>
    </message>
    <message>
        <source>Click the third point</source>
        <translation>Den dritten Punkt anklicken</translation>
    </message>
    <message>
        <source>Click the fourth point</source>
        <translation>Den vierten Punkt anklicken</translation>
    </message>
    <message>
        <source>Click the next point</source>
        <translation>Den nächsten Punkt anklicken</translation>
    </message>
    <message>
        <source>Click the centre and a corner of the square around the circle; Primitives ▸ Form makes it an ellipse</source>
        <translation>Den Mittelpunkt und eine Ecke des Quadrats um den Kreis anklicken; Primitive ▸ Form macht eine Ellipse daraus</translation>
    </message>
    <message>
        <source>The run is still being recorded. Its numbers appear here.</source>
        <translation>Der Lauf wird noch aufgezeichnet. Seine Zahlen erscheinen hier.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::Playhead</name>
    <message>
        <source>No pixel is picked: click one in the pixel grid or press an arrow key.</source>
        <translation>Kein Pixel ist gewählt: eines im Pixelraster anklicken oder eine Pfeiltaste drücken.</translation>
    </message>
    <message>
        <source>No later step writes pixel (%1, %2).</source>
        <translation>Kein späterer Schritt schreibt Pixel (%1, %2).</translation>
    </message>
    <message>
        <source>No earlier step writes pixel (%1, %2).</source>
        <translation>Kein früherer Schritt schreibt Pixel (%1, %2).</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PointerReadout</name>
    <message>
        <source>less than 0.01 px</source>
        <translation>weniger als 0.01 px</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 · on %2</source>
        <translation>%1 · auf %2</translation>
    </message>
    <message>
        <source>%1 · %2 from %3</source>
        <translation>%1 · %2 von %3</translation>
    </message>
    <message>
        <source>not painted</source>
        <translation>nicht gezeichnet</translation>
    </message>
    <message>
        <source>not painted yet</source>
        <translation>noch nicht gezeichnet</translation>
    </message>
    <message>
        <source>on %1 of %2</source>
        <translation>auf %1, %2</translation>
    </message>
    <message>
        <source>%1 inside %2 of %3</source>
        <translation>%1 innerhalb von %2, %3</translation>
    </message>
    <message>
        <source>%1 outside %2 of %3</source>
        <translation>%1 außerhalb von %2, %3</translation>
    </message>
    <message>
        <source>student: %1</source>
        <translation>Abgabe: %1</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>Eckpunkt %1</translation>
    </message>
    <message>
        <source>%1; expected: %2</source>
        <translation>%1; erwartet: %2</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PrecisionPanel</name>
    <message>
        <source>Bound</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Which bound&apos;s error is plotted</source>
        <translation>Der Fehler welcher Grenze gezeichnet wird</translation>
    </message>
    <message>
        <source>lower bound y_B</source>
        <translation>untere Grenze y_B</translation>
    </message>
    <message>
        <source>upper bound y_T</source>
        <translation>obere Grenze y_T</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Show or hide the curve of %1</source>
        <translation>Die Kurve von %1 zeigen oder ausblenden</translation>
    </message>
    <message>
        <source>Dotted: the largest error that rounding can add up to after n additions: n·ulp/2 in floating point, n·2⁻¹⁷ in 16.16, n·2⁻³³ in 32.32. ≠: the first column that covers the wrong samples. A click goes there.</source>
        <translation>Punktiert: was Rundung aufsummieren kann, n·ulp/2 in Gleitkomma, n·2⁻¹⁷ in 16.16, n·2⁻³³ in 32.32 nach n Additionen. ≠: die erste Spalte, die andere Abtastpunkte überdeckt, als sie soll. Ein Klick geht dorthin.</translation>
    </message>
    <message>
        <source>left bound x_L</source>
        <translation>linke Grenze x_L</translation>
    </message>
    <message>
        <source>right bound x_R</source>
        <translation>rechte Grenze x_R</translation>
    </message>
    <message>
        <source>The scene is being drawn.</source>
        <translation>Die Szene wird gezeichnet.</translation>
    </message>
    <message>
        <source>The method “%1” has no bounds that could be wrong here: it tests every sample, or computes only in exact arithmetic, or draws no triangle of this scene.</source>
        <translation>Das Verfahren „%1“ hat hier keine Grenzen, die danebenliegen könnten: Es prüft jeden Abtastpunkt, rechnet nur exakt oder zeichnet kein Dreieck dieser Szene.</translation>
    </message>
    <message>
        <source>%1: at most %2 px</source>
        <translation>%1: höchstens %2 px</translation>
    </message>
    <message>
        <source>, rows wrong: %1, the first at y = %2</source>
        <translation>, falsche Zeilen: %1, die erste bei y = %2</translation>
    </message>
    <message>
        <source>, columns wrong: %1, the first at x = %2</source>
        <translation>, falsche Spalten: %1, die erste bei x = %2</translation>
    </message>
    <message>
        <source>, no column wrong</source>
        <translation>, keine Spalte falsch</translation>
    </message>
    <message>
        <source>, no row wrong</source>
        <translation>, keine Zeile falsch</translation>
    </message>
    <message>
        <source>Triangle %1. </source>
        <translation>Dreieck %1. </translation>
    </message>
    <message>
        <source>lower bound</source>
        <translation>untere Grenze</translation>
    </message>
    <message>
        <source>upper bound</source>
        <translation>obere Grenze</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PrecisionPlot</name>
    <message>
        <source>Error of a bound over the columns</source>
        <translation>Fehler einer Grenze über die Spalten</translation>
    </message>
    <message>
        <source>row y</source>
        <translation>Zeile y</translation>
    </message>
    <message>
        <source>column x</source>
        <translation>Spalte x</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>Fehler, px</translation>
    </message>
    <message>
        <source>−½ px</source>
        <translation>−½ px</translation>
    </message>
    <message>
        <source>½ px</source>
        <translation>½ px</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PredictPanel</name>
    <message>
        <source>The question</source>
        <translation>Die Frage</translation>
    </message>
    <message>
        <source>What is said of the answer</source>
        <translation>Was zur Antwort gesagt wird</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Punktestand</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>Vorhersagen</translation>
    </message>
    <message>
        <source>What is asked for</source>
        <translation>Wonach gefragt wird</translation>
    </message>
    <message>
        <source>Your answer</source>
        <translation>Die eigene Antwort</translation>
    </message>
    <message>
        <source>2, 2.75, 11/4 or 2 3/4</source>
        <translation>2, 2.75, 11/4 oder 2 3/4</translation>
    </message>
    <message>
        <source>Compare the answer with what the kernel computes (Enter)</source>
        <translation>Die Antwort mit dem vergleichen, was der Kern berechnet (Eingabetaste)</translation>
    </message>
    <message>
        <source>Give up this question and see how the number comes about</source>
        <translation>Diese Frage aufgeben und sehen, wie die Zahl zustande kommt</translation>
    </message>
    <message>
        <source>Step on and ask again (Enter)</source>
        <translation>Weitergehen und wieder fragen (Eingabetaste)</translation>
    </message>
    <message>
        <source>the next pixel</source>
        <translation>das nächste Pixel</translation>
    </message>
    <message>
        <source>The run has ended, so there is nothing to predict: step back, or go to the start.</source>
        <translation>Es liegt nichts voraus: zurückgehen oder zum Anfang laufen.</translation>
    </message>
    <message>
        <source>(%1, %2)</source>
        <translation>(%1, %2)</translation>
    </message>
    <message>
        <source>Right, %1. %2</source>
        <translation>Richtig, %1. %2</translation>
    </message>
    <message>
        <source>Not %1. %2 Try again, or press Show.</source>
        <translation>Nicht %1. %2 Noch einmal versuchen oder zeigen lassen.</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>It is (%1, %2). %3</source>
        <translation>Es ist (%1, %2). %3</translation>
    </message>
    <message>
        <source>Right at the first try: %1 of %2</source>
        <translation>Beim ersten Versuch richtig: %1 von %2</translation>
    </message>
    <message>
        <source>Predict is closed. %1.</source>
        <translation>Vorhersagen ist geschlossen. %1.</translation>
    </message>
    <message>
        <source>The panel was closed with this question open. %1</source>
        <translation>Das Fenster wurde bei offener Frage geschlossen. %1</translation>
    </message>
    <message>
        <source>&amp;Check</source>
        <translation>&amp;Prüfen</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>As&amp;k for</source>
        <translation>Fragen na&amp;ch</translation>
    </message>
    <message>
        <source>&amp;Answer</source>
        <translation>&amp;Antwort</translation>
    </message>
    <message>
        <source>x, y</source>
        <translation>x, y</translation>
    </message>
    <message>
        <source>Type the pixel&apos;s x and y, such as 12, 7.</source>
        <translation>x und y des Pixels eingeben, etwa 12, 7.</translation>
    </message>
    <message>
        <source>2</source>
        <translation>2</translation>
    </message>
    <message>
        <source>%1: what is %2?</source>
        <translation>%1: Was ist %2?</translation>
    </message>
    <message>
        <source>A whole number.</source>
        <translation>Eine ganze Zahl.</translation>
    </message>
    <message>
        <source>A fraction, or a decimal rounded to %1 places or more.</source>
        <translation>Ein Bruch oder eine Dezimalzahl, auf %1 Stellen oder mehr gerundet.</translation>
    </message>
    <message>
        <source>Which pixel of the frame is written next? Type its x, y, right-click it, or go there with the arrow keys and press Check.</source>
        <translation>Welches Pixel des Bildes wird als nächstes geschrieben? Sein x, y eingeben, es mit der rechten Maustaste wählen oder mit den Pfeiltasten hingehen und „Prüfen“ drücken.</translation>
    </message>
    <message>
        <source>Nothing is drawn yet. Draw a triangle: Predict then asks for its numbers.</source>
        <translation>Noch ist nichts gezeichnet. Ein Dreieck zeichnen: „Vorhersagen“ fragt dann nach seinen Zahlen.</translation>
    </message>
    <message>
        <source>This number is the same along the whole primitive and stands in earlier rows of the table, so the answer does not count.</source>
        <translation>Diese Zahl ist entlang des ganzen Primitivs dieselbe und steht in früheren Zeilen der Tabelle, also zählt die Antwort nicht.</translation>
    </message>
    <message>
        <source>This step has already been shown, so the answer does not count.</source>
        <translation>Dieser Schritt war schon zu sehen, also zählt die Antwort nicht.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PredictWords</name>
    <message>
        <source>%1 is the whole number nearest to %2</source>
        <translation>%1 ist die ganze Zahl, die %2 am nächsten ist</translation>
    </message>
    <message>
        <source>%1 is the last whole number below %2</source>
        <translation>%1 ist die letzte ganze Zahl unter %2</translation>
    </message>
    <message>
        <source>%1 is the first whole number above %2</source>
        <translation>%1 ist die erste ganze Zahl über %2</translation>
    </message>
    <message>
        <source>%1 is the first whole number not below %2</source>
        <translation>%1 ist die erste ganze Zahl nicht unter %2</translation>
    </message>
    <message>
        <source>%1 is the last whole number not above %2</source>
        <translation>%1 ist die letzte ganze Zahl nicht über %2</translation>
    </message>
    <message>
        <source>Right: %1 = %2.</source>
        <translation>Richtig: %1 = %2.</translation>
    </message>
    <message>
        <source>Type a number, such as 2, 2.75, 11/4 or 2 3/4.</source>
        <translation>Eine Zahl eingeben, etwa 2, 2.75, 11/4 oder 2 3/4.</translation>
    </message>
    <message>
        <source>That is %1 of the span before: %2.</source>
        <translation>Das ist %1 der Spanne davor: %2.</translation>
    </message>
    <message>
        <source>That is %1 of the span before: what does one step add to it?</source>
        <translation>Das ist %1 der Spanne davor: was kommt mit einem Schritt dazu?</translation>
    </message>
    <message>
        <source>That is %1, the whole number next to it. The question asks for %2 itself: a fraction, or a decimal rounded to %3 places or more.</source>
        <translation>Das ist %1, die ganze Zahl daneben. Gefragt ist %2 selbst: ein Bruch oder eine Dezimalzahl, auf %3 oder mehr Stellen gerundet.</translation>
    </message>
    <message>
        <source>Near, but a whole number is asked for: %1.</source>
        <translation>Nahe daran, aber gefragt ist eine ganze Zahl: %1.</translation>
    </message>
    <message>
        <source>Near: a fraction is wanted, or a decimal rounded to %1 places or more.</source>
        <translation>Nahe daran: gefragt ist ein Bruch oder eine Dezimalzahl, auf %1 oder mehr Stellen gerundet.</translation>
    </message>
    <message>
        <source>One off: %1.</source>
        <translation>Um eins daneben: %1.</translation>
    </message>
    <message>
        <source>The sign is the other one.</source>
        <translation>Das Vorzeichen ist das andere.</translation>
    </message>
    <message>
        <source>Not yet: %1. Substitute the numbers, or press Show.</source>
        <translation>Noch nicht: %1. Die Zahlen einsetzen oder zeigen lassen.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PrimitiveForms</name>
    <message>
        <source>Outlined</source>
        <translation>Als Umriss</translation>
    </message>
    <message>
        <source>Filled by parity (even-odd)</source>
        <translation>Gefüllt nach Parität (gerade-ungerade)</translation>
    </message>
    <message>
        <source>Filled by winding number (non-zero)</source>
        <translation>Gefüllt nach Windungszahl (ungleich null)</translation>
    </message>
    <message>
        <source>Filled</source>
        <translation>Gefüllt</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Ellipse: its corner is free</source>
        <translation>Ellipse: ihre Ecke ist frei</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PrimitiveListModel</name>
    <message>
        <source>several</source>
        <translation>mehrere</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>Eckpunkt %1</translation>
    </message>
    <message>
        <source>%1, hidden</source>
        <translation>%1, ausgeblendet</translation>
    </message>
    <message>
        <source>%1, solid %2</source>
        <translation>%1, Körper %2</translation>
    </message>
    <message>
        <source>The number used in all other places: counted from 0, among the drawn primitives</source>
        <translation>Die Nummer, die es überall hat: unter denen, die gezeichnet werden, ab 0</translation>
    </message>
    <message>
        <source>The place in the drawing order, hidden ones counted, from 1; hiding changes none</source>
        <translation>Der Platz in der Zeichenreihenfolge, ausgeblendete mitgezählt, ab 1; Ausblenden ändert keinen</translation>
    </message>
    <message>
        <source>primitive</source>
        <translation>Primitiv</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>x, px</source>
        <translation>x, px</translation>
    </message>
    <message>
        <source>y, px</source>
        <translation>y, px</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>vertex %1, %2</source>
        <translation>Eckpunkt %1, %2</translation>
    </message>
</context>
<context>
    <name>pixelplumb::PrimitivesPanel</name>
    <message>
        <source>Primitives in drawing order</source>
        <translation>Primitive in Zeichenreihenfolge</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Draw it before the one above</source>
        <translation>Vor dem darüber zeichnen</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Draw it after the one below</source>
        <translation>Nach dem darunter zeichnen</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe …</translation>
    </message>
    <message>
        <source>The colour of the vertex, or of all vertices of the primitive</source>
        <translation>Die Farbe des Eckpunkts, oder aller Eckpunkte des Primitivs</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the primitive</source>
        <translation>Das Primitiv löschen</translation>
    </message>
    <message numerus="yes">
        <source>%n primitives</source>
        <translation>
            <numerusform>%n Primitiv</numerusform>
            <numerusform>%n Primitive</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, and %n hidden that the numbers leave out</source>
        <translation>
            <numerusform>, und %n ausgeblendetes, das die Nummern auslassen</numerusform>
            <numerusform>, und %n ausgeblendete, die die Nummern auslassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> and %n solids</source>
        <translation>
            <numerusform> und %n Körper</numerusform>
            <numerusform> und %n Körper</numerusform>
        </translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Draw the primitive again, at its place; the others are numbered with it</source>
        <translation>Das Primitiv wieder zeichnen, an seinem Platz; die anderen werden mit ihm nummeriert</translation>
    </message>
    <message>
        <source>Keep the primitive and do not draw it; the others are numbered without it. The box before its name shows it again</source>
        <translation>Das Primitiv behalten und nicht zeichnen; die anderen werden ohne es nummeriert. Das Kästchen vor seinem Namen blendet es wieder ein</translation>
    </message>
    <message>
        <source>Colour of the Primitive</source>
        <translation>Farbe des Primitivs</translation>
    </message>
    <message>
        <source>Colour of the Vertex</source>
        <translation>Farbe des Eckpunkts</translation>
    </message>
    <message>
        <source>Colour of the Solid</source>
        <translation>Farbe des Körpers</translation>
    </message>
    <message>
        <source>. The camera makes the triangles of a solid; the Projection panel shows both</source>
        <translation>. Die Kamera macht die Dreiecke eines Körpers; die Ansicht „Projektion“ zeigt beides</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>The forms it can take, such as circle or ellipse, outlined or filled</source>
        <translation>Aus einem Kreis eine Ellipse, als Umriss oder gefüllt: eine Liste dessen, was es sein kann</translation>
    </message>
</context>
<context>
    <name>pixelplumb::ProjectionPanel</name>
    <message>
        <source>a triangle</source>
        <translation>ein Dreieck</translation>
    </message>
    <message>
        <source>a polygon</source>
        <translation>ein Polygon</translation>
    </message>
    <message>
        <source>a plane</source>
        <translation>eine Ebene</translation>
    </message>
    <message>
        <source>a sphere</source>
        <translation>eine Kugel</translation>
    </message>
    <message>
        <source>a patch</source>
        <translation>ein Flächenstück</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>ein Netz</translation>
    </message>
    <message>
        <source>%1: each %2</source>
        <translation>%1: jedes %2</translation>
    </message>
    <message>
        <source> Not drawn are %1.</source>
        <translation> Nicht gezeichnet sind %1.</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>The current triangle</source>
        <translation>Das aktuelle Dreieck</translation>
    </message>
    <message>
        <source>Projection and surfaces</source>
        <translation>Projektion und Flächen</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>The scene is being drawn.</source>
        <translation>Die Szene wird gezeichnet.</translation>
    </message>
    <message numerus="yes">
        <source>The scene&apos;s solids become %n triangles.</source>
        <translation>
            <numerusform>Die Körper der Szene werden zu %n Dreieck.</numerusform>
            <numerusform>Die Körper der Szene werden zu %n Dreiecken.</numerusform>
        </translation>
    </message>
    <message>
        <source> Step into one of them.</source>
        <translation> Ein Schritt hinein zeigt eines davon.</translation>
    </message>
    <message>
        <source>The current triangle is %1 %2 %3 of face %4 of solid %5, %6.</source>
        <translation>Das aktuelle Dreieck ist %1 %2 %3 der Seitenfläche %4 des Körpers %5 (%6).</translation>
    </message>
    <message>
        <source>This scene has no solids. For a face of a sphere, a plane, a patch, a mesh or a polygon in space, this panel shows how the camera takes it to the frame: from its vertices to the eye&apos;s axes, clip coordinates, clipping at the near plane, division by w, pixels and rounding to the lattice, with each number beside its exact value.</source>
        <translation>Diese Szene hat keine Körper. Von einer Seitenfläche einer Kugel, einer Ebene, eines Flächenstücks, eines Netzes oder eines Polygons im Raum steht hier, wie die Kamera sie auf die Bildfläche bringt: von ihren Eckpunkten zu den Achsen des Auges, den Clip-Koordinaten, dem Abschneiden an der vorderen Ebene, der Division durch w, den Pixeln und der Rundung auf das Koordinatengitter, jede Zahl neben ihrem exakten Wert.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::RecentFiles</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>Zu&amp;letzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation>&amp;Liste leeren</translation>
    </message>
</context>
<context>
    <name>pixelplumb::RunNotes</name>
    <message numerus="yes">
        <source>and %n more numbers are taken as the nearest of 1/256 px or 2^-24</source>
        <translation>
            <numerusform>und %n weitere Zahl wird auf das nächste 1/256 px oder 2^-24 gelegt</numerusform>
            <numerusform>und %n weitere Zahlen werden auf das nächste 1/256 px oder 2^-24 gelegt</numerusform>
        </translation>
    </message>
    <message>
        <source>%L1 primitives are not drawn. The first: %2</source>
        <translation>%L1 Primitive sind nicht gezeichnet. Das erste: %2</translation>
    </message>
    <message>
        <source>the arithmetic %1</source>
        <translation>die Arithmetik %1</translation>
    </message>
    <message>
        <source>the fill rule %1</source>
        <translation>die Füllregel %1</translation>
    </message>
    <message>
        <source>what it knows of the variants</source>
        <translation>was es von den Varianten kennt</translation>
    </message>
    <message>
        <source>%1 %2. Changed to %3.</source>
        <translation>%1 %2. Geändert zu: %3.</translation>
    </message>
    <message>
        <source>, and </source>
        <translation>, und </translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>Only the first %L1 steps are recorded, into primitive %L2 of %L3: stepping and the panels end there. At the end the canvas shows the finished picture. To record the whole run, make the frame or the scene smaller.</source>
        <translation>Aufgezeichnet sind die ersten %L1 Schritte, bis in Primitiv %L2 von %L3: Die Schritte und die Bereiche enden dort. Am Ende zeigt die Zeichenfläche das fertige Bild. Mit kleinerer Bildfläche oder Szene wird der ganze Lauf aufgezeichnet.</translation>
    </message>
    <message>
        <source>Tracing was cancelled: the panels show the run before. Undo the change, or change the scene again to trace it.</source>
        <translation>Das Aufzeichnen wurde abgebrochen: Die Bereiche zeigen den Lauf davor. Rückgängig machen, oder die Szene noch einmal ändern, damit sie aufgezeichnet wird.</translation>
    </message>
    <message>
        <source>When finished: all pixels correct</source>
        <translation>Am Ende: alle Pixel richtig</translation>
    </message>
    <message>
        <source>as forced: %1</source>
        <translation>wie erzwungen: %1</translation>
    </message>
    <message>
        <source>When finished: %1 px wrong; the exact picture has %2 px</source>
        <translation>Am Ende: %1 px falsch; das exakte Bild hat %2 px</translation>
    </message>
</context>
<context>
    <name>pixelplumb::SceneDocument</name>
    <message numerus="yes">
        <source>%n waiting vertices dropped: “%1” draws another kind of primitive. Undo brings them back.</source>
        <translation>
            <numerusform>%n wartender Eckpunkt verworfen: „%1“ zeichnet eine andere Art von Primitiv. Rückgängig bringt ihn zurück.</numerusform>
            <numerusform>%n wartende Eckpunkte verworfen: „%1“ zeichnet eine andere Art von Primitiv. Rückgängig bringt sie zurück.</numerusform>
        </translation>
    </message>
    <message>
        <source>A vertex at (%1, %2) is too far away: coordinates must lie within ±2^30 px.</source>
        <translation>Ein Eckpunkt bei (%1, %2) ist zu weit weg: Koordinaten müssen innerhalb von ±2^30 px liegen.</translation>
    </message>
    <message>
        <source>place vertex</source>
        <translation>Eckpunkt setzen</translation>
    </message>
    <message>
        <source>move vertex</source>
        <translation>Eckpunkt bewegen</translation>
    </message>
    <message>
        <source>change colour</source>
        <translation>Farbe ändern</translation>
    </message>
    <message>
        <source>change drawing order</source>
        <translation>Zeichenreihenfolge ändern</translation>
    </message>
    <message>
        <source>add triangle</source>
        <translation>Dreieck hinzufügen</translation>
    </message>
    <message>
        <source>change triangle</source>
        <translation>Dreieck ändern</translation>
    </message>
    <message>
        <source>close polygon</source>
        <translation>Polygon schließen</translation>
    </message>
    <message>
        <source>change text</source>
        <translation>Text ändern</translation>
    </message>
    <message>
        <source>delete vertex</source>
        <translation>Eckpunkt löschen</translation>
    </message>
    <message>
        <source>discard vertices</source>
        <translation>Eckpunkte verwerfen</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>alles entfernen</translation>
    </message>
    <message>
        <source>A frame of %1 × %2 pixels cannot be made: each side must be 1 to %3 and the area at most %4.</source>
        <translation>Eine Bildfläche von %1 × %2 Pixeln ist nicht möglich: Jede Seite muss 1 bis %3 sein und die Fläche höchstens %4.</translation>
    </message>
    <message>
        <source>The frame&apos;s first pixel (%1, %2) lies beyond ±2^30 px.</source>
        <translation>Das erste Pixel der Bildfläche (%1, %2) liegt jenseits von ±2^30 px.</translation>
    </message>
    <message>
        <source>The off-screen point lies beyond ±2^30 px.</source>
        <translation>Der Punkt außerhalb liegt jenseits von ±2^30 px.</translation>
    </message>
    <message>
        <source>change frame</source>
        <translation>Bildfläche ändern</translation>
    </message>
    <message>
        <source>change appearance</source>
        <translation>Aussehen ändern</translation>
    </message>
    <message>
        <source>change motion</source>
        <translation>Bewegung ändern</translation>
    </message>
    <message>
        <source>end motion</source>
        <translation>Bewegung beenden</translation>
    </message>
    <message>
        <source>move off-screen point</source>
        <translation>Punkt außerhalb bewegen</translation>
    </message>
    <message>
        <source>change settings</source>
        <translation>Einstellungen ändern</translation>
    </message>
    <message>
        <source>There is no method “%1”.</source>
        <translation>Es gibt kein Verfahren „%1“.</translation>
    </message>
    <message>
        <source>change method</source>
        <translation>Verfahren ändern</translation>
    </message>
    <message>
        <source>delete primitive</source>
        <translation>Primitiv löschen</translation>
    </message>
    <message>
        <source>hide primitive</source>
        <translation>Primitiv ausblenden</translation>
    </message>
    <message>
        <source>show primitive</source>
        <translation>Primitiv einblenden</translation>
    </message>
    <message>
        <source>show all primitives</source>
        <translation>alle Primitive einblenden</translation>
    </message>
    <message>
        <source>change solid</source>
        <translation>Körper ändern</translation>
    </message>
    <message>
        <source>show solid</source>
        <translation>Körper einblenden</translation>
    </message>
    <message>
        <source>hide solid</source>
        <translation>Körper ausblenden</translation>
    </message>
    <message>
        <source>delete solid</source>
        <translation>Körper löschen</translation>
    </message>
    <message>
        <source>change form</source>
        <translation>Form ändern</translation>
    </message>
    <message>
        <source>With one sample a pixel, lines have stairs and differ from the truth, which is the nearest pixels: Effects ▸ exact area makes them even.</source>
        <translation>Mit einem Abtastpunkt je Pixel haben Linien Treppen und weichen von der Wahrheit ab, den nächsten Pixeln: Effekte ▸ genaue Fläche macht sie gleichmäßig.</translation>
    </message>
    <message>
        <source>change camera, light and materials</source>
        <translation>Kamera, Licht und Materialien ändern</translation>
    </message>
</context>
<context>
    <name>pixelplumb::SceneExports</name>
    <message>
        <source>there is not enough memory.</source>
        <translation>der Speicher reicht nicht.</translation>
    </message>
    <message>
        <source>another trace is still being written.</source>
        <translation>eine andere Aufzeichnung wird noch geschrieben.</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Schreiben von %1</translation>
    </message>
    <message>
        <source>%1 was not written.</source>
        <translation>%1 wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>Export the Picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>PNG-Bild</translation>
    </message>
    <message>
        <source>Export the Annotated Grid</source>
        <translation>Beschriftetes Gitter exportieren</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG-Zeichnung</translation>
    </message>
    <message>
        <source>Export the Columns</source>
        <translation>Spalten exportieren</translation>
    </message>
    <message>
        <source>Export the Pixels</source>
        <translation>Pixel exportieren</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>CSV-Tabelle</translation>
    </message>
    <message>
        <source>JSON</source>
        <translation>JSON</translation>
    </message>
    <message>
        <source>Export the Raster</source>
        <translation>Raster exportieren</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>The finished picture&apos;s raster is on the clipboard: %1 × %2, # is covered.</source>
        <translation>Das Raster des fertigen Bildes ist in der Zwischenablage: %1 × %2, # ist überdeckt.</translation>
    </message>
    <message numerus="yes">
        <source>%n more primitives leave it alone</source>
        <translation>
            <numerusform>%n weiteres Primitiv lässt es in Ruhe</numerusform>
            <numerusform>%n weitere Primitive lassen es in Ruhe</numerusform>
        </translation>
    </message>
    <message>
        <source>Pixel (%1, %2) is on the clipboard.</source>
        <translation>Pixel (%1, %2) ist in der Zwischenablage.</translation>
    </message>
    <message>
        <source>%1, finished (*.%2)</source>
        <translation>%1, fertig (*.%2)</translation>
    </message>
    <message>
        <source>%1, as drawn so far: step %2 of %3 (*.%4)</source>
        <translation>%1, wie bisher gezeichnet: Schritt %2 von %3 (*.%4)</translation>
    </message>
    <message>
        <source>it was read, and the export would replace it.</source>
        <translation>es wurde gelesen, und der Export würde es ersetzen.</translation>
    </message>
    <message>
        <source>Nothing is drawn yet.</source>
        <translation>Noch ist nichts gezeichnet.</translation>
    </message>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>%1 was not written: %2</source>
        <translation>%1 wurde nicht geschrieben: %2</translation>
    </message>
    <message>
        <source> It is of %1.</source>
        <translation> Es zeigt %1.</translation>
    </message>
    <message>
        <source>%1 is written: %2.</source>
        <translation>%1 ist geschrieben: %2.</translation>
    </message>
    <message>
        <source>Export the Rows</source>
        <translation>Zeilen exportieren</translation>
    </message>
    <message>
        <source>Export the Steps</source>
        <translation>Schritte exportieren</translation>
    </message>
    <message>
        <source>The finished picture&apos;s raster is copied when the run has come to its end (F5), or Predict is closed.</source>
        <translation>Das Raster des fertigen Bildes wird kopiert, wenn der Lauf am Ende ist (F5) oder Vorhersagen geschlossen wird.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::SceneFiles</name>
    <message>
        <source>The scene was not saved: %1 was read as something else, such as a texture, and would be replaced.</source>
        <translation>Die Szene wurde nicht gespeichert: %1 wurde als etwas anderes gelesen, etwa als Textur, und würde ersetzt.</translation>
    </message>
    <message>
        <source>Scenes (*.json *.pixelplumb);;All files (*)</source>
        <translation>Szenen (*.json *.pixelplumb);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Another program has written %1: File ▸ Revert to the file reads it again.</source>
        <translation>Ein anderes Programm hat %1 geschrieben: Datei ▸ Auf Datei zurücksetzen liest sie neu.</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>the scene does not fit into memory</source>
        <translation>die Szene passt nicht in den Speicher</translation>
    </message>
    <message>
        <source>Recovering the unsaved scene</source>
        <translation>Wiederherstellen der nicht gespeicherten Szene</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Öffnen von %1</translation>
    </message>
    <message>
        <source>Not opened: %1</source>
        <translation>Nicht geöffnet: %1</translation>
    </message>
    <message>
        <source>%1 was not opened: %2</source>
        <translation>%1 wurde nicht geöffnet: %2</translation>
    </message>
    <message>
        <source>Open a Scene</source>
        <translation>Szene öffnen</translation>
    </message>
    <message>
        <source>Save the Scene</source>
        <translation>Szene speichern</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Speichern von %1</translation>
    </message>
    <message>
        <source>the scene&apos;s text does not fit into memory</source>
        <translation>der Text der Szene passt nicht in den Speicher</translation>
    </message>
    <message>
        <source>The scene was not saved: %1</source>
        <translation>Die Szene wurde nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Speichert …</translation>
    </message>
    <message>
        <source>Go on working</source>
        <translation>Weiterarbeiten</translation>
    </message>
</context>
<context>
    <name>pixelplumb::SceneLook</name>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>The material&apos;s name, by which primitives name it</source>
        <translation>Der Name des Materials, mit dem Primitive es nennen</translation>
    </message>
    <message>
        <source>material %1</source>
        <translation>Material %1</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Eye (x, y, z)</source>
        <translation>Auge (x, y, z)</translation>
    </message>
    <message>
        <source>Looks at (x, y, z)</source>
        <translation>Blickt auf (x, y, z)</translation>
    </message>
    <message>
        <source>Upward (x, y, z)</source>
        <translation>Nach oben (x, y, z)</translation>
    </message>
    <message>
        <source>Field of view, degrees</source>
        <translation>Blickwinkel, Grad</translation>
    </message>
    <message>
        <source>Height of the view</source>
        <translation>Höhe des Ausschnitts</translation>
    </message>
    <message>
        <source>Near plane</source>
        <translation>Vordere Ebene</translation>
    </message>
    <message>
        <source>Far plane</source>
        <translation>Hintere Ebene</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Texture filter</source>
        <translation>Texturfilter</translation>
    </message>
    <message>
        <source>Beyond the texture&apos;s border</source>
        <translation>Jenseits des Texturrands</translation>
    </message>
    <message>
        <source>Diffuse colour</source>
        <translation>Diffuse Farbe</translation>
    </message>
    <message>
        <source>Specular colour</source>
        <translation>Glanzfarbe</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>Glanzexponent</translation>
    </message>
    <message>
        <source>Direction (x, y, z)</source>
        <translation>Richtung (x, y, z)</translation>
    </message>
    <message>
        <source>Position (x, y, z)</source>
        <translation>Ort (x, y, z)</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Ambient light</source>
        <translation>Umgebungslicht</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>Depth test</source>
        <translation>Tiefentest</translation>
    </message>
    <message>
        <source>Bits of depth</source>
        <translation>Bits der Tiefe</translation>
    </message>
    <message>
        <source>Samples per pixel</source>
        <translation>Abtastpunkte je Pixel</translation>
    </message>
    <message>
        <source>“%1” in a scene file</source>
        <translation>„%1“ in einer Szenendatei</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Lichter</translation>
    </message>
    <message>
        <source>Light %1</source>
        <translation>Licht %1</translation>
    </message>
</context>
<context>
    <name>pixelplumb::SceneTracer</name>
    <message>
        <source>The scene does not fit into memory: a frame of %1 × %2 pixels with %3. Make the frame or the triangles smaller.</source>
        <translation>Die Szene passt nicht in den Speicher: eine Bildfläche von %1 × %2 Pixeln mit %3. Eine kleinere Bildfläche oder kleinere Dreiecke passen eher.</translation>
    </message>
    <message numerus="yes">
        <source>%n triangles</source>
        <translation>
            <numerusform>%n Dreieck</numerusform>
            <numerusform>%n Dreiecken</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no method named “%1”.</source>
        <translation>Es gibt kein Verfahren namens „%1“.</translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation>Aufzeichnen</translation>
    </message>
</context>
<context>
    <name>pixelplumb::Scrubber</name>
    <message>
        <source>Position in the run</source>
        <translation>Ort im Lauf</translation>
    </message>
    <message>
        <source>step %1: %2</source>
        <translation>Schritt %1: %2</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>ties</source>
        <translation>Grenzfall</translation>
    </message>
    <message>
        <source>clamps</source>
        <translation>begrenzt</translation>
    </message>
    <message>
        <source>spans</source>
        <translation>Spannen</translation>
    </message>
    <message>
        <source>still ahead, predict it</source>
        <translation>liegt noch voraus, vorhersagen</translation>
    </message>
    <message>
        <source>first</source>
        <translation>erster</translation>
    </message>
    <message>
        <source>first: here is the first pixel that differs from the truth</source>
        <translation>erster: hier ist das erste Pixel, das von der Wahrheit abweicht</translation>
    </message>
</context>
<context>
    <name>pixelplumb::SegmentSliders</name>
    <message>
        <source>Segments around, or along s</source>
        <translation>Segmente ringsum, oder entlang s</translation>
    </message>
    <message>
        <source>Segments from pole to pole, or along t</source>
        <translation>Segmente von Pol zu Pol, oder entlang t</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>%1, at most %2 from the sphere</source>
        <translation>%1, höchstens %2 von der Kugel entfernt</translation>
    </message>
</context>
<context>
    <name>pixelplumb::SideView</name>
    <message>
        <source>The camera from the side</source>
        <translation>Die Kamera von der Seite</translation>
    </message>
    <message>
        <source>The eye, the near plane, the picture plane and the rays to the current face. Drag to turn, wheel to magnify, double click to put it back.</source>
        <translation>Das Auge, die vordere Ebene, die Bildebene und die Strahlen zur aktuellen Seitenfläche. Ziehen dreht, das Mausrad vergrößert, ein Doppelklick stellt die Ansicht zurück.</translation>
    </message>
    <message>
        <source>near plane</source>
        <translation>vordere Ebene</translation>
    </message>
    <message>
        <source>picture plane</source>
        <translation>Bildebene</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>Auge</translation>
    </message>
    <message>
        <source>eye (far away)</source>
        <translation>Auge (weit weg)</translation>
    </message>
</context>
<context>
    <name>pixelplumb::StageTree</name>
    <message>
        <source>The stages of the current face</source>
        <translation>Die Stufen der aktuellen Seitenfläche</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Benutzt</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>What the same code gives without rounding, from the numbers of the scene</source>
        <translation>Was derselbe Code ohne Rundung aus den Zahlen der Szene ergibt</translation>
    </message>
    <message>
        <source>Used − exact; at the lattice that is the snap&apos;s displacement</source>
        <translation>Benutzt − exakt; beim Koordinatengitter die Verschiebung durch das Einrasten</translation>
    </message>
</context>
<context>
    <name>pixelplumb::StatusFields</name>
    <message>
        <source>pixel (%1, %2) %3</source>
        <translation>Pixel (%1, %2) %3</translation>
    </message>
    <message>
        <source>column %1, second half</source>
        <translation>Spalte %1, zweite Hälfte</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>y upward</source>
        <translation>y nach oben</translation>
    </message>
    <message>
        <source>y downward</source>
        <translation>y nach unten</translation>
    </message>
    <message>
        <source>samples at ½</source>
        <translation>Abtastpunkte bei ½</translation>
    </message>
    <message>
        <source>recording cut at its limit</source>
        <translation>Aufzeichnung endete an ihrer Grenze</translation>
    </message>
    <message>
        <source>no pixel</source>
        <translation>kein Pixel</translation>
    </message>
    <message>
        <source>Wrong pixels of the finished picture</source>
        <translation>Falsche Pixel des fertigen Bilds</translation>
    </message>
    <message>
        <source>Submission: %1</source>
        <translation>Abgabe: %1</translation>
    </message>
    <message>
        <source>The method itself: %1</source>
        <translation>Das Verfahren selbst: %1</translation>
    </message>
    <message>
        <source>The method is proved to draw every pixel right.</source>
        <translation>Dass das Verfahren jedes Pixel richtig zeichnet, ist bewiesen.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::StepActions</name>
    <message>
        <source>Next &amp;column</source>
        <translation>Nächste &amp;Spalte</translation>
    </message>
    <message>
        <source>column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Go on to the next column, or first to the pixel that stepping back set out from</source>
        <translation>Weiter zur nächsten Spalte, oder erst zum Pixel, von dem es zurückging</translation>
    </message>
    <message>
        <source>Previous c&amp;olumn</source>
        <translation>V&amp;orige Spalte</translation>
    </message>
    <message>
        <source>Go back to where this column begins, to the previous one, or to the pixel that stepping on set out from</source>
        <translation>Zurück zum Beginn dieser oder zur vorigen Spalte, oder zum Pixel, von dem es weiterging</translation>
    </message>
    <message>
        <source>Next &amp;pixel</source>
        <translation>Nächstes &amp;Pixel</translation>
    </message>
    <message>
        <source>pixel</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Write the next pixel</source>
        <translation>Das nächste Pixel schreiben</translation>
    </message>
    <message>
        <source>Previous p&amp;ixel</source>
        <translation>Voriges Pi&amp;xel</translation>
    </message>
    <message>
        <source>Take back the last pixel</source>
        <translation>Das letzte Pixel zurücknehmen</translation>
    </message>
    <message>
        <source>Next pri&amp;mitive</source>
        <translation>Nächstes Pri&amp;mitiv</translation>
    </message>
    <message>
        <source>primitive</source>
        <translation>Primitiv</translation>
    </message>
    <message>
        <source>Go on to the next primitive&apos;s set-up</source>
        <translation>Weiter zur Vorbereitung des nächsten Primitivs</translation>
    </message>
    <message>
        <source>Previous p&amp;rimitive</source>
        <translation>Voriges Primiti&amp;v</translation>
    </message>
    <message>
        <source>Go back to the previous primitive&apos;s set-up</source>
        <translation>Zurück zur Vorbereitung des vorigen Primitivs</translation>
    </message>
    <message>
        <source>Run to the &amp;end</source>
        <translation>Zum &amp;Ende laufen</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Go on to the next breakpoint or the end</source>
        <translation>Weiter zum nächsten Haltepunkt oder zum Ende</translation>
    </message>
    <message>
        <source>Run back to the &amp;start</source>
        <translation>Zum An&amp;fang zurücklaufen</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Go back to the last breakpoint or the start</source>
        <translation>Zurück zum letzten Haltepunkt oder zum Anfang</translation>
    </message>
    <message>
        <source>Run to the picke&amp;d pixel</source>
        <translation>Zum gewählten Pixel &amp;laufen</translation>
    </message>
    <message>
        <source>Go on to the next step that writes the picked pixel</source>
        <translation>Weiter zum nächsten Schritt, der das gewählte Pixel schreibt</translation>
    </message>
    <message>
        <source>Run &amp;back to the picked pixel</source>
        <translation>Zum gewählten Pixel zurüc&amp;klaufen</translation>
    </message>
    <message>
        <source>Go back to the last step that writes the picked pixel</source>
        <translation>Zurück zum letzten Schritt, der das gewählte Pixel schreibt</translation>
    </message>
    <message>
        <source>Pla&amp;y</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>play</source>
        <translation>abspielen</translation>
    </message>
    <message>
        <source>Break&amp;point on the column</source>
        <translation>&amp;Haltepunkt auf der Spalte</translation>
    </message>
    <message>
        <source>Set or clear a breakpoint on the current column or row</source>
        <translation>Einen Haltepunkt auf der aktuellen Spalte oder Zeile setzen oder löschen</translation>
    </message>
    <message>
        <source>Breakpoint on the picked pi&amp;xel</source>
        <translation>Haltepunkt auf dem &amp;gewählten Pixel</translation>
    </message>
    <message>
        <source>Set or clear a breakpoint on the picked pixel</source>
        <translation>Einen Haltepunkt auf dem gewählten Pixel setzen oder löschen</translation>
    </message>
    <message>
        <source>C&amp;lear all breakpoints</source>
        <translation>Alle Haltepunkte lös&amp;chen</translation>
    </message>
    <message>
        <source>Clear all breakpoints</source>
        <translation>Alle Haltepunkte löschen</translation>
    </message>
    <message>
        <source>Playing and the scrubber&apos;s arrow keys go by this unit</source>
        <translation>Das Abspielen und die Pfeiltasten der Zeitleiste gehen nach dieser Einheit</translation>
    </message>
    <message>
        <source>by primitives</source>
        <translation>nach Primitiven</translation>
    </message>
    <message>
        <source>by columns</source>
        <translation>nach Spalten</translation>
    </message>
    <message>
        <source>by pixels</source>
        <translation>nach Pixeln</translation>
    </message>
    <message>
        <source>Next &amp;row</source>
        <translation>Nächste &amp;Zeile</translation>
    </message>
    <message>
        <source>Previous r&amp;ow</source>
        <translation>V&amp;orige Zeile</translation>
    </message>
    <message>
        <source>row</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Go on to the next row, or first to the pixel that stepping back set out from</source>
        <translation>Weiter zur nächsten Zeile, oder erst zum Pixel, von dem es zurückging</translation>
    </message>
    <message>
        <source>Go back to where this row begins, to the previous one, or to the pixel that stepping on set out from</source>
        <translation>Zurück zum Beginn dieser oder zur vorigen Zeile, oder zum Pixel, von dem es weiterging</translation>
    </message>
    <message>
        <source>Break&amp;point on the row</source>
        <translation>&amp;Haltepunkt auf der Zeile</translation>
    </message>
    <message>
        <source>by rows</source>
        <translation>nach Zeilen</translation>
    </message>
    <message>
        <source>Next &amp;step</source>
        <translation>Nächster &amp;Schritt</translation>
    </message>
    <message>
        <source>Previous st&amp;ep</source>
        <translation>V&amp;origer Schritt</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Go on to the method&apos;s next step</source>
        <translation>Weiter zum nächsten Schritt des Verfahrens</translation>
    </message>
    <message>
        <source>Go back to the method&apos;s previous step</source>
        <translation>Zurück zum vorigen Schritt des Verfahrens</translation>
    </message>
    <message>
        <source>Break&amp;point</source>
        <translation>&amp;Haltepunkt</translation>
    </message>
    <message>
        <source>by steps</source>
        <translation>nach Schritten</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pause (pla&amp;y)</source>
        <translation>Pause (&amp;abspielen)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Play by the chosen unit</source>
        <translation>Nach der gewählten Einheit abspielen</translation>
    </message>
</context>
<context>
    <name>pixelplumb::StepMenu</name>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Schritt</translation>
    </message>
    <message>
        <source>Play &amp;by</source>
        <translation>Abspielen &amp;nach</translation>
    </message>
    <message>
        <source>Next &amp;mark</source>
        <translation>Nächste Ma&amp;rke</translation>
    </message>
    <message>
        <source>Previous m&amp;ark</source>
        <translation>Vor&amp;ige Marke</translation>
    </message>
    <message>
        <source>&amp;Go to…</source>
        <translation>Gehe z&amp;u …</translation>
    </message>
</context>
<context>
    <name>pixelplumb::StepText</name>
    <message>
        <source>%1 %2 draws nothing</source>
        <translation>%1 %2 zeichnet nichts</translation>
    </message>
    <message>
        <source>%1 %2 set up</source>
        <translation>%1 %2 vorbereitet</translation>
    </message>
    <message>
        <source>nothing drawn yet</source>
        <translation>noch nichts gezeichnet</translation>
    </message>
    <message>
        <source>%1 entered</source>
        <translation>%1 betreten</translation>
    </message>
    <message>
        <source>pixel (%1, %2) written</source>
        <translation>Pixel (%1, %2) geschrieben</translation>
    </message>
    <message>
        <source>sample (%1, %2) refused</source>
        <translation>Abtastpunkt (%1, %2) abgewiesen</translation>
    </message>
    <message>
        <source>vertex: here is a corner of the primitive, or a part of it begins or ends</source>
        <translation>Eckpunkt: hier ist eine Ecke des Primitivs, oder ein Teil davon beginnt oder endet</translation>
    </message>
    <message>
        <source>tie: a sample here lies exactly on an edge, or a line half-way between two</source>
        <translation>Grenzfall: Ein Abtastpunkt liegt hier genau auf einer Kante oder eine Linie in der Mitte zwischen zweien</translation>
    </message>
    <message>
        <source>clamp: a colour level left 0 … 255</source>
        <translation>Begrenzung: Ein Farbwert verließ 0 … 255</translation>
    </message>
    <message>
        <source>first difference from the truth: pixel (%1, %2) is missing when the run ends</source>
        <translation>erste Abweichung von der Wahrheit: Pixel (%1, %2) fehlt am Ende des Laufs</translation>
    </message>
    <message>
        <source>first difference from the truth: pixel (%1, %2) is missing, and this step was the last that could have drawn it</source>
        <translation>erste Abweichung von der Wahrheit: Pixel (%1, %2) fehlt; dieser Schritt war der letzte, der es hätte zeichnen können</translation>
    </message>
    <message>
        <source>first difference from the truth: pixel (%1, %2) is extra</source>
        <translation>erste Abweichung von der Wahrheit: Pixel (%1, %2) ist überzählig</translation>
    </message>
    <message>
        <source>first difference from the truth: pixel (%1, %2) has another colour</source>
        <translation>erste Abweichung von der Wahrheit: Pixel (%1, %2) hat eine andere Farbe</translation>
    </message>
    <message>
        <source>before the first step</source>
        <translation>vor dem ersten Schritt</translation>
    </message>
</context>
<context>
    <name>pixelplumb::StepperBar</name>
    <message>
        <source>Stepper</source>
        <translation>Schrittablauf</translation>
    </message>
    <message>
        <source>play</source>
        <translation>abspielen</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Unit of playing</source>
        <translation>Einheit des Abspielens</translation>
    </message>
    <message>
        <source>Play by primitives, by columns (rows, steps) or by pixels</source>
        <translation>Nach Primitiven, Spalten (Zeilen, Schritten) oder Pixeln abspielen</translation>
    </message>
    <message>
        <source>Speed of playing, steps per second</source>
        <translation>Tempo des Abspielens, Schritte je Sekunde</translation>
    </message>
    <message>
        <source> /s</source>
        <translation> /s</translation>
    </message>
</context>
<context>
    <name>pixelplumb::StudentPicture</name>
    <message>
        <source>Reading the student&apos;s picture</source>
        <translation>Lesen des abgegebenen Bildes</translation>
    </message>
    <message>
        <source>Comparing with the student&apos;s picture</source>
        <translation>Vergleichen mit dem abgegebenen Bild</translation>
    </message>
    <message>
        <source>The method does not draw this scene.</source>
        <translation>Das Verfahren zeichnet diese Szene nicht.</translation>
    </message>
    <message>
        <source>The picture is %1 × %2 pixels%5, the scene&apos;s frame %3 × %4; use a picture of the frame&apos;s size, or make the frame the picture&apos;s size (Edit ▸ Frame).</source>
        <translation>Das Bild hat %1 × %2 Pixel%5, die Bildfläche der Szene %3 × %4; erwartet wird ein Bild dieser Größe, oder eine Bildfläche wie die des Bildes (Bearbeiten ▸ Bildfläche).</translation>
    </message>
    <message>
        <source>%1 does not fit into memory.</source>
        <translation>%1 passt nicht in den Speicher.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::StudentPictureFiles</name>
    <message>
        <source>Open a Student&apos;s Picture</source>
        <translation>Abgegebenes Bild öffnen</translation>
    </message>
    <message>
        <source>Pictures and rasters (*.png *.ppm *.pgm *.pbm *.bmp *.txt)</source>
        <translation>Bilder und Raster (*.png *.ppm *.pgm *.pbm *.bmp *.txt)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>Zwischenablage</translation>
    </message>
</context>
<context>
    <name>pixelplumb::SubmissionOpening</name>
    <message>
        <source>Being opened.</source>
        <translation>Wird geöffnet.</translation>
    </message>
    <message>
        <source>No picture: %1.</source>
        <translation>Kein Bild: %1.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::SubmissionPanel</name>
    <message>
        <source>Submission</source>
        <translation>Abgabe</translation>
    </message>
    <message>
        <source>The student&apos;s picture&apos;s file</source>
        <translation>Die Datei des abgegebenen Bildes</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Take the student&apos;s picture away; the scene stays as it is</source>
        <translation>Das abgegebene Bild wegnehmen; die Szene bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Pixels by cause</source>
        <translation>Pixel nach Ursachen</translation>
    </message>
    <message>
        <source>What explains the whole picture</source>
        <translation>Was das ganze Bild erklärt</translation>
    </message>
    <message>
        <source>Student</source>
        <translation>Abgabe</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Next difference</source>
        <translation>Nächste Abweichung</translation>
    </message>
    <message>
        <source>Pick the next pixel that differs, in reading order</source>
        <translation>Das nächste abweichende Pixel in Leserichtung wählen</translation>
    </message>
    <message>
        <source>The picked pixel</source>
        <translation>Das gewählte Pixel</translation>
    </message>
    <message>
        <source>No student&apos;s picture</source>
        <translation>Kein abgegebenes Bild</translation>
    </message>
    <message>
        <source>Being compared.</source>
        <translation>Wird verglichen.</translation>
    </message>
    <message numerus="yes">
        <source>%n pixels</source>
        <translation>
            <numerusform>%n Pixel</numerusform>
            <numerusform>%n Pixel</numerusform>
        </translation>
    </message>
    <message>
        <source>covered</source>
        <translation>überdeckt</translation>
    </message>
    <message>
        <source>not covered</source>
        <translation>nicht überdeckt</translation>
    </message>
    <message>
        <source>%L1 missing</source>
        <translation>%L1 fehlend</translation>
    </message>
    <message>
        <source>%L1 extra</source>
        <translation>%L1 überzählig</translation>
    </message>
    <message>
        <source>%L1 of another colour, by up to %2</source>
        <translation>%L1 in anderer Farbe, um bis zu %2</translation>
    </message>
    <message>
        <source>%L1 the same</source>
        <translation>%L1 gleich</translation>
    </message>
    <message numerus="yes">
        <source>Wrong: %n pixels differ.</source>
        <translation>
            <numerusform>Falsch: %n Pixel weicht ab.</numerusform>
            <numerusform>Falsch: %n Pixel weichen ab.</numerusform>
        </translation>
    </message>
    <message>
        <source>Right: no pixel differs.</source>
        <translation>Richtig: Kein Pixel weicht ab.</translation>
    </message>
    <message>
        <source>Its transparency is ignored; its colours count.</source>
        <translation>Durchsichtigkeit bleibt außer Betracht; die Farben zählen.</translation>
    </message>
    <message>
        <source>The whole picture: %1. That explains every pixel.</source>
        <translation>Das ganze Bild: %1. Das erklärt jedes Pixel.</translation>
    </message>
    <message>
        <source>The whole picture: %1. That leaves %2.</source>
        <translation>Das ganze Bild: %1. Das lässt %2 übrig.</translation>
    </message>
    <message>
        <source>(%1, %2) student: %3, expected: %4</source>
        <translation>(%1, %2) abgegeben: %3, erwartet: %4</translation>
    </message>
    <message>
        <source>Leeway</source>
        <translation>Spielraum</translation>
    </message>
    <message>
        <source>Open a student&apos;s picture: PNG, PPM, BMP, or a raster of “#” and “.”</source>
        <translation>Ein abgegebenes Bild öffnen: PNG, PPM, BMP oder ein Raster aus „#“ und „.“</translation>
    </message>
    <message>
        <source>Drop a picture of this scene on the canvas, paste it (Ctrl+V) or open it: PNG, PPM, BMP, or a raster of “#” and “.”. What differs is marked on the canvas.</source>
        <translation>Ein Bild dieser Szene auf die Zeichenfläche ziehen, einfügen (Strg+V) oder öffnen: PNG, PPM, BMP oder ein Raster aus „#“ und „.“. Was abweicht, wird auf der Zeichenfläche markiert.</translation>
    </message>
    <message>
        <source>%L1 undecidable: on an edge or within rounding error</source>
        <translation>%L1 unentscheidbar: auf einer Kante oder innerhalb des Rundungsfehlers</translation>
    </message>
    <message numerus="yes">
        <source>Right within the leeway: %n pixels differ as a right program&apos;s may.</source>
        <translation>
            <numerusform>Richtig innerhalb des Spielraums: %n Pixel weicht ab, wie es ein richtiges Programm darf.</numerusform>
            <numerusform>Richtig innerhalb des Spielraums: %n Pixel weichen ab, wie es ein richtiges Programm darf.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pixelplumb::SubmissionView</name>
    <message>
        <source>The student&apos;s picture</source>
        <translation>Das abgegebene Bild</translation>
    </message>
    <message>
        <source>The expected picture</source>
        <translation>Das erwartete Bild</translation>
    </message>
    <message>
        <source>The student&apos;s picture. A click picks the pixel.</source>
        <translation>Das abgegebene Bild. Ein Klick wählt das Pixel.</translation>
    </message>
    <message>
        <source>What the method draws. A click picks the pixel.</source>
        <translation>Was das Verfahren zeichnet. Ein Klick wählt das Pixel.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::SurfacesPanel</name>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>Fehler %1</translation>
    </message>
    <message>
        <source>no such number here</source>
        <translation>hier keine solche Zahl</translation>
    </message>
    <message>
        <source>an example: the scene has none</source>
        <translation>ein Beispiel: Die Szene hat keine</translation>
    </message>
    <message>
        <source>The parameter s, 0 … 1</source>
        <translation>Der Parameter s, 0 … 1</translation>
    </message>
    <message>
        <source>The parameter t of a surface, 0 … 1</source>
        <translation>Der Parameter t einer Fläche, 0 … 1</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Forms of curves and surfaces</source>
        <translation>Formen von Kurven und Flächen</translation>
    </message>
    <message>
        <source>s = %1, t = %2</source>
        <translation>s = %1, t = %2</translation>
    </message>
    <message>
        <source>Explicit</source>
        <translation>Explizit</translation>
    </message>
    <message>
        <source>Parametric</source>
        <translation>Parametrisch</translation>
    </message>
    <message>
        <source>Implicit</source>
        <translation>Implizit</translation>
    </message>
</context>
<context>
    <name>pixelplumb::SvgExport</name>
    <message>
        <source>There is nothing drawn yet to export.</source>
        <translation>Noch ist nichts gezeichnet, das exportiert werden könnte.</translation>
    </message>
    <message>
        <source>A frame of %1 × %2 pixels is too large for a figure of cells, which holds at most %3 of them. Export a PNG, or make the frame smaller.</source>
        <translation>Eine Bildfläche von %1 × %2 Pixeln ist zu groß für eine Abbildung aus Zellen, die höchstens %3 davon hat. Als PNG exportieren oder die Bildfläche verkleinern.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::TriangleDialog</name>
    <message>
        <source>Add a Triangle</source>
        <translation>Dreieck hinzufügen</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>vertex %1, %2</source>
        <translation>Eckpunkt %1, %2</translation>
    </message>
    <message>
        <source>more than 0</source>
        <translation>mehr als 0</translation>
    </message>
    <message>
        <source>vertex %1, x</source>
        <translation>Eckpunkt %1, x</translation>
    </message>
    <message>
        <source>vertex %1, y</source>
        <translation>Eckpunkt %1, y</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>a normal of length 0 beside others</source>
        <translation>eine Normale der Länge 0 neben anderen</translation>
    </message>
    <message>
        <source>three normals, or none</source>
        <translation>drei Normalen, oder keine</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>Eckpunkt %1</translation>
    </message>
    <message>
        <source>26, 26.5 or 53/2</source>
        <translation>26, 26.5 oder 53/2</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>Farbe von %1</translation>
    </message>
    <message>
        <source>&amp;Depth, texture and normals</source>
        <translation>&amp;Tiefe, Textur und Normalen</translation>
    </message>
</context>
<context>
    <name>pixelplumb::UnsavedChanges</name>
    <message>
        <source>Unsaved Changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>„%1“ hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation>Ohne Speichern gehen sie verloren.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::ViewMenu</name>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Gitter</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Lines between the pixels (G)</source>
        <translation>Linien zwischen den Pixeln (G)</translation>
    </message>
    <message>
        <source>T&amp;ruth</source>
        <translation>&amp;Wahrheit</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>wahr</translation>
    </message>
    <message>
        <source>The exact finished picture instead of the frame (R)</source>
        <translation>Das exakte fertige Bild anstelle des aktuellen (R)</translation>
    </message>
    <message>
        <source>&amp;Differences</source>
        <translation>&amp;Differenzen</translation>
    </message>
    <message>
        <source>differences</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Mark pixels that differ from the truth, or in the student&apos;s picture: ? missing, ! extra, c colour (D)</source>
        <translation>Pixel markieren, die von der Wahrheit abweichen, oder im abgegebenen Bild: ? fehlend, ! überzählig, c Farbe (D)</translation>
    </message>
    <message>
        <source>&amp;Clipped polygon</source>
        <translation>Be&amp;schnittenes Polygon</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>beschnitten</translation>
    </message>
    <message>
        <source>The current triangle&apos;s face as clipped by the near plane, and the triangles that it is drawn as (N)</source>
        <translation>Was die vordere Ebene von der Seitenfläche des aktuellen Dreiecks übrig lässt, und die Dreiecke, als die es gezeichnet wird (N)</translation>
    </message>
    <message>
        <source>Values in &amp;hexadecimal</source>
        <translation>Werte &amp;hexadezimal</translation>
    </message>
    <message>
        <source>hexadecimal</source>
        <translation>hexadezimal</translation>
    </message>
    <message>
        <source>The bytes in large cells and in the pixel grid as 00 … ff instead of 0 … 255 (X)</source>
        <translation>Die Bytes in großen Zellen und im Pixelraster als 00 … ff statt 0 … 255 (X)</translation>
    </message>
    <message>
        <source>&amp;Overdraw and gaps</source>
        <translation>&amp;Mehrfachzeichnung und Lücken</translation>
    </message>
    <message>
        <source>How often each pixel is written, and the gaps that are never written (O)</source>
        <translation>Wie oft jedes Pixel geschrieben ist, und die Lücken, die niemand schreibt (O)</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>V&amp;ergrößern</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ve&amp;rkleinern</translation>
    </message>
    <message>
        <source>&amp;Fit the frame</source>
        <translation>Bildfläche ein&amp;passen</translation>
    </message>
    <message>
        <source>One &amp;to one</source>
        <translation>E&amp;ins zu eins</translation>
    </message>
    <message>
        <source>In&amp;spector (pixel grid)</source>
        <translation>&amp;Lupe (Pixelraster)</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Berei&amp;che</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>as the &amp;desktop</source>
        <translation>wie der &amp;Desktop</translation>
    </message>
    <message>
        <source>&amp;light</source>
        <translation>&amp;hell</translation>
    </message>
    <message>
        <source>d&amp;ark</source>
        <translation>d&amp;unkel</translation>
    </message>
    <message>
        <source>&amp;Workspace</source>
        <translation>&amp;Arbeitsbereich</translation>
    </message>
    <message>
        <source>Step through a run, with all its numbers</source>
        <translation>Einen Lauf Schritt für Schritt verfolgen, mit allen seinen Zahlen</translation>
    </message>
    <message>
        <source>Compare methods with each other and the truth</source>
        <translation>Verfahren miteinander und mit der Wahrheit vergleichen</translation>
    </message>
    <message>
        <source>Measure what accuracy costs</source>
        <translation>Messen, was Genauigkeit kostet</translation>
    </message>
    <message>
        <source>Grade students&apos; pictures</source>
        <translation>Abgegebene Bilder bewerten</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;Reset this workspace</source>
        <translation>Diesen Arbeitsbereich zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>Nothing to show: the scene has no solid, so the near plane clips nothing.</source>
        <translation>Nichts zu zeigen: Die Szene hat keinen Körper, also schneidet die nahe Ebene nichts ab.</translation>
    </message>
    <message>
        <source>Stude&amp;nt&apos;s picture</source>
        <translation>Eingereichtes &amp;Bild</translation>
    </message>
    <message>
        <source>student</source>
        <translation>Abgabe</translation>
    </message>
    <message>
        <source>The student&apos;s picture instead of the frame; while Shift is held, the expected one (S)</source>
        <translation>Das eingereichte Bild statt der Bildfläche; solange Umschalt gehalten wird, das erwartete (S)</translation>
    </message>
</context>
<context>
    <name>pixelplumb::WhatsThis</name>
    <message>
        <source>The frame as it is at the current step, with its triangles and the plumb line through the current column or row. With the tool Draw a click places a vertex and a drag moves one, with Inspect a click picks the pixel; a right click always picks. Arrows move the picked pixel, the wheel zooms, Shift shows the truth as long as it is held.</source>
        <translation>Die Bildfläche beim aktuellen Schritt, mit ihren Dreiecken und der Lotlinie durch die aktuelle Spalte oder Zeile. Mit dem Werkzeug Zeichnen setzt ein Klick einen Eckpunkt und Ziehen bewegt einen, mit Prüfen wählt ein Klick das Pixel; ein Rechtsklick wählt immer. Pfeiltasten bewegen das gewählte Pixel, das Mausrad vergrößert, Umschalt zeigt die Wahrheit, solange es gehalten wird.</translation>
    </message>
    <message>
        <source>The method that draws the scene. The buttons, the table and the formulas follow it; the menu Method shows the keys that choose one on the canvas.</source>
        <translation>Das Verfahren, das die Szene zeichnet. Die Knöpfe, die Tabelle und die Formeln folgen ihm; das Menü Verfahren zeigt die Tasten, die auf der Zeichenfläche eines wählen.</translation>
    </message>
    <message>
        <source>How many of the run&apos;s steps are done. A step writes a pixel, begins a column or row, or sets a primitive up; Step ▸ Go to… goes to any.</source>
        <translation>Wie viele Schritte des Laufs getan sind. Ein Schritt schreibt ein Pixel, beginnt eine Spalte oder Zeile oder bereitet ein Primitiv vor; Schritt ▸ Gehe zu … geht zu jedem.</translation>
    </message>
    <message>
        <source>The pixel under the pointer, else the picked one, and its colour.</source>
        <translation>Das Pixel unter dem Zeiger, sonst das gewählte, und seine Farbe.</translation>
    </message>
    <message>
        <source>The column, row or step of the current method.</source>
        <translation>Die Spalte, die Zeile oder der Schritt des aktuellen Verfahrens.</translation>
    </message>
    <message>
        <source>The arithmetic, the fill rule and the frame&apos;s convention that the scene is drawn by.</source>
        <translation>Die Arithmetik, die Füllregel und die Konvention der Bildfläche, nach denen die Szene gezeichnet wird.</translation>
    </message>
    <message>
        <source>The current step as formulas with its numbers put in: what the drawing used, beside the exact value. The entries of the menu Step go on and back by a column or row, or by a pixel.</source>
        <translation>Der aktuelle Schritt als Formeln mit eingesetzten Zahlen: was das Zeichnen benutzt hat, neben dem exakten Wert. Die Einträge des Menüs Schritt gehen um eine Spalte oder Zeile oder um ein Pixel vor und zurück.</translation>
    </message>
    <message>
        <source>The pixels around the picked one, large enough to read: their bytes, their sample points, the true edges, and where the current column or row meets them. Arrows move the picked pixel, + and − make the cells larger and smaller, Enter goes to the step that wrote it.</source>
        <translation>Die Pixel um das gewählte, groß genug zum Lesen: ihre Bytes, ihre Abtastpunkte, die wahren Kanten, und wo die aktuelle Spalte oder Zeile sie trifft. Pfeiltasten bewegen das gewählte Pixel, + und − machen die Zellen größer und kleiner, die Eingabetaste geht zum Schritt, der es schrieb.</translation>
    </message>
    <message>
        <source>How the picked pixel got its colour: each primitive that tried, with its numbers, or the edge that refuses the pixel and by how much. Enter on a line goes to that step.</source>
        <translation>Wie das gewählte Pixel zu seiner Farbe kam: jedes Primitiv, das es versuchte, mit seinen Zahlen, oder die Kante, die das Pixel abweist, und um wie viel. Die Eingabetaste auf einer Zeile geht zu jenem Schritt.</translation>
    </message>
    <message>
        <source>The numbers of every column (with other methods, every row or step), as the drawing used them; exact ones can be shown next to them. A click on a row goes to it.</source>
        <translation>Die Zahlen jeder Spalte, oder jeder Zeile oder jedes Schritts anderer Verfahren, wie das Zeichnen sie benutzt hat; exakte lassen sich daneben zeigen. Ein Klick auf eine Zeile geht dorthin.</translation>
    </message>
    <message>
        <source>Two to four methods, or the truth, draw the scene side by side, and a map shows where they agree; the text below says why the picked pixel differs. Arrows move the picked pixel, + and − zoom all of them.</source>
        <translation>Zwei bis vier Verfahren, oder die Wahrheit, zeichnen die Szene nebeneinander, und eine Karte zeigt, wo sie übereinstimmen; darunter steht, warum das gewählte Pixel abweicht. Pfeiltasten bewegen das gewählte Pixel, + und − vergrößern und verkleinern alle.</translation>
    </message>
    <message>
        <source>How far the bounds that each arithmetic computes are from the exact edges of the current triangle, column by column.</source>
        <translation>Wie weit die Grenzen, die jede Arithmetik berechnet, von den exakten Kanten des aktuellen Dreiecks liegen, Spalte für Spalte.</translation>
    </message>
    <message>
        <source>The gallery of hard cases by family, each drawn by the current method beside the truth, and whether the method is right. Its buttons open a case in the window.</source>
        <translation>Die Sammlung schwieriger Fälle nach Familien, jeder mit dem aktuellen Verfahren neben der Wahrheit gezeichnet, und ob das Verfahren recht hat. Ihre Knöpfe öffnen einen Fall im Fenster.</translation>
    </message>
    <message>
        <source>What drawing the scene takes by the plain and by the fast kernels, which of them took which triangles and why, and what columns and rows ask of the cache.</source>
        <translation>Was das Zeichnen der Szene mit den einfachen und den schnellen Kernen braucht, welche davon welche Dreiecke nahmen und warum, und was Spalten und Zeilen vom Cache verlangen.</translation>
    </message>
    <message>
        <source>How many divisions, roundings, additions and other operations a set-up, a span and a sample take in the current method and arithmetic.</source>
        <translation>Wie viele Divisionen, Rundungen, Additionen und andere Operationen eine Vorbereitung, eine Spanne und ein Abtastpunkt im aktuellen Verfahren und in der aktuellen Arithmetik brauchen.</translation>
    </message>
    <message>
        <source>What accuracy costs in time: Run judges and times every method in every arithmetic, and the chart shows cost against error. Arrows go from dot to dot, Enter opens the dot&apos;s first wrong pixel.</source>
        <translation>Was Genauigkeit an Zeit kostet: Messen beurteilt und misst jedes Verfahren in jeder Arithmetik, und das Diagramm zeigt Kosten gegen Fehler. Pfeiltasten gehen von Punkt zu Punkt, die Eingabetaste öffnet das erste falsche Pixel des Punkts.</translation>
    </message>
    <message>
        <source>How the current triangle came from three dimensions to the frame: the camera from the side, and every stage with its numbers. Arrows turn the view, + and − bring it nearer and farther, Home brings the first view back.</source>
        <translation>Wie das aktuelle Dreieck aus drei Dimensionen auf die Bildfläche kam: die Kamera von der Seite, und jede Stufe mit ihren Zahlen. Pfeiltasten drehen die Ansicht, + und − holen sie näher und schieben sie fort, Pos1 bringt die erste zurück.</translation>
    </message>
    <message>
        <source>Which effects the scene calls for, why, and what each costs. Only what is called for runs; a switch forces an effect on or off in the picture.</source>
        <translation>Welche Effekte die Szene fordert, warum, und was jeder kostet. Nur was gefordert ist, läuft; ein Schalter erzwingt einen Effekt im Bild oder schaltet ihn aus.</translation>
    </message>
    <message>
        <source>The current method: what it does, where it comes from, and its pseudocode, with the lines that the current step does marked.</source>
        <translation>Das aktuelle Verfahren: was es tut, woher es kommt, und sein Pseudocode; die Zeilen, die der aktuelle Schritt ausführt, sind markiert.</translation>
    </message>
    <message>
        <source>How a student&apos;s picture, dropped on the window or pasted, differs from the expected one, by cause, with both pictures; Name the bug looks for known defects that draw it.</source>
        <translation>Was an einem abgegebenen Bild, auf das Fenster gezogen oder eingefügt, anders ist, nach Ursachen, mit beiden Bildern; Fehler benennen sucht bekannte Defekte, die es zeichnen.</translation>
    </message>
    <message>
        <source>The submissions of a graded folder, by cause, with what each student is told. J and K go to the next and the previous one, A accepts its grade, C comments on it.</source>
        <translation>Die Abgaben eines bewerteten Ordners, nach Ursachen, mit dem, was jede erfährt. J und K gehen zur nächsten und zur vorigen, A nimmt ihre Bewertung an, C kommentiert sie.</translation>
    </message>
    <message>
        <source>Opens, saves and exports scenes, and shows the examples.</source>
        <translation>Öffnet, speichert und exportiert Szenen und zeigt die Beispiele.</translation>
    </message>
    <message>
        <source>Changes the scene, and takes back what was changed; chooses what a click on the canvas does.</source>
        <translation>Ändert die Szene und nimmt zurück, was geändert wurde; wählt, was ein Klick auf die Zeichenfläche tut.</translation>
    </message>
    <message>
        <source>Lays the figures of the course texts over the scene, at the current step.</source>
        <translation>Legt die Abbildungen der Kurstexte über die Szene, beim aktuellen Schritt.</translation>
    </message>
    <message>
        <source>Goes through the run of the scene, forward and back.</source>
        <translation>Geht durch den Lauf der Szene, vor und zurück.</translation>
    </message>
    <message>
        <source>Timeline of the steps, lined up with the picture, with marks at vertices, ties and clamps and at the first wrong pixel. A drag goes to another step. Arrows go by the unit of playing, with Ctrl from mark to mark, PageUp and PageDown by columns or rows, Home and End to the ends.</source>
        <translation>Der Lauf auf einer Linie, mit Marken, wo Eckpunkte, Grenzfälle und Begrenzungen sind und wo das erste Pixel falsch ist; Spalten stehen in jeder Vergrößerung unter denen der Zeichenfläche. Ziehen geht zu einem anderen Schritt. Pfeile gehen in der Einheit des Abspielens, mit Strg von Marke zu Marke, Bild auf und Bild ab um Spalten oder Zeilen, Pos1 und Ende an die Enden.</translation>
    </message>
    <message>
        <source>Lets the scene move by a fraction of a pixel a frame, and counts the pixels that flicker beside those of the truth. The frame of its slider is what the canvas shows and what is stepped through.</source>
        <translation>Lässt die Szene sich je Bild um einen Bruchteil eines Pixels bewegen und zählt die Pixel, die flimmern, neben denen der Wahrheit. Das Bild des Reglers ist das, das die Zeichenfläche zeigt und das in Schritten gezeichnet wird.</translation>
    </message>
    <message>
        <source>Asks for what comes next (y_B, the rows, the increments or the next pixel) before it is shown, and says whether the answer is right, and why. Enter checks what is typed, a number or the pixel&apos;s x, y, and goes on. While this panel is open, the others hide the truth and what lies ahead.</source>
        <translation>Fragt nach dem, was folgt (y_B, die Zeilen, die Inkremente oder das nächste Pixel), bevor es gezeigt wird, und sagt mit dem Grund, was richtig und was falsch ist. Die Eingabetaste prüft, was eingegeben ist, eine Zahl oder x, y des Pixels, und geht weiter. Solange dieser Bereich offen ist, verbergen die anderen, was voraus liegt, und die Wahrheit.</translation>
    </message>
    <message>
        <source>What is drawn over the frame, how large, in which colours, and which workspace and panels are shown.</source>
        <translation>Was über die Bildfläche gezeichnet wird, wie groß, in welchen Farben, und welcher Arbeitsbereich mit welchen Bereichen gezeigt wird.</translation>
    </message>
    <message>
        <source>The scene&apos;s primitives in drawing order. The box before a name shows or hides the primitive, coordinates and colours are typed in place, and the buttons below, which a right click shows as a menu, move, recolour and delete it.</source>
        <translation>Die Primitive der Szene in Zeichenreihenfolge. Das Kästchen vor einem Namen blendet das Primitiv ein oder aus, Koordinaten und Farben werden an Ort und Stelle getippt, und die Knöpfe darunter, die ein Rechtsklick als Menü zeigt, verschieben, färben und löschen es.</translation>
    </message>
    <message>
        <source>The manual, all keys, and what the parts of the window are.</source>
        <translation>Das Handbuch, alle Tasten, und was die Teile des Fensters sind.</translation>
    </message>
    <message>
        <source>The method that draws the scene, and its printed variants with their faults.</source>
        <translation>Das Verfahren, das die Szene zeichnet, und seine gedruckten Varianten mit ihren Fehlern.</translation>
    </message>
</context>
<context>
    <name>pixelplumb::WindowDocks</name>
    <message>
        <source>Formula</source>
        <translation>Formel</translation>
    </message>
    <message>
        <source>Pixel grid</source>
        <translation>Pixelraster</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Hard cases</source>
        <translation>Schwierige Fälle</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Operationen</translation>
    </message>
    <message>
        <source>Accuracy lab</source>
        <translation>Genauigkeitslabor</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>This method</source>
        <translation>Dieses Verfahren</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>Vorhersagen</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Primitives</source>
        <translation>Primitive</translation>
    </message>
    <message>
        <source>Submission</source>
        <translation>Abgabe</translation>
    </message>
    <message>
        <source>Grading</source>
        <translation>Bewertung</translation>
    </message>
</context>
<context>
    <name>pixelplumb::WindowStatusBar</name>
    <message>
        <source>Progress of opening</source>
        <translation>Fortschritt des Öffnens</translation>
    </message>
    <message>
        <source>Cancel opening</source>
        <translation>Öffnen abbrechen</translation>
    </message>
    <message>
        <source>Progress of saving</source>
        <translation>Fortschritt des Speicherns</translation>
    </message>
    <message>
        <source>Progress of exporting</source>
        <translation>Fortschritt des Exportierens</translation>
    </message>
    <message>
        <source>Cancel exporting</source>
        <translation>Exportieren abbrechen</translation>
    </message>
    <message>
        <source>Progress of tracing</source>
        <translation>Fortschritt der Aufzeichnung</translation>
    </message>
    <message>
        <source>Cancel tracing</source>
        <translation>Aufzeichnung abbrechen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>pixelplumb::WorkspaceRow</name>
    <message>
        <source>Workspaces</source>
        <translation>Arbeitsbereiche</translation>
    </message>
</context>
<context>
    <name>pixelplumb::Workspaces</name>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Schritte</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleich</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messung</translation>
    </message>
    <message>
        <source>&amp;Grade</source>
        <translation>&amp;Bewertung</translation>
    </message>
</context>
</TS>
