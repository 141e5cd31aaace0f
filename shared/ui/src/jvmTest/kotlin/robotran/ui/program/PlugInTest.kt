package robotran.ui.program

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.workshop.Workshop
import robotran.workshop.event.RunEvent
import robotran.workshop.programs.asProject
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.PupilProgram
import robotran.world.PortSensor
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals

/** The remark about a sensor that a program lacks, and its button. */
@OptIn(ExperimentalTestApi::class)
class PlugInTest {
    private val Workshop.ports get() = project.world.robots.first().ports

    /** Runs a program that feels with both bumpers in a world whose robot has nothing on port 3. */
    private fun ComposeUiTest.runWithoutRightBumper(workshop: Workshop) {
        val plain = BuiltInWorlds.plain
        val robots = plain.robots.map { it.copy(ports = it.ports.dropLast(1) + listOf(emptyList())) }
        val program = PupilProgram("feel.robo", "if left bumper\n  beep\nend\nwait 5 seconds\n")
        workshop.openProject(
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
        onNodeWithTag("remarks").assertIsDisplayed()
        onNodeWithTag("plug-in-3").performClick()
        pass(100)
        assertEquals(listOf(PortSensor.RIGHT_BUMPER), workshop.ports.last())
        onNodeWithTag("notice-text").assertTextContains("Port 3", substring = true)
        workshop.handle(RunEvent.RunPressed)
        pass(300)
        assertEquals(0, count("remarks"))
    }

    @Test
    fun `Undo takes the sensor out again`() = onTablet { workshop ->
        runWithoutRightBumper(workshop)
        onNodeWithTag("plug-in-3").performClick()
        pass(100)
        onNodeWithTag("notice-action").performClick()
        pass(100)
        assertEquals(emptyList(), workshop.ports.last())
        assertEquals(0, count("notice"))
    }

    @Test
    fun `on a phone the button is also where the run is explained`() = onPhone { workshop ->
        runWithoutRightBumper(workshop)
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.WHY))
        pass(400)
        onNodeWithTag("why-remark").assertTextContains("touch sensor on port 3", substring = true)
        onNodeWithTag("plug-in-3").performClick()
        pass(100)
        assertEquals(listOf(PortSensor.RIGHT_BUMPER), workshop.ports.last())
    }
}
