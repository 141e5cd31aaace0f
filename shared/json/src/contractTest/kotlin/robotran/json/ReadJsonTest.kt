package robotran.json

import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class ReadJsonTest {
    private fun <T> read(text: String, read: (JsonCursor) -> T): T =
        assertIs<JsonReading.Success<T>>(readJson(text, read = read, language = Language.ENGLISH)).value

    private fun refusal(text: String, read: (JsonCursor) -> Any?): JsonReading.Failure =
        assertIs<JsonReading.Failure>(readJson(text, read = read, language = Language.ENGLISH))

    @Test
    fun `the line is that of the name, wherever its value begins`() {
        val text = "{\n\"a\" :\n[ {\"x\": 1},\n\n{ \"b\" : \"}]\\\"\" , \"c\":[[]\n,5 ] }\n]}"
        val c = { place: JsonCursor -> place.member("a").items(0..9)[1].member("c") }
        assertEquals(
            JsonReading.Failure("Line 6: a[1].c[1] must be a text in quotes.", 6, "a[1].c[1]"),
            refusal(text) { c(it).items(0..9)[1].text(5) },
        )
        assertEquals(5, refusal(text) { c(it).flag() }.line)
        assertEquals(2, refusal(text) { it.member("a").flag() }.line)
        assertEquals(5, refusal(text) { it.member("a").items(0..9)[1].member("d") }.line)
        assertEquals(1, refusal(text) { it.member("z") }.line)
    }

    @Test
    fun `names are found however they are written`() {
        val text = "{\"x\\n\\\"\\\\\\/\\b\\f\\r\\t\":0,\n\"\\u0061\\u00e9\":1}"
        assertEquals(2, refusal(text) { it.member("a\u00e9").flag() }.line)
        assertEquals(1, refusal(text) { it.member("x\n\"\\/\b\u000C\r\t").flag() }.line)
    }

    @Test
    fun `what nobody asked for is left, also within what somebody asked for`() {
        val text = """{"a": 1, "b": {"c": 2, "d": {"e": 3, "f": 4}}, "g": {"h": 5}, "i": {"j": 6}}"""
        val rest = read(text) { file ->
            file.member("a")
            file.member("b").member("d").member("e")
            file.member("g").member("h")
            assertEquals(mapOf("j" to JsonPrimitive(6)), file.member("i").rest())
            file.rest()
        }
        assertEquals("""{"b":{"c":2,"d":{"f":4}}}""", writeCompactJson(JsonObject(rest)))
    }

    @Test
    fun `the rest is put back where it was`() {
        val known = jsonObject {
            number("a", 1)
            put("b", jsonObject { number("c", 2) })
        }
        val rest = mapOf(
            "b" to JsonObject(mapOf("d" to JsonPrimitive(3))),
            "e" to JsonPrimitive(4),
            "a" to JsonPrimitive(5),
        )
        assertEquals("""{"a":1,"b":{"c":2,"d":3},"e":4}""", writeCompactJson(known.withRest(rest)))
    }

    @Test
    fun `whole numbers are whole however they are written`() {
        assertEquals(12, read("12.0") { it.wholeNumber(0..20) })
        assertEquals(1200, read("1.2e3") { it.wholeNumber(0..2000) })
        assertEquals(5_000_000_000, read("5000000000") { it.longNumber(0..9_000_000_000) })
        assertEquals(
            "Line 1: the file must be a whole number from 0 to 20.",
            refusal("1e30") { it.wholeNumber(0..20) }.message,
        )
        assertEquals(
            "Line 1: the file must be a whole number from 0 to 9000000000.",
            refusal("-1e30") { it.longNumber(0..9_000_000_000) }.message,
        )
    }

    @Test
    fun `what the parser lets pass is refused all the same`() {
        listOf("nan", "[01]", "{\"a\": tru}", "+1", "'a'", "[1.]", "{\"a\": {\"b\": [0, .5]}}").forEach {
            refusal(it) { }
        }
        listOf(
            "{a: 1}",
            "[1,]",
            "{\"a\":1,}",
            "[1 2]",
            "// a\n1",
            "1 1",
            "\"a\nb\"",
            "\"\\x\"",
            "\"\\u12\"",
            "\"\\",
            "\"",
        ).forEach {
            refusal(it) { }
        }
    }
}
