package robotran.narration

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.simulation.state.RobotSnapshot
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.Template
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** On all targets, so that a place has the same words on each. */
class WhereIsTest {
    @Test
    fun `the corridor is told so that one can drive through it`() = runTest {
        assertEquals(
            listOf(
                "The robot is 15 cm from the left, 18 cm up.",
                "It looks to the right, 13 degrees further up.",
                "Goal, not yet: Drive your robot to the marked area on the right. " +
                    "Its middle is 150 cm away, 13 degrees to the right.",
                "A wall: 46 cm ahead, 11 cm on the left, 7.7 cm on the right and 8 cm behind.",
                "The pen is up.",
            ),
            whereIn("corridor"),
        )
    }

    @Test
    fun `what is in the way to the goal is told`() = runTest {
        assertTrue(
            whereIn("maze").any { "26 degrees to the left. On the straight way there: a wall, after 14 cm." in it },
        )
    }

    @Test
    fun `the edges of the sheet are one sentence, after the goals`() = runTest {
        assertEquals(
            listOf(
                "Ziel, noch nicht: Follow the line once round. " +
                    "Eine schwarze Linie \"track\": am nächsten 2,5 cm entfernt, 90 Grad nach rechts.",
                "Bis zum Rand des Blatts: vorne 81 cm, links 76 cm, rechts 9,4 cm und hinten 55 cm.",
                "Der Stift ist oben.",
            ),
            whereIn("line-loop", language = Language.GERMAN).drop(2),
        )
    }

    @Test
    fun `a thing straight ahead is told once`() = runTest {
        val told = whereIn("block-push")
        assertEquals(1, told.count { "block \"box\"," in it || "block \"box\" is" in it }, "$told")
    }

    @Test
    fun `a drawing is told so that one can draw it`() = runTest {
        val house = worldOf("plain").copy(
            robots = worldOf("plain").robots.map { it.copy(start = Pose(30.0, 12.0, 0.0)) },
            template = Template(
                listOf(
                    listOf(
                        Point(30.0, 12.0),
                        Point(50.0, 12.0),
                        Point(50.0, 32.0),
                        Point(30.0, 32.0),
                        Point(30.0, 12.0),
                    ),
                    listOf(Point(30.0, 32.0), Point(40.0, 49.32), Point(50.0, 32.0)),
                ),
            ),
            goals = listOf(Goal(GoalCondition.DrawTemplate())),
        )
        val told = whereIs(0, house, stateOf(house), Language.ENGLISH).single { it.startsWith("Goal") }
        assertEquals(
            "Line 1 of the drawing begins where the robot is and goes to the right: " +
                "4 times 20 cm and 90 degrees to the left. " +
                "Line 2 of the drawing begins 20 cm away, 90 degrees to the left, " +
                "and goes up, 30 degrees further to the right: " +
                "20 cm, 120 degrees to the right and 20 cm.",
            told.substringAfter("beside it. "),
        )
    }

    @Test
    fun `a turned robot says how far it is turned`() = runTest {
        val told = whereIn("line-loop", Pose(50.0, 50.0, 120.0))
        assertEquals("It looks up, 30 degrees further to the left.", told[1])
        assertTrue("Under its light sensor: a black line \"track\"." in told, "$told")
        assertTrue(told.any { it.startsWith("To the edge of the sheet: 49 cm ahead") }, "$told")
        assertEquals("Er schaut nach unten.", whereIn("line-loop", Pose(5.0, 5.0, -90.0), Language.GERMAN)[1])
    }

    @Test
    fun `beside the sheet there is only the table`() = runTest {
        val loop = worldOf("line-loop")
        val beside = Pose(-10.0, 40.0, 180.0)
        assertEquals(
            listOf("The robot has left the sheet: it is 10 cm beyond the left edge.", "It looks to the left."),
            whereIs(
                0,
                loop,
                stateOf(loop).run {
                    copy(robots = robots.map { it.at(beside) })
                },
                Language.ENGLISH,
            ).take(2),
        )
    }

    @Test
    fun `lamps and blocks are told by the turn to them`() = runTest {
        val lamp = whereIn("light-room").single { it.startsWith("The lamp") }
        assertTrue(
            Regex("The lamp \"lamp\" is [0-9]+ cm away, [0-9]+ degrees to the (left|right)\\.").matches(lamp),
            lamp,
        )
        val turned = whereIn("block-push", Pose(20.0, 30.0, 40.0))
        assertTrue("The block \"box\" is 30 cm away, 40 degrees to the right." in turned, "$turned")
    }

    @Test
    fun `the explorer says what is there, the way to the goal and what is near`() = runTest {
        assertEquals(
            listOf(
                "30 cm from the left, 30 cm up: white paper.",
                "To the goal: 135 cm to the right and 10 cm down.",
                "Nearest: a wall, 7.5 cm up.",
            ),
            whatIsIn("corridor", Point(30.0, 30.0)),
        )
        assertEquals("15 cm from the left, 20 cm up: the robot.", whatIsIn("corridor", Point(15.0, 20.0)).first())
        assertEquals(
            "A 50 cm de la izquierda y 52 cm de abajo: una línea negra \"track\".",
            whatIsIn("line-loop", Point(50.0, 52.0), Language.SPANISH).first(),
        )
        assertEquals(
            "-5 cm from the left, 20 cm up: the table beside the sheet.",
            whatIsIn("line-loop", Point(-5.0, 20.0)).first(),
        )
    }

    @Test
    fun `the explorer does not name the edge of the sheet while there is a place to come to`() = runTest {
        val loop = worldOf("line-loop")
        val far = whatIsAt(Point(100.0, 70.0), loop, stateOf(loop), Language.ENGLISH)
        assertTrue(far.none { "edge" in it } && far.any { it.startsWith("To the goal: ") }, "$far")
        val idle = loop.copy(goals = emptyList(), marks = emptyList())
        val beside = whatIsAt(Point(138.0, 70.0), idle, stateOf(idle), Language.ENGLISH)
        assertTrue(beside.last().startsWith("Nearest: the edge of the sheet, "), "$beside")
    }

    @Test
    fun `angles are those of atan2, without it`() {
        for (x in -20..20) {
            for (y in -20..20) {
                val expected = if (x == 0 && y == 0) 0.0 else atan2(y.toDouble(), x.toDouble()) * 180 / PI
                assertEquals(expected, directionOf(x.toDouble(), y.toDouble()), 1e-9, "$x, $y")
            }
        }
    }

    private fun RobotSnapshot.at(pose: Pose) = copy(robot = robot.copy(pose = pose))

    private suspend fun whereIn(name: String, pose: Pose? = null, language: Language = Language.ENGLISH): List<String> {
        val world: World = worldOf(name)
        return whereIs(0, world, stateOf(world, pose ?: world.start), language)
    }

    private suspend fun whatIsIn(name: String, point: Point, language: Language = Language.ENGLISH): List<String> {
        val world = worldOf(name)
        return whatIsAt(point, world, stateOf(world), language)
    }
}
