package robotran.world.file

import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class RejectedWorldTest {
    @Test
    fun `text that is not JSON is refused with its line`() {
        assertEquals(
            "Line 4: a comma is missing at its end, before the next entry.",
            refusalWith("\"Everything\",", "\"Everything\""),
        )
        assertEquals(
            "Line 4 has a text that is not closed with a quote.",
            refusalWith("\"Everything\",", "\"Everything,"),
        )
        assertEquals("The file is empty.", refusal("").message)
        assertEquals("Line 1 opens a { that no } closes.", refusal("{\n\n").message)
        assertEquals("Line 1: \\u0000 cannot stand there.", refusal("\u0000\uD800").message)
    }

    @Test
    fun `JSON that is no world is refused`() {
        val notWorld = "This is not a Robotran world: a world file says \"format\": \"robotran-world\"."
        assertEquals(notWorld, refusal("{}").message)
        assertEquals("Line 2: $notWorld", refusalWith("\"robotran-world\"", "\"something else\""))
        assertEquals("Line 1: the file must be an object in braces.", refusal("[]").message)
        assertEquals("Line 1: the file must be an object in braces.", refusal("null").message)
    }

    @Test
    fun `a world of a newer version is refused as such`() {
        assertEquals(
            "Line 3: This world was made by a newer Robotran (it has version 3, this Robotran reads up to 2).",
            refusalWith("\"version\": 2", "\"version\": 3"),
        )
        assertEquals("Line 3: version must be from 1 to 2.", refusalWith("\"version\": 2", "\"version\": 0"))
        assertEquals("Line 3: version must be a number.", refusalWith("\"version\": 2", "\"version\": \"2\""))
    }

    @Test
    fun `a refusal tells its line and its path by themselves too`() {
        assertEquals(
            WorldFileResult.Failure("Line 34: walls[0].thickness must be from 0.1 to 100.", 34, "walls[0].thickness"),
            refusal(FULL_WORLD.replaceFirst("\"thickness\": 1.5", "\"thickness\": 0")),
        )
    }

    @Test
    fun `where a name is there twice, the last one counts and is told`() {
        val title = "\"title\": \"Everything\","
        assertEquals("Line 5: title must not be empty.", refusalWith(title, "$title\n\"t\\u0069tle\": \" \","))
        assertEquals("Twice", loaded(FULL_WORLD.replaceFirst(title, "\"title\": 5, \"title\": \"Twice\",")).title)
    }

    @Test
    fun `a word without quotes is refused wherever it is`() {
        assertEquals("Line 6: NaN is not a number.", refusalWith("\"width\": 200", "\"width\": NaN"))
        assertEquals("Line 6: 0x64 is not a number.", refusalWith("\"width\": 200", "\"width\": 0x64"))
        assertEquals(
            "Line 6: a text stands in double quotes: \"deep\".",
            refusalWith("\"width\": 200", "\"width\": 200, \"depth\": deep"),
        )
    }

    @Test
    fun `a file that is too long or too deep is refused`() {
        assertEquals("The file is too long: more than 1000000 characters.", refusal(" ".repeat(1_000_001)).message)
        assertEquals("Line 2 opens too many brackets inside one another.", refusal("\n" + "[".repeat(900_000)).message)
        assertEquals("Line 1 opens too many brackets inside one another.", refusal("{\"a\":".repeat(150_000)).message)
    }

    @Test
    fun `a bracket in a text does not count as nesting`() {
        assertEquals(
            "[".repeat(50) + "\"",
            loaded(FULL_WORLD.replaceFirst("Everything", "[".repeat(50) + "\\\"")).title,
        )
    }

    @Test
    fun `bytes are read as UTF-8 with or without a byte order mark, and in old encodings with a warning`() {
        val text = FULL_WORLD.replaceFirst("Everything", "Überall")
        val world = WorldFileResult.Success(loaded(text))
        assertEquals<WorldFileResult>(world, readWorld(text.encodeToByteArray(), Language.ENGLISH))
        assertEquals<WorldFileResult>(world, readWorld("\uFEFF$text".encodeToByteArray(), Language.ENGLISH))
        val old =
            assertIs<WorldFileResult.Success>(
                readWorld(
                    ByteArray(text.length) {
                        text[it].code.toByte()
                    },
                    Language.ENGLISH,
                ),
            )
        assertEquals(world.world, old.world)
        assertEquals("The file is in Windows-1252, not in UTF-8.", old.warnings.single().message)
        assertEquals(
            "The file is not a text.",
            assertIs<WorldFileResult.Failure>(readWorld(byteArrayOf(0, -1, 3), Language.ENGLISH)).message,
        )
        assertEquals(
            "The file is too long: more than 1000000 characters.",
            assertIs<WorldFileResult.Failure>(
                readWorld(
                    ByteArray(10_000_000) {
                        ' '.code.toByte()
                    },
                    Language.ENGLISH,
                ),
            ).message,
        )
    }
}
