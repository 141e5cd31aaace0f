package robotran.world.file

import kotlin.test.Test
import kotlin.test.assertEquals

class MigrationTest {
    private val plain = """
        {
          "format": "robotran-world",
          "version": 1,
          "name": "Plain sheet",
          "paper": { "width": 100, "height": 80 },
          "walls": [
            { "from": { "x": -0.5, "y": -0.5 }, "to": { "x": 100.5, "y": -0.5 }, "thickness": 1 },
            { "from": { "x": 100.5, "y": -0.5 }, "to": { "x": 100.5, "y": 80.5 }, "thickness": 1 },
            { "from": { "x": 100.5, "y": 80.5 }, "to": { "x": -0.5, "y": 80.5 }, "thickness": 1 },
            { "from": { "x": -0.5, "y": 80.5 }, "to": { "x": -0.5, "y": -0.5 }, "thickness": 1 }
          ],
          "start": { "x": 40, "y": 30, "heading": 0 },
          "seed": 1
        }
    """.trimIndent()

    private fun refusalWith(old: String, new: String): String = refusal(plain.replaceFirst(old, new)).message

    @Test
    fun `a world of version 1 is the same as it was`() {
        assertEquals(BuiltInWorlds.plain, loaded(plain))
    }

    @Test
    fun `a refusal names the fields as version 1 does`() {
        assertEquals("Line 4: name must not be empty.", refusalWith("Plain sheet", " "))
        assertEquals("Line 7: walls[0].from.x must be a number.", refusalWith("\"x\": -0.5", "\"x\": \"left\""))
        assertEquals("Line 7: walls[0].from.y must be from -1000 to 2000.", refusalWith("\"y\": -0.5", "\"y\": 5000"))
        assertEquals(
            "Line 7: walls[0].to must be an object in braces.",
            refusalWith("{ \"x\": 100.5, \"y\": -0.5 }", "[100.5, -0.5]"),
        )
        assertEquals("Line 7: walls[0].thickness is missing.", refusalWith("\"thickness\"", "\"width\""))
        assertEquals(
            "Line 12: start.heading must be from -360 to 360.",
            refusalWith("\"heading\": 0", "\"heading\": 400"),
        )
        assertEquals("Line 12: start puts the robot into walls[1].", refusalWith("\"x\": 40", "\"x\": 99"))
        assertEquals("Line 1: seed is missing.", refusalWith("\"seed\"", "\"luck\""))
        val newer = "Line 4: title belongs to version 2 of the format, but this file says version 1."
        assertEquals(newer, refusalWith("\"name\"", "\"title\""))
    }
}
