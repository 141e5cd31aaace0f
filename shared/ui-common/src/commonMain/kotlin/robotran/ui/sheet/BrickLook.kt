package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.brick.kind.BrickKind
import robotran.uikit.*
import robotran.world.RobotColour
import robotran.world.RobotDescription
import kotlin.math.max

/** How a kind of brick and its motors look from above, in centimetres; its upper end is at smaller y. */
interface BrickLook {
    val body: Rect
    val display: Rect

    fun DrawTarget.drawBrick(top: BrickTop, colour: RobotColour)

    /**
     * The motors of the wheels, and that of the pen where it shows.
     *
     * @param side the y to which the motor of a wheel reaches.
     */
    fun motors(robot: RobotDescription, chassis: Rect, side: Float): List<MotorTop>

    companion object {
        fun of(brick: BrickKind): BrickLook = when (brick) {
            BrickKind.RCX -> RcxLook
            BrickKind.NXT, BrickKind.NXT_PYBRICKS -> NxtLook
            BrickKind.SPIKE_PRIME -> PrimeLook
            BrickKind.SPIKE_ESSENTIAL -> EssentialLook
            BrickKind.TECHNIC_HUB -> TechnicLook
            BrickKind.EV3 -> Ev3Look
            BrickKind.MICROBIT, BrickKind.MICROBIT_V1 -> MicrobitLook
        }
    }
}

/** 6.4 by 11.2 cm. View and On-Off are behind the display if it lies across, Prgm and Run ahead. */
private object RcxLook : BrickLook {
    private const val MOTOR_BACK = -4.6f
    private val buttons =
        listOf(Offset(-2.05f, -1.1f), Offset(-2.05f, 1.1f), Offset(1.95f, -1.1f), Offset(1.95f, 1.1f))
    private val inputs = portsAt(-3.6f)
    private val outputs = portsAt(3.6f)

    override val body = Rect(-3.05f, -4.9f, 3.05f, 4.9f)
    override val display = Rect(-0.95f, -1.5f, 1.05f, 1.5f)

    override fun DrawTarget.drawBrick(top: BrickTop, colour: RobotColour) {
        box(top.box, RobotColours.brick(colour), 0.6f, RobotColours.edge(colour))
        box(top.display, RobotColours.GLASS, 0.2f, RobotColours.CHASSIS)
        for ((place, button) in buttons.zip(RobotColours.BUTTONS)) disc(top.point(place), 0.55f, button)
        for (place in inputs) box(top.rect(place), RobotColours.BUMPER, 0.15f)
        for (place in outputs) box(top.rect(place), RobotColours.CHASSIS, 0.15f)
    }

    override fun motors(robot: RobotDescription, chassis: Rect, side: Float): List<MotorTop> {
        val back = max(MOTOR_BACK, chassis.left + EDGE)
        return listOf(Rect(back, -3.8f, back + 2.7f, -0.5f), Rect(back, 0.5f, back + 2.7f, 3.8f)).map { MotorTop(it) }
    }

    private fun portsAt(y: Float): List<Rect> = listOf(-1.85f, 0.05f, 1.95f).map {
        Rect(it - 0.7f, y - 0.7f, it + 0.7f, y + 0.7f)
    }
}

/** 7.2 by 11.2 cm: a grey brick in a frame of the robot's colour. */
internal object NxtLook : BrickLook {
    private const val MOTOR_BACK = -7.4f
    private const val MOTOR_FRONT = 1.4f
    private const val MOTOR_WIDTH = 2.5f
    private val face = Rect(-2.75f, -4.75f, 2.75f, 4.75f)
    private val frame = Rect(-2.4f, -3.75f, 2.4f, -0.55f)
    private val enter = Rect(-0.75f, 0f, 0.75f, 1.5f)
    private val arrows = listOf(Offset(-1.65f, 0.75f), Offset(1.65f, 0.75f))
    private val escape = Rect(-1.3f, 1.85f, 1.3f, 2.75f)
    val motorPorts: List<Rect> = portsAt(-4.55f, listOf(-1.75f, 0f, 1.75f))
    private val sensorPorts = portsAt(4.1f, listOf(-2f, -0.67f, 0.67f, 2f))

    override val body = Rect(-3.3f, -5.1f, 3.3f, 5.1f)
    override val display = Rect(-2.05f, -3.4f, 2.05f, -0.9f)

    override fun DrawTarget.drawBrick(top: BrickTop, colour: RobotColour) {
        box(top.box, RobotColours.brick(colour), 0.7f, RobotColours.edge(colour))
        box(top.rect(face), RobotColours.NXT_FACE, 0.5f, RobotColours.edge(colour))
        box(top.rect(frame), RobotColours.BUMPER_EDGE, 0.3f)
        box(top.display, RobotColours.GLASS, 0.15f)
        box(top.rect(enter), RobotColours.ORANGE, 0.2f)
        for (place in arrows) disc(top.point(place), 0.6f, RobotColours.BUMPER)
        box(top.rect(escape), RobotColours.BUMPER_EDGE, 0.2f)
        for (place in motorPorts + sensorPorts) box(top.rect(place), RobotColours.CHASSIS, 0.1f)
    }

