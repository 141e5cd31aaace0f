package robotran.microbitlink.link

import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.runTest
import robotran.microbitlink.BoardError
import robotran.microbitlink.BoardResult
import robotran.microbitlink.FlashErrorKind
import robotran.microbitlink.ImageError
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.Remains
import robotran.microbitlink.SendProgress
import robotran.microbitlink.SendResult
import robotran.microbitlink.files.MAIN_FILE
import robotran.microbitlink.madeUp
import robotran.microbitlink.madeUpForBoth
import robotran.microbitlink.simulated.CableFaults
import robotran.microbitlink.simulated.InjectedError
import robotran.microbitlink.value
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class FlashTest {
    private val program = programOf(2_000)

    private fun whole(board: MicrobitBoard): String =
        madeUpForBoth.imageFor(board).value().withFiles(mapOf(MAIN_FILE to program)).value().hexText()

    @Test
    fun `a board tells what it is`() = runTest {
        val second = TestBoard(this).open()
        assertEquals(MicrobitBoard.V2 to 257, second.board to second.daplink)
        assertEquals(48, second.serialNumber.length)
        val first = TestBoard(this, MicrobitBoard.V1).open()
        assertEquals(MicrobitBoard.V1 to null, first.board to first.daplink)
    }

    @Test
    fun `another board with the same interface is no micro bit`() = runTest {
        for (id in listOf("0240", "9902", "zzzz")) {
            assertEquals(BoardResult.Failure(BoardError.NotAMicrobit), TestBoard(this, id = id).link.open(), id)
        }
    }

    @Test
    fun `answers to an earlier session are read away`() = runTest {
        val stale = listOf(byteArrayOf(0x05, 1), byteArrayOf(0x83.toByte(), 62), byteArrayOf(0x8C.toByte(), 0))
        assertEquals(MicrobitBoard.V2, TestBoard(this, faults = CableFaults(staleAnswers = stale)).open().board)
    }

    @Test
    fun `a whole file is sent to both boards and started`() = runTest {
        for (type in MicrobitBoard.entries) {
            val test = TestBoard(this, type)
            test.open()
            val seen = mutableListOf<SendProgress>()
            val watching = backgroundScope.launch {
                test.link.state.collect { state ->
                    state.sending?.let { seen += it }
                }
            }
            assertEquals(SendResult.Success(attempts = 1), test.link.flash(madeUpForBoth, program), "$type")
            watching.cancel()
            assertEquals(whole(type), test.text, "$type")
            assertContentEquals(program, test.board.python.files[MAIN_FILE])
            assertEquals(1, test.board.starts)
            assertEquals(Remains.AS_SENT, test.link.state.value.holds)
            assertTrue(seen.first().sent == 0 && seen.zipWithNext().all { (a, b) -> a.sent <= b.sent }, "$seen")
        }
    }

    @Test
    fun `a file that is not for this board or too large is refused before anything is sent`() = runTest {
        val test = TestBoard(this)
        test.open()
        val before = test.port.packets
        val first = madeUp(MicrobitBoard.V1)
        val other = BoardError.BadFile(ImageError.OtherBoard(MicrobitBoard.V2))
        assertEquals(SendResult.Failure(other), test.link.flash(first, program))
        val large = BoardError.BadFile(ImageError.TooLarge(20_151, 20_150))
        assertEquals(SendResult.Failure(large), test.link.flash(madeUpForBoth, programOf(20_151)))
        val empty = BoardError.BadFile(ImageError.EmptyFile(MAIN_FILE))
        assertEquals(SendResult.Failure(empty), test.link.flash(madeUpForBoth, ByteArray(0)))
        assertEquals(before, test.port.packets)
        assertEquals(test.oldText, test.text)
    }

    @Test
    fun `what a board refuses once is sent again`() = runTest {
        for (at in listOf(1, 7, 60)) {
            val test = TestBoard(this, faults = CableFaults(injectedError = InjectedError(number = 21, at = at)))
            test.open()
            assertEquals(SendResult.Success(attempts = 2), test.link.flash(madeUpForBoth, program), "at $at")
            assertEquals(whole(MicrobitBoard.V2), test.text)
        }
    }

    @Test
    fun `what a board refuses for good is told with its number`() = runTest {
        val lasting = TestBoard(this, faults = CableFaults(injectedError = InjectedError(number = 29, at = 1)))
        lasting.open()
        val other = SendResult.Failure(BoardError.Refused(29, FlashErrorKind.OTHER_BOARD), Remains.PART)
        assertEquals(other, lasting.link.flash(madeUpForBoth, program))
        val always =
            TestBoard(this, faults = CableFaults(injectedError = InjectedError(number = 17, at = 1, times = 1_000)))
        always.open()
        val writing = SendResult.Failure(BoardError.Refused(17, FlashErrorKind.WRITING), Remains.PART)
        assertEquals(writing, always.link.flash(madeUpForBoth, program))
    }

    @Test
    fun `the same number is the end on an old board and an error on a new one`() = runTest {
        val old =
            TestBoard(
                this,
                MicrobitBoard.V1,
                CableFaults(injectedError = InjectedError(number = 16, at = 3, times = 9)),
            )
        old.open()
        // In the middle of a file, no end is the end.
        assertTrue(old.link.flash(madeUpForBoth, program) is SendResult.Failure)
        val new = TestBoard(this, MicrobitBoard.V1, daplink = 257)
        assertEquals(257, new.open().daplink)
        assertEquals(SendResult.Success(attempts = 1), new.link.flash(madeUpForBoth, program))
    }

    @Test
    fun `a board that is unplugged in the middle says so and what it holds`() = runTest {
        val test = TestBoard(this, faults = CableFaults(packetsUntilUnplugged = 60))
        test.open()
        val broken = SendResult.Failure(BoardError.BrokenOff, Remains.PART)
        assertEquals(broken, test.link.flash(madeUpForBoth, program))
        assertTrue(test.link.state.value.isGone)
        val gone = TestBoard(this)
        gone.open()
        gone.port.unplug()
        assertTrue((gone.link.flash(madeUpForBoth, program) as SendResult.Failure).error in NOT_THERE)
    }

    @Test
    fun `sending is cancelled and the board takes the next file`() = runTest {
        val test = TestBoard(this, faults = CableFaults(longestDelay = 20.milliseconds))
        test.open()
        val sending = launch { test.link.flash(madeUpForBoth, program) }
        delay(1.seconds)
        sending.cancel()
        sending.join()
        assertEquals(Remains.PART, test.link.state.value.holds)
        assertEquals(null, test.link.state.value.sending)
        assertTrue(test.text != whole(MicrobitBoard.V2))
        assertEquals(SendResult.Success(attempts = 1), test.link.flash(madeUpForBoth, program))
        assertEquals(whole(MicrobitBoard.V2), test.text)
    }

    private companion object {
        val NOT_THERE = setOf(BoardError.OutOfReach, BoardError.BrokenOff)
    }
}
