package robotran.tinyvm

import robotran.brick.program.ProgramStatus
import robotran.rcxrom.call.RomCall
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class RomTest {
    @Test
    fun `two motors are started by two calls`() {
        val ran =
            ran(
                "ROM.call((short) 0x1a4e, (short) 0x2000, (short) 1, (short) 3); ROM.call((short) 0x1a4e, (short) " +
                    "0x2002, (short) " +
                    "1, (short) 3);",
            )
        assertEquals(
            listOf(RomCall(0x1A4E, listOf(0x2000, 1, 3)), RomCall(0x1A4E, listOf(0x2002, 1, 3))),
            ran.rom.calls,
        )
        assertEquals(ProgramStatus.Ended, ran.status)
    }

    @Test
    fun `a call tells the line of the program it comes from`() {
        val call = "ROM.call((short) 0x1ff2, (short) 0x3001, (short) 7, (short) 0x3002);"
        assertEquals(listOf(5, 7), ran("int x = 1;\n$call\nx++;\n$call").rom.lines)
    }

    @Test
    fun `a routine leaves its result in an array`() = assertEquals(
        listOf(2),
        shownBy(
            "short[] result = new short[1]; ROM.call((short) 0x1fb6, (short) 0x3000, (short) " +
                "Memory.getDataAddress(result)); " +
                "show(result[0]);",
        ),
    )

    @Test
    fun `memory is read and written bit by bit`() = assertEquals(
        listOf(9, 13),
        shownBy(
            "Memory.writeByte(0xEF43, (byte) 9); show(Memory.readByte(0xEF43)); Memory.setBit(0xEF43, 2, 1); " +
                "show(Memory.readByte(0xEF43));",
        ),
    )

    @Test
    fun `an endless loop uses only its budget`() {
        val rom = RecordingRom()
        val run = linked(program("while (true) { }")).start(rom)
        repeat(1000) { assertIs<ProgramStatus.Running>(run.resume(100)) }
    }

    @Test
    fun `catching everything for ever can be stopped`() {
        val rom = RecordingRom()
        val run = linked(
            program(
                "while (true) { try { forever(); } catch (Throwable t) { } }",
                "static void forever() { forever(); " +
                    "}",
            ),
        ).start(rom)
        repeat(1000) { assertIs<ProgramStatus.Running>(run.resume(100)) }
    }
}
