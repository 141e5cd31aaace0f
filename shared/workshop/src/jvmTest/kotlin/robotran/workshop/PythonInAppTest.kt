package robotran.workshop

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ShownLanguage
import robotran.programs.ProgramTranslation
import robotran.programs.SourceLine
import robotran.projects.ProgramView
import robotran.workshop.documents.Machine
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

/** A pupil sees a program for a robot with a hub in Python. */
class PythonInAppTest {
    private fun workshop(check: suspend (Workshop) -> Unit) = runBlocking {
        val workshop = openWorkshop()
        workshop.use(BrickKind.SPIKE_PRIME)
        check(workshop)
        workshop.close()
    }

    private suspend fun Workshop.use(brick: BrickKind) {
        handle(WorldEditEvent.PenbotChosen(state.programs.shownRobot, brick))
        compilePrograms()
    }

    private fun Workshop.write(text: String) = handle(ProgramEvent.ProgramEdited(text))

    private val Workshop.python: ProgramTranslation get() = assertNotNull(state.programs.translation)

    @Test
    fun `a program for a hub is shown in Python for that hub, and in nothing else`() = workshop { workshop ->
        assertEquals(listOf(ShownLanguage.PYTHON), workshop.state.programs.translationKinds)
        workshop.handle(ProgramEvent.TranslationShown(true))
        assertContains(workshop.python.text, "from pybricks.robotics import DriveBase")
        workshop.write("beep\n")
        assertContains(workshop.python.text, "from pybricks.hubs import PrimeHub")
        workshop.use(BrickKind.EV3)
        assertContains(workshop.python.text, "from pybricks.hubs import EV3Brick")
        workshop.use(BrickKind.RCX)
        assertFalse(ShownLanguage.PYTHON in workshop.state.programs.translationKinds)
    }

    @Test
    fun `each line of Python leads to its line, in text and in blocks`() = workshop { workshop ->
        workshop.write("pen down\nrepeat 4 times\n  forward 10\n  turn left 90\nend\n")
        workshop.handle(ProgramEvent.TranslationShown(true))
        for (view in listOf(ProgramView.TEXT, ProgramView.BLOCKS)) {
            workshop.handle(BlockEvent.ViewChosen(view))
            val lines = workshop.python.text.lines()
            val forward = workshop.python.linesOf(workshop.state.file.name, 3).single()
            assertEquals("    robot.straight(100)", lines[forward - 1])
            assertEquals(SourceLine(workshop.state.file.name, 3), workshop.python.originOf(forward))
        }
    }

    @Test
    fun `what is different on a hub stands above the Python, in the pupil's language`() = workshop { workshop ->
        workshop.write("forward 20\nshow \"hello\"\n")
        workshop.handle(ProgramEvent.TranslationShown(true))
        val notes = workshop.python.notes
        assertEquals(listOf(1, 2), notes.map { it.line })
        workshop.handle(SettingsEvent.SettingsChanged(workshop.settings.copy(language = Language.GERMAN)))
        assertTrue(workshop.python.notes.first().message != notes.first().message)
    }

    @Test
    fun `what a hub cannot do is told while one types, with what to do instead`() = workshop { workshop ->
        workshop.write("beep\nwait until right bumper\nshow 2000000000\n")
        assertEquals(emptyList(), workshop.state.diagnostics)
        val notes = workshop.state.programs.notes
        assertEquals(listOf(2, 3), notes.map { it.line })
        assertTrue(notes.all { it.isWarning })
        assertContains(notes.first().diagnostic.message, "Use the one that it has, or build one on.")
        assertContains(notes.last().diagnostic.message, "Use a smaller number.")
        workshop.use(BrickKind.RCX)
        assertEquals(emptyList(), workshop.state.programs.notes.map { it.diagnostic.message })
    }

    @Test
    fun `the Python is saved as a file`() = runBlocking {
        val machine = Machine()
        val workshop = machine.window()
        workshop.use(BrickKind.SPIKE_PRIME)
        workshop.handle(ProgramEvent.TranslationShown(true))
        machine.files.location = "out"
        workshop.handle(DocumentEvent.TranslationSaved(workshop.python))
        assertEquals("square.py", machine.files.suggestion)
        assertEquals(workshop.python.text, machine.files.disk.getValue("out").decodeToString())
        workshop.close()
    }
}
