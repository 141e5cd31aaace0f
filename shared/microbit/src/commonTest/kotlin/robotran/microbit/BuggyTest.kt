package robotran.microbit

import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.brick.kind.BuggyPins
import robotran.brick.kind.PlainDrive
import robotran.microbit.buggy.Buggy
import robotran.microbit.buggy.Frame
import robotran.microbit.buggy.PenServo
import robotran.microbit.buggy.ServoPulse
import robotran.microbit.buggy.ServoWheels
import robotran.microbit.hardware.BuggyChip
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitError
import robotran.microbit.program.MicrobitNative
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class BuggyTest {
    private val bridge = BuggyPins(PlainDrive.BRIDGE, left = listOf(12, 8), right = listOf(16, 14), pen = 2)
    private val all = BuggyKind.entries.map { Buggy.of(it) } + Buggy.of(BuggyKind.PLAIN, bridge)

    private fun wheels(kind: BuggyKind, left: Int, right: Int) =
        Buggy.of(kind).wheels.calls(left, right).map { it.toString() }

    @Test
    fun `a buggy gets the bytes of its maker for one wheel ahead and one back`() {
        assertEquals(listOf("i2c 0x10 01 02 2d 00", "i2c 0x10 02 01 2d 00"), wheels(BuggyKind.CUTEBOT, 45, -45))
        assertEquals(listOf("i2c 0x10 ff f9 10 04 02 2d 2d 02"), wheels(BuggyKind.CUTEBOT_PRO, 45, -45))
        assertEquals(listOf("i2c 0x10 00 00 73", "i2c 0x10 02 01 73"), wheels(BuggyKind.MAQUEEN, 45, -45))
        assertEquals(listOf("i2c 0x10 00 00 73 01 73"), wheels(BuggyKind.MAQUEEN_PLUS, 45, -45))
        assertEquals(listOf("i2c 0x01 02 73 00 00 73"), wheels(BuggyKind.TINY_BIT, 45, -45))
        assertEquals(listOf("i2c 0x62 a2 73 00 73 00"), wheels(BuggyKind.KITRONIK_MOVE, 45, -45))
        assertEquals(listOf("pin 2 analog 88", "pin 1 analog 88"), wheels(BuggyKind.PLAIN, 45, -45))
        val motors = Buggy.of(BuggyKind.PLAIN, bridge).wheels.calls(45, -45).map { it.toString() }
        assertEquals(listOf("pin 8 analog 0", "pin 12 analog 460", "pin 16 analog 0", "pin 14 analog 460"), motors)
    }

    @Test
    fun `the same bytes stop it`() {
        assertEquals(listOf("i2c 0x10 01 02 00 00", "i2c 0x10 02 02 00 00"), wheels(BuggyKind.CUTEBOT, 0, 0))
        assertEquals(listOf("i2c 0x01 02 00 00 00 00"), wheels(BuggyKind.TINY_BIT, 0, 0))
        assertEquals(listOf("pin 2 analog 0", "pin 1 analog 0"), wheels(BuggyKind.PLAIN, 0, 0))
    }

    @Test
    fun `the chip reads back what a program has written`() {
        for (buggy in all) {
            val chip = BuggyChip(buggy)
            for (left in -100..100 step 5) {
                val right = -left + if (left > 50) 20 else 0
                write(chip, buggy.wheels.calls(left, right))
                // The pulses of a servo have steps of 4 percent.
                val off = if (buggy.wheels is ServoWheels) 4 else 0
                assertTrue(abs(chip.left - left) <= off && abs(chip.right - right) <= off, "${buggy.kind} $left")
            }
            write(chip, buggy.stopCalls)
            assertEquals(0 to 0, chip.left to chip.right, "${buggy.kind}")
        }
    }

    @Test
    fun `the servo of the pen turns where it is told`() {
        for (buggy in all) {
            val pen = buggy.pen ?: continue
            val chip = BuggyChip(buggy)
            for (degrees in listOf(PenServo.UP_DEGREES, PenServo.DOWN_DEGREES)) {
                write(chip, listOf(pen.turnTo(degrees)))
                assertTrue(abs(degrees - assertNotNull(chip.servo)) <= 2, "${buggy.kind} ${chip.servo}")
            }
            assertEquals(0 to 0, chip.left to chip.right, "${buggy.kind}")
        }
    }

    @Test
    fun `nobody answers at another address, and no byte is larger than 255`() {
        val chip = BuggyChip(Buggy.of(BuggyKind.CUTEBOT))
        assertEquals(MicrobitError.NO_DEVICE, chip.write(intArrayOf(0x62, 1)))
        assertEquals(MicrobitError.INVALID_ARGUMENT, chip.write(intArrayOf(0x10, 256)))
        assertEquals(MicrobitError.INVALID_ARGUMENT, chip.setPin(21, 0))
        assertEquals(MicrobitError.INVALID_ARGUMENT, chip.setPin(1, 1024))
        assertNull(chip.setPin(1, 1023))
    }

    @Test
    fun `no pin of a buggy is used twice, and all sensors have a port`() {
        for (buggy in all) {
            assertTrue(
                buggy.sensors.keys.all {
                    it in 1..BrickKind.MICROBIT.inputPorts
                },
                "${buggy.kind}",
            )
        }
        assertEquals(setOf(1, 2, 3), Buggy.of(BuggyKind.CUTEBOT).sensors.keys)
        assertEquals(setOf(1, 2, 3, 4), Buggy.of(BuggyKind.MAQUEEN_PLUS).sensors.keys)
        assertEquals(emptySet(), Buggy.of(BuggyKind.PLAIN).sensors.keys)
        val own = bridge.copy(lines = listOf(0, 1), trigger = 15, echo = 13)
        assertEquals(own.all.distinct(), own.all)
        assertEquals(setOf(1, 2, 3), Buggy.of(BuggyKind.PLAIN, own).sensors.keys)
    }

    @Test
    fun `pulses of servos are a part of twenty milliseconds`() {
        assertEquals(listOf(51, 77, 102), listOf(-100, 1, 100).map { ServoPulse.ofSpeed(it) })
        assertEquals(listOf(26, 77, 128), listOf(0, 90, 180).map { ServoPulse.ofAngle(it) })
        assertEquals(0, ServoPulse.ofSpeed(0))
        assertEquals(115, Frame.scaled(45, 255))
    }

    private fun write(chip: BuggyChip, calls: List<MicrobitCall>) {
        for (call in calls) {
            val error = when (call.native) {
                MicrobitNative.I2C_WRITE -> chip.write(call.numbers)
                else -> chip.setPin(call.numbers[0], call.numbers[1])
            }
            assertNull(error, "$call")
        }
    }
}
