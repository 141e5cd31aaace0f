package robotran.workshop.send

import kotlinx.coroutines.ExperimentalCoroutinesApi
import robotran.microbitlink.FlashErrorKind
import robotran.microbitlink.ImageError
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.drive.DriveResult
import robotran.microbitlink.drive.MicrobitDrive
import robotran.microbitlink.drive.MicrobitDrives
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.ChoosingProblem
import robotran.workshop.state.MicrobitSendStep
import robotran.workshop.state.MicrobitTransfer
import robotran.workshop.state.ProgramSize
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** MicroPython that is chosen and kept, and programs that go into files and onto drives. */
@OptIn(ExperimentalCoroutinesApi::class)
internal class MicrobitFilesTest : MicrobitSendBench() {
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
}
