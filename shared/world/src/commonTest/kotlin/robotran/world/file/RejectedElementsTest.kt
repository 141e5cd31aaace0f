package robotran.world.file

import kotlin.test.Test
import kotlin.test.assertEquals

class RejectedElementsTest {
    @Test
    fun `a missing field is named with its place`() {
        assertEquals("title is missing.", complaint("\"title\"", "\"called\"", line = 1))
        assertEquals(
            "title is missing; perhaps \"titel\" is meant for it.",
            complaint("\"title\"", "\"titel\"", line = 1),
        )
        assertEquals("walls[0].thickness is missing.", complaint("\"thickness\"", "\"width\""))
        assertEquals("robots[0].start.heading is missing.", complaint("\"heading\"", "\"facing\""))
        assertEquals("goals[5].goals[1].line is missing.", complaint("\"line\": \"loop\"", "\"way\": \"loop\""))
    }

    @Test
    fun `a value of the wrong kind is refused with its place`() {
        assertEquals("paper.width must be a number.", complaint("\"width\": 200", "\"width\": \"200\""))
        assertEquals("paper.width must be a number.", complaint("\"width\": 200", "\"width\": null"))
        assertEquals("title must be a text in quotes.", complaint("\"Everything\"", "7"))
        assertEquals("title must not be empty.", complaint("Everything", " "))
        assertEquals("title must not have more than 100 characters.", complaint("Everything", "e".repeat(101)))
        assertEquals("title must be one line of ordinary characters.", complaint("Everything", "Every\\nthing"))
        assertEquals("title must be one line of ordinary characters.", complaint("Everything", "Every\\ud800thing"))
        assertEquals(
            "walls must be a list in square brackets.",
            complaint("\"walls\": [{", "\"walls\": 7, \"fences\": [{"),
        )
        assertEquals("lamps[0].on must be true or false.", complaint("\"on\": false", "\"on\": 0"))
        assertEquals("seed must be a whole number from 0 to 2147483647.", complaint("\"seed\": 7", "\"seed\": 1.5"))
        assertEquals(
            "walls[0].from must be a place such as [20, 30], first x and then y.",
            complaint("[0, 90]", "[0, 90, 5]"),
        )
    }

    @Test
    fun `a number out of range is refused`() {
        assertEquals("paper.width must be from 20 to 1000.", complaint("\"width\": 200", "\"width\": 1e400"))
        assertEquals("paper.height must be from 20 to 1000.", complaint("\"height\": 100", "\"height\": -80"))
        assertEquals("walls[0].to[1] must be from -1000 to 2000.", complaint("[120, 90]", "[120, 1e99999999999999]"))
        assertEquals("barriers[1].circle.radius must be from 0.1 to 2000.", complaint("\"radius\": 3", "\"radius\": 0"))
        assertEquals("blocks[0].mass must be from 0.001 to 100.", complaint("\"mass\": 0.2", "\"mass\": -1"))
        assertEquals("lamps[0].cone must be from 1 to 360.", complaint("\"cone\": 60", "\"cone\": 0"))
        assertEquals(
            "timeLimit must be a whole number from 1 to 3600.",
            complaint("\"timeLimit\": 90", "\"timeLimit\": 0"),
        )
        assertEquals("realism must be from 0 to 1.", complaint("\"realism\": 0.3", "\"realism\": 1.01"))
    }

