package robotran.robolang.run

import robotran.brick.controls.MotorPort
import robotran.microbit.buggy.MicrobitSensor
import robotran.microbit.model.MicrobitButton
import robotran.microbit.program.Microbit
import robotran.robolang.robot.MicrobitFigures
import robotran.robolang.robot.MicrobitUses
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.BrickButton
import robotran.robolang.syntax.Sense

/** Reads the sensors of a robot with a micro:bit. */
internal class MicrobitSenses(
    private val board: Microbit,
    private val robot: RobotTarget.Microbit,
    private val uses: MicrobitUses,
) : RobotSenses {
    private var centimetres = MicrobitFigures.NOTHING
    private var measuredAt: Long? = null

    /** [port] is that of the left bumper on other bricks, or of the right one. */
    override fun isPressed(port: Int): Boolean = board.isPressed(if (port == 1) MicrobitButton.A else MicrobitButton.B)

    override fun light(port: Int): Int = if (uses.isLightAhead) {
        percent(board.lightLevel)
    } else {
        uses.sensorOf(Sense.Light)?.let(::valueOf) ?: 0
    }

    override fun value(port: Int): Int = uses.sensorOf(Sense.Sensor(port))?.let(::valueOf) ?: 0

    override fun isHeld(button: BrickButton, sourceLine: Int): Boolean = board.isPressed(MicrobitUses.buttonOf(button))

    override fun batteryVolts(sourceLine: Int): Float = notOnThisBrick()

    override fun measureDistance(port: Int, sourceLine: Int) = Unit

    override fun hasDistance(port: Int): Boolean = true

    override fun distance(port: Int): Int =
        if (uses.sensorOf(Sense.Distance) == null) MicrobitFigures.NOTHING else echo()

    override fun loudness(port: Int): Int = percent(board.soundLevel)

    override fun colour(port: Int): Int = notOnThisBrick()

    override fun turned(motor: MotorPort): Int = notOnThisBrick()

    private fun valueOf(sensor: MicrobitSensor): Int = when (sensor) {
        MicrobitSensor.Sonar -> echo()

        is MicrobitSensor.Line -> when {
            robot.buggy.lines[sensor.line].isGrey -> board.grey(sensor.line)
            board.isDark(sensor.line) -> MicrobitFigures.DARK
            else -> MicrobitFigures.BRIGHT
        }
    }

    private fun echo(): Int {
        val now = board.milliseconds
        val last = measuredAt
        if (last == null || now - last >= MicrobitFigures.SONAR_MILLISECONDS) {
            centimetres = board.distance
            measuredAt = now
        }
        return centimetres
    }

    private fun percent(level: Int) = level * MicrobitFigures.BRIGHT / MicrobitFigures.FULL_LEVEL
}
