package robotran.ui.screen

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onNodeWithTag
import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** What must fit on every screen in every language with every size of text, on those that [looksOn] gives. */
@OptIn(ExperimentalTestApi::class)
abstract class ScreensInLooks {
    /** The looks that are tested on the window with this [number] of a test. */
    internal abstract fun looksOn(number: Int): List<Look>

    internal data class Look(val language: Language, val textScale: Float)

    @Test
    fun `nothing that can be pressed moves while a program runs, ends, fails, or the app says something`() =
        everywhere(1180 to 820, 820 to 1180, 412 to 915, 1366 to 768, 891 to 411) { workshop, described ->
            workshop.handle(LearningEvent.WorldChosen("maze"))
            workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
            pass(300)
            val places = pressablePlaces()
            assertTrue(
                places.keys.containsAll(listOf(RunTags.RUN, WorldTags.WORLD, RunTags.TIMELINE, RunTags.GOAL_CHIP)),
                "$described: ${places.keys}",
            )

            fun check(moment: String) {
                pass(300)
                assertEquals(places, pressablePlaces().filterKeys { it in places }, "$described, $moment")
            }
            workshop.handle(ProgramEvent.ProgramEdited("forward 3\n"))
            workshop.handle(RunEvent.RunPressed)
            check("running")
            workshop.handle(RunEvent.PausePressed)
            check("paused")
            workshop.handle(RunEvent.PausePressed)
            pass(4_000)
            check("at its end")
            workshop.handle(RunEvent.Scrubbed(500))
            check("looking back")
            workshop.handle(ProgramEvent.ProgramEdited("var zero = 0\nshow 5 / zero\n"))
            workshop.handle(RunEvent.RunPressed)
            pass(2_000)
            check("failed")
            workshop.handle(RunEvent.LogCopied)
            check("with a notice")
            onNodeWithTag(ScreenTags.NOTICE).assertIsDisplayed()
        }

    @Test
    fun `with hint and solution open, everything that can be done with a step stays in sight`() =
        everywhere(412 to 915, 820 to 1180, 1024 to 768, 1280 to 800, 1366 to 768) { workshop, described ->
            workshop.handle(LearningEvent.TutorialStarted)
            workshop.handle(LearningEvent.HintRequested(true))
            workshop.handle(LearningEvent.SolutionRequested(true))
            pass(600)
            for (tag in listOf(
                LearningTags.PREVIOUS_STEP,
                LearningTags.NEXT_STEP,
                LearningTags.STEP_MORE,
            )) {
                assertWhole(tag, described)
            }
            if (workshop.settings.textScale == 1f) {
                assertTrue(
                    placesByTag().getValue(LearningTags.TUTORIAL_TEXT).height >= 120f,
                    "$described: no room for the text",
                )
            }
        }

    @Test
    fun `the tab of what the drawer shows is in sight, and where not all fit it is seen that there are more`() =
        everywhere(412 to 915, 360 to 740, 820 to 1180) { workshop, described ->
            workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
            for (tab in DrawerTab.entries.reversed()) {
                workshop.handle(RunEvent.DrawerChosen(tab))
                pass(600)
                assertWhole(RunTags.tab(RunTags.DRAWER, tab), described)
            }
            val last = onNodeWithTag(RunTags.tab(RunTags.DRAWER, DrawerTab.WHY)).fetchSemanticsNode()
            val isCut = last.boundsInRoot.width < last.size.width - 0.5f
            if (isCut) {
                assertTrue(
                    saysThereIsMore(RunTags.names(RunTags.DRAWER), isRight = true),
                    "$described: nothing says that there are more",
                )
            }
            scroll(RunTags.names(RunTags.DRAWER), toEnd = true)
            assertFalse(saysThereIsMore(RunTags.names(RunTags.DRAWER), isRight = true), described)
        }

    @Test
    fun `all that belongs beside the sheet is in the window`() = everywhere(
        360 to 640,
        411 to 891,
        640 to 360,
        891 to 411,
        820 to 1180,
        1280 to 800,
        1440 to 900,
        1920 to 1080,
    ) { workshop, described ->
        workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
        workshop.handle(LearningEvent.WorldChosen("maze"))
        workshop.handle(ScreenEvent.TaskShown(false))
        pass(500)
        for (tag in listOf(
            RunTags.RUN,
            RunTags.PAUSE,
            RunTags.STEP,
            RunTags.STOP,
            RunTags.RUN_MORE,
            RunTags.TIMELINE,
        )) {
            assertWhole(tag, described)
        }
        val onSheet = listOf(WorldTags.SHEET_WHOLE, WorldTags.SHEET_SHOW, WorldTags.SHEET_MEASURE, WorldTags.SHEET_3D)
        for (tag in onSheet + listOf(RunTags.GOAL_CHIP, RunTags.TASK_CHIP)) assertWhole(tag, described)
        if (!isThere(RunTags.BRICK)) {
            for (tag in listOf(
                RunTags.button(BrickButton.RUN),
                ScreenTags.BRICK_SIZE,
                RunTags.LCD,
            )) {
                assertWhole(tag, described)
            }
        }
        val places = placesByTag()
        val sheet = places.getValue("world")
        for (tag in onSheet) {
            val button = places.getValue(tag)
            assertTrue(
                button.top >= sheet.top && button.bottom <= sheet.bottom,
                "$described: $tag is at $button of $sheet",
            )
        }
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        pass(300)
        val program = placesByTag().getValue("program")
        assertTrue(program.height >= MIN_PROGRAM, "$described: $program")
        for (tag in listOf(
            ProgramTags.UNDO,
            ProgramTags.EDITOR_MORE,
            RunTags.RUN,
            RunTags.STOP,
        )) {
            assertWhole(tag, described)
        }
    }

    private fun everywhere(vararg windows: Pair<Int, Int>, check: ComposeUiTest.(Workshop, described: String) -> Unit) {
        for ((number, window) in windows.withIndex()) {
            val (width, height) = window
            for ((language, scale) in looksOn(number)) {
                onScreen(width, height) { workshop ->
                    val settings = Settings(language = language, textScale = scale, lessMotion = true)
                    workshop.handle(SettingsEvent.SettingsChanged(settings))
                    pass(300)
                    check(workshop, "$width x $height in $language at $scale")
                }
            }
        }
    }

    private companion object {
        /** Some lines of a program. */
        const val MIN_PROGRAM = 100f
    }
}
