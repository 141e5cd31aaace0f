package robotran.narration

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.simulation.state.RobotSnapshot
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
                "The robot is 15 cm from the left edge and 18 cm from the bottom edge.",
                "It looks to the right, 13 degrees further up.",
                "The pen is up.",
                "Ahead: a wall, 46 cm away.",
            ),
            whereIn("corridor").take(4),
        )
        assertEquals(
            "Goal, not yet: Drive your robot to the marked area on the right. Its middle is 150 cm away, 13 degrees to the right.",
            whereIn("corridor").last(),
        )
    }

    @Test
    fun `a turned robot says how far it is turned`() = runTest {
        val told = whereIn("line-loop", Pose(50.0, 50.0, 120.0))
        assertEquals("It looks up, 30 degrees further to the left.", told[1])
        assertTrue("Under its light sensor: a black line \"track\"." in told, "$told")
        assertEquals("Ahead: the edge of the sheet, 49 cm away.", told[3])
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
        assertTrue(whereIn("block-push").any { it.startsWith("The block \"box\" is ") })
    }

    @Test
    fun `the explorer says what is there and what is nearest`() = runTest {
        assertEquals(
            listOf("30 across, 30 up: white paper.", "Nearest: a wall, 7.5 cm up."),
            whatIsIn("corridor", Point(30.0, 30.0)),
        )
        assertEquals("15 across, 20 up: the robot.", whatIsIn("corridor", Point(15.0, 20.0)).first())
        assertEquals(
            "50 a la derecha, 52 hacia arriba: una línea negra \"track\".",
            whatIsIn("line-loop", Point(50.0, 52.0), Language.SPANISH).first(),
        )
        assertEquals(
            "-5 across, 20 up: the table beside the sheet.",
            whatIsIn("line-loop", Point(-5.0, 20.0)).first(),
        )
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
