package robotran.microbit.buggy

import robotran.brick.kind.BuggyKind
import robotran.brick.kind.BuggyPins
import robotran.brick.kind.PlainDrive
import robotran.microbit.buggy.FrameByte.Direction
import robotran.microbit.buggy.FrameByte.Fixed
import robotran.microbit.buggy.FrameByte.Power
import robotran.microbit.buggy.FrameByte.PowerAhead
import robotran.microbit.buggy.FrameByte.PowerBack
import robotran.microbit.buggy.WheelSide.LEFT
import robotran.microbit.buggy.WheelSide.RIGHT

/** The buggies. Sources: the makers' own extensions for MakeCode and their MicroPython modules. */
internal object Buggies {
    /** What a whole byte means as a power. */
    private const val BYTE = 255

    /** What a percentage means as a power. */
    private const val PERCENT = 100

    private const val CUTEBOT_CHIP = 0x10

    /** elecfreaks/pxt-cutebot. */
    val CUTEBOT = Buggy(
        BuggyKind.CUTEBOT,
        I2cWheels(
            CUTEBOT_CHIP,
            frames = listOf(
                frame(Fixed(1), Direction(LEFT, ahead = 2, back = 1), Power(LEFT, PERCENT), Fixed(0)),
                frame(Fixed(2), Direction(RIGHT, ahead = 2, back = 1), Power(RIGHT, PERCENT), Fixed(0)),
            ),
        ),
        lines = listOf(PinLine(13, darkIs = 0), PinLine(14, darkIs = 0)),
        sonar = SonarPins(trigger = 8, echo = 12),
        pen = I2cServo(CUTEBOT_CHIP, frame(Fixed(5), FrameByte.Angle, Fixed(0), Fixed(0))),
        buzzer = 0,
    )

    private const val PRO_HEAD = 0xFF
    private const val PRO_SECOND = 0xF9
    private const val PRO_POWER = 0x10
    private const val PRO_SERVO = 0x40
    private const val PRO_LINE = 0x60

    /** elecfreaks/pxt-Cutebot-Pro, second generation. Its outer line sensors are on no port. */
    val CUTEBOT_PRO = Buggy(
        BuggyKind.CUTEBOT_PRO,
        I2cWheels(
            CUTEBOT_CHIP,
            frames = listOf(
                frame(
                    Fixed(PRO_HEAD),
                    Fixed(PRO_SECOND),
                    Fixed(PRO_POWER),
                    Fixed(4),
                    Fixed(2),
                    Power(LEFT, PERCENT),
                    Power(RIGHT, PERCENT),
                    FrameByte.BackBits,
                ),
            ),
            pauseMilliseconds = 1,
        ),
        lines = listOf(proLine(bit = 1), proLine(bit = 2)),
        sonar = SonarPins(trigger = 8, echo = 12),
        pen = I2cServo(
            CUTEBOT_CHIP,
            frame(Fixed(PRO_HEAD), Fixed(PRO_SECOND), Fixed(PRO_SERVO), Fixed(2), Fixed(0), FrameByte.Angle),
        ),
    )

    private fun proLine(bit: Int) = I2cLine(CUTEBOT_CHIP, listOf(PRO_HEAD, PRO_SECOND, PRO_LINE, 1, 0), bit)

    private const val MAQUEEN_CHIP = 0x10
    private const val MAQUEEN_SERVO = 0x14

    /** DFRobot/pxt-maqueen. */
    val MAQUEEN = Buggy(
        BuggyKind.MAQUEEN,
        I2cWheels(
            MAQUEEN_CHIP,
            frames = listOf(
                frame(Fixed(0), Direction(LEFT, ahead = 0, back = 1), Power(LEFT, BYTE)),
                frame(Fixed(2), Direction(RIGHT, ahead = 0, back = 1), Power(RIGHT, BYTE)),
            ),
        ),
        lines = listOf(PinLine(13, darkIs = 0), PinLine(14, darkIs = 0)),
        sonar = SonarPins(trigger = 1, echo = 2),
        pen = I2cServo(MAQUEEN_CHIP, frame(Fixed(MAQUEEN_SERVO), FrameByte.Angle)),
        buzzer = 0,
    )

