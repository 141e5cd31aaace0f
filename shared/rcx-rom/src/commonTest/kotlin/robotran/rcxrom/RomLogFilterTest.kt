package robotran.rcxrom

import robotran.brick.log.CallGroup
import robotran.brick.log.CallLogFilter
import robotran.brick.log.CallOutcome
import robotran.brick.log.toCsv
import robotran.brick.log.toLogText
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCallText
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.log.RomLogEntry
import robotran.rcxrom.log.romCalls
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import kotlin.test.Test
import kotlin.test.assertEquals

class RomLogFilterTest {
    private val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))

    init {
        hardware.call(RomAddress.CONTROL_MOTOR, 0x2000, 1, 3)
        hardware.tick(10)
        hardware.rom.call(RomCall(RomAddress.REFRESH_LCD, emptyList()), sourceLine = 12)
        hardware.tick(10)
        hardware.rom.call(RomCall(0x1234, listOf(1)), sourceLine = 13)
        hardware.rom.call(RomCall(RomAddress.PLAY_TONE, listOf(RomCode.TONE, 440, 10)), sourceLine = 0)
    }

    private fun chosen(filter: CallLogFilter) = hardware.log.entries.filter(filter::accepts).romCalls().map {
        RomCallText.hexadecimal(it.call.address)
    }

    @Test
    fun `without conditions everything is chosen`() {
        assertEquals(listOf("0x1a4e", "0x27c8", "0x1234", "0x327c"), chosen(CallLogFilter()))
    }

    @Test
    fun `entries are chosen by what they are about`() {
        assertEquals(
            listOf("0x1a4e", "0x327c"),
            chosen(CallLogFilter(groups = setOf(CallGroup.MOTORS, CallGroup.SOUND))),
        )
        assertEquals(listOf("0x1234"), chosen(CallLogFilter(groups = setOf(CallGroup.UNKNOWN))))
    }

    @Test
    fun `entries are chosen by their line`() {
        assertEquals(listOf("0x27c8", "0x1234"), chosen(CallLogFilter(sourceLines = 8..13)))
        assertEquals(listOf("0x327c"), chosen(CallLogFilter(sourceLines = 0..0)))
    }

    @Test
    fun `entries are chosen by their time`() {
        assertEquals(listOf("0x27c8"), chosen(CallLogFilter(milliseconds = 1L..10L)))
    }

    @Test
    fun `entries are chosen by words and figures of their line in the written log`() {
        assertEquals(listOf("0x1a4e"), chosen(CallLogFilter(text = "Motor A")))
        assertEquals(listOf("0x327c"), chosen(CallLogFilter(text = "0x1773")))
        assertEquals(emptyList(), chosen(CallLogFilter(text = "Motor A", sourceLines = 12..12)))
    }

    @Test
    fun `those that did nothing can be chosen alone`() {
        assertEquals(listOf("0x1234"), chosen(CallLogFilter(onlyReported = true)))
    }

    @Test
    fun `a log is written as text`() {
        assertEquals(
            """
            0 0x1a4e 0x2000 1 3 ; motor A forward 3 ; 7
            10 0x27c8 ; refresh the LCD ; 12
            20 0x1234 1 ; nothing happens, no routine is known here ; 13
            20 0x327c 0x1773 440 10 ; queue tone of 440 Hz for 100 ms ; firmware

            """.trimIndent(),
            hardware.log.entries.toLogText(),
        )
    }

    @Test
    fun `a log is written as a table for a spreadsheet`() {
        assertEquals(
            listOf(
                "milliseconds,group,address,arguments,meaning,line,outcome",
                "0,motors,0x1a4e,0x2000 1 3,motor A forward 3,7,done",
                "10,display,0x27c8,,refresh the LCD,12,done",
                "20,unknown,0x1234,1,\"nothing happens, no routine is known here\",13,unknown_routine",
                "20,sound,0x327c,0x1773 440 10,queue tone of 440 Hz for 100 ms,,done",
                "",
            ),
            hardware.log.entries.toCsv().split("\r\n"),
        )
    }

    @Test
    fun `marks in a table are kept apart from its own`() {
        val entry = RomLogEntry(5, RomCall(RomAddress.REFRESH_LCD, emptyList()), "says \"so\"", 1, CallOutcome.DONE)
        assertEquals("5,display,0x27c8,,\"says \"\"so\"\"\",1,done\r\n", listOf(entry).toCsv().substringAfter("\r\n"))
    }

    @Test
    fun `the line of a program with several files has its file before it`() {
        val entry =
            RomLogEntry(
                5,
                RomCall(RomAddress.REFRESH_LCD, emptyList()),
                "refresh the LCD",
                7,
                CallOutcome.DONE,
                "Robot.java",
            )
        assertEquals("5 0x27c8 ; refresh the LCD ; Robot.java:7", entry.text)
        assertEquals("5,display,0x27c8,,refresh the LCD,Robot.java:7,done", listOf(entry).toCsv().lines()[1].trimEnd())
    }
}