    override fun motors(robot: RobotDescription, chassis: Rect, side: Float): List<MotorTop> {
        val back = max(MOTOR_BACK, chassis.left + EDGE)
        val outer = side - 0.1f
        val wheels = listOf(-1, 1).map { sign ->
            val middle = sign * (outer - MOTOR_WIDTH / 2)
            val body = Rect(back, middle - MOTOR_WIDTH / 2, MOTOR_FRONT, middle + MOTOR_WIDTH / 2)
            MotorTop(body, Offset(0f, body.center.y))
        }
        val pen = if (robot.pen == null) null else Rect(back, -1.2f, -1.5f, 1.2f)
        return wheels + listOfNotNull(pen?.let { MotorTop(it, Offset(it.right - 1f, 0f)) })
    }

    private fun portsAt(y: Float, middles: List<Float>): List<Rect> = middles.map {
        Rect(it - 0.5f, y - 0.1f, it + 0.5f, y + 0.6f)
    }
}

/**
 * A hub from above: a light case in a frame of the robot's colour, its lights or screen, its button, and its ports at the
 * sides.
 *
 * @param ports how many ports each side has.
 */
private open class HubLook(halfWidth: Float, halfLength: Float, private val ports: Int) : BrickLook {
    override val body = Rect(-halfWidth, -halfLength, halfWidth, halfLength)
    override val display = Rect(-halfWidth * SHARE, -halfLength * SHARE, halfWidth * SHARE, halfLength * RISE)
    private val face = body.deflate(FRAME)
    private val button = Offset(0f, halfLength * SHARE)

    override fun DrawTarget.drawBrick(top: BrickTop, colour: RobotColour) {
        box(top.box, RobotColours.brick(colour), 0.6f, RobotColours.edge(colour))
        box(top.rect(face), RobotColours.NXT_FACE, 0.5f, RobotColours.edge(colour))
        drawDisplay(top)
        disc(top.point(button), BUTTON, RobotColours.BUMPER)
        for (place in portsOf()) box(top.rect(place), RobotColours.CHASSIS, 0.1f)
    }

    protected open fun DrawTarget.drawDisplay(top: BrickTop) = box(top.display, RobotColours.GLASS, 0.15f)

    private fun portsOf(): List<Rect> = List(ports) { number ->
        val y = body.top + body.height * (number + 1) / (ports + 1)
        listOf(
            Rect(body.left, y - PORT, body.left + PORT, y + PORT),
            Rect(
                body.right - PORT,
                y - PORT,
                body.right,
                y + PORT,
            ),
        )
    }.flatten()

    override fun motors(robot: RobotDescription, chassis: Rect, side: Float): List<MotorTop> =
        with(NxtLook) { motors(robot, chassis, side) }

    private companion object {
        const val SHARE = 0.6f
        const val RISE = 0.2f
        const val FRAME = 0.35f
        const val BUTTON = 0.6f
        const val PORT = 0.45f
    }
}

/** 5.6 by 8.8 cm, with 5 by 5 lights. */
private object PrimeLook : HubLook(halfWidth = 3.1f, halfLength = 4.3f, ports = 3) {
    private const val LIGHTS = 5

    override fun DrawTarget.drawDisplay(top: BrickTop) {
        box(top.display, RobotColours.BUMPER_EDGE, 0.15f)
        val (width, height) = display.width / LIGHTS to display.height / LIGHTS
        for (row in 0..<LIGHTS) {
            for (column in 0..<LIGHTS) {
                val middle = Offset(display.left + (column + 0.5f) * width, display.top + (row + 0.5f) * height)
                disc(top.point(middle), width * 0.3f, RobotColours.NXT_FACE)
            }
        }
    }
}

/** 4 by 5.6 cm, without a display. */
private object EssentialLook : HubLook(halfWidth = 2f, halfLength = 2.8f, ports = 1) {
    override fun DrawTarget.drawDisplay(top: BrickTop) = Unit
}

/** 4.8 by 7.2 cm, without a display. */
private object TechnicLook : HubLook(halfWidth = 3.1f, halfLength = 3.6f, ports = 2) {
    override fun DrawTarget.drawDisplay(top: BrickTop) = Unit
}

/** 7.2 by 11.2 cm, with a screen. */
private object Ev3Look : HubLook(halfWidth = 3.4f, halfLength = 5.2f, ports = 4)

/** What stays free at the edge of the chassis. */
private const val EDGE = 0.4f
