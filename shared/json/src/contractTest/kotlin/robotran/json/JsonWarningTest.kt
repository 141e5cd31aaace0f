package robotran.json

import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

class JsonWarningTest {
    private fun warnings(text: String, read: (JsonCursor) -> Any?): List<JsonWarning> =
        assertIs<JsonReading.Success<Any?>>(readJson(text, read = read, language = Language.ENGLISH)).warnings

    /** Reads what a file of walls may have. */
    private fun walls(file: JsonCursor) {
        file.optional("title")
        file.optional("timeLimit")
        file.optional("walls")?.items(0..99)?.forEach { it.optional("colour") }
    }

    @Test
    fun `a field with a name near a known one is a warning with that name`() {
        val text = "{\"titel\": 1,\n\"walls\": [{},\n{\"color\": 2}]}"
        assertEquals(
            listOf(
                JsonWarning(
                    "Line 1: titel is not known and does nothing; perhaps \"title\" is meant.",
                    1,
                    "titel",
                ),
                JsonWarning(
                    "Line 3: walls[1].color is not known and does nothing; perhaps \"colour\" is meant.",
                    3,
                    "walls[1].color",
                ),
            ),
            warnings(text, ::walls),
        )
    }

    @Test
    fun `capitals and joints do not make another name, and other names are nobody's business`() {
        val named = { name: String -> warnings("{\"$name\": 1}", ::walls).map { it.path } }
        for (name in listOf("TITLE", "time_limit", "Time-Limit", "timelimit", "wals", "timeLimt")) {
            assertEquals(listOf(name), named(name))
        }
        for (name in listOf("title", "\$schema", "author", "x", "note", "tall", "limit", "_title")) {
            assertEquals(emptyList(), named(name), name)
        }
    }

    @Test
    fun `a name that is there twice is a warning, however it is written`() {
        assertEquals(
            listOf("Line 3: walls[0].a is there twice; only the last one counts."),
            warnings("{\"walls\": [{\"a\": 1,\n\"b\": 2,\n\"\\u0061\": 3}]}", ::walls).map { it.message },
        )
    }

    @Test
    fun `a missing field tells what may be meant for it`() {
        val rejected =
            assertIs<JsonReading.Failure>(readJson("{\"tittle\": 1}", Language.ENGLISH) { it.member("title") })
        assertEquals("Line 1: title is missing; perhaps \"tittle\" is meant for it.", rejected.message)
    }

    @Test
    fun `no more than the first warnings are told`() {
        val text = List(500) { "{\"color\": 1, \"color\": 2}" }.joinToString(prefix = "{\"walls\": [", postfix = "]}")
        val found = warnings(text) { file -> file.member("walls").items(0..500).forEach { it.optional("colour") } }
        assertEquals(JsonLimits.MAXIMUM_WARNINGS, found.size)
    }

    @Test
    fun `a file in an old encoding is read with a warning`() {
        val bytes = "{\"title\": \"Gr\u00FC\u00DFe\"}".map { it.code.toByte() }.toByteArray()
        val reading = readJson(bytes, Language.GERMAN) { it.member("title").text(9) }
        assertEquals(
            JsonReading.Success(
                "Gr\u00FC\u00DFe",
                listOf(JsonWarning("Die Datei ist in Windows-1252, nicht in UTF-8.")),
            ),
            reading,
        )
        assertIs<JsonReading.Failure>(readJson(byteArrayOf(0, 1, -1), Language.ENGLISH) { })
    }

    @Test
    fun `short names have no near ones`() {
        assertFalse(isNear("y", "x"))
        assertFalse(isNear("no", "on"))
        assertTrue(isNear("X", "x"))
        assertTrue(isNear("tsk", "task"))
    }
}
