package robotran.robolang.run

import robotran.rcxrom.call.RomAddress
import robotran.robolang.RecordingRom
import robotran.robolang.programOf
import robotran.robolang.translate.javaLinesOf
import kotlin.test.Test
import kotlin.test.assertEquals

/** A program sets up the ports of the sensors that it uses, and so does its translation. */
class SensorPortsTest {
    /** What is set up, from the [touchPorts] and the port that gets power. */
    private data class SetUp(val touchPorts: List<Int> = emptyList(), val lightPort: Int? = null)

    private fun check(source: String, expected: SetUp) {
        assertEquals(expected, ofRun(source), "the run of:\n$source")
        assertEquals(expected, ofTranslation(source), "the translation of:\n$source")
    }

    private fun ofRun(source: String): SetUp {
        val rom = RecordingRom()
        programOf(source).start(rom).resume(STEPS)
        val powered = rom.calls.filter { it.call.address == RomAddress.ACTIVATE_SENSOR }
        return SetUp(rom.touchPorts, powered.singleOrNull()?.let { it.call.arguments.single() - FIRST_PORT + 1 })
    }

    private fun ofTranslation(source: String): SetUp {
        val lines = javaLinesOf(source)
        return SetUp(
            lines.mapNotNull { TOUCH.find(it)?.groupValues?.get(1)?.toInt() },
            lines.mapNotNull { POWER.find(it)?.groupValues?.get(1)?.toInt() }.singleOrNull(),
        )
    }

    @Test
    fun `a program with one bumper sets up only the port of that bumper`() {
        check("if left bumper\n  beep\nend", SetUp(listOf(1)))
        check("if right bumper\n  beep\nend", SetUp(listOf(3)))
        check("if right bumper and not left bumper\n  beep\nend", SetUp(listOf(1, 3)))
    }

    @Test
    fun `a bumper counts wherever it is in the program`() {
        check("procedure never()\n  wait until right bumper\nend\nbeep", SetUp(listOf(3)))
        check("function felt()\n  return left bumper\nend\nif felt()\n  beep\nend", SetUp(listOf(1)))
        check("whenever right bumper\n  beep\nend\nbeep", SetUp(listOf(3)))
        check("repeat 2 times\n  var x = not (right bumper or false)\nend", SetUp(listOf(3)))
    }

    @Test
    fun `a program without sensors sets up none`() {
        check("show sensor 1\nshow sensor 3\nshow battery", SetUp())
        check("robot\n  light sensor on 1 facing down\nend\nbeep", SetUp())
    }

    @Test
    fun `a bumper that shares its port with a light sensor in use is not set up`() {
        val header = "robot\n  light sensor on 3 facing forward\nend\n"
        check(header + "if right bumper or left bumper\n  show light\nend", SetUp(listOf(1), lightPort = 3))
        check(header + "if right bumper\n  show light\nend", SetUp(lightPort = 3))
        check(header + "if right bumper\n  beep\nend", SetUp(listOf(3)))
        check("if right bumper\n  show light\nend", SetUp(listOf(3), lightPort = 2))
    }

    private companion object {
        const val STEPS = 100
        const val FIRST_PORT = 0x1000
        val TOUCH = Regex("""Sensor\.S(\d)\.setTypeAndMode\(SensorConstants\.SENSOR_TYPE_TOUCH""")
        val POWER = Regex("""Sensor\.S(\d)\.activate\(\)""")
    }
}
