package robotran.simulation.explain

import robotran.simulation.messages.SimulationMessages
import robotran.simulation.robot.SensorErrors
import robotran.simulation.robot.SimulatedRobot
import robotran.world.RobotPlacement
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.geometry.length
import robotran.world.thousandthsIn
import kotlin.math.abs

/** Explains why one robot has deviated so far; leaves negligible causes out. */
internal class Explanation(
    private val placement: RobotPlacement,
    private val machine: SimulatedRobot,
    private val sensors: SensorErrors,
    private val messages: SimulationMessages,
) {
    private val left = machine.leftWheel.account
    private val right = machine.rightWheel.account

    fun deviationCauses(): List<DeviationCause> = listOfNotNull(
        startPlace(),
        startHeading(),
        strength(leftMotor = true),
        strength(leftMotor = false),
        flutter(),
        slip(),
        battery(),
        spin(),
        lightBias(),
        lightNoise(),
        bounce(),
        motorPlay(),
        sonarBias(),
        sonarNoise(),
        colourNoise(),
    )

    private fun startPlace() = length(machine.start.x - placement.start.x, machine.start.y - placement.start.y).let {
        cause(Cause.START_POSITION, it, MIN_LENGTH) { messages.startPlace(text(it)) }
    }

    private fun startHeading() = (machine.start.heading - placement.start.heading).let {
        cause(Cause.START_HEADING, it, MIN_ANGLE) { messages.startHeading(text(it), left = it > 0) }
    }

    private fun strength(leftMotor: Boolean): DeviationCause? {
        val way = if (leftMotor) left.strength else right.strength
        val strength = (if (leftMotor) machine.leftNoise else machine.rightNoise).strength
        return cause(if (leftMotor) Cause.LEFT_STRENGTH else Cause.RIGHT_STRENGTH, way, MIN_LENGTH) {
            messages.strength(leftMotor, strength < 1, text((strength - 1) * PER_CENT), text(way))
        }
    }

    private fun flutter() = (left.flutter - right.flutter).let {
        cause(Cause.FLUTTER, it, MIN_LENGTH) {
            messages.flutter(text(it), text(it / machine.parameters.wheelTrack / RADIANS_PER_DEGREE), left = it < 0)
        }
    }

    private fun slip() = (left.slip + right.slip).let { cause(Cause.SLIP, it, MIN_LENGTH) { messages.slip(text(it)) } }

    private fun spin() = (left.spin + right.spin).let { cause(Cause.SPIN, it, MIN_SPIN) { messages.spin(text(it)) } }

    private fun battery() = ((abs(left.battery) + abs(right.battery)) / 2).let {
        cause(Cause.BATTERY, it, MIN_LENGTH) { messages.battery(text(machine.battery.volts), text(it)) }
    }

    private fun lightBias() = cause(Cause.LIGHT_BIAS, sensors.lightBias, MIN_RAW) {
        messages.lightBias(
            text(sensors.lightBias),
            dark = sensors.lightBias > 0,
        )
    }

    private fun lightNoise() = sensors.lightNoise.let {
        cause(Cause.LIGHT_NOISE, it, MIN_RAW) { messages.lightNoise(text(it)) }
    }

    private fun bounce() = machine.bumpers.sumOf { it.bounceCount }.let {
        cause(Cause.BOUNCE, it.toDouble(), 1.0) { messages.bounce(it) }
    }

    private fun motorPlay() = (machine.leftWheel.playedAway + machine.rightWheel.playedAway).let {
        cause(Cause.MOTOR_PLAY, it, MIN_LENGTH) { messages.motorPlay(text(it)) }
    }

    private fun sonarBias() = sensors.sonarBias.let {
        cause(Cause.SONAR_BIAS, it, MIN_DISTANCE) { messages.sonarBias(text(it), far = it > 0) }
    }

    private fun sonarNoise() = sensors.sonarNoise.let {
        cause(Cause.SONAR_NOISE, it, MIN_DISTANCE) { messages.sonarNoise(text(it)) }
    }

    private fun colourNoise() = sensors.colourNoise.let {
        cause(Cause.COLOUR_NOISE, it, MIN_RAW) { messages.colourNoise(text(it)) }
    }

    private fun cause(cause: Cause, amount: Double, min: Double, sentence: () -> String): DeviationCause? =
        if (abs(amount) < min) null else DeviationCause(placement.name, cause, amount, sentence())

    /** The absolute value of [number] with one decimal. */
    private fun text(number: Double): String {
        val tenths = (thousandthsIn(abs(number)) + HALF_TENTH) / TENTH
        return "${tenths / TENTHS}.${tenths % TENTHS}"
    }

    private companion object {
        const val MIN_LENGTH = 0.05
        const val MIN_ANGLE = 0.05

        /** In each change from driving to turning the tyres slip minimally, which is part of the calibration. */
        const val MIN_SPIN = 1.0
        const val MIN_RAW = 0.5
        const val MIN_DISTANCE = 0.1
        const val PER_CENT = 100.0
        const val TENTH = 100L
        const val HALF_TENTH = 50L
        const val TENTHS = 10
    }
}
