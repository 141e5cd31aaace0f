package robotran.ui.screen

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onFirst
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.workshop.Workshop
import robotran.workshop.event.RunEvent
import robotran.workshop.programs.asProject
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane
import robotran.workshop.state.PupilProgram
import robotran.workshop.state.WorkshopStatus
import robotran.world.Goal
import robotran.world.GoalCondition.Reach
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class OutcomeCardTest {
    private fun Workshop.runToFlag(source: String, milliseconds: Int = 8_000) {
        val world = BuiltInWorlds.plain.copy(
            goals = listOf(Goal(Reach(Shape.Circle(Point(70.0, 30.0), 5.0)))),
        )
        val program = PupilProgram("a.robo", source).asProject()
        openProject(Project(world, listOf(ProjectRobot(world.robots.first().name, listOf(program)))))
        handle(RunEvent.RunPressed)
        advance(milliseconds)
    }

    @Test
    fun `after a run the card says what was missing, and a touch shows its moment`() = onPhone { workshop ->
        workshop.runToFlag("forward 15\nbackward 10\n")
        pass(300)
        onNodeWithTag("missing-card").assertIsDisplayed()
        onNodeWithTag("shortfall").assertTextContains("cm short of the marked area", substring = true)
        onNodeWithTag("shortfall").performClick()
        pass(500)
        val moment = workshop.state.run.shortfalls.single().shortfall.moment
        assertEquals(moment?.milliseconds, workshop.state.run.time)
        assertEquals(55.0, workshop.state.session.robot.pose.x, 0.5)
        assertEquals(0, onAllNodesWithTag("missing-card").fetchSemanticsNodes().size)
    }

    @Test
    fun `on a phone a touch on the sentence in the goals shows the sheet`() = onPhone { workshop ->
        workshop.runToFlag("forward 15\n")
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.GOALS))
        pass(300)
        onAllNodesWithTag("shortfall").onFirst().performClick()
        pass(500)
        assertEquals(Pane.WORLD to null, workshop.state.pane to workshop.state.run.drawer.tab)
        onNodeWithTag("world").assertIsDisplayed()
    }

    @Test
    fun `a solved task stops a program that would go on for ever and is praised`() = onTablet { workshop ->
        workshop.runToFlag("repeat forever\n  forward 5\nend\n")
        pass(300)
        assertEquals(WorkshopStatus.Solved, workshop.state.status)
        assertTrue(workshop.state.session.robot.pose.x in 65.0..66.0)
        onNodeWithTag("solved-card").assertIsDisplayed()
        onNodeWithTag("outcome-close").performClick()
        pass(300)
        assertEquals(0, onAllNodesWithTag("solved-card").fetchSemanticsNodes().size)
    }
}
