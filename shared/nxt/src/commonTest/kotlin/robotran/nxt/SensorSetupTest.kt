package robotran.nxt

import robotran.language.Language
import robotran.nxt.hardware.SensorType
import robotran.nxt.messages.NxtMessages
import robotran.nxt.program.SensorSetup
import kotlin.test.Test
import kotlin.test.assertEquals

class SensorSetupTest {
    @Test
    fun `a light sensor gets its lamp`() = assertEquals(
        listOf(
            "setTypeById 2 5",
            "setPowerTypeById 2 0",
            "setSensorPinMode 2 0 2",
            "setSensorPinMode 2 1 2",
            "setSensorPin 2 0 1",
            "setSensorPin 2 1 0",
        ),
        calls(port = 2, SensorType.LIGHT_ACTIVE),
    )

    @Test
    fun `each type has its power and pins`() {
        assertEquals("setPowerTypeById 0 1", calls(0, SensorType.REFLECTION)[1])
        assertEquals("setPowerTypeById 3 2", calls(3, SensorType.LOWSPEED_9V)[1])
        assertEquals(listOf("setSensorPin 0 0 0", "setSensorPin 0 1 1"), calls(0, SensorType.SOUND_DBA).takeLast(2))
        assertEquals(listOf("setTypeById 1 13", "setPowerTypeById 1 0"), calls(1, SensorType.COLOUR_FULL))
    }

    @Test
    fun `a brick does what the calls say`() {
        val brick = NxtBrick(listOf(scriptedProgram("endless")), messages = NxtMessages.of(Language.ENGLISH))
        brick.runSnippet(checkNotNull(scriptedProgram("endless")))
        for (call in SensorSetup.callsFor(1, SensorType.LIGHT_ACTIVE)) brick.nxt.call(call, TEST_LINE)
        val port = brick.sensorPort(1)
        assertEquals(listOf(SensorType.LIGHT_ACTIVE, 0), listOf(port.type, port.power))
        assertEquals(listOf(true, false), listOf(port.pin0, port.pin1))
    }

    private fun calls(port: Int, type: Int): List<String> = SensorSetup.callsFor(port, type).map { it.toString() }
}
