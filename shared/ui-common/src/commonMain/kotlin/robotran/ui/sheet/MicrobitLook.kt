package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.uikit.*
import robotran.world.RobotColour
import robotran.world.RobotDescription
import kotlin.math.max

/** A micro:bit, 5.2 by 4.3 cm, as if it lay on its buggy: dark, with 5 by 5 lights, two buttons and golden pins. */
internal object MicrobitLook : BrickLook {
    private const val LIGHTS = 5
    private const val LIGHT = 0.11f
    private const val KNOB = 0.3f
    private const val PIN = 0.24f
    private const val MOTOR_LENGTH = 2.2f
    private const val MOTOR_WIDTH = 1.2f
    private val buttons = listOf(Offset(-1.9f, -0.1f), Offset(1.9f, -0.1f))
    private val pins = List(LIGHTS) { Offset(-1.9f + it * 0.95f, 1.7f) }

    override val body = Rect(-2.5f, -2.1f, 2.5f, 2.1f)
    override val display = Rect(-1f, -1.1f, 1f, 0.9f)

    override fun DrawTarget.drawBrick(top: BrickTop, colour: RobotColour) {
        box(top.box, RobotColours.CHASSIS, 0.35f, RobotColours.brick(colour))
        val cell = display.width / LIGHTS
        for (place in 0..<LIGHTS * LIGHTS) {
            val middle = Offset(
                display.left + (place % LIGHTS + 0.5f) * cell,
                display.top + (place / LIGHTS + 0.5f) * cell,
            )
            disc(top.point(middle), LIGHT, RobotColours.PEN_TIP_DOWN)
        }
        for (place in buttons) disc(top.point(place), KNOB, RobotColours.BUMPER)
        for (place in pins) disc(top.point(place), PIN, RobotColours.GOLD)
    }

    override fun motors(robot: RobotDescription, chassis: Rect, side: Float): List<MotorTop> {
        val back = max(-MOTOR_LENGTH / 2, chassis.left)
        return listOf(-1, 1).map { sign ->
            val outer = sign * side
            val inner = outer - sign * MOTOR_WIDTH
            MotorTop(Rect(back, minOf(outer, inner), back + MOTOR_LENGTH, maxOf(outer, inner)))
        }
    }
}