    private const val PLUS_LINE = 0x1D

    /** DFRobot/pxt-DFRobot_MaqueenPlus_v20. Its outer line sensors are on no port. */
    val MAQUEEN_PLUS = Buggy(
        BuggyKind.MAQUEEN_PLUS,
        I2cWheels(
            MAQUEEN_CHIP,
            frames = listOf(
                frame(
                    Fixed(0),
                    Direction(LEFT, ahead = 0, back = 1),
                    Power(LEFT, BYTE),
                    Direction(RIGHT, ahead = 0, back = 1),
                    Power(RIGHT, BYTE),
                ),
            ),
        ),
        lines = listOf(plusLine(bit = 3), plusLine(bit = 2), plusLine(bit = 1)),
        sonar = SonarPins(trigger = 13, echo = 14),
        pen = PinServo(1),
        buzzer = 0,
    )

    private fun plusLine(bit: Int) = I2cLine(MAQUEEN_CHIP, listOf(PLUS_LINE), bit)

    private const val TINY_CHIP = 0x01

    /** lzty634158/Tiny-bit. */
    val TINY_BIT = Buggy(
        BuggyKind.TINY_BIT,
        I2cWheels(
            TINY_CHIP,
            frames = listOf(
                frame(
                    Fixed(2),
                    PowerAhead(LEFT, BYTE),
                    PowerBack(LEFT, BYTE),
                    PowerAhead(RIGHT, BYTE),
                    PowerBack(RIGHT, BYTE),
                ),
            ),
        ),
        lines = listOf(PinLine(13, darkIs = 1), PinLine(14, darkIs = 1)),
        sonar = SonarPins(trigger = 16, echo = 15),
        pen = null,
        buzzer = 0,
    )

    private const val KITRONIK_CHIP = 0x62

    /** From register 2 on, each write to the next one. */
    private const val KITRONIK_POWERS = 0xA2

    /** KitronikLtd/pxt-kitronik-move-motor: the PCA9632 of its boards V1 and V2. */
    val KITRONIK_MOVE = Buggy(
        BuggyKind.KITRONIK_MOVE,
        I2cWheels(
            KITRONIK_CHIP,
            frames = listOf(
                frame(
                    Fixed(KITRONIK_POWERS),
                    PowerBack(RIGHT, BYTE),
                    PowerAhead(RIGHT, BYTE),
                    PowerAhead(LEFT, BYTE),
                    PowerBack(LEFT, BYTE),
                ),
            ),
            setUp = listOf(listOf(0x01, 0x04), listOf(0x08, 0xAA), listOf(0x00, 0x00)),
        ),
        lines = listOf(AnalogLine(2, isDarkHigh = true), AnalogLine(1, isDarkHigh = true)),
        sonar = SonarPins(trigger = 13, echo = 14),
        pen = PinServo(15),
        buzzer = 0,
    )

    fun plain(pins: BuggyPins) = Buggy(
        BuggyKind.PLAIN,
        when (pins.drive) {
            PlainDrive.SERVOS -> ServoWheels(pins.left[0], pins.right[0])

            PlainDrive.BRIDGE ->
                BridgeWheels(BridgePins(pins.left[0], pins.left[1]), BridgePins(pins.right[0], pins.right[1]))
        },
        lines = pins.lines.map { PinLine(it, darkIs = if (pins.isDarkOne) 1 else 0) },
        sonar = pins.trigger?.let { SonarPins(it, pins.echo ?: it) },
        pen = pins.pen?.let(::PinServo),
        usesPin0 = 0 in pins.all,
    )

    private fun frame(vararg bytes: FrameByte) = Frame(bytes.toList())
}
