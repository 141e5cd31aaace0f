package robotran.world

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class WorldFileTest {
    private val plain = BuiltInWorlds.texts.getValue("plain.world.json")

    private fun refusal(text: String): String = assertIs<WorldFileResult.Refused>(readWorld(text)).message

    private fun refusalWith(old: String, new: String): String {
        assertTrue(old in plain, "$old is in the file")
        return refusal(plain.replaceFirst(old, new))
    }

    private fun loaded(text: String): World = assertIs<WorldFileResult.Loaded>(readWorld(text), "$text").world

    @Test
    fun `the plain sheet has four walls and a start for a square in its middle`() {
        val world = loaded(plain)
        assertEquals("Plain sheet", world.title)
        assertEquals(Paper(100.0, 80.0), world.paper)
        assertEquals(4, world.walls.size)
        assertEquals(Wall(Point(-0.5, -0.5), Point(100.5, -0.5), 1.0), world.walls.first())
        assertEquals(Pose(40.0, 30.0, 0.0), world.start)
        assertEquals(1, world.seed)
    }

    @Test
    fun `every world that comes with Robotran can be read`() {
        BuiltInWorlds.texts.values.forEach(::loaded)
    }

    @Test
    fun `every example of the page on world files can be read`() {
        assertEquals(2, documentedWorlds.size)
        documentedWorlds.values.forEach(::loaded)
    }

    @Test
    fun `unknown fields are passed over`() {
        assertEquals(loaded(plain), loaded(plain.replaceFirst("\"seed\"", "\"lamps\": [{ \"x\": 1 }], \"seed\"")))
    }

    @Test
    fun `a heading is brought into half a turn to either side`() {
        assertEquals(-90.0, loaded(plain.replace("\"heading\": 0", "\"heading\": 270")).start.heading)
        assertEquals(180.0, loaded(plain.replace("\"heading\": 0", "\"heading\": -180")).start.heading)
    }

    @Test
    fun `text that is not JSON is refused with its line`() {
        assertEquals(
            "Line 5 of the world file cannot be read: something is missing or out of place there.",
            refusalWith("\"Plain sheet\",", "\"Plain sheet\""),
        )
        assertTrue(refusal("").startsWith("Line 1 of the world file"))
        assertTrue(refusal("{").startsWith("Line 1 of the world file"))
        assertTrue(refusal("\u0000\uD800").startsWith("Line 1 of the world file"))
    }

    @Test
    fun `JSON that is no world is refused`() {
        val notWorld = "This is not a Robotran world: a world file says \"format\": \"robotran-world\"."
        assertEquals(notWorld, refusal("{}"))
        assertEquals(notWorld, refusalWith("\"robotran-world\"", "\"something else\""))
        assertEquals("The world file must be an object in braces.", refusal("[]"))
        assertEquals("The world file must be an object in braces.", refusal("null"))
    }

    @Test
    fun `a world of a newer version is refused as such`() {
        assertEquals(
            "This world was made by a newer Robotran (it has version 2, this Robotran reads up to 1).",
            refusalWith("\"version\": 1", "\"version\": 2"),
        )
        assertEquals("There is no version 0 of the world format.", refusalWith("\"version\": 1", "\"version\": 0"))
    }

    @Test
    fun `a missing field is named with its place`() {
        assertEquals("The world file lacks name.", refusalWith("\"name\"", "\"nom\""))
        assertEquals("The world file lacks walls[0].thickness.", refusalWith("\"thickness\"", "\"width\""))
        assertEquals("The world file lacks start.heading.", refusalWith("\"heading\"", "\"facing\""))
        assertEquals("The world file lacks seed.", refusalWith("\"seed\"", "\"luck\""))
    }

    @Test
    fun `a value of the wrong kind is refused with its place`() {
        assertEquals("The world file's paper.width must be a number.", refusalWith("\"width\": 100", "\"width\": \"100\""))
        assertEquals("The world file's paper.width must be a number.", refusalWith("\"width\": 100", "\"width\": null"))
        assertEquals("The world file's paper.width must be a number.", refusalWith("\"width\": 100", "\"width\": NaN"))
        assertEquals("The world file's paper.width must be a number.", refusalWith("\"width\": 100", "\"width\": 0x64"))
        assertEquals("The world file's name must be a text in quotes.", refusalWith("\"Plain sheet\"", "7"))
        assertEquals("The world file's name must not be empty.", refusalWith("Plain sheet", " "))
        assertEquals("The world file's name must be one line of ordinary characters.", refusalWith("Plain sheet", "Plain\\nsheet"))
        assertEquals("The world file's start must be an object in braces.", refusalWith("{ \"x\": 40, \"y\": 30, \"heading\": 0 }", "3"))
        assertEquals("The world file's seed must be a whole number from 0 to 2147483647.", refusalWith("\"seed\": 1", "\"seed\": 1.5"))
    }

    @Test
    fun `a number out of range is refused`() {
        assertEquals("The world file's paper.width must be from 20 to 1000.", refusalWith("\"width\": 100", "\"width\": 1e400"))
        assertEquals("The world file's paper.height must be from 20 to 1000.", refusalWith("\"height\": 80", "\"height\": -80"))
        assertEquals("The world file's walls[0].thickness must be from 0.1 to 100.", refusalWith("\"thickness\": 1", "\"thickness\": 0"))
        assertEquals("The world file's walls[0].from.x must be from -1000 to 2000.", refusalWith("\"x\": -0.5", "\"x\": 1e99999999999999"))
    }

    @Test
    fun `a start beside the paper or in a wall is refused`() {
        assertEquals("The robot's start is beside the paper (at start).", refusalWith("\"x\": 40, \"y\"", "\"x\": 101, \"y\""))
        assertEquals("The robot would start in a wall (the one at walls[1]).", refusalWith("\"x\": 40, \"y\"", "\"x\": 99, \"y\""))
    }

    @Test
    fun `too many walls are refused`() {
        val wall = "{ \"from\": { \"x\": 1, \"y\": 1 }, \"to\": { \"x\": 2, \"y\": 1 }, \"thickness\": 1 },"
        assertEquals(
            "The world file's walls has 204 entries, but at most 200 are allowed.",
            refusalWith(
                "\"walls\": [",
                "\"walls\": [" + wall.repeat(200),
            ),
        )
    }

    @Test
    fun `a file that is too long or too deep is refused`() {
        assertEquals("The world file is too long: more than 1000000 characters.", refusal(" ".repeat(1_000_001)))
        assertEquals("Line 2 of the world file opens too many brackets inside one another.", refusal("\n" + "[".repeat(900_000)))
        assertEquals("Line 1 of the world file opens too many brackets inside one another.", refusal("{\"a\":".repeat(150_000)))
    }

    @Test
    fun `a bracket in a text does not count as nesting`() {
        assertEquals("[".repeat(50) + "\"", loaded(plain.replaceFirst("Plain sheet", "[".repeat(50) + "\\\"")).title)
    }
}
