package robotran.workshop

import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.projects.ProgramView
import robotran.projects.Project
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.world.Goal
import robotran.world.GoalCondition.InkLength
import robotran.world.file.BuiltInWorlds
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class WorkshopLanguageTest {
    private val workshop = runBlocking { openWorkshop() }
    private var now = 0L

    @AfterTest
    fun close() = workshop.close()

    private fun speak(language: Language) =
        workshop.handle(SettingsEvent.SettingsChanged(workshop.settings.copy(language = language)))

    private val diagnostic: String get() = workshop.state.programs.diagnostics.single().message

    @Test
    fun `mistakes are told in the language that is chosen, at once`() {
        speak(Language.ENGLISH)
        workshop.handle(ProgramEvent.ProgramEdited("foward 20"))
        assertEquals("There is no command \"foward\". Did you mean \"forward\"?", diagnostic)
        speak(Language.GERMAN)
        assertEquals("Es gibt keinen Befehl \"foward\". Meinst du \"forward\"?", diagnostic)
        speak(Language.SPANISH)
        assertEquals("No existe la orden \"foward\". ¿Querías decir \"forward\"?", diagnostic)
        assertEquals("foward 20", workshop.state.programText)
    }

    @Test
    fun `in blocks mistakes are quoted in the words that stand on them, in text in its own`() {
        speak(Language.GERMAN)
        workshop.handle(ProgramEvent.ProgramEdited("forward 20\nx = 5"))
        val inText = diagnostic
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        assertTrue("Schreib \"var\" davor" in inText, inText)
        assertTrue("Schreib \"variable\" davor" in diagnostic, diagnostic)
        workshop.handle(SettingsEvent.SettingsChanged(workshop.settings.copy(hasEnglishWords = true)))
        assertEquals(inText, diagnostic)
    }

    @Test
    fun `the goals of a world that nobody has run in yet are told anew`() {
        val world = BuiltInWorlds.plain.copy(goals = listOf(Goal(InkLength(atLeast = 10.5, atMost = null))))
        speak(Language.ENGLISH)
        workshop.services.editor.openProject(Project(world))
        assertEquals("Draw 10.5 cm or more.", workshop.state.session.goals.single().sentence)
        speak(Language.GERMAN)
        assertEquals("Zeichne 10,5 cm oder mehr.", workshop.state.session.goals.single().sentence)
    }

    @Test
    fun `a run that goes on is not disturbed by another language`() {
        speak(Language.ENGLISH)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(500)
        val before = workshop.state.session.robot.pose
        speak(Language.SPANISH)
        assertEquals(before, workshop.state.session.robot.pose)
        workshop.advance(20_000)
        workshop.handle(ProgramEvent.ProgramEdited("show 1 / 0"))
        assertEquals("Nada se puede dividir entre 0.", diagnostic)
    }

    @Test
    fun `the clock of a run that is over stays where it was in another language, and while somebody writes`() {
        speak(Language.ENGLISH)
        workshop.handle(ProgramEvent.ProgramEdited("forward 1\nbeep"))
        workshop.handle(RunEvent.RunPressed)
        frames()
        assertFalse(workshop.state.awake)
        val time = workshop.state.run.time
        speak(Language.GERMAN)
        frames()
        assertEquals(time, workshop.state.run.time)
        assertEquals(time, workshop.state.session.milliseconds)
        assertFalse(workshop.state.awake)
        workshop.handle(ProgramEvent.ProgramEdited("forward 2"))
        frames()
        assertEquals(time, workshop.state.run.time)
        workshop.handle(RunEvent.ButtonPressed(BrickButton.VIEW))
        frames()
        assertTrue(workshop.state.run.time > time)
    }

    private fun frames() = repeat(300) {
        now += 16_666_667
        workshop.frame(now)
    }
}