    @Test
    fun `a word that means nothing is refused with those that do`() {
        assertEquals(
            "robots[0].lightSensor must be \"down\" or \"forward\".",
            complaint("\"forward\", \"beacon\"", "\"up\", \"beacon\""),
        )
        assertEquals(
            "robots[0].ports.1 must be \"left bumper\", \"right bumper\", \"touch\", \"light\", \"left rotation\", " +
                "\"right rotation\" or " +
                "\"temperature\".",
            complaint("\"left bumper\"", "\"bumper\""),
        )
        assertEquals(
            "robots[0].ports must not have \"4\": a brick has the ports \"1\", \"2\" and \"3\".",
            complaint("\"3\": []", "\"4\": []"),
        )
        assertEquals(
            "robots[0].ports.2 must not have the same sensor twice.",
            complaint("[\"light\", \"touch\"]", "[\"light\", \"light\"]"),
        )
        assertEquals("marks[1].colour must be a colour such as \"#1133aa\".", complaint("#1133AA", "#1133AG"))
        assertEquals(
            "goals[3].what[0] must be \"walls\", \"barriers\", \"blocks\" or \"robots\".",
            complaint("[\"walls\"", "[\"floor\""),
        )
    }

    @Test
    fun `a thing has one shape`() {
        assertEquals(
            "barriers[1] must have \"rectangle\", \"circle\" or \"polygon\".",
            complaint("{ \"circle\"", "{ \"oval\""),
        )
        assertEquals(
            "barriers[1] must have only one of \"circle\" and \"polygon\".",
            complaint("\"radius\": 3 }", "\"radius\": 3 }, \"polygon\": []"),
        )
        assertEquals(
            "marks[1] must have only one of \"grey\" and \"colour\".",
            complaint("\"colour\": \"#", "\"grey\": 1, \"colour\": \"#"),
        )
    }

    @Test
    fun `a polygon must have an inside and edges that do not cross`() {
        val corners = "[[100, 60], [110, 60], [105, 70]]"
        val crosses = "barriers[2].polygon must not have edges that cross or touch each other."
        assertEquals(
            "barriers[2].polygon has 2 entries, but at least 3 must be there.",
            complaint(corners, "[[100, 60], [110, 60]]"),
        )
        assertEquals(crosses, complaint(corners, "[[100, 60], [110, 70], [110, 60], [100, 70]]"))
        assertEquals(crosses, complaint(corners, "[[100, 60], [110, 60], [110, 60], [105, 70]]"))
        assertEquals(crosses, complaint(corners, "[[100, 60], [110, 60], [104, 60]]"))
        assertEquals(crosses, complaint(corners, "[[100, 60], [120, 60], [120, 70], [110, 60], [100, 70]]"))
        assertEquals(
            "barriers[2].polygon must cover some of the paper.",
            complaint(corners, "[[100, 60], [100.01, 60], [100, 60.01]]"),
        )
    }

    @Test
    fun `a dented polygon and one with a corner on a straight edge are polygons`() {
        val corners = "[[100, 60], [110, 60], [105, 70]]"
        loaded(FULL_WORLD.replace(corners, "[[100, 60], [110, 60], [105, 62], [105, 70]]"))
        loaded(FULL_WORLD.replace(corners, "[[100, 60], [105, 60], [110, 60], [105, 70]]"))
    }

    @Test
    fun `lines must lead somewhere`() {
        assertEquals(
            "marks[0].line.points[1] must not be the same place as the one before.",
            complaint("[[10, 10], [30, 10], [30, 50]]", "[[10, 10], [10, 10], [30, 50]]"),
        )
        assertEquals(
            "marks[0].line.points[3] must not be the first one again, since the line is closed anyway.",
            complaint("[[10, 10], [30, 10], [30, 50]]", "[[10, 10], [30, 10], [30, 50], [10, 10]]"),
        )
        assertEquals(
            "template.strokes[0] has 1 entry, but at least 2 must be there.",
            complaint("[[0, 0], [10, 0]]", "[[0, 0]]"),
        )
    }

    @Test
    fun `grey maps have rows of the same length and of greys`() {
        assertEquals("marks[2].greyMap.rows[1] must be as long as the first row, 3.", complaint("\".8f\"", "\".8\""))
        assertEquals(
            "marks[2].greyMap.rows[1] must be made of 0 to 9, a to f and points.",
            complaint("\".8f\"", "\".8g\""),
        )
    }

