package robotran.world.file

import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class WorldCountsTest {
    private val start =
        "\"format\": \"robotran-world\", \"version\": 2, \"title\": \"T\", \"paper\": {\"width\": 1000, \"height\": " +
            "1000}, " +
            "\"robots\": [{\"start\": {\"x\": 900, \"y\": 900, \"heading\": 0}}]"

    private fun refused(fields: String): String =
        assertIs<WorldFileResult.Failure>(readWorld("{$start, $fields}", Language.ENGLISH)).message

    private fun check(field: String, item: String, max: Int) {
        loaded("{$start, ${list(field, item, max)}}")
        assertEquals(
            "Line 1: $field has ${max + 1} entries, but at most $max are allowed.",
            refused(
                list(
                    field,
                    item,
                    max + 1,
                ),
            ),
        )
    }

    private fun list(field: String, item: String, count: Int) = List(count) {
        item
    }.joinToString(",", "\"$field\": [", "]")

    @Test
    fun `there are only so many things`() {
        check("walls", "{\"from\": [0, 0], \"to\": [1, 0], \"thickness\": 1}", 200)
        check("barriers", "{\"circle\": {\"x\": 1, \"y\": 1, \"radius\": 1}}", 400)
        check("blocks", "{\"circle\": {\"x\": 1, \"y\": 1, \"radius\": 1}}", 100)
        check("marks", "{\"circle\": {\"x\": 1, \"y\": 1, \"radius\": 1}}", 500)
        check("lamps", "{\"x\": 1, \"y\": 1}", 20)
        check("goals", "{\"kind\": \"playSound\"}", 50)
        val robots = List(9) { "{\"name\": \"r$it\", \"start\": {\"x\": ${20 + 40 * it}, \"y\": 20, \"heading\": 0}}" }
        val nine = robots.joinToString(",", "\"robots\": [", "]")
        assertEquals("Line 1: robots has 9 entries, but at most 8 are allowed.", refused(nine))
        assertEquals("Line 1: robots has 0 entries, but at least 1 must be there.", refused("\"robots\": []"))
    }

    @Test
    fun `goals inside others count too`() {
        val many =
            "\"goals\": [" + "{\"kind\": \"all\", \"goals\": [{\"kind\": \"playSound\"}]},".repeat(25) +
                "{\"kind\": \"playSound\"}]"
        assertEquals("Line 1: goals[25] goes beyond the 50 goals that a world may have.", refused(many))
    }

    @Test
    fun `there are only so many points and cells`() {
        val stroke = List(2000) { "[$it, ${it % 2}]" }.joinToString(",", "[", "]")
        val strokes = { count: Int -> list("strokes", stroke, count).let { "\"template\": {$it}" } }
        loaded("{$start, ${strokes(10)}}")
        assertEquals(
            "Line 1: template.strokes[10][0] goes beyond the 20000 points that a world may have all together.",
            refused(strokes(11)),
        )

        val map = "{\"greyMap\": {\"x\": 0, \"y\": 0, \"cell\": 1, ${list("rows", "\"${"f".repeat(500)}\"", 250)}}}"
        loaded("{$start, ${list("marks", map, 2)}}")
        assertEquals(
            "Line 1: marks[2].greyMap goes beyond the 250000 cells that the grey maps of a world may have all " +
                "together.",
            refused(list("marks", map, 3)),
        )
    }

    @Test
    fun `a million of anything is refused by its count`() {
        assertEquals(
            "Line 1: barriers has 333000 entries, but at most 400 are allowed.",
            refused(list("barriers", "{}", 333_000)),
        )
        assertEquals(
            "Line 1: walls has 499000 entries, but at most 200 are allowed.",
            refused(list("walls", "1", 499_000)),
        )
        val corners = refused("\"barriers\": [{\"polygon\": [${List(100_000) { "[0,$it]" }.joinToString(",")}]}]")
        assertEquals("Line 1: barriers[0].polygon has 100000 entries, but at most 100 are allowed.", corners)
    }

    @Test
    fun `a number of a million digits is no trouble`() {
        assertEquals("Line 1: light must be from 0 to 100.", refused("\"light\": " + "9".repeat(990_000)))
        assertEquals(0.0, loaded("{$start, \"light\": 0.${"0".repeat(990_000)}1}").ambientLight)
    }
}
