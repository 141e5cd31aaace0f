package robotran.rcxrom

import robotran.brick.log.CallOutcome
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class LcdSegmentTest {
    private val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))

    /** Code, byte and bit of the icons with a single segment, as on a real brick. */
    private val singleSegments = listOf(
        Triple(0x3008, 0xEF49, 0),
        Triple(0x3009, 0xEF49, 1),
        Triple(0x300A, 0xEF48, 4),
        Triple(0x300B, 0xEF48, 0),
        Triple(0x300C, 0xEF47, 4),
        Triple(0x300D, 0xEF45, 4),
        Triple(0x300E, 0xEF4A, 2),
        Triple(0x300F, 0xEF46, 6),
        Triple(0x3010, 0xEF46, 2),
        Triple(0x3011, 0xEF43, 6),
        Triple(0x3012, 0xEF44, 2),
        Triple(0x3013, 0xEF47, 2),
        Triple(0x3014, 0xEF44, 6),
        Triple(0x3015, 0xEF47, 6),
        Triple(0x3016, 0xEF45, 6),
        Triple(0x301B, 0xEF47, 0),
    )

    @Test
    fun `each single segment is set and cleared in its own bit alone`() {
        for ((code, address, bit) in singleSegments) {
            show(code)
            assertEquals(mapOf(address to (1 shl bit)), litBytes(), "code $code shown")
            hide(code)
            assertEquals(emptyMap(), litBytes(), "code $code hidden")
        }
    }

    @Test
    fun `hiding a single segment leaves all others`() {
        for ((code, address, bit) in singleSegments) {
            show(RomCode.SEGMENT_ALL)
            hide(code)
            val expected = (0xEF43..0xEF4B).associateWith { if (it == address) 0xFF - (1 shl bit) else 0xFF }
            assertEquals(expected, litBytes(), "code $code hidden")
        }
    }

    @Test
    fun `the men take each other's place`() {
        show(RomCode.SEGMENT_STANDING_MAN)
        assertEquals(mapOf(0xEF43 to 0x6), litBytes())
        show(RomCode.SEGMENT_WALKING_MAN)
        assertEquals(mapOf(0xEF43 to 0xB), litBytes())
        show(RomCode.SEGMENT_STANDING_MAN)
        assertEquals(mapOf(0xEF43 to 0x6), litBytes())
        hide(RomCode.SEGMENT_STANDING_MAN)
        assertEquals(emptyMap(), litBytes())
    }

    @Test
    fun `the two infrared ranges take each other's place`() {
        show(RomCode.SEGMENT_INFRARED_LONG)
        assertEquals(mapOf(0xEF49 to 0xC), litBytes())
        show(RomCode.SEGMENT_INFRARED_SHORT)
        assertEquals(mapOf(0xEF49 to 0x4), litBytes())
        hide(RomCode.SEGMENT_INFRARED_LONG)
        assertEquals(emptyMap(), litBytes())
    }

    @Test
    fun `the data log's circle grows clockwise by quarters and the fifth clears it`() {
        val bytes = List(6) {
            show(RomCode.SEGMENT_DATALOG)
            hardware.memory.readByte(0xEF45)
        }
        assertEquals(listOf(0x1, 0x5, 0xD, 0xF, 0x0, 0x1), bytes)
        hide(RomCode.SEGMENT_DATALOG)
        show(RomCode.SEGMENT_DATALOG)
        assertEquals(0x1, hardware.memory.readByte(0xEF45))
    }

    @Test
    fun `download dots grow from the left and the sixth clears them`() {
        val rows = List(7) { dotsAfter(RomCode.SEGMENT_DOWNLOAD) }
        assertEquals(listOf("*....", "**...", "***..", "****.", "*****", ".....", "*...."), rows)
        hide(RomCode.SEGMENT_DOWNLOAD)
        assertEquals("*....", dotsAfter(RomCode.SEGMENT_DOWNLOAD))
    }

    @Test
    fun `upload dots are all there at first and go from the left`() {
        val rows = List(7) { dotsAfter(RomCode.SEGMENT_UPLOAD) }
        assertEquals(listOf("*****", ".****", "..***", "...**", "....*", ".....", "*****"), rows)
    }

    @Test
    fun `a program that spoils the step counters cannot break the steps`() {
        hardware.memory.writeByte(0xEF4E, 200)
        hardware.memory.writeByte(0xEF4F, 255)
        show(RomCode.SEGMENT_DATALOG)
        show(RomCode.SEGMENT_UPLOAD)
        assertEquals(emptyMap(), litBytes())
        show(RomCode.SEGMENT_DATALOG)
        assertEquals(mapOf(0xEF45 to 0x1), litBytes())
    }

    @Test
    fun `everything can be shown at once but not hidden`() {
        assertEquals("LCD show everything", show(RomCode.SEGMENT_ALL).meaning)
        hardware.lcd.refresh()
        assertEquals(LcdIcon.entries.toSet(), hardware.lcd.glass.litIcons)
        assertEquals("-8.8.8.8 8", hardware.lcd.glass.text)
        assertEquals(CallOutcome.WRONG_ARGUMENTS, hide(RomCode.SEGMENT_ALL).outcome)
    }

    @Test
    fun `codes without a segment are reported and change nothing`() {
        for (code in listOf(0x3000, 0x3001, 0x3005, 0x3017, 0x301E, 0x301F, 0x3021, 0x30FF)) {
            assertEquals(CallOutcome.WRONG_ARGUMENTS, show(code).outcome)
            assertEquals(CallOutcome.WRONG_ARGUMENTS, hide(code).outcome)
        }
        assertEquals(emptyMap(), litBytes())
    }

    @Test
    fun `the log names the segment`() {
        assertEquals("0 0x1b62 0x3007 ; LCD show walking man ; 7", show(RomCode.SEGMENT_WALKING_MAN).text)
        assertEquals("0 0x1e4a 0x3010 ; LCD hide motor A forward ; 7", hide(0x3010).text)
        assertEquals("LCD show sensor 1 view", show(0x3008).meaning)
    }

    @Test
    fun `an icon on the glass is the one of its code`() {
        val icons = mapOf(
            0x3006 to LcdIcon.STANDING_MAN,
            0x3007 to LcdIcon.WALKING_MAN,
            0x300D to LcdIcon.SENSOR_3_ACTIVE,
            0x300F to LcdIcon.MOTOR_A_BACKWARD,
            0x3016 to LcdIcon.MOTOR_C_FORWARD,
            0x301B to LcdIcon.LOW_BATTERY,
        )
        for ((code, icon) in icons) {
            assertFalse(LcdGlass.of(hardware.memory).isLit(icon))
            show(code)
            assertTrue(LcdGlass.of(hardware.memory).isLit(icon))
            hide(code)
        }
    }

    private fun show(code: Int) = hardware.call(RomAddress.SET_LCD_SEGMENT, code)

    private fun hide(code: Int) = hardware.call(RomAddress.CLEAR_LCD_SEGMENT, code)

    private fun litBytes(): Map<Int, Int> =
        (0xEF43..0xEF4B).associateWith(hardware.memory::readByte).filterValues { it != 0 }

    private fun dotsAfter(code: Int): String {
        show(code)
        val places = listOf(0xEF4A to 4, 0xEF4A to 0, 0xEF4B to 4, 0xEF4B to 0, 0xEF49 to 4)
        return places.joinToString("") { (address, bit) ->
            if (hardware.memory.readByte(address) shr bit and 1 == 1) {
                "*"
            } else {
                "."
            }
        }
    }
}
