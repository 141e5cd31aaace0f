package robotran.robolang.robot

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind

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

    /**
     * A robot with an RCX, whose motors run for a time.
     *
     * @property millisecondsPerCentimetre how long both motors run per centimetre.
     * @property millisecondsPerDegree how long they run in opposite directions per degree.
     */
    data class Rcx(
        val millisecondsPerCentimetre: Double,
        val millisecondsPerDegree: Double,
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
    }
}

/** The motor that drives no wheel: the pen's, if there is a pen. */
internal val RobotTarget.thirdMotor: MotorPort
    get() = pen ?: MotorPort.entries.first { it != left && it != right }
