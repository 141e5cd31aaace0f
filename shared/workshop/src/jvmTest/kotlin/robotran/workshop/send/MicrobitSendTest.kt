package robotran.workshop.send

import kotlinx.coroutines.ExperimentalCoroutinesApi
import robotran.microbitlink.BoardError
import robotran.microbitlink.FlashErrorKind
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.Remains
import robotran.microbitlink.simulated.CableFaults
import robotran.microbitlink.simulated.InjectedError
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.state.ChoosingProblem
import robotran.workshop.state.FoundBoard
import robotran.workshop.state.MicrobitSendStep
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** From a program over USB to a simulated board. */
@OptIn(ExperimentalCoroutinesApi::class)
internal class MicrobitSendTest : MicrobitSendBench() {
    @Test
    fun `where MicroPython is on the board the program alone goes there, starts, and prints`() = onSheet {
        request()
        assertEquals(MicrobitSendStep.Found, after(MicrobitSendEvent.UsbRequested))
        assertEquals(FoundBoard(MicrobitBoard.V2), sending.state?.board)
        assertEquals(MicrobitSendStep.Running(), after(MicrobitSendEvent.Confirmed))
        assertEquals(MAIN, boards.board.python.main)
        assertTrue(boards.board.python.isRunning)
        boards.board.python.print("hello\r\n")
        assertEquals(listOf("hello"), assertIs<MicrobitSendStep.Running>(end()).console.lines)
    }

    @Test
    fun `a board without MicroPython gets everything`() = onSheet(board = EMPTY) {
        request()
        choose(MicrobitBoard.V2)
        assertEquals(MicrobitSendStep.Found, after(MicrobitSendEvent.UsbRequested))
        sending.handle(MicrobitSendEvent.Confirmed)
        assertTrue(steps().any { it is MicrobitSendStep.Sending && it.isWhole && it.progress != null })
        assertEquals(MicrobitSendStep.Running(), end())
        assertEquals(MAIN, boards.board.python.main)
    }

    @Test
    fun `without MicroPython anywhere the pupil is told that Python does not answer`() = onSheet(board = EMPTY) {
        request()
        after(MicrobitSendEvent.UsbRequested)
        assertEquals(MicrobitSendStep.Failed(BoardError.NoPython), after(MicrobitSendEvent.Confirmed))
    }

    @Test
    fun `the second time the same board is taken without a question`() = onSheet {
        send()
        sending.handle(MicrobitSendEvent.Cancelled)
        end()
        assertNull(sending.state)
        request()
        assertIs<MicrobitSendStep.Running>(after(MicrobitSendEvent.UsbRequested))
        assertEquals(1, boards.questions)
        assertEquals(listOf(MY_BOARD, MY_BOARD), boards.opened)
    }

    @Test
    fun `of several boards the pupil takes one`() = onSheet {
        boards.boards = listOf(MY_BOARD, OTHER_BOARD)
        request()
        assertEquals(MicrobitSendStep.ManyBoards(boards.boards), after(MicrobitSendEvent.UsbRequested))
        assertEquals(MicrobitSendStep.Found, after(MicrobitSendEvent.BoardChosen(OTHER_BOARD)))
        assertEquals(listOf(OTHER_BOARD), boards.opened)
    }

    @Test
    fun `where the platform has no dialog the app asks for another board`() = onSheet {
        request()
        assertEquals(MicrobitSendStep.Found, after(MicrobitSendEvent.UsbRequested))
        boards.several = listOf(MY_BOARD, OTHER_BOARD)
        assertEquals(MicrobitSendStep.ManyBoards(boards.several), after(MicrobitSendEvent.OtherBoardRequested))
        assertEquals(MicrobitSendStep.Found, after(MicrobitSendEvent.BoardChosen(OTHER_BOARD)))
        assertEquals(listOf(MY_BOARD, OTHER_BOARD), boards.opened)
    }

    @Test
    fun `whoever closes the platform's dialog is back where he was`() = onSheet {
        boards.chosen = null
        request()
        val choosing = assertIs<MicrobitSendStep.Choosing>(after(MicrobitSendEvent.UsbRequested))
        assertEquals(ChoosingProblem.NoBoard, choosing.problem)
    }

