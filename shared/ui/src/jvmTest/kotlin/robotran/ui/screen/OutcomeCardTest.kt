package robotran.ui.screen

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onFirst
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.learning.Lessons
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.service.asProject
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
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
    private fun Workshop.runToFlag(
        source: String,
        milliseconds: Int = 8_000,
        timeLimit: Int = 60,
        stays: Boolean = false,
    ) {
        val world = BuiltInWorlds.plain.copy(
            task = "Drive to the flag.",
            goals = listOf(Goal(Reach(Shape.Circle(Point(70.0, 30.0), 5.0), stays = stays))),
            timeLimit = timeLimit,
        )
        val program = Program.of("a.robo", source).asProject()
        services.editor.openProject(Project(world, listOf(ProjectRobot(world.robots.first().name, listOf(program)))))
        handle(RunEvent.RunPressed)
        advance(milliseconds)
    }

    @Test
    fun `after a run the card says what was missing, and a touch shows its moment`() = onPhone { workshop ->
        workshop.runToFlag("forward 15\nbackward 10\n")
        pass(300)
        onNodeWithTag(ScreenTags.MISSING_CARD).assertIsDisplayed()
        onNodeWithTag(RunTags.SHORTFALL).assertTextContains("cm short of the marked area", substring = true)
        onNodeWithTag(RunTags.SHORTFALL).performClick()
        pass(500)
        assertEquals("A", workshop.state.run.shortfalls.single().sign)
        val moment = workshop.state.run.shortfalls.single().shortfall.moment
        assertEquals(moment?.milliseconds, workshop.state.run.time)
        assertEquals(55.0, workshop.state.session.robot.pose.x, 0.5)
        assertEquals(0, onAllNodesWithTag(ScreenTags.MISSING_CARD).fetchSemanticsNodes().size)
    }

    @Test
    fun `once the program is changed, the card says that it is about the last run`() = onTablet { workshop ->
        workshop.runToFlag("forward 15\n")
        pass(300)
        onNodeWithTag(ScreenTags.OUTCOME_TITLE).assertTextEquals("Not there yet")
        workshop.handle(ProgramEvent.ProgramEdited("forward 16\n"))
        pass(300)
        onNodeWithTag(ScreenTags.OUTCOME_TITLE).assertTextEquals("Last run: not there yet")
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(8_000)
        pass(300)
        onNodeWithTag(ScreenTags.OUTCOME_TITLE).assertTextEquals("Not there yet")
    }

    @Test
    fun `upright with German and the largest text, the task's line is whole and the first sentence is in sight`() =
        onScreen(820, 1180) { workshop ->
            val settings = Settings(textScale = 2f, lessMotion = true, language = Language.GERMAN)
            workshop.handle(SettingsEvent.SettingsChanged(settings))
            workshop.handle(LearningEvent.WorldChosen("block-push"))
            workshop.handle(ProgramEvent.ProgramEdited("forward 15\n"))
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(60_000)
            pass(500)
            for (tag in listOf(AssignmentTags.TASK_TITLE, ScreenTags.OUTCOME_TITLE, RunTags.SHORTFALL_TEXT)) {
                val node = onNodeWithTag(tag, useUnmergedTree = true).fetchSemanticsNode()
                assertEquals(node.size.height.toFloat(), node.boundsInRoot.height, 1f, tag)
            }
            val sheet = onNodeWithTag(WorldTags.WORLD).fetchSemanticsNode().boundsInRoot
            assertTrue(sheet.height > 150, "the sheet is only ${sheet.height} high")
        }

    @Test
    fun `on a phone a touch on the sentence in the goals shows the sheet`() = onPhone { workshop ->
        workshop.runToFlag("forward 15\n")
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.GOALS))
        pass(300)
        onAllNodesWithTag(RunTags.SHORTFALL).onFirst().performClick()
        pass(500)
        assertEquals(Pane.WORLD to null, workshop.state.pane to workshop.state.run.drawer.tab)
        onNodeWithTag(WorldTags.WORLD).assertIsDisplayed()
    }

    @Test
    fun `a solved task stops a program that would go on for ever and is praised`() = onTablet { workshop ->
        workshop.runToFlag("repeat forever\n  forward 5\nend\n")
        pass(300)
        assertEquals(WorkshopStatus.Solved, workshop.state.status)
        assertTrue(workshop.state.session.robot.pose.x in 65.0..66.0)
        onNodeWithTag(ScreenTags.SOLVED_CARD).assertIsDisplayed()
        onNodeWithTag(ScreenTags.OUTCOME_CLOSE).performClick()
        pass(300)
        assertEquals(0, onAllNodesWithTag(ScreenTags.SOLVED_CARD).fetchSemanticsNodes().size)
    }

    @Test
    fun `a solved task needs no words about motors and no help, until the next run`() = onTablet { workshop ->
        workshop.handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == "bumpers" }))
        val solution = Lessons.all.first { it.name == "bumpers" }.solution.text
        val help = listOf(LearningTags.HINT_WANTED, LearningTags.SOLUTION_WANTED)
        for ((program, isSolved) in listOf("$solution\nforward 20\n" to false, solution to true)) {
            workshop.handle(ProgramEvent.ProgramEdited(program))
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(60_000)
            // It works here: the same has to work in the lesson's other place.
            workshop.handle(LearningEvent.OtherPlaceTried)
            workshop.advance(60_000)
            pass(300)
            assertEquals(isSolved, isThere(ScreenTags.SOLVED_CARD), program)
            for (tag in help) assertEquals(!isSolved, isThere(tag), "$tag of $program")
        }
        workshop.handle(RunEvent.RunPressed)
        pass(300)
        for (tag in help) assertTrue(isThere(tag), tag)
    }

    @Test
    fun `what works here is not praised, but a touch tries it where something is different, in every language`() {
        for ((window, isNarrow) in listOf((1180 to 820) to false, (412 to 915) to true)) {
            onScreen(window.first, window.second) { workshop ->
                workshop.handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == "edge" }))
                if (isNarrow) workshop.handle(LearningEvent.TutorialFolded(true))
                workshop.handle(ProgramEvent.ProgramEdited("wait 0.1 seconds\nforward 46\nbeep\n"))
                workshop.handle(RunEvent.RunPressed)
                workshop.advance(20_000)
                for (language in Language.entries) {
                    workshop.handle(SettingsEvent.SettingsChanged(Settings(lessMotion = true, language = language)))
                    pass(300)
                    onNodeWithTag(ScreenTags.ELSEWHERE_CARD).assertIsDisplayed()
                    val again = checkNotNull(Lessons.named("edge")?.text(language)?.again)
                    onNodeWithTag(ScreenTags.ELSEWHERE_WORDS).assertTextEquals(again)
                    onNodeWithTag(ScreenTags.TRY_ELSEWHERE).assertIsDisplayed()
                }
                onNodeWithTag(ScreenTags.SOLVED_CARD).assertDoesNotExist()
                onNodeWithTag(ScreenTags.TRY_ELSEWHERE).performClick()
                workshop.advance(20_000)
                pass(300)
                onNodeWithTag(ScreenTags.ELSEWHERE_CARD).assertDoesNotExist()
                onNodeWithTag(ScreenTags.MISSING_CARD).assertIsDisplayed()
                if (!isNarrow) {
                    onNodeWithTag(LearningTags.AGAIN).assertExists()
                    onNodeWithTag(LearningTags.HINT).assertIsDisplayed()
                }
            }
        }
    }

    @Test
    fun `why the motors have stopped is told, but not of a solved task`() = onTablet { workshop ->
        for ((seconds, isShown) in listOf("0.5" to true, "1.5" to false)) {
            val program = "start forward\nwait $seconds seconds\n"
            workshop.runToFlag(program, stays = true)
            pass(300)
            assertEquals(!isShown, workshop.state.run.isSolved, program)
            assertTrue(workshop.state.session.brick.explanation != null, program)
            assertEquals(isShown, isThere(RunTags.BRICK_HINT), program)
        }
    }

    @Test
    fun `why a program failed comes before what it has not reached for that`() = onPhone { workshop ->
        workshop.handle(LearningEvent.WorldChosen("square"))
        workshop.handle(ProgramEvent.ProgramEdited("var zero = 0\nforward 2\nshow 5 / zero\n"))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(5_000)
        workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
        pass(500)
        val why = onNodeWithTag(RunTags.BRICK_HINT).assertIsDisplayed().fetchSemanticsNode().boundsInRoot
        val missing = onNodeWithTag(ScreenTags.MISSING_CARD).fetchSemanticsNode().boundsInRoot
        val brick = onNodeWithTag(RunTags.button(BrickButton.RUN)).fetchSemanticsNode().boundsInRoot
        assertTrue(why.bottom <= missing.top || missing.isEmpty, "$why and $missing")
        assertTrue(why.bottom <= brick.top, "$why and $brick")
    }

    @Test
    fun `before a run nothing is praised, even if the robot begins where the goal is`() = onTablet { workshop ->
        val start = BuiltInWorlds.plain.robots.first().start
        val here = Goal(Reach(Shape.Circle(Point(start.x, start.y), 5.0)))
        workshop.services.editor.openProject(Project(BuiltInWorlds.plain.copy(goals = listOf(here)), emptyList()))
        pass(500)
        assertTrue(workshop.state.run.outcome.allMet)
        onNodeWithTag(ScreenTags.SOLVED_CARD).assertDoesNotExist()
        onNodeWithTag(ScreenTags.MISSING_CARD).assertDoesNotExist()
    }

    @Test
    fun `what had not begun is not among what was missing`() = onTablet { workshop ->
        workshop.handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == "knock" }))
        workshop.handle(ProgramEvent.ProgramEdited("start forward\nwait until left bumper or right bumper\nbeep\n"))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(20_000)
        pass(300)
        assertEquals(1, onAllNodesWithTag(RunTags.SHORTFALL).fetchSemanticsNodes().size)
    }

    @Test
    fun `when the time is up the run pauses and the card says so, and the clock has the comma of the language`() =
        onPhone { workshop ->
            workshop.runToFlag("repeat forever\n  wait 1 second\nend\n", timeLimit = 5)
            pass(300)
            assertTrue(workshop.state.run.isPaused)
            assertEquals(WorkshopStatus.TimeUp(5), workshop.state.status)
            onNodeWithTag(ScreenTags.MISSING_TIME_UP).assertTextEquals("The time is up (5 s).")
            onNodeWithTag(RunTags.CLOCK).assertTextEquals("5.0 s")
            for ((language, words, clock) in TIMES) {
                workshop.handle(SettingsEvent.SettingsChanged(Settings(lessMotion = true, language = language)))
                pass(1_000)
                onNodeWithTag(RunTags.STATUS).assertTextEquals(words)
                onNodeWithTag(RunTags.CLOCK).assertTextEquals(clock)
            }
            workshop.handle(RunEvent.PausePressed)
            workshop.advance(3_000)
            assertEquals(8_000, workshop.state.run.time)
        }

    @Test
    fun `on a phone the task can be read again beside the outcome`() {
        for (source in listOf("forward 45\n", "forward 15\n")) {
            onPhone { workshop ->
                val card = if (source == "forward 45\n") ScreenTags.SOLVED_CARD else ScreenTags.MISSING_CARD
                workshop.runToFlag(source)
                pass(300)
                onNodeWithTag(card).assertIsDisplayed()
                workshop.handle(ScreenEvent.TaskShown(true))
                pass(300)
                onNodeWithTag(AssignmentTags.TASK_CARD).assertIsDisplayed()
                onNodeWithTag(card).assertIsDisplayed()
            }
        }
    }

    private companion object {
        val TIMES = listOf(
            Triple(Language.GERMAN, "Die Zeit ist um (5 s).", "5,0 s"),
            Triple(Language.SPANISH, "Se acabó el tiempo (5 s).", "5,0 s"),
        )
    }
}
