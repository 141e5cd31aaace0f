package robotran.ui.drawer

import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertContentDescriptionContains
import androidx.compose.ui.test.assertContentDescriptionEquals
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onFirst
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onParent
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTextInput
import robotran.brick.kind.BrickKind
import robotran.brick.log.CallGroup
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.runcontrol.ChartLane
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.showWholeBrick
import robotran.ui.world.tags.WorldTags
import robotran.workshop.Workshop
import robotran.workshop.event.RunEvent
import robotran.workshop.service.asProject
import robotran.workshop.state.DrawerTab
import robotran.world.Goal
import robotran.world.GoalCondition.InkLength
import robotran.world.PortSensor
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class RunDrawerTest {
    private fun Workshop.with(source: String, goals: List<Goal> = emptyList(), on: World = BuiltInWorlds.plain) {
        val world = on.copy(goals = goals)
        services.editor.openProject(
            Project(
                world,
                listOf(ProjectRobot(world.robots.first().name, listOf(Program.of("a.robo", source).asProject()))),
            ),
        )
    }

    @Test
    fun `the drawer is closed, and a touch on a name opens it and another closes it`() = onTablet { workshop ->
        assertEquals(0, onAllNodesWithTag(RunTags.DRAWER_GRIP).fetchSemanticsNodes().size)
        for (tab in DrawerTab.entries) {
            onNodeWithTag(RunTags.tab(RunTags.DRAWER, tab)).performClick()
            pass(400)
            assertEquals(tab, workshop.state.run.drawer.tab)
            // The firmware makes calls before any program runs.
            onNodeWithTag(if (tab == DrawerTab.LOG) RunTags.LOG else RunTags.DRAWER_EMPTY).assertIsDisplayed()
        }
        onNodeWithTag(RunTags.DRAWER_CLOSE).performClick()
        pass(400)
        assertEquals(null, workshop.state.run.drawer.tab)
    }

    @Test
    fun `chart and log can be seen side by side, change places, and be closed one by one`() = onTablet { workshop ->
        workshop.with("forward 5\nbeep")
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.LOG))
        pass(400)
        onNodeWithTag(RunTags.DRAWER_TWO).performClick()
        workshop.handle(RunEvent.RunPressed)
        pass(400)
        onNodeWithTag(RunTags.LOG).assertIsDisplayed()
        onNodeWithTag(RunTags.chart(ChartLane.SENSOR_1), useUnmergedTree = true).assertIsDisplayed()
        onNodeWithTag(RunTags.tab(RunTags.BESIDE, DrawerTab.LOG)).performClick()
        pass(100)
        assertEquals(DrawerTab.CHART to DrawerTab.LOG, workshop.state.run.drawer.run { tab to beside })
        onNodeWithTag(RunTags.tab(RunTags.DRAWER, DrawerTab.LOG)).performClick()
        pass(100)
        assertEquals(DrawerTab.LOG to DrawerTab.CHART, workshop.state.run.drawer.run { tab to beside })
        onNodeWithTag(RunTags.BESIDE_CLOSE).performClick()
        pass(100)
        assertEquals(DrawerTab.LOG to null, workshop.state.run.drawer.run { tab to beside })
        onNodeWithTag(RunTags.LOG).assertIsDisplayed()
    }

    @Test
    fun `it can be made higher`() = onTablet { workshop ->
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.GOALS))
        pass(400)
        val before = onNodeWithTag(RunTags.DRAWER).fetchSemanticsNode().size.height
        onNodeWithTag(RunTags.DRAWER_GRIP).performSemanticsAction(SemanticsActions.SetProgress) { it(330f) }
        pass(400)
        assertTrue(onNodeWithTag(RunTags.DRAWER).fetchSemanticsNode().size.height > before)
    }

    @Test
    fun `variables and calls of a paused program are shown, and a frame can be chosen`() = onTablet { workshop ->
        workshop.with("procedure go(n)\n  var half = n / 2\n  beep\n  beep\nend\nvar way = 7\ngo(way)")
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        repeat(5) {
            onNodeWithTag(RunTags.STEP).performClick()
            pass(200)
        }
        onNodeWithTag(RunTags.frame(1)).assertIsDisplayed()
        onNodeWithTag(RunTags.variable("n")).assertIsDisplayed()
        onNodeWithTag(RunTags.frame(1)).performClick()
        pass(200)
        assertEquals(0, onAllNodesWithTag(RunTags.variable("n")).fetchSemanticsNodes().size)
        onNodeWithTag(RunTags.variable("way")).assertTextContains("7", substring = true)
    }

    @Test
    fun `the ROM log follows the run and finds what is searched`() = onTablet { workshop ->
        workshop.with("forward 5\nbeep\nforward 5")
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.LOG))
        workshop.handle(RunEvent.RunPressed)
        pass(3_000)
        onNodeWithTag(RunTags.LOG).assertIsDisplayed()
        val all = workshop.state.run.drawer.log.entries.size
        onNodeWithTag(RunTags.LOG_SEARCH).performTextInput("motor A")
        pass(300)
        val found = workshop.state.run.drawer.log.entries
        assertTrue(found.isNotEmpty() && found.size < all)
        onNodeWithTag(RunTags.LOG_COUNT).assertTextContains("${found.size} of", substring = true)
        workshop.handle(
            RunEvent.LogFiltered(workshop.state.run.drawer.log.filter.copy(groups = setOf(CallGroup.INFRARED))),
        )
        pass(300)
        onNodeWithTag(RunTags.DRAWER_EMPTY).assertIsDisplayed()
    }

    @Test
    fun `the chart shows the power of a motor, and its lanes can be hidden`() = onTablet { workshop ->
        workshop.with("forward 60")
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.CHART))
        workshop.handle(RunEvent.RunPressed)
        pass(1_000)
        onNodeWithTag(RunTags.lane(ChartLane.SENSOR_1)).performClick()
        onNodeWithTag(RunTags.lane(ChartLane.SENSOR_2)).performClick()
        onNodeWithTag(RunTags.lane(ChartLane.SENSOR_3)).performClick()
        pass(300)
        assertEquals(
            setOf(ChartLane.SENSOR_1, ChartLane.SENSOR_2, ChartLane.SENSOR_3),
            workshop.state.run.drawer.chart.hidden,
        )
        assertEquals(
            0,
            onAllNodesWithTag(RunTags.chart(ChartLane.SENSOR_1), useUnmergedTree = true).fetchSemanticsNodes().size,
        )
        onNodeWithTag(RunTags.value(ChartLane.MOTOR_A), useUnmergedTree = true).assertTextContains("+3")
        onNodeWithTag(RunTags.CHART_FINER).performClick()
        pass(200)
        onNodeWithTag(RunTags.chart(ChartLane.MOTOR_A), useUnmergedTree = true).assertIsDisplayed()
    }

    @Test
    fun `the chart of an NXT has units, the counters of its motors and its battery`() = onTablet { workshop ->
        workshop.with("forward 10\nshow distance\nwait 4 seconds", on = BuiltInWorlds.plainFor(BrickKind.NXT))
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.CHART))
        workshop.handle(RunEvent.RunPressed)
        pass(3_000)
        // What is not shown leaves room for the last lanes.
        for (lane in ChartLane.entries.filter { it.isMotor || (it.isSensor && it.port < 3) }) {
            workshop.handle(RunEvent.LaneSwitched(lane))
        }
        pass(300)
        val expected = listOf(
            ChartLane.SENSOR_4 to "Sensor 4: \\d+ cm",
            ChartLane.DEGREES_A to "Turned A: \\d+ °",
        )
        for ((lane, value) in expected) {
            val words = spokenOf(lane)
            assertTrue(Regex(value).matches(words), words)
        }
        assertEquals("Battery: 8004 mV", spokenOf(ChartLane.BATTERY))
        pass(4_000)
        // The brick switches it off at the end of the program.
        assertEquals("Sensor 4: no value", spokenOf(ChartLane.SENSOR_4))
    }

    private fun ComposeUiTest.spokenOf(lane: ChartLane): String =
        onNodeWithTag(RunTags.value(lane), useUnmergedTree = true).onParent().fetchSemanticsNode()
            .config[SemanticsProperties.ContentDescription].single()

    @Test
    fun `goals are counted beside the world and told in the drawer`() = onTablet { workshop ->
        workshop.with("pen down\nforward 10", listOf(Goal(InkLength(5.0, null)), Goal(InkLength(500.0, null))))
        pass(300)
        onNodeWithTag(RunTags.GOAL_CHIP).assertContentDescriptionEquals("0 of 2 goals met")
        onNodeWithTag(RunTags.GOAL_CHIP).performClick()
        workshop.handle(RunEvent.RunPressed)
        pass(6_000)
        onNodeWithTag(RunTags.GOAL_CHIP).assertContentDescriptionEquals("1 of 2 goals met")
        onAllNodesWithTag(RunTags.GOAL).onFirst().assertIsDisplayed()
    }

    @Test
    fun `when all goals are met a kind sentence says so`() = onPhone { workshop ->
        workshop.with("pen down\nforward 10", listOf(Goal(InkLength(5.0, null))))
        workshop.handle(RunEvent.RunPressed)
        pass(6_000)
        onNodeWithTag(RunTags.GOAL_CHIP).assertTextContains("All goals met")
    }

    @Test
    fun `on a phone the drawer has the whole pane`() = onPhone { workshop ->
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.CHART))
        pass(400)
        onNodeWithTag(RunTags.DRAWER).assertIsDisplayed()
        assertEquals(0, onAllNodesWithTag(WorldTags.WORLD).fetchSemanticsNodes().size)
        onNodeWithTag(RunTags.DRAWER_CLOSE).performClick()
        pass(400)
        onNodeWithTag(WorldTags.WORLD).assertIsDisplayed()
    }

    @Test
    fun `a robot that has come to a stop is announced`() = onTablet { workshop ->
        workshop.with("forward 5")
        workshop.handle(RunEvent.RunPressed)
        pass(6_000)
        onNodeWithTag(RunTags.ANNOUNCER).assertContentDescriptionContains("Robot at", substring = true)
    }

    @Test
    fun `a touch sensor that only a finger presses is pressed on the brick`() = onTablet { workshop ->
        val world = BuiltInWorlds.plain.let {
            it.copy(robots = listOf(it.robots.first().withPorts(listOf(listOf(PortSensor.TOUCH)))))
        }
        workshop.services.editor.openProject(Project(world))
        showWholeBrick()
        onNodeWithTag(RunTags.port(1)).performSemanticsAction(SemanticsActions.OnClick)
        pass(300)
        assertTrue(workshop.state.session.brick.inputs[0].isPressed)
        onNodeWithTag(RunTags.port(1)).performSemanticsAction(SemanticsActions.OnClick)
        pass(300)
        assertTrue(!workshop.state.session.brick.inputs[0].isPressed)
    }
}
