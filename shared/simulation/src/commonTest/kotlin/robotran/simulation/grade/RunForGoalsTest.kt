package robotran.simulation.grade

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.rcxrom.program.RcxProgram
import robotran.simulation.GoalReportStatus
import robotran.simulation.RobotProgramSet
import robotran.simulation.RunStatus
import robotran.simulation.ScriptedProgram
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.GoalCondition.DrawTemplate
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.NeverTouch
import robotran.world.GoalCondition.PlaySound
import robotran.world.GoalCondition.Reach
import robotran.world.GoalCondition.StayIn
import robotran.world.Paper
import robotran.world.RobotPlacement
import robotran.world.Template
import robotran.world.TouchKind
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class RunForGoalsTest {
    private val ahead = Goal(Reach(Shape.Circle(Point(80.0, 40.0), 5.0)))
    private val nothing = ScriptedProgram { }
    private val forward30 = ScriptedProgram { forward(30.0) }

    private fun world(vararg goals: Goal) = World(
        "A sheet",
        Paper(100.0, 80.0),
        listOf(RobotPlacement(Pose(50.0, 40.0, 0.0))),
        goals = goals.toList(),
        timeLimit = 10,
    )

    private suspend fun grade(world: World, vararg programs: RcxProgram?): Grade {
        val session =
            Session(world, programs.map { RobotProgramSet(listOfNotNull(it)) }, loadPhysicsEngine(), Language.ENGLISH)
        return session.runForGoals().also { session.close() }
    }

    @Test
    fun `a program that reaches the goal passes and is let go on no longer`() = runTest {
        val grade = grade(world(ahead), forward30)
        assertTrue(grade.passed)
        assertEquals(emptyList(), grade.unmet)
        assertTrue(grade.seconds in 1.0..1.6, "${grade.seconds}")
        assertEquals(GoalReportStatus.MET, grade.report.goals.single().status)
        assertEquals(1.0, grade.report.goals.single().progress)
    }

    @Test
    fun `an empty program does not pass, and no program at all either`() = runTest {
        for (program in listOf(nothing, null)) {
            val grade = grade(world(ahead, Goal(NeverTouch())), program)
            assertFalse(grade.passed)
            assertEquals(listOf(GoalStatus.FAILED, GoalStatus.MET), grade.goals.map { it.status })
            assertTrue(grade.seconds < 2, "${grade.seconds}")
        }
    }

    @Test
    fun `a program that never ends is judged when the time is up`() = runTest {
        val endless = ScriptedProgram { repeat(1000) { pause(1000) } }
        val grade = grade(world(ahead, Goal(StayIn(Shape.Circle(Point(50.0, 40.0), 5.0)))), endless)
        assertEquals(10.0, grade.seconds)
        assertEquals(RunStatus.RUNNING, grade.report.status)
        assertEquals(listOf(GoalStatus.FAILED, GoalStatus.MET), grade.goals.map { it.status })
    }

    @Test
    fun `the run is over at once when nothing can be met any more`() = runTest {
        val wall = Wall(Point(70.0, 0.0), Point(70.0, 80.0), 1.0)
        val grade =
            grade(
                world(Goal(NeverTouch(setOf(TouchKind.WALLS)))).copy(walls = listOf(wall)),
                ScriptedProgram {
                    forward(100.0)
                },
            )
        assertFalse(grade.passed)
        assertTrue(grade.seconds in 0.4..0.8, "${grade.seconds}")
    }

    @Test
    fun `who has to stay is watched to the end`() = runTest {
        val through = ScriptedProgram { forward(45.0) }
        val stay = Goal(Reach(Shape.Circle(Point(80.0, 40.0), 5.0), stays = true))
        assertFalse(grade(world(stay), through).passed)
        assertTrue(grade(world(ahead), through).passed)
        assertTrue(grade(world(stay), forward30).passed)
    }

    @Test
    fun `a drawing is graded by its ink`() = runTest {
        val corners = listOf(50.0 to 40.0, 70.0 to 40.0, 70.0 to 60.0, 50.0 to 60.0, 50.0 to 40.0).map {
            Point(it.first, it.second)
        }
        val goals = arrayOf(Goal(DrawTemplate(tolerance = 0.5, coverage = 0.95)), Goal(InkLength(79.0, 81.0)))
        val world = world(*goals).copy(template = Template(listOf(corners)), timeLimit = 30)
        assertTrue(grade(world, ScriptedProgram.square).passed)
        assertEquals(listOf(0.0, 0.0), grade(world, nothing).goals.map { it.progress })
    }

    @Test
    fun `the sounds of switching on and of the end are no tones of the program`() = runTest {
        val grade = grade(world(Goal(PlaySound())), ScriptedProgram { pause(2000) })
        assertEquals(GoalStatus.FAILED, grade.goals.single().status)
    }

    @Test
    fun `the programs of other robots are started too`() = runTest {
        val red = RobotPlacement(Pose(20.0, 20.0, 0.0), name = "red")
        val world = world(Goal(Reach(Shape.Circle(Point(50.0, 20.0), 3.0), who = "red")))
        val two = world.copy(robots = world.robots + red)
        assertTrue(grade(two, ScriptedProgram { pause(3000) }, forward30).passed)
        assertFalse(grade(two, ScriptedProgram { pause(3000) }, null).passed)
    }

    @Test
    fun `a world without goals is not passed`() = runTest {
        assertFalse(grade(world(), forward30).passed)
    }

    @Test
    fun `the same run is graded alike`() = runTest {
        assertEquals(grade(world(ahead), forward30), grade(world(ahead), forward30))
    }
}
