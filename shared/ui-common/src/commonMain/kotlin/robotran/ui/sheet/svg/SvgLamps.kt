package robotran.ui.sheet.svg

import robotran.simulation.state.LampState
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.bulbColour
import robotran.world.Lamp
import robotran.world.geometry.Point
import kotlin.math.PI
import kotlin.math.sqrt

/** Writes lamps and their light. */
internal class SvgLamps(private val svg: SvgWriter, private val shapes: SvgShapes) {
    /** Without shadows, which only the screen shows. */
    fun glow(point: Point, brightness: Double, direction: Double, cone: Double) {
        if (brightness <= 0) return
        val reach = REACH * sqrt(brightness)
        val y = shapes.down(point.y)
        if (cone >= Lamp.ALL_ROUND) {
            svg.element("circle", "cx" to point.x, "cy" to y, "r" to reach, "fill" to "url(#glow)")
            return
        }
        // An arc of radius r/2 with line width r fills a sector, without trigonometry.
        val round = PI * reach
        val highlighted = round * cone / Lamp.ALL_ROUND
        svg.element(
            "circle",
            "cx" to point.x,
            "cy" to y,
            "r" to reach / 2,
            "fill" to "none",
            "stroke" to hex(SheetColours.LAMP),
            "stroke-opacity" to CONE_OPACITY,
            "stroke-width" to reach,
            "stroke-dasharray" to "${figure(highlighted)} ${figure(round - highlighted)}",
            "transform" to "rotate(${figure(-direction - cone / 2)} ${figure(point.x)} ${figure(y)})",
        )
    }

    fun lamp(lamp: Lamp, now: LampState) {
        val y = shapes.down(now.place.y)
        if (lamp.cone < Lamp.ALL_ROUND) {
            val round = 2 * PI * SHADE_RADIUS
            val closed = round * (Lamp.ALL_ROUND - lamp.cone) / Lamp.ALL_ROUND
            svg.element(
                "circle",
                "cx" to now.place.x,
                "cy" to y,
                "r" to SHADE_RADIUS,
                "fill" to "none",
                "stroke" to hex(SheetColours.LAMP_SHADE),
                "stroke-width" to 0.65,
                "stroke-dasharray" to "${figure(closed)} ${figure(round - closed)}",
                "transform" to "rotate(${figure(-lamp.direction + lamp.cone / 2)} ${figure(now.place.x)} ${figure(y)})",
            )
        }
        svg.element(
            "circle",
            "cx" to now.place.x,
            "cy" to y,
            "r" to BULB_RADIUS,
            "stroke-width" to 0.22,
            "fill" to hex(bulbColour(lamp, now.on)),
            "stroke" to hex(if (now.on) SheetColours.LAMP_EDGE else SheetColours.LAMP_SHADE),
        )
    }

    private companion object {
        const val REACH = 45.0
        const val CONE_OPACITY = 0.22
        const val BULB_RADIUS = 1.3
        const val SHADE_RADIUS = 2.08
    }
}
