package robotran.ui.program.blocks

import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.platform.ClipboardManager
import androidx.compose.ui.platform.LocalClipboardManager
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.click
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.unit.LayoutDirection
import kotlinx.coroutines.runBlocking
import robotran.projects.ProgramView
import robotran.ui.RobotranApp
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.write
import robotran.ui.screen.Undrawn
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.undrawnTest
import robotran.workshop.Workshop
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.Pane

/** Shows [text] in blocks on a phone. */
@OptIn(ExperimentalTestApi::class)
internal fun onPhoneInBlocks(text: String, check: ComposeUiTest.(Workshop) -> Unit) = onPhone { workshop ->
    showInBlocks(workshop, text)
    check(workshop)
}

/** Shows [text] in blocks on a tablet. */
@OptIn(ExperimentalTestApi::class)
internal fun onTabletInBlocks(text: String, check: ComposeUiTest.(Workshop) -> Unit) = onTablet { workshop ->
    showInBlocks(workshop, text)
    check(workshop)
}

/** The same with another [direction] of reading, and with a [clipboard] of the test's own. */
@OptIn(ExperimentalTestApi::class)
internal fun onTabletInBlocks(
    text: String,
    direction: LayoutDirection = LayoutDirection.Ltr,
    clipboard: ClipboardManager,
    check: ComposeUiTest.(Workshop) -> Unit,
) {
    val workshop = runBlocking { openWorkshop() }
    try {
        undrawnTest(1280, 800) {
            mainClock.autoAdvance = false
            setContent {
                CompositionLocalProvider(LocalClipboardManager provides clipboard) {
                    Undrawn {
                        RobotranApp(workshop, dark = false, isRightToLeft = direction == LayoutDirection.Rtl)
                    }
                }
            }
            pass(100)
            showInBlocks(workshop, text)
            check(workshop)
        }
    } finally {
        workshop.close()
    }
}

/** A clipboard that no other program sees. */
internal class OwnClipboard : ClipboardManager {
    private var text: AnnotatedString? = null

    override fun setText(annotatedString: AnnotatedString) {
        text = annotatedString
    }

    override fun getText(): AnnotatedString? = text
}

@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.showInBlocks(workshop: Workshop, text: String) {
    workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
    workshop.write(text, caret = 0)
    workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
    pass(300)
}

/** Touches the block [tag] before its words, where no socket is. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.touchSignOf(tag: String) {
    onNodeWithTag(tag).performTouchInput { click(Offset(BlockSizes.GRIP.toPx() / 2, height / 2f)) }
    pass(200)
}

/** A finger rests on [from] until it carries, moves to [to] of the list of blocks, and goes up unless it [holds] on. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.carry(from: String, to: Offset, holds: Boolean = false) {
    val start = onNodeWithTag(from).fetchSemanticsNode().boundsInRoot.center
    val list = onNodeWithTag(ProgramTags.BLOCKS).fetchSemanticsNode().boundsInRoot.topLeft
    onNodeWithTag(ProgramTags.BLOCKS).performTouchInput { down(start - list) }
    pass(800)
    onNodeWithTag(ProgramTags.BLOCKS).performTouchInput { moveTo(to - list) }
    pass(100)
    if (!holds) letGo()
}

/** The finger that carries goes up. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.letGo() {
    onNodeWithTag(ProgramTags.BLOCKS).performTouchInput { up() }
    pass(200)
}

/** Where [tag] is on the screen. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.placeOf(tag: String): Rect = onNodeWithTag(tag).fetchSemanticsNode().boundsInRoot

/** The tag of the socket with [label] in [text], the first one. */
internal fun socketOf(text: String, label: String): String {
    val start = text.indexOf(label)
    return "socket-$start-${start + label.length}"
}

/** Gives the blocks the keyboard's focus. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.focusBlocks() {
    onNodeWithTag(ProgramTags.BLOCK_PANE).performSemanticsAction(SemanticsActions.RequestFocus)
    pass(100)
}
