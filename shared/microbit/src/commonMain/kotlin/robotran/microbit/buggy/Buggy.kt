package robotran.microbit.buggy

import robotran.brick.kind.BuggyKind
import robotran.brick.kind.BuggyPins
import robotran.microbit.model.MicrobitModel
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitNative

/**
 * How a micro:bit drives a buggy and reads its sensors.
 *
 * @property lines its line sensors from left to right, which are on the ports from 1 on.
 * @property sonar its distance sensor, which is on the port behind; null without one.
 * @property pen its plug for a servo that moves a pen; null without one.
 * @property buzzer the pin of its buzzer; null without one.
 * @property usesPin0 whether something else is on pin 0, where a board without a loudspeaker plays its tones.
 */
data class Buggy(
    val kind: BuggyKind,
    val wheels: Wheels,
    val lines: List<LineSensor>,
    val sonar: SonarPins?,
    val pen: PenServo?,
    val buzzer: Int? = null,
    val usesPin0: Boolean = false,
) {
    /** The port of the distance sensor, from 1; null without one. */
    val sonarPort: Int? get() = if (sonar == null) null else lines.size + 1

    /** What is on its ports, by their numbers. */
    val sensors: Map<Int, MicrobitSensor>
        get() = lines.indices.associate { it + 1 to MicrobitSensor.Line(it) as MicrobitSensor } +
            listOfNotNull(sonarPort).associateWith { MicrobitSensor.Sonar }

    /** What a program does before its first line: chip and servo made ready, wheels stopped. */
    fun startCalls(hasPen: Boolean): List<MicrobitCall> =
        wheels.start + (if (hasPen) pen?.start.orEmpty() else emptyList()) + stopCalls

    /** Whether a program for this [board] can play tones and nothing else on the buggy moves; [hasPen] as in [startCalls]. */
    fun bearsTones(board: MicrobitModel, hasPen: Boolean): Boolean {
        val hasServo = startCalls(hasPen).any { it.native == MicrobitNative.PIN_PERIOD }
        return (board.hasSpeaker || !usesPin0) && !(board.hasOnePulsePeriod && hasServo)
    }

    /** What stops the wheels. */
    val stopCalls: List<MicrobitCall> get() = wheels.calls(0, 0)

    companion object {
        /** The buggy of this kind, a plain one with these [pins]. */
        fun of(kind: BuggyKind, pins: BuggyPins? = null): Buggy = when (kind) {
            BuggyKind.CUTEBOT -> Buggies.CUTEBOT
            BuggyKind.CUTEBOT_PRO -> Buggies.CUTEBOT_PRO
            BuggyKind.MAQUEEN -> Buggies.MAQUEEN
            BuggyKind.MAQUEEN_PLUS -> Buggies.MAQUEEN_PLUS
            BuggyKind.TINY_BIT -> Buggies.TINY_BIT
            BuggyKind.KITRONIK_MOVE -> Buggies.KITRONIK_MOVE
            BuggyKind.PLAIN -> Buggies.plain(pins ?: BuggyPins.SERVOS)
        }
    }
}
