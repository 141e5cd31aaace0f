package robotran.ui.screen

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import robotran.brick.controls.BrickButton
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane

/** The places of all elements that can be pressed, by tag. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.pressablePlaces(): Map<String, Rect> = onAllNodes(TAGGED).fetchSemanticsNodes()
    .groupBy { it.config[SemanticsProperties.TestTag] }
    .filter { (tag, nodes) -> tag in PRESSABLE && nodes.size == 1 }
    .mapValues { (_, nodes) -> nodes.single().boundsInRoot }

private val TAGGED = SemanticsMatcher.keyIsDefined(SemanticsProperties.TestTag)
private val PRESSABLE = setOf(
    ScreenTags.MENU,
    ScreenTags.LEARN,
    ScreenTags.WORLDS,
    ScreenTags.EDIT_WORLD,
    ScreenTags.tab(Pane.PROGRAM),
    ScreenTags.tab(Pane.WORLD),
    ScreenTags.tab(Pane.BRICK),
    RunTags.RUN,
    RunTags.PAUSE,
    RunTags.STEP,
    RunTags.STEPS,
    RunTags.STOP,
    RunTags.SPEED,
    RunTags.RUN_MORE,
    RunTags.SOUND,
    RunTags.TIMELINE,
    RunTags.MARK_PREVIOUS,
    RunTags.MARK_NEXT,
    WorldTags.WORLD,
    WorldTags.SHEET_NEARER,
    WorldTags.SHEET_WHOLE,
    WorldTags.SHEET_SHOW,
    WorldTags.SHEET_3D,
    WorldTags.SHEET_SURROUNDINGS,
    RunTags.tab(RunTags.DRAWER, DrawerTab.VARIABLES),
    RunTags.tab(RunTags.DRAWER, DrawerTab.GOALS),
    RunTags.GOAL_CHIP,
    RunTags.BRICK,
    RunTags.button(BrickButton.RUN),
    RunTags.button(BrickButton.VIEW),
    RunTags.button(BrickButton.PRGM),
    RunTags.button(BrickButton.ON_OFF),
    ProgramTags.PROGRAM,
    ProgramTags.UNDO,
    ProgramTags.EDITOR_MORE,
    ProgramTags.program(0),
    ProgramTags.ADD_PROGRAM,
    ScreenTags.DIVIDER,
)
