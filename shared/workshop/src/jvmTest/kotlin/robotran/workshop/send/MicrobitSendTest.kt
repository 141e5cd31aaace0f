package robotran.workshop.send

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.runTest
import robotran.documents.MemoryKeyValueStore
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.microbitlink.BoardError
import robotran.microbitlink.FlashErrorKind
import robotran.microbitlink.ImageError
import robotran.microbitlink.ImageResult
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.Remains
import robotran.microbitlink.drive.DriveResult
import robotran.microbitlink.drive.MicrobitDrive
import robotran.microbitlink.drive.MicrobitDrives
import robotran.microbitlink.drive.NoMicrobitDrives
import robotran.microbitlink.hex.HexMemory
import robotran.microbitlink.simulated.CableFaults
import robotran.microbitlink.simulated.InjectedError
import robotran.microbitlink.simulated.SimulatedBoard
import robotran.programs.Program
import robotran.workshop.documents.MemoryFilePicker
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.ChoosingProblem
import robotran.workshop.state.FoundBoard
import robotran.workshop.state.MicrobitSendStep
import robotran.workshop.state.MicrobitTransfer
import robotran.workshop.state.ProgramSize
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** From a program to a simulated board, to a file or to a drive. */
@OptIn(ExperimentalCoroutinesApi::class)
class MicrobitSendTest {
    private val files = MemoryFilePicker()
    private val store = MemoryKeyValueStore()

    @Test
    fun `MicroPython is chosen once and kept, and the program is saved in it`() = onSheet(canReach = false) {
        request()
        assertEquals(MicrobitSendStep.Choosing(emptySet()), end())
        assertNull(sending.state?.microPython)
        choose(MicrobitBoard.V2)
        assertEquals(MicrobitSendStep.Choosing(setOf(MicrobitTransfer.SAVE)), end())
        val found = assertNotNull(sending.state?.microPython)
        assertEquals("v2.hex" to mapOf(MicrobitBoard.V2 to "2.1.2"), found.file to found.versions)
        files.location = "/home/ada/square.hex"
        assertEquals(MicrobitSendStep.HexSaved("square.hex"), after(MicrobitSendEvent.HexSaved))
        assertEquals("square.hex", files.suggestion)
        assertEquals(mapOf<MicrobitBoard, String?>(MicrobitBoard.V2 to MAIN), programsIn(saved("square.hex")))
        // The next time, in another session of the app.
        val next = holder()
        next.handle(MicrobitSendEvent.Requested)
        testScheduler.advanceTimeBy(1_000)
        assertEquals(found, next.state?.microPython)
        assertEquals(MicrobitSendStep.Choosing(setOf(MicrobitTransfer.SAVE)), next.state?.step)
    }

    @Test
    fun `how full the board gets is told before and after MicroPython is chosen`() = onSheet {
        request()
        assertEquals(ProgramSize(MAIN.length, 20_150), sending.state?.size)
        choose(MicrobitBoard.V2)
        val room = madeUpMicroPython(MicrobitBoard.V2).smallestImage.room.largestMain
        assertEquals(ProgramSize(MAIN.length, room), sending.state?.size)
    }

    @Test
    fun `a file that is no good is told, and what was chosen before stays`() = onSheet {
        request()
        files.chosen = listOf(OpenedFile("holiday.hex", "no hex".encodeToByteArray()))
        sending.handle(MicrobitSendEvent.MicroPythonRequested)
        val choosing = assertIs<MicrobitSendStep.Choosing>(end())
        assertEquals(ChoosingProblem.OfFile("holiday.hex", ImageError.NotHex), choosing.problem)
        choose(MicrobitBoard.V2)
        files.chosen = listOf(OpenedFile("cut.hex", madeUpHex(MicrobitBoard.V2).copyOf(300)))
        sending.handle(MicrobitSendEvent.MicroPythonRequested)
        assertIs<ChoosingProblem.OfFile>(assertIs<MicrobitSendStep.Choosing>(end()).problem)
        assertEquals("v2.hex", sending.state?.microPython?.file)
    }

