package robotran.microbit

import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.microbit.model.MicrobitModel
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitNative
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals

class MicrobitCallTest {
    @Test
    fun `the log shows a call as it is written`() {
        val calls = listOf(
            MicrobitCall.i2c(0x10, listOf(1, 2, 45, 0)),
            MicrobitCall.pinAnalog(2, 88),
            MicrobitCall.pinPeriod(2, 20),
            MicrobitCall.of(MicrobitNative.PIN_DIGITAL, 8, 1),
            MicrobitCall.of(MicrobitNative.DISPLAY_SHOW, "5"),
            MicrobitCall.of(MicrobitNative.DISPLAY_SCROLL, "12"),
            MicrobitCall.of(MicrobitNative.DISPLAY_CLEAR),
            MicrobitCall.of(MicrobitNative.MUSIC_PITCH, 880, 100),
            MicrobitCall.of(MicrobitNative.MUSIC_STOP),
            MicrobitCall.of(MicrobitNative.PRINT, "two words"),
        )
        val shown = listOf(
            "i2c 0x10 01 02 2d 00",
            "pin 2 analog 88",
            "pin 2 period 20",
            "pin 8 digital 1",
            "display show 5",
            "display scroll 12",
            "display clear",
            "pitch 880 100",
            "music stop",
            "print two words",
        )
        assertEquals(shown, calls.map { it.toString() })
        assertEquals(MicrobitNative.entries.toSet(), calls.map { it.native }.toSet())
    }

    @Test
    fun `calls that differ are told apart`() {
        fun identity(call: MicrobitCall) = buildList { call.identify(::add) }
        val one = MicrobitCall.of(MicrobitNative.PRINT, "a")
        assertEquals(identity(one), identity(MicrobitCall.of(MicrobitNative.PRINT, "a")))
        assertNotEquals(identity(one), identity(MicrobitCall.of(MicrobitNative.PRINT, "b")))
        assertNotEquals(identity(one), identity(MicrobitCall.of(MicrobitNative.DISPLAY_SHOW, "a")))
        assertEquals(MicrobitNative.entries.size, MicrobitNative.entries.map { it.id }.toSet().size)
    }

    @Test
    fun `the rows of boards and bricks agree`() {
        assertEquals(BrickKind.entries.filter { it.isOnBuggy }.toSet(), MicrobitModel.entries.map { it.kind }.toSet())
        for (model in MicrobitModel.entries) {
            assertEquals(model.kind.buttons, model.buttons.map { it.control })
            assertEquals(SensorKind.SOUND in model.kind.ownSensors, model.hasMicrophone)
            assertEquals(model, MicrobitModel.of(model.kind))
        }
    }
}
