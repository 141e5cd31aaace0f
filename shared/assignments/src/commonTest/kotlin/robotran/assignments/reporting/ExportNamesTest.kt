package robotran.assignments.reporting

import robotran.assignments.packaging.ScormVersion
import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class ExportNamesTest {
    @Test
    fun `names tell pupil, assignment and what it is`() {
        val names = Language.entries.associateWith { feedbackFileName("Ida Meier", "the maze", it) }
        assertEquals("Ida Meier - feedback - the maze.robotran", names[Language.ENGLISH])
        assertEquals("Ida Meier - Rückmeldung - the maze.robotran", names[Language.GERMAN])
        assertEquals("Ida Meier - comentarios - the maze.robotran", names[Language.SPANISH])
        assertEquals("Ida (2) - feedback - the maze.robotran", feedbackFileName("Ida", "the maze", Language.ENGLISH, 2))
        assertEquals("the maze - Rückmeldung.zip", feedbackZipName("the maze", Language.GERMAN))
        assertEquals("the maze - SCORM 1.2.zip", packageFileName("the maze", ScormVersion.SCORM_1_2))
        assertEquals("the maze - SCORM 2004.zip", packageFileName("the maze", ScormVersion.SCORM_2004))
    }

    @Test
    fun `names are safe on all file systems`() {
        val name = feedbackFileName("../C:\\con?|\n<Ida>.robo", "a/b.", Language.ENGLISH)
        assertEquals("-C--con----Ida-.robo - feedback - a-b.robotran", name)
        val all =
            listOf("", "  ", "\uD83D\uDE00".repeat(60), "ü".repeat(60), "x\uD83D\uDE00".repeat(40), "漢".repeat(200))
        for (pupil in all) {
            for (title in all) {
                for (number in listOf(1, 500)) {
                    val long = feedbackFileName(pupil, title, Language.GERMAN, number)
                    val bytes = long.encodeToByteArray(throwOnInvalidSequence = true)
                    assertTrue(bytes.size <= 255 && "Rückmeldung" in long && long.endsWith(".robotran"), long)
                }
            }
        }
        val pupil = "Maximiliane ".repeat(5).take(55)
        assertEquals("$pupil - Rückmeldung - the maze.robotran", feedbackFileName(pupil, "the maze", Language.GERMAN))
        assertTrue(feedbackZipName("t".repeat(200), Language.SPANISH).endsWith("t - comentarios.zip"))
    }
}
