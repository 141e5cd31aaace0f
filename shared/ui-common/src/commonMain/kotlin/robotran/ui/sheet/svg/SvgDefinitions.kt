package robotran.ui.sheet.svg

import robotran.ui.sheet.SheetColours
import robotran.world.Paper

/** Writes the patterns and clip paths that other elements refer to. */
internal class SvgDefinitions(private val svg: SvgWriter) {
    /** The `defs` element for [paper]. */
    fun write(paper: Paper) = svg.element("defs") {
        svg.element("clipPath", "id" to "paper") {
            svg.element("rect", "width" to paper.width, "height" to paper.height)
        }
        pattern("hatching", HATCHING_STEP, "rotate(45)") {
            svg.element(
                "rect",
                "width" to HATCHING_STEP / 3,
                "height" to HATCHING_STEP,
                "fill" to hex(SheetColours.WALL_HATCHING),
            )
        }
        pattern("dots", DOT_STEP, null) {
            svg.element(
                "circle",
                "cx" to DOT_STEP / 2,
                "cy" to DOT_STEP / 2,
                "r" to DOT_SIZE / 2,
                "fill" to hex(SheetColours.MARK_DOTS),
                "fill-opacity" to SheetColours.MARK_DOTS.alpha,
            )
        }
        pattern("grain", GRAIN_STEP, null) {
            svg.element("rect", "width" to GRAIN_STEP, "height" to GRAIN_WIDTH, "fill" to hex(SheetColours.BLOCK_GRAIN))
        }
        svg.element("radialGradient", "id" to "glow") {
            for ((place, colour, strength) in GLOW) {
                svg.element(
                    "stop",
                    "offset" to place,
                    "stop-color" to hex(colour),
                    "stop-opacity" to strength,
                )
            }
        }
    }

    private fun pattern(name: String, step: Double, transform: String?, content: () -> Unit) = svg.element(
        "pattern",
        "id" to name,
        "width" to step,
        "height" to step,
        "patternUnits" to "userSpaceOnUse",
        "patternTransform" to transform,
        content = content,
    )

    private companion object {
        const val HATCHING_STEP = 0.5
        const val GRAIN_STEP = 1.2
        val GLOW = listOf(
            Triple(0.0, SheetColours.LAMP_CORE, 0.95),
            Triple(0.07, SheetColours.LAMP_CORE, 0.7),
            Triple(0.2, SheetColours.LAMP, 0.36),
            Triple(0.5, SheetColours.LAMP, 0.14),
            Triple(1.0, SheetColours.LAMP, 0.0),
        )
    }
}
