package robotran.ui.program

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.tags.ScreenTags
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.examples.examplesFor
import robotran.workshop.platform.OpenedFile
import robotran.world.ReadyRobots
import robotran.world.file.writeRobot
import kotlin.test.Test
import kotlin.test.assertEquals

@OptIn(ExperimentalTestApi::class)
class OtherBrickTest {
    @Test
    fun `a program for an NXT offers a robot with one, and that has a kit instead of sending`() = onTablet { workshop ->
        val text = ProgramLanguage.JAVA.examplesFor(BrickKind.NXT).getValue("Hello.java")
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("Hello.java", text)))
        runBlocking { workshop.compilePrograms() }
        pass(300)
        onNodeWithText("This robot has an RCX. Your program is for an NXT.").assertIsDisplayed()
        onNodeWithTag(ProgramTags.USE_OTHER_BRICK).performClick()
        runBlocking { workshop.compilePrograms() }
        pass(300)
        onNodeWithTag(ProgramTags.OTHER_BRICK).assertDoesNotExist()
        assertEquals(BrickKind.NXT, workshop.state.programs.brick)
        assertEquals(emptyList(), workshop.state.diagnostics)
        onNodeWithText("For a real robot…").assertExists()
        onNodeWithText("Send to my robot").assertDoesNotExist()
        onNodeWithTag(ScreenTags.NOTICE_TEXT).assertTextEquals("The robot yellow is now: NXT penbot.")
        onNodeWithTag(ScreenTags.NOTICE_ACTION).assertTextEquals("Undo").performClick()
        runBlocking { workshop.compilePrograms() }
        pass(300)
        assertEquals(BrickKind.RCX, workshop.state.programs.brick)
        onNodeWithTag(ScreenTags.NOTICE).assertDoesNotExist()
        onNodeWithTag(ProgramTags.OTHER_BRICK).assertExists()
    }

    @Test
    fun `a program in NQC on an NXT is told once, with what helps`() = onTablet { workshop ->
        val hello = ProgramLanguage.JAVA.examplesFor(BrickKind.NXT).getValue("Hello.java")
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("Hello.java", hello)))
        runBlocking { workshop.compilePrograms() }
        pass(300)
        onNodeWithTag(ProgramTags.USE_OTHER_BRICK).performClick()
        runBlocking { workshop.compilePrograms() }
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("drive.nqc", "task main()\n{\n    Wait(10);\n}\n")))
        runBlocking { workshop.compilePrograms() }
        pass(300)
        onNodeWithText("This robot has an NXT. Your program is for an RCX.").assertIsDisplayed()
        onNodeWithTag(ProgramTags.MISTAKES).assertDoesNotExist()
        onNodeWithTag(RunTags.STATUS).assertTextEquals("The program cannot run like this.")
        workshop.handle(ProgramEvent.ProgramEdited("task main()\n{\n    Wait(10)\n}\n"))
        runBlocking { workshop.compilePrograms() }
        pass(300)
        onNodeWithTag(ProgramTags.OTHER_BRICK).assertExists()
    }

    @Test
    fun `in a world for the other brick a program that came along is told once, with a program to begin with`() =
        onTablet { workshop ->
            workshop.handle(LearningEvent.WorldChosen("nxt-wall"))
            workshop.handle(
                ProgramEvent.ProgramEdited("robot\n  sonar on 1\nend\nstart forward\nshow distance\nstop\n"),
            )
            runBlocking { workshop.compilePrograms() }
            assertEquals(emptyList(), workshop.state.diagnostics)
            workshop.handle(LearningEvent.WorldChosen("slalom"))
            runBlocking { workshop.compilePrograms() }
            pass(300)
            onNodeWithText("This robot has an RCX. Your program is for an NXT.").assertIsDisplayed()
            onNodeWithTag(ProgramTags.MISTAKES).assertDoesNotExist()
            onNodeWithTag(ProgramTags.OTHER_BRICK_BEGINNING).assertIsDisplayed().performClick()
            runBlocking { workshop.compilePrograms() }
            pass(300)
            onNodeWithTag(ProgramTags.OTHER_BRICK).assertDoesNotExist()
            assertEquals(emptyList(), workshop.state.diagnostics)
        }

    @Test
    fun `a robot that is dropped on the window takes the place of the robot, and Undo brings that back`() {
        for (show in listOf(::onTablet, ::onPhone)) {
            show { workshop ->
                val owl = ReadyRobots.BOTH_SIDES.copy(title = "Owl")
                val file = OpenedFile("owl.robot.json", writeRobot(owl).encodeToByteArray())
                workshop.handle(DocumentEvent.FilesBrought(listOf(file)))
                pass(300)
                onNodeWithTag(ScreenTags.NOTICE_TEXT).assertTextEquals("The robot yellow is now: Owl.")
                onNodeWithTag(ScreenTags.NOTICE_ACTION).performClick()
                pass(300)
                assertEquals(ReadyRobots.RCX_PENBOT, workshop.state.programs.robot.description)
            }
        }
    }

    @Test
    fun `a file that is no robot is told in a sentence`() = onTablet { workshop ->
        workshop.handle(DocumentEvent.FilesBrought(listOf(OpenedFile("owl.robot.json", "{}".encodeToByteArray()))))
        pass(300)
        onNodeWithText("owl.robot.json: ", substring = true).assertIsDisplayed()
        assertEquals(ReadyRobots.RCX_PENBOT, workshop.state.programs.robot.description)
    }
}
