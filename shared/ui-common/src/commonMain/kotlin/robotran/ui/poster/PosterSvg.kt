package robotran.ui.poster

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import robotran.ui.sheet.svg.SheetSvg
import robotran.ui.sheet.svg.SvgWriter
import robotran.ui.sheet.svg.figure
import robotran.ui.sheet.svg.hex
import robotran.uikit.*
import robotran.workshop.state.Poster

/** [poster] as SVG text, the same on every platform; a unit is a millimetre. */
fun posterSvg(poster: Poster): String {
    val page = layPoster(poster)
    val svg = SvgWriter()
    svg.element(
        "svg",
        "xmlns" to "http://www.w3.org/2000/svg",
        "viewBox" to "0 0 ${figure(page.width)} ${figure(page.height)}",
        "width" to "${figure(page.width)}mm",
        "height" to "${figure(page.height)}mm",
    ) {
        svg.textElement("title", poster.title)
        svg.element("rect", "width" to page.width, "height" to page.height, "fill" to "#ffffff")
        SheetSvg(poster.world, poster.session).writeInto(svg, page.crop.rect(), page.sheet.rect())
        svg.element(
            "rect",
            "x" to page.sheet.left,
            "y" to page.sheet.top,
            "width" to page.sheet.width,
            "height" to page.sheet.height,
            "fill" to "none",
            "stroke" to hex(RobotranColours.LIGHT.line),
            "stroke-width" to EDGE,
        )
        for (box in page.boxes) svg.box(box)
        for (line in page.lines) svg.line(line)
    }
    return svg.toString()
}

private fun PosterArea.rect(): Rect {
    val corner = Offset(left.toFloat(), top.toFloat())
    return Rect(corner, Size(width.toFloat(), height.toFloat()))
}

private fun SvgWriter.box(box: PosterBox) = element(
    "rect",
    "x" to box.area.left,
    "y" to box.area.top,
    "width" to box.area.width,
    "height" to box.area.height,
    "rx" to box.corner.takeIf { it > 0 },
    "fill" to hex(box.fill),
    "stroke" to box.edge?.let(::hex),
    "stroke-width" to EDGE.takeIf { box.edge != null },
)

private fun SvgWriter.line(line: PosterLine) = runs(
    "text",
    line.runs.map { run -> run.words.replace(' ', NO_BREAK_SPACE) to listOf("fill" to hex(run.colour)) },
    "x" to line.left,
    "y" to line.baseline,
    "font-size" to line.size,
    "font-family" to if (line.isCode) CODE_FONTS else "sans-serif",
    "font-weight" to "bold".takeIf { line.isBold },
)

/** Programs that draw SVG drop several blanks, and those at the beginning. */
private const val NO_BREAK_SPACE = '\u00A0'

/** Fonts whose letters all have the width that the layout counts with. */
private const val CODE_FONTS = "'JetBrains Mono', 'DejaVu Sans Mono', Menlo, 'Courier New', monospace"

/** Millimetres. */
internal const val EDGE = 0.3
