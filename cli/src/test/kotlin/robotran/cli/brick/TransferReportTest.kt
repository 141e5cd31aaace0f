package robotran.cli.brick

import robotran.cli.messages.CommandMessages
import robotran.console.RecordingConsole
import robotran.language.Language
import robotran.tower.RcxVersion
import robotran.tower.Remains
import robotran.tower.TowerError
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.firmware.FirmwareFileError
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class TransferReportTest {
    private val console = RecordingConsole()

    @Test
    fun `a transfer that has failed tells what the brick has now`() {
        val report = TransferReport(console, isTerminal = false, slot = 4)
        val failed = TransferResult.Failure(TowerError.BrickSilent, Remains.NO_PROGRAM)
        assertEquals(4, report.end(failed) { "never" }.status)
        val empty = "Slot 4 of the brick is empty now, and the other slots are as before. Send the program again."
        assertEquals(empty, console.complaints.last())
        assertEquals(2, console.complaints.size)
    }

    private fun progress(confirmed: Int, all: Int, secondsLeft: Int) =
        TransferProgress(confirmed, all, repeats = 0, secondsLeft)

    @Test
    fun `a terminal shows a bar that the end clears`() {
        val report = TransferReport(console, isTerminal = true)
        report.show(progress(0, 30, secondsLeft = 100))
        report.show(progress(15, 30, secondsLeft = 9))
        val (empty, half) = console.mentions
        assertEquals("\r[${" ".repeat(40)}] 0 of 30 blocks, 100 s left", empty)
        assertEquals("\r[${"#".repeat(20)}${" ".repeat(20)}] 15 of 30 blocks, 9 s left".padEnd(empty.length), half)
        assertEquals(0, report.end(TransferResult.Success(600, repeats = 0)) { "$it bytes" }.status)
        assertEquals("\r${" ".repeat(empty.length - 1)}\r", console.mentions.last())
        assertEquals("600 bytes", console.said.single())
    }

    @Test
    fun `elsewhere each tenth is a line`() {
        val report = TransferReport(console, isTerminal = false)
        for (block in 0..100) report.show(progress(block, 100, secondsLeft = 100 - block))
        assertEquals(10, console.mentions.size)
        assertEquals("10 of 100 blocks, 90 s left\n", console.mentions.first())
    }

    @Test
    fun `every error has a sentence of its own`() {
        val errors =
            listOf(
                TowerError.TowerGone,
                TowerError.TowerSilent,
                TowerError.BrickSilent,
                TowerError.NoLejos(),
                TowerError.NoLejos(RcxVersion(3, 28)),
                TowerError.NoLegoFirmware,
                TowerError.LegoFirmwareTooOld(RcxVersion(3, 9)),
                TowerError.BadConnection,
                TowerError.BatteryLow(millivolts = 6090),
                TowerError.TooLarge(bytes = 14_000, maxBytes = 13_788),
                TowerError.TooLarge(bytes = 700, maxBytes = null),
                TowerError.FirmwareRefused,
            )
        for (language in Language.entries) {
            val described = errors.map { CommandMessages.of(language).sentence(it) }
            assertEquals(errors.size, described.toSet().size, "$described")
            val remains = listOf(null, 3).flatMap { slot ->
                Remains.entries.map { CommandMessages.of(language).sentence(it, slot) }
            }
            // Only what a program leaves depends on the slot.
            assertEquals(Remains.entries.size + 2, remains.toSet().size, "$remains")
        }
        val sentences = errors.map { CommandMessages.of(Language.ENGLISH).sentence(it) }
        assertTrue("The batteries have only 6.0 V. Put new ones in first." in sentences, "$sentences")
        val files =
            listOf(
                FirmwareFileError.NotSRecords,
                FirmwareFileError.DamagedLine(3),
                FirmwareFileError.CutOff,
                FirmwareFileError.OutOfRange(4),
                FirmwareFileError.TooLarge(40_000),
                FirmwareFileError.NoRomText,
            ).map { CommandMessages.of(Language.ENGLISH).sentence(it, "f.srec") }
        assertTrue(files.toSet().size == 6 && files.all { it.startsWith("f.srec ") }, "$files")
    }
}