    @Test
    fun `robots start on the paper and clear of everything`() {
        val bob = "\"x\": 80, \"y\": 30, \"heading\": 0"
        assertEquals("robots[1].start is beside the paper.", complaint(bob, "\"x\": 201, \"y\": 30, \"heading\": 0"))
        assertEquals(
            "robots[1].start puts the robot into walls[0].",
            complaint(bob, "\"x\": 80, \"y\": 83, \"heading\": 0"),
        )
        assertEquals(
            "robots[1].start puts the robot into walls[0].",
            complaint(bob, "\"x\": 60, \"y\": 80.1, \"heading\": 90"),
        )
        assertEquals(
            "robots[1].start puts the robot into barriers[2].",
            complaint(bob, "\"x\": 105, \"y\": 63, \"heading\": 0"),
        )
        assertEquals(
            "robots[1].start puts the robot into barriers[1].",
            complaint(bob, "\"x\": 20, \"y\": 70, \"heading\": 45"),
        )
        assertEquals(
            "robots[1].start puts the robot into blocks[0].",
            complaint(bob, "\"x\": 150, \"y\": 20, \"heading\": 45"),
        )
        assertEquals(
            "robots[1].start puts the robot into robots[0].",
            complaint(bob, "\"x\": 54, \"y\": 30, \"heading\": 90"),
        )
        loaded(FULL_WORLD.replace(bob, "\"x\": 54.5, \"y\": 30, \"heading\": 90"))
        loaded(FULL_WORLD.replace(bob, "\"x\": 60, \"y\": 80, \"heading\": 90"))
        loaded(FULL_WORLD.replace(bob, "\"x\": 60, \"y\": 79.9, \"heading\": -270"))
    }

    @Test
    fun `names are had once and goals name what is there`() {
        val already = "barriers[0] must not be called \"ann\", since robots[0] is called so already."
        assertEquals(already, complaint("\"name\": \"box\"", "\"name\": \"ann\""))
        assertEquals(
            "goals[0].who must be the name of a robot or a block.",
            complaint("\"who\": \"brick\"", "\"who\": \"box\""),
        )
        assertEquals(
            "goals[3].who must be the name of a robot.",
            complaint("\"robots\"], \"who\": \"bob\"", "\"robots\"], \"who\": \"brick\""),
        )
        assertEquals(
            "goals[5].goals[1].line must be the name of a mark that is a line.",
            complaint("\"line\": \"loop\"", "\"line\": \"box\""),
        )
        assertEquals(
            "goals[4] needs a drawing to trace, and this world has none.",
            complaint("\"template\"", "\"pattern\"", line = 57),
        )
    }

    @Test
    fun `bounds of goals must leave room`() {
        assertEquals(
            "goals[5].goals[0] must not have \"atLeast\" above \"atMost\".",
            complaint("\"atLeast\": 10", "\"atLeast\": 30"),
        )
        assertEquals(
            "goals[5].goals[0] must have \"atLeast\" or \"atMost\" or both.",
            complaint("\"atLeast\": 10, \"atMost\": 20", "\"about\": 20"),
        )
        assertEquals(
            "goals[7].goals[1] must not have \"lowest\" above \"highest\".",
            complaint("\"lowest\": 400", "\"lowest\": 600"),
        )
    }

    @Test
    fun `goals lie in one another four deep at most`() {
        fun nested(depth: Int): String = if (depth == 1) {
            "{ \"kind\": \"drawTemplate\" }"
        } else {
            "{ \"kind\": \"all\", \"goals\": [${nested(depth - 1)}] }"
        }
        loaded(FULL_WORLD.replaceFirst("\"goals\": [\n", "\"goals\": [\n${nested(4)},"))
        assertEquals(
            "goals[0].goals[0].goals[0].goals[0].goals",
            refusal(FULL_WORLD.replaceFirst("\"goals\": [\n", "\"goals\": [\n${nested(5)},")).path,
        )
    }
}
