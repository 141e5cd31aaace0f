package robotran.rcxrom

import robotran.brick.controls.BrickButton
import robotran.brick.program.ProgramStatus
import robotran.brick.sensors.ExpectedSensor
import robotran.brick.sensors.SensorKind
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorCode
import kotlin.test.Test
import kotlin.test.assertEquals

/** Which sensors a program expects at the ports is seen from what it sets and powers. */
class ExpectedSensorsTest {
    private fun setting(port: Int, type: Int, mode: Int = SensorCode.MODE_PERCENT): (Rom) -> ProgramStatus = { rom ->
        rom.setSensorTypeAndMode(port - 1, type, mode)
        ProgramStatus.Running
    }

    private fun powering(port: Int) = calling(RomAddress.ACTIVATE_SENSOR, SensorCode.FIRST_PORT + port - 1)

    /** What leJOS's class `Sensor` does when a program first uses it. */
    private val initialising = (1..SensorCode.PORTS).map { setting(it, SensorCode.TYPE_LIGHT) }

    private fun brickAfter(actions: List<(Rom) -> ProgramStatus>): RcxBrick {
        val brick =
            RcxBrick(
                listOf(ScriptedProgram(actions, statusAtEnd = ProgramStatus.Running)),
                messages = BrickMessages.of(Language.ENGLISH),
            )
        brick.push(BrickButton.RUN)
        brick.tick(20)
        return brick
    }

    private fun expectedAfter(vararg actions: (Rom) -> ProgramStatus): List<Pair<Int, SensorKind>> =
        brickAfter(initialising + actions).expectedSensors.map { it.port to it.kind }

    @Test
    fun `a program that sets no type expects nothing`() {
        assertEquals(emptyList(), expectedAfter())
    }

    @Test
    fun `a program that sets a type expects a sensor of that kind`() {
        assertEquals(listOf(2 to SensorKind.TOUCH), expectedAfter(setting(2, SensorCode.TYPE_TOUCH)))
        assertEquals(listOf(1 to SensorKind.TEMPERATURE), expectedAfter(setting(1, SensorCode.TYPE_TEMPERATURE)))
        assertEquals(listOf(3 to SensorKind.ROTATION), expectedAfter(setting(3, SensorCode.TYPE_ROTATION)))
        assertEquals(listOf(1 to SensorKind.LIGHT), expectedAfter(setting(1, SensorCode.TYPE_LIGHT)))
    }

    @Test
    fun `raw values come from every sensor`() {
        assertEquals(emptyList(), expectedAfter(setting(2, type = 0, SensorCode.MODE_RAW)))
    }

    @Test
    fun `a program that powers a port expects what its type needs power for`() {
        assertEquals(listOf(1 to SensorKind.LIGHT), expectedAfter(powering(1)))
        assertEquals(listOf(1 to SensorKind.TOUCH), expectedAfter(setting(1, SensorCode.TYPE_TOUCH), powering(1)))
    }

    @Test
    fun `each kind is expected once per port, at the line that said so first`() {
        val touch = setting(2, SensorCode.TYPE_TOUCH)
        val brick = brickAfter(initialising + touch + touch + setting(2, SensorCode.TYPE_LIGHT) + powering(2))
        assertEquals(
            listOf(
                ExpectedSensor(2, SensorKind.TOUCH, sourceLine = 4, sourceFile = null),
                ExpectedSensor(2, SensorKind.LIGHT, sourceLine = 6, sourceFile = null),
            ),
            brick.expectedSensors,
        )
    }

    @Test
    fun `expectations stay until the next program is started`() {
        val brick = brickAfter(initialising + setting(2, SensorCode.TYPE_TOUCH))
        brick.stopProgram()
        brick.tick(5)
        assertEquals(1, brick.expectedSensors.size)
        brick.push(BrickButton.RUN)
        assertEquals(emptyList(), brick.expectedSensors)
        brick.tick(20)
        assertEquals(listOf(SensorKind.TOUCH), brick.expectedSensors.map { it.kind })
    }
}