    @Test
    fun `MicroPython for the other board is told before anything is saved or sent`() = onSheet {
        request()
        choose(MicrobitBoard.V1)
        val problem = ChoosingProblem.OfProgram(ImageError.OtherBoard(MicrobitBoard.V2))
        // The board may have Python of its own.
        assertEquals(MicrobitSendStep.Choosing(setOf(MicrobitTransfer.USB), problem), end())
        sending.handle(MicrobitSendEvent.HexSaved)
        end()
        assertTrue(files.disk.isEmpty())
    }

    @Test
    fun `a program that is too large is told with both sizes`() = onSheet(main = "#".repeat(30_000)) {
        request()
        choose(MicrobitBoard.V2)
        val problem = assertIs<ChoosingProblem.OfProgram>(assertIs<MicrobitSendStep.Choosing>(end()).problem)
        assertEquals(30_000, assertIs<ImageError.TooLarge>(problem.error).bytes)
    }

    @Test
    fun `the program is saved as Python, too`() = onSheet {
        request()
        files.location = "/home/ada/main.py"
        assertEquals(MicrobitSendStep.PythonSaved("main.py"), after(MicrobitSendEvent.PythonSaved))
        assertEquals(MAIN, saved("main.py").decodeToString())
        files.full = true
        sending.handle(MicrobitSendEvent.BackRequested)
        end()
        sending.handle(MicrobitSendEvent.PythonSaved)
        assertEquals(ChoosingProblem.NotSaved, assertIs<MicrobitSendStep.Choosing>(end()).problem)
    }

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
    fun `the file goes straight onto a drive if there is one`() {
        val drive = PluggedDrive(DriveResult.Copied)
        onSheet(canReach = false, drives = drive) {
            request()
            choose(MicrobitBoard.V2)
            assertEquals(MicrobitSendStep.Choosing(setOf(MicrobitTransfer.DRIVE, MicrobitTransfer.SAVE)), end())
            assertEquals(MicrobitSendStep.Copied, after(MicrobitSendEvent.DriveRequested))
            assertEquals(MAIN, programsIn(checkNotNull(drive.hex))[MicrobitBoard.V2])
        }
        onSheet(canReach = false, drives = PluggedDrive(DriveResult.Refused("The file is damaged."))) {
            request()
            assertEquals(
                MicrobitSendStep.NotCopied("The file is damaged."),
                after(MicrobitSendEvent.DriveRequested),
            )
        }
    }

    @Test
    fun `the number that a board shows is explained once it is whole`() = onSheet(canReach = false) {
        request()
        choose(MicrobitBoard.V2)
        files.location = "/home/ada/square.hex"
        after(MicrobitSendEvent.HexSaved)
        sending.handle(MicrobitSendEvent.NumberEntered("52"))
        assertNull(assertIs<MicrobitSendStep.HexSaved>(end()).number.kind)
        sending.handle(MicrobitSendEvent.NumberEntered("529"))
        assertEquals(FlashErrorKind.OTHER_BOARD, assertIs<MicrobitSendStep.HexSaved>(end()).number.kind)
    }

    @Test
    fun `a platform that lets nobody ask for a board says so`() = onSheet {
        boards.boards = emptyList()
        boards.refused = BoardError.NotAllowed
        request()
        assertEquals(MicrobitSendStep.Failed(BoardError.NotAllowed), after(MicrobitSendEvent.UsbRequested))
    }

    @Test
    fun `of the drives of several boards none is written`() {
        val drives = object : MicrobitDrives {
            override val canWrite: Boolean get() = true

            override suspend fun available() =
                listOf(MicrobitDrive("/media/ada/MICROBIT"), MicrobitDrive("/media/ada/MICROBIT1"))

            override suspend fun copy(hex: ByteArray, drive: MicrobitDrive) = error("Nobody chose ${drive.path}.")
        }
        onSheet(canReach = false, drives = drives) {
            request()
            choose(MicrobitBoard.V2)
            val shown = assertIs<MicrobitSendStep.Choosing>(after(MicrobitSendEvent.DriveRequested))
            assertEquals(ChoosingProblem.SeveralBoards, shown.problem)
        }
    }

