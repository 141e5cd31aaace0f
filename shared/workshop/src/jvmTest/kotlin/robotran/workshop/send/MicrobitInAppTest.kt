package robotran.workshop.send

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.microbitlink.MicrobitBoard
import robotran.programs.Program
import robotran.workshop.Workshop
import robotran.workshop.documents.MemoryFilePicker
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.MicrobitSendStep
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull

/** A pupil's program on its way onto a board, from the app's menu on. */
@OptIn(ExperimentalCoroutinesApi::class)
class MicrobitInAppTest {
    private val files = MemoryFilePicker()

    @Test
    fun `sending to my robot opens the sheet for a micro bit, and the program is in the file`() = inApp { workshop ->
        workshop.handle(SendEvent.Requested)
        assertIs<MicrobitSendStep.Choosing>(end(workshop))
        assertNull(workshop.state.send)
        files.chosen = listOf(OpenedFile("v2.hex", madeUpHex(MicrobitBoard.V2)))
        workshop.handle(MicrobitSendEvent.MicroPythonRequested)
        end(workshop)
        assertEquals("v2.hex", workshop.state.microbitSend?.microPython?.file)
        files.location = "/home/ada/drive.hex"
        workshop.handle(MicrobitSendEvent.HexSaved)
        assertEquals(MicrobitSendStep.HexSaved("drive.hex"), end(workshop))
        val main = assertNotNull(programsIn(files.disk.getValue("/home/ada/drive.hex"))[MicrobitBoard.V2])
        assertContains(main, "from microbit import")
        workshop.handle(MicrobitSendEvent.Cancelled)
        end(workshop)
        assertNull(workshop.state.microbitSend)
    }

    @Test
    fun `a mistake is told with its line, and shown there`() = inApp(text = "forward 5\nforwrd 5\n") { workshop ->
        workshop.handle(SendEvent.Requested)
        assertEquals(2, assertIs<MicrobitSendStep.HasErrors>(end(workshop)).first.range?.line)
        workshop.handle(MicrobitSendEvent.LineShown)
        assertNull(workshop.state.microbitSend)
    }

    @Test
    fun `a V1 takes MicroPython for V1`() = inApp(BrickKind.MICROBIT_V1) { workshop ->
        workshop.handle(SendEvent.Requested)
        end(workshop)
        files.chosen = listOf(OpenedFile("v1.hex", madeUpHex(MicrobitBoard.V1)))
        files.location = "/home/ada/drive.hex"
        workshop.handle(MicrobitSendEvent.MicroPythonRequested)
        end(workshop)
        workshop.handle(MicrobitSendEvent.HexSaved)
        assertEquals(MicrobitSendStep.HexSaved("drive.hex"), end(workshop))
    }

    private fun inApp(
        brick: BrickKind = BrickKind.MICROBIT,
        text: String = "forward 20\nbeep\n",
        check: suspend TestScope.(Workshop) -> Unit,
    ) = runTest {
        val workshop = openWorkshop(platform = MemoryPlatform(files = files), scope = backgroundScope)
        workshop.handle(DocumentEvent.NewWithBrick(brick))
        end(workshop)
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("drive.robo", text)))
        check(workshop)
        workshop.close()
    }

    /** The step in which nothing is under way any more. */
    private fun TestScope.end(workshop: Workshop): MicrobitSendStep? {
        do testScheduler.advanceTimeBy(3_000) while (workshop.state.microbitSend?.step?.isBusy == true)
        return workshop.state.microbitSend?.step
    }
}
