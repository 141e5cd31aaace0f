package robotran.workshop

import kotlinx.coroutines.runBlocking
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.ProjectLimits
import robotran.textediting.EditKind
import robotran.textediting.text.TextDocument
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.WorkshopEvent
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull

class LongProgramTest {
    private val workshop = runBlocking { openWorkshop(listOf(Program.of("a.robo", "beep"))) }

    @AfterTest
    fun close() = workshop.close()

    private fun write(text: String) =
        workshop.handle(ProgramEvent.DraftChanged(TextDocument(text).withCaret(text.length), EditKind.OTHER))

    @Test
    fun `a program that becomes too long is refused in a sentence, and stays as it was`() {
        write("b".repeat(ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS + 1))
        assertEquals("beep", workshop.state.programText)
        assertNotNull(workshop.state.notice)
        workshop.handle(WorkshopEvent.NoticeDismissed)
        write("\n".repeat(ProjectLimits.MAXIMUM_LINES))
        assertEquals("beep", workshop.state.programText)
        assertNotNull(workshop.state.notice)
    }

    @Test
    fun `as much as there is room for is written`() {
        val max = "// ${"b".repeat(ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS - 3)}"
        write(max)
        assertEquals(max, workshop.state.programText)
        assertNull(workshop.state.notice)
        write("$max!")
        assertEquals(max, workshop.state.programText)
        write(max.dropLast(1))
        assertEquals(max.dropLast(1), workshop.state.programText)
    }

    @Test
    fun `all files of a Java program share the room`() {
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
        write("/* ${"b".repeat(ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS / 2)} */")
        workshop.handle(ProgramEvent.FileAdded)
        val before = workshop.state.programText
        write("/* ${"b".repeat(ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS / 2)} */")
        assertEquals(before, workshop.state.programText)
    }
}
