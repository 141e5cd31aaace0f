package robotran.robolang.words

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind

// Words of which a line or a value has one.

internal val SIDES = listOf(Keyword.LEFT, Keyword.RIGHT)
internal val DIRECTIONS = listOf(Keyword.FORWARD, Keyword.BACKWARD)
internal val MOTOR_COMMANDS = DIRECTIONS + listOf(Keyword.STOP, Keyword.FLOAT)
internal val PEN_POSITIONS = listOf(Keyword.DOWN, Keyword.UP)
internal val TIME_UNITS = listOf(Keyword.SECONDS, Keyword.MILLISECONDS)
internal val FACINGS = listOf(Keyword.DOWN, Keyword.FORWARD)

/** The bricks by their words; of several with one word the first. */
internal val KINDS: Map<Keyword, BrickKind> =
    BrickKind.entries.distinctBy { BrickDialect.of(it).keyword }.associateBy { BrickDialect.of(it).keyword }

/** The letters of the motors that any brick has. */
internal val MOTORS: List<String> =
    MotorPort.entries.filter { port -> BrickKind.entries.any { port in it.motorPorts } }.map { it.name }

/** The numbers of the inputs of each brick. */
internal val PORTS: Map<BrickKind, List<String>> =
    BrickKind.entries.associateWith { brick -> (1..brick.inputPorts).map { it.toString() } }

internal val Iterable<Keyword>.texts: List<String> get() = map { it.text }
