package robotran.ui.screen

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.unit.dp
import robotran.learning.Lesson
import robotran.learning.Lessons
import robotran.learning.WorldGallery
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.sheet.transform
import robotran.ui.world.SheetRoom
import robotran.ui.world.tags.WorldTags
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** In each lesson and world, nothing lies over the robot, its ink, the goals and what was missing, whatever is said. */
@OptIn(ExperimentalTestApi::class)
abstract class StageInSight {
    /** The windows on which the task with this [number] is tested; may be empty. */
    internal abstract fun windowsOf(number: Int): List<Pair<Int, Int>>

    @Test
    fun `in each lesson the robot, its ink, the goals and the pins are in sight at start, failure and success`() =
        Lessons.all.forEachIndexed { number, lesson ->
            for (window in windowsOf(number)) onStage(window) { inLesson(it, lesson, "${lesson.name} at $window") }
        }

    @Test
    fun `in each world of the gallery they are in sight at start and at the end of a run`() =
        WorldGallery.worlds.forEachIndexed { number, world ->
            for (window in windowsOf(number)) {
                onStage(window) { workshop ->
                    workshop.handle(LearningEvent.WorldChosen(world.name))
                    assertStage(workshop, "${world.name} at $window, start")
                    workshop.run("forward 10\n", "${world.name} at $window, end", this)
                }
            }
        }

    private fun ComposeUiTest.inLesson(workshop: Workshop, lesson: Lesson, described: String) {
        workshop.handle(LearningEvent.LessonChosen(Lessons.indexOf(lesson)))
        // A phone shows it in the place of the sheet.
        if (isThere(ScreenTags.tab(Pane.WORLD))) workshop.handle(LearningEvent.TutorialFolded(true))
        assertStage(workshop, "$described, start")
        workshop.run(workshop.state.programText, "$described, failure", this)
        workshop.run(lesson.solution.text, "$described, success", this)
        if (lesson.places.size == 1) return
        workshop.handle(LearningEvent.OtherPlaceTried)
        workshop.advance(minOf(workshop.state.world.timeLimit, LONGEST_SECONDS) * 1_000)
        assertStage(workshop, "$described, success there")
    }

    private fun Workshop.run(program: String, described: String, screen: ComposeUiTest) {
        handle(ProgramEvent.ProgramEdited(program))
        screen.pass(100)
        handle(RunEvent.RunPressed)
        advance(minOf(state.world.timeLimit, LONGEST_SECONDS) * 1_000)
        screen.assertStage(this, described)
    }

    private fun ComposeUiTest.assertStage(workshop: Workshop, described: String) {
        workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
        pass(600)
        val pane = onNodeWithTag(WorldTags.WORLD).fetchSemanticsNode().boundsInRoot
        val world = workshop.state.world
        val aside = SheetRoom.of(world, pane.width.dp, pane.height.dp).aside
        val sheet = Rect(aside.left.value, 0f, pane.width, pane.height - aside.bottom.value)
        val transform = workshop.state.sheet.camera.transform(world.paper, sheet)
        for ((name, point) in thingsOf(workshop)) {
            val pixel: Offset = transform.toPixels(point)
            assertTrue(sheet.inflate(1f).contains(pixel), "$described: $name is at $pixel of $sheet")
        }
        val inSight = sheet.translate(pane.topLeft)
        for (tag in OTHERS) {
            for (node in onAllNodesWithTag(tag).fetchSemanticsNodes()) {
                assertTrue(!node.boundsInRoot.overlaps(inSight), "$described: $tag lies over the sheet")
            }
        }
        assertEquals(
            1f,
            onNodeWithTag(WorldTags.WORLD).fetchSemanticsNode().run {
                boundsInRoot.width / size.width
            },
            described,
        )
    }

    /** Those that are on the paper: a robot that has left it is told at its edge. */
    private fun thingsOf(workshop: Workshop): List<Pair<String, Point>> {
        val paper = workshop.state.world.paper
        val session = workshop.state.session
        val robots = session.robots.map { "a robot" to Point(it.robot.pose.x, it.robot.pose.y) }
        val ink = session.ink.strokes.flatMap { stroke -> stroke.points.map { "ink" to it } }
        val pins = workshop.state.run.shortfalls.mapNotNull { it.shortfall.place }.map { "a pin" to it }
        val corners = listOf(Point(0.0, 0.0), Point(paper.width, paper.height)).map { "a corner of the paper" to it }
        return (robots + ink + pins + corners).filter { (_, at) ->
            at.x in 0.0..paper.width && at.y in 0.0..paper.height
        }
    }

    private fun onStage(window: Pair<Int, Int>, check: ComposeUiTest.(Workshop) -> Unit) =
        onScreen(window.first, window.second) { workshop ->
            workshop.handle(SettingsEvent.SettingsChanged(Settings(lessMotion = true)))
            pass(100)
            check(workshop)
        }

    protected companion object {
        /** A phone both ways, a tablet both ways and a laptop. */
        val WINDOWS = listOf(412 to 915, 891 to 411, 1180 to 820, 820 to 1180, 1366 to 768)
        private const val LONGEST_SECONDS = 60

        /** What could lie over the sheet. */
        private val OTHERS = listOf(
            ScreenTags.MESSAGES,
            ScreenTags.NOTICE,
            ScreenTags.SOLVED_CARD,
            ScreenTags.MISSING_CARD,
            AssignmentTags.TASK_CARD,
            RunTags.BRICK_HINT,
            RunTags.BRICK,
            RunTags.GOAL_CHIP,
            RunTags.RUN,
        )
    }
}
