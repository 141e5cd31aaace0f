package robotran.robolang.robot

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.kind.WheelTrim
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubModel
import robotran.microbit.buggy.Buggy
import robotran.microbit.buggy.MicrobitSensor
import robotran.microbit.model.MicrobitModel
import kotlin.math.PI

/** The robot that a program is compiled for. Its figures belong to the robot, not to the language. */
sealed interface RobotTarget {
    val kind: BrickKind

    /** The motor of the left drive wheel. */
    val left: MotorPort

    /** The motor of the right drive wheel. */
    val right: MotorPort

    /** The motor of the pen; null if the robot has none. */
    val pen: MotorPort?

    /** Whether the motors of the drive wheels run backwards to drive forwards. */
    val isReversed: Boolean

    /** About how long both motors run per centimetre. */
    val millisecondsPerCentimetre: Double

    /** About how long they run in opposite directions per degree. */
    val millisecondsPerDegree: Double

    /**
     * A robot with an RCX, whose motors run for a time.
     *
     * @property millisecondsPerCentimetre how long both motors run per centimetre.
     * @property millisecondsPerDegree how long they run in opposite directions per degree.
     */
    data class Rcx(
        override val millisecondsPerCentimetre: Double,
        override val millisecondsPerDegree: Double,
        override val left: MotorPort = MotorPort.A,
        override val right: MotorPort = MotorPort.C,
        override val pen: MotorPort? = MotorPort.B,
        override val isReversed: Boolean = false,
    ) : RobotTarget {
        override val kind: BrickKind get() = BrickKind.RCX
    }

    /**
     * A robot with an NXT, whose motors count degrees.
     *
     * @property wheelDiameter in centimetres, of a wheel that turns as often as its motor: with gears the real diameter
     * divided by the turns of the motor per turn of the wheel.
     * @property track the distance between the middles of the drive wheels, in centimetres.
     */
    data class Nxt(
        val wheelDiameter: Double,
        val track: Double,
        override val left: MotorPort = MotorPort.A,
        override val right: MotorPort = MotorPort.C,
        override val pen: MotorPort? = MotorPort.B,
        override val isReversed: Boolean = false,
    ) : RobotTarget {
        override val kind: BrickKind get() = BrickKind.NXT

        /** A wheel turns once a second at its usual speed. */
        override val millisecondsPerCentimetre: Double get() = MILLISECONDS_PER_SECOND / (PI * wheelDiameter)
        override val millisecondsPerDegree: Double get() = PI * track / FULL_TURN * millisecondsPerCentimetre

        private companion object {
            const val MILLISECONDS_PER_SECOND = 1000
            const val FULL_TURN = 360
        }
    }

    /**
     * A robot with a hub that runs Pybricks.
     *
     * @property wheelDiameter in millimetres, of a wheel that turns as often as its motor.
     * @property track the distance between the middles of the drive wheels, in millimetres.
     * @property sensors what is on its ports for sensors, by their numbers from 1.
     */
    data class Hub(
        val model: HubModel,
        val wheelDiameter: Double,
        val track: Double,
        override val left: MotorPort,
        override val right: MotorPort,
        override val pen: MotorPort?,
        override val isReversed: Boolean = false,
        val sensors: Map<Int, HubDeviceKind> = emptyMap(),
    ) : RobotTarget {
        override val kind: BrickKind get() = model.kind

        /** A wheel turns once a second at its usual speed. */
        override val millisecondsPerCentimetre: Double get() = MILLISECONDS_PER_TURN_OF_CM / (PI * wheelDiameter)
        override val millisecondsPerDegree: Double get() = PI * track / FULL_TURN_OF_CM * millisecondsPerCentimetre

        /** Whether the motor turns the other way round when the robot drives ahead. */
        fun isCounterclockwise(motor: MotorPort): Boolean = when (motor) {
            left -> isReversed != model.mirrorsLeft
            right -> isReversed
            else -> false
        }

        private companion object {
            /** A second, for lengths in millimetres. */
            const val MILLISECONDS_PER_TURN_OF_CM = 10_000
            const val FULL_TURN_OF_CM = 3600
        }
    }

    /**
     * A robot with a micro:bit on a buggy, whose wheels turn for a time.
     *
     * @property millisecondsPerCentimetre how long both wheels turn per centimetre at power 3.
     * @property millisecondsPerDegree how long they turn in opposite directions per degree at power 3.
     * @property trim what the program slows down the faster wheel by.
     * @property sensors what is on its ports, by their numbers from 1.
     */
    data class Microbit(
        val model: MicrobitModel,
        val buggy: Buggy,
        override val millisecondsPerCentimetre: Double,
        override val millisecondsPerDegree: Double,
        override val left: MotorPort = MotorPort.A,
        override val right: MotorPort = MotorPort.C,
        override val pen: MotorPort? = MotorPort.B,
        override val isReversed: Boolean = false,
        val trim: WheelTrim = WheelTrim.NONE,
        val sensors: Map<Int, MicrobitSensor> = buggy.sensors,
    ) : RobotTarget {
        override val kind: BrickKind get() = model.kind

        /** Whether its programs play tones; otherwise they are silent, for a tone would move something on the buggy. */
        val playsTones: Boolean get() = buggy.bearsTones(model, pen != null)
    }
}

/** The motor that drives no wheel: the pen's, if there is a pen. */
internal val RobotTarget.thirdMotor: MotorPort
    get() = pen ?: kind.motorPorts.first { it != left && it != right }
