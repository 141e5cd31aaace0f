package robotran.workshop.learning

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.WorldGallery
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.examples.firstProgram
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** What a pupil begins with: on a new sheet, and in a world of the gallery. */
class WorldBeginningTest {
    private val workshop = runBlocking { openWorkshop(platform = MemoryPlatform()) }
    private val tabs get() = workshop.state.programs.programs.map { it.name }

    @AfterTest
    fun close() = workshop.close()

    private fun choose(name: String) = workshop.handle(LearningEvent.WorldChosen(name))

    private fun startOf(name: String) = checkNotNull(WorldGallery.named(name)?.lesson).program

    private fun speak(language: Language) =
        workshop.handle(SettingsEvent.SettingsChanged(workshop.settings.copy(language = language)))

    @Test
    fun `the first program as it came makes way for what each world brings, and comes back on the free sheet`() {
        for (name in WorldGallery.worlds.mapNotNull { found -> found.name.takeIf { found.lesson != null } }) {
            choose(name)
            assertEquals(listOf(startOf(name).name), tabs, name)
            assertEquals(startOf(name).text, workshop.state.programText, name)
            assertFalse(workshop.state.learning.worldTask?.canStart ?: true, name)
        }
        choose("plain")
        assertEquals(firstProgram(Language.ENGLISH).files.single().text, workshop.state.programText)
    }

    @Test
    fun `a first program that the pupil has changed stays, and the world only offers its own`() {
        workshop.handle(ProgramEvent.ProgramEdited("forward 7\n"))
        choose("maze")
        assertEquals("forward 7\n", workshop.state.programText)
        assertTrue(workshop.state.learning.worldTask?.canStart ?: false)
    }

    @Test
    fun `a beginning that the pupil has changed comes along to the next world`() {
        choose("maze")
        workshop.handle(ProgramEvent.ProgramEdited("forward 9\n"))
        choose("corridor")
        assertEquals(listOf(startOf("maze").name), tabs)
        assertEquals("forward 9\n", workshop.state.programText)
    }

    @Test
    fun `who has only what a world brought in NQC begins the next one in NQC`() {
        choose("slalom")
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.NQC))
        workshop.handle(LearningEvent.WorldProgramRequested)
        assertEquals("slalom.nqc", workshop.state.programName)
        while (tabs.size > 1) workshop.handle(ProgramEvent.ProgramClosed(tabs.indexOfFirst { it != "slalom.nqc" }))
        choose("maze")
        assertEquals(listOf("maze.nqc"), tabs)
    }

    @Test
    fun `the first program makes way in any language, and its note follows the language until it is changed`() {
        for (language in Language.entries) {
            speak(language)
            assertEquals(firstProgram(language, language).text, workshop.state.programText)
        }
        choose("maze")
        assertEquals(listOf(startOf("maze").name), tabs)
        choose("plain")
        workshop.handle(ProgramEvent.ProgramEdited("forward 7\n"))
        speak(Language.SPANISH)
        assertEquals("forward 7\n", workshop.state.programText)
    }

    @Test
    fun `the first program has one note, and six blocks`() {
        for (language in Language.entries) {
            val lines = firstProgram(language).files.single().text.trim().lines()
            assertTrue(lines.first().startsWith("// ") && lines.first().length <= LINE, lines.first())
            assertEquals(0, lines.drop(1).count { "//" in it || it.isBlank() })
            assertEquals(6, lines.drop(1).count { it.trim() != "end" })
        }
        assertEquals(Language.entries.size, Language.entries.map { firstProgram(it) }.toSet().size)
    }

    private companion object {
        /** What a phone shows of a line, with the two slashes. */
        const val LINE = 43
    }
}
