package robotran.ui.poster

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
        with(page.sheet) { SheetSvg(poster.world, poster.session).writeInto(svg, left, top, width, height) }
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
        for (line in page.lines) svg.line(line)
    }
    return svg.toString()
}

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