    @Test
    fun `MicroPython that was kept is read, also if the sheet was closed in the middle of that`() = onSheet {
        request()
        choose(MicrobitBoard.V2)
        sending.close()
        val again = holder()
        again.handle(MicrobitSendEvent.Requested)
        again.close()
        testScheduler.advanceTimeBy(1_000)
        again.handle(MicrobitSendEvent.Requested)
        testScheduler.advanceTimeBy(1_000)
        assertEquals("v2.hex", again.state?.microPython?.file)
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

    private class SendSheet(
        val scope: TestScope,
        val boards: PluggedBoards,
        val tabs: ShownLines,
        val files: MemoryFilePicker,
        val holder: () -> MicrobitSendStateHolder,
    ) {
        val sending = holder()
        val testScheduler get() = scope.testScheduler

        fun request() {
            sending.handle(MicrobitSendEvent.Requested)
            end()
        }

        fun choose(board: MicrobitBoard) {
            files.chosen = listOf(OpenedFile("${board.name.lowercase()}.hex", madeUpHex(board)))
            after(MicrobitSendEvent.MicroPythonRequested)
        }

        fun send() {
            request()
            after(MicrobitSendEvent.UsbRequested)
            assertIs<MicrobitSendStep.Running>(after(MicrobitSendEvent.Confirmed))
        }

        fun after(event: MicrobitSendEvent): MicrobitSendStep? {
            sending.handle(event)
            return end()
        }

        /** All steps until nothing is under way. */
        fun steps(): Set<MicrobitSendStep?> = buildSet {
            do {
                add(sending.state?.step)
                testScheduler.advanceTimeBy(20)
            } while (sending.state?.step?.isBusy == true)
        }

        /** The step in which nothing is under way any more. */
        fun end(): MicrobitSendStep? {
            do testScheduler.advanceTimeBy(1_000) while (sending.state?.step?.isBusy == true)
            return sending.state?.step
        }

        fun saved(name: String) = files.disk.getValue("/home/ada/$name")
    }

    private fun onSheet(
        main: String = MAIN,
        translation: MicrobitTranslation = MicrobitTranslation.Success(main, MicrobitBoard.V2, maxBytes = 20_150) {
            it *
                10
        },
        board: () -> SimulatedBoard = { boardWith(MicrobitBoard.V2) },
        canReach: Boolean = true,
        drives: MicrobitDrives = NoMicrobitDrives,
        check: suspend SendSheet.() -> Unit,
    ) = runTest {
        val boards = PluggedBoards(backgroundScope, board(), canReach)
        val tabs = ShownLines()
        val platform = MemoryPlatform(files = files, store = store, microbits = boards, microbitDrives = drives)
        val programs = object : MicrobitPrograms {
            override suspend fun build(program: Program) = translation
        }
        SendSheet(this, boards, tabs, files) {
            MicrobitSendStateHolder(platform, backgroundScope, ShownProgram, tabs, programs)
        }.check()
    }

    private companion object {
        const val MAIN = "from microbit import *\nprint(1 / 0)\n"
        const val OLD = "# the old program\n"
        val MISTAKE =
            Diagnostic(Severity.ERROR, "square.robo", SourceRange(3, 1, 5), "A micro:bit has no battery sensor.")

        /** A board without anything. */
        val EMPTY = { SimulatedBoard(checkNotNull(HexMemory.of(emptyList()))) }

        fun boardWith(type: MicrobitBoard): SimulatedBoard {
            val image = madeUpMicroPython(type).imageFor(type) as ImageResult.Success
            val filled = image.value.withFiles(mapOf("main.py" to OLD.encodeToByteArray())) as ImageResult.Success
            val isFirst = type == MicrobitBoard.V1
            return SimulatedBoard(filled.value.memory, if (isFirst) "9900" else "9904", if (isFirst) 253 else 257)
        }
    }
}
