package robotran.projects

import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import robotran.json.JsonWarning
import robotran.json.schema.Misspelling
import robotran.json.schema.misspellingsOf
import robotran.json.writeCompactJson
import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class MisspeltProjectFieldTest {
    private class Read(val warnings: List<JsonWarning>, val refusal: String?)

    private fun project(file: JsonElement): Read =
        when (val result = readProject(writeCompactJson(file), Language.ENGLISH)) {
            is ProjectFileResult.Success -> Read(result.warnings, null)
            is ProjectFileResult.Failure -> Read(emptyList(), result.message)
        }

    private fun course(file: JsonElement): Read =
        when (val result = readCourse(writeCompactJson(file), Language.ENGLISH)) {
            is CourseFileResult.Success -> Read(result.warnings, null)
            is CourseFileResult.Failure -> Read(emptyList(), result.message)
        }

    private fun silent(file: JsonElement, read: (JsonElement) -> Read): List<String> =
        misspellingsOf(file).filterNot { slip ->
            val result = read(slip.file)
            result.warnings.any { slip.written in it.path && "\"${slip.name}\"" in it.message } ||
                (result.refusal != null && (isReported(slip, result.refusal) || read(slip.without).refusal != null))
        }.map { "${it.written} for ${it.name}" }

    /** Some objects may not have any other field. */
    private fun isReported(slip: Misspelling, refusal: String): Boolean =
        slip.name in refusal || "\"${slip.written}\"" in refusal

    @Test
    fun `every field of a project and an assignment that is misspelt is told with its right name`() {
        for (project in listOf(FULL_PROJECT, FIRMWARE_PROJECT, EVERY_ASSIGNMENT, EVERY_HAND_IN)) {
            val file = elementOf(project)
            assertEquals(null, project(file).refusal)
            assertEquals(emptyList(), silent(file, ::project))
        }
    }

    @Test
    fun `every field of a course that is misspelt is told with its right name`() {
        val course = JsonObject(
            elementOf(Course("C", "about\nit", listOf(EVERY_ASSIGNMENT), "c-1")).filterKeys { it != "assignments" },
        )
        val assignments = elementOf(Course("C", "", listOf(EVERY_ASSIGNMENT), "c-1")).getValue("assignments")
        val read = { file: JsonElement ->
            course(JsonObject(mapOf("assignments" to assignments) + (file as JsonObject)))
        }
        assertEquals(emptyList(), silent(course, read))
    }

    @Test
    fun `the files beside a course are read with their warnings`() {
        val written = writeProject(EVERY_ASSIGNMENT).replaceFirst("\"mayChangeWorld\"", "\"mayChangWorld\"")
        val course = """{"format": "robotran-course", "version": 1, "title": "C", "assignments": ["a.robotran"]}"""
        val loaded =
            assertIs<CourseFileResult.Success>(readCourse(course, Language.ENGLISH) { written.encodeToByteArray() })
        assertTrue(loaded.warnings.single().message.startsWith("a.robotran: Line "), "${loaded.warnings}")
        assertTrue("mayChangeWorld" in loaded.warnings.single().message, "${loaded.warnings}")
    }
}
