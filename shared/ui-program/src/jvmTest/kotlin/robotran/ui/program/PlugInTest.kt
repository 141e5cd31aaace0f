package robotran.ui.program

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.ui.common.tags.CommonTags
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.onPhone
import robotran.ui.screen.onScreen
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.tags.ScreenTags
import robotran.workshop.Workshop
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.service.asProject
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane
import robotran.world.PortSensor
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The remark about a sensor that a program lacks, and its button. */
@OptIn(ExperimentalTestApi::class)
class PlugInTest {
    private val Workshop.ports get() = project.world.robots.first().ports

    /** Runs a program that feels with both bumpers in a world whose robot has nothing on port 3. */
    private fun ComposeUiTest.runWithoutRightBumper(workshop: Workshop) = runWith(
        workshop,
        listOf(listOf(PortSensor.LEFT_BUMPER), listOf(PortSensor.LIGHT), emptyList()),
    )

    private fun ComposeUiTest.runWith(workshop: Workshop, ports: List<List<PortSensor>>) {
        val plain = BuiltInWorlds.plain
        val robots = plain.robots.map { it.withPorts(ports) }
        val program = Program.of("feel.robo", "if left bumper and not right bumper\n  beep\nend\nwait 5 seconds\n")
        workshop.services.editor.openProject(
            Project(
                plain.copy(robots = robots),
                listOf(ProjectRobot(robots.first().name, listOf(program.asProject()))),
            ),
        )
        workshop.handle(RunEvent.RunPressed)
        pass(300)
    }

    private fun ComposeUiTest.count(tag: String) = onAllNodesWithTag(tag).fetchSemanticsNodes().size

    @Test
    fun `the remark beside the program plugs the sensor in, and the next run has it`() = onTablet { workshop ->
        runWithoutRightBumper(workshop)
        onNodeWithTag(ProgramTags.REMARKS).assertIsDisplayed()
        onNodeWithTag(CommonTags.PLUG_IN).performClick()
        pass(100)
        assertEquals(listOf(PortSensor.RIGHT_BUMPER), workshop.ports.last())
        onNodeWithTag(ScreenTags.NOTICE_TEXT).assertTextContains("Port 3", substring = true)
        workshop.handle(RunEvent.RunPressed)
        pass(300)
        assertEquals(0, count(ProgramTags.REMARKS))
    }

    @Test
    fun `Undo takes the sensor out again`() = onTablet { workshop ->
        runWithoutRightBumper(workshop)
        onNodeWithTag(CommonTags.PLUG_IN).performClick()
        pass(100)
        onNodeWithTag(ScreenTags.NOTICE_ACTION).performClick()
        pass(100)
        assertEquals(emptyList(), workshop.ports.last())
        assertEquals(0, count(ScreenTags.NOTICE))
    }

    @Test
    fun `all sensors that are missing are one remark, one button and one undo`() = onTablet { workshop ->
        val bare = listOf(emptyList(), listOf(PortSensor.LIGHT), emptyList<PortSensor>())
        runWith(workshop, bare)
        onNodeWithText("Touch sensors are missing on ports 1 and 3", substring = true).assertIsDisplayed()
        onNodeWithTag(CommonTags.PLUG_IN).performClick()
        pass(100)
        val plugged =
            listOf(listOf(PortSensor.LEFT_BUMPER), listOf(PortSensor.LIGHT), listOf(PortSensor.RIGHT_BUMPER))
        assertEquals(plugged, workshop.ports)
        onNodeWithTag(ScreenTags.NOTICE_TEXT).assertTextContains("Ports 1 and 3", substring = true)
        onNodeWithTag(ScreenTags.NOTICE_ACTION).performClick()
        pass(100)
        assertEquals(bare, workshop.ports)
    }

    @Test
    fun `on a phone held across the remark leaves at least half of the program free`() =
        onScreen(891, 411) { workshop ->
            runWith(workshop, listOf(emptyList(), emptyList(), emptyList()))
            workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
            pass(100)
            val warning = onNodeWithTag(ProgramTags.REMARKS).fetchSemanticsNode().size.height
            val program = onNodeWithTag(ProgramTags.PROGRAM).fetchSemanticsNode().size.height
            assertTrue(warning * 2 <= program, "The remark is $warning high, the program $program.")
        }

    @Test
    fun `on a phone the button is also where the run is explained`() = onPhone { workshop ->
        runWithoutRightBumper(workshop)
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.WHY))
        pass(400)
        onNodeWithTag(RunTags.WHY_REMARK).assertTextContains("touch sensor is missing on port 3", substring = true)
        onNodeWithTag(CommonTags.PLUG_IN).performClick()
        pass(100)
        assertEquals(listOf(PortSensor.RIGHT_BUMPER), workshop.ports.last())
    }
}