    @Test
    fun `another board than the robot's is told before anything is sent`() =
        onSheet(board = { boardWith(MicrobitBoard.V1) }) {
            request()
            after(MicrobitSendEvent.UsbRequested)
            assertEquals(FoundBoard(MicrobitBoard.V1, expected = MicrobitBoard.V2), sending.state?.board)
            assertEquals(MicrobitSendStep.Found, end())
            assertEquals(OLD, boards.board.python.main)
        }

    @Test
    fun `a file that is cancelled leaves a part, which is told, and the next try is whole`() = onSheet(board = EMPTY) {
        request()
        choose(MicrobitBoard.V2)
        after(MicrobitSendEvent.UsbRequested)
        sending.handle(MicrobitSendEvent.WholeRequested)
        while ((sending.state?.step as? MicrobitSendStep.Sending)?.progress == null) testScheduler.advanceTimeBy(1)
        sending.handle(MicrobitSendEvent.Cancelled)
        assertEquals(MicrobitSendStep.Cancelled(Remains.PART), end())
        assertIs<MicrobitSendStep.Running>(after(MicrobitSendEvent.Retried))
        assertEquals(MAIN, boards.board.python.main)
    }

    @Test
    fun `a board that is unplugged in the middle is told, and gets the program with the next try`() =
        onSheet(board = EMPTY) {
            request()
            choose(MicrobitBoard.V2)
            boards.faults = CableFaults(packetsUntilUnplugged = 12)
            after(MicrobitSendEvent.UsbRequested)
            val failed = assertIs<MicrobitSendStep.Failed>(after(MicrobitSendEvent.WholeRequested))
            assertEquals(BoardError.BrokenOff to Remains.PART, failed.error to failed.remains)
            boards.faults = CableFaults()
            assertIs<MicrobitSendStep.Running>(after(MicrobitSendEvent.Retried))
            assertEquals(MAIN, boards.board.python.main)
        }

    @Test
    fun `a refused file is told with its number`() = onSheet(board = EMPTY) {
        request()
        choose(MicrobitBoard.V2)
        boards.faults = CableFaults(injectedError = InjectedError(number = 25, at = 3, times = 100))
        after(MicrobitSendEvent.UsbRequested)
        val failed = assertIs<MicrobitSendStep.Failed>(after(MicrobitSendEvent.WholeRequested))
        assertEquals(BoardError.Refused(25, FlashErrorKind.NOT_FOR_THIS_BOARD), failed.error)
    }

    @Test
    fun `an error of the program is told at the pupil's line`() = onSheet {
        send()
        boards.board.python.print(
            "Traceback (most recent call last):\r\n  File \"main.py\", line 2, in <module>\r\n" +
                "ZeroDivisionError: divide by zero\r\n",
        )
        assertEquals(20, assertIs<MicrobitSendStep.Running>(end()).errorLine)
        sending.handle(MicrobitSendEvent.LineShown)
        assertNull(sending.state)
        assertEquals(20, tabs.shown?.range?.line)
    }

    @Test
    fun `a board that is unplugged while its program runs is no mistake`() = onSheet {
        send()
        boards.port?.unplug()
        assertTrue(assertIs<MicrobitSendStep.Running>(end()).isGone)
    }

    @Test
    fun `a board that another app has is told`() = onSheet {
        boards.failure = BoardError.Taken
        request()
        assertEquals(MicrobitSendStep.Failed(BoardError.Taken), after(MicrobitSendEvent.UsbRequested))
    }

    @Test
    fun `a platform that lets nobody ask for a board says so`() = onSheet {
        boards.boards = emptyList()
        boards.refused = BoardError.NotAllowed
        request()
        assertEquals(MicrobitSendStep.Failed(BoardError.NotAllowed), after(MicrobitSendEvent.UsbRequested))
    }

    @Test
    fun `a mistake is told instead of anything that would be sent`() = onSheet(
        translation = MicrobitTranslation.Failure(listOf(MISTAKE)),
    ) {
        request()
        assertEquals(MicrobitSendStep.HasErrors(MISTAKE), end())
        sending.handle(MicrobitSendEvent.LineShown)
        assertEquals(MISTAKE, tabs.shown)
    }
}
