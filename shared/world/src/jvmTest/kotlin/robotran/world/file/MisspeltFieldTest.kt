package robotran.world.file

import kotlinx.serialization.json.Json
import robotran.json.schema.misspellingsOf
import robotran.json.writeCompactJson
import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class MisspeltFieldTest {
    @Test
    fun `every field of a world that is misspelt is told with its right name`() {
        val slips = misspellingsOf(Json.parseToJsonElement(FULL_WORLD))
        assertTrue(slips.size > 150, "${slips.size}")
        val silent = slips.filterNot { slip ->
            when (val result = readWorld(writeCompactJson(slip.file), Language.ENGLISH)) {
                is WorldFileResult.Success -> {
                    result.warnings.any {
                        slip.written in it.path && "\"${slip.name}\"" in it.message
                    }
                }

                // What needs the field may be refused for that alone.
                is WorldFileResult.Failure -> {
                    slip.name in result.message ||
                        readWorld(writeCompactJson(slip.without), Language.ENGLISH) is WorldFileResult.Failure
                }
            }
        }
        assertEquals(emptyList(), silent.map { "${it.written} for ${it.name}" })
    }

    @Test
    fun `a misspelt field of a robot file is told, and the file opens`() {
        val text = """
            { "format": "robotran-robot", "version": 1, "title": "Wide",
              "wheels": { "trak": 20 } }
        """.trimIndent()
        val loaded = assertIs<RobotFileResult.Success>(readRobot(text, Language.ENGLISH))
        assertEquals(
            listOf("Line 2: wheels.trak is not known and does nothing; perhaps \"track\" is meant."),
            loaded.warnings.map { it.message },
        )
    }

    @Test
    fun `a world of version 1 tells its own names and lines`() {
        val text = """
            { "format": "robotran-world", "version": 1, "name": "Old", "paper": { "width": 90, "height": 90 },
              "walls": [{ "from": { "x": 1, "y": 1 }, "to": { "x": 9, "y": 1 }, "thickness": 1 }],
              "start": { "x": 40, "y": 40, "heading": 0 }, "seed": 1,
              "tsk": "Drive." }
        """.trimIndent()
        val loaded = assertIs<WorldFileResult.Success>(readWorld(text, Language.ENGLISH))
        assertEquals(
            listOf("Line 4: tsk is not known and does nothing; perhaps \"task\" is meant."),
            loaded.warnings.map { it.message },
        )
    }

    @Test
    fun `the worlds that come with Robotran have nothing misspelt`() {
        BuiltInWorlds.texts.forEach { (name, text) ->
            assertEquals(
                emptyList(),
                assertIs<WorldFileResult.Success>(readWorld(text, Language.ENGLISH)).warnings,
                name,
            )
        }
    }
}
