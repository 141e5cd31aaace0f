package robotran.ui.program.blocks

import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.compose.ui.test.performSemanticsAction
import robotran.ui.program.write
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.workshop.Workshop
import robotran.workshop.blocks.ProgramView
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.WorkshopEvent
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

@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.showInBlocks(workshop: Workshop, text: String) {
    workshop.handle(WorkshopEvent.PaneChosen(Pane.PROGRAM))
    workshop.write(text, caret = 0)
    workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
    pass(300)
}

/** Touches [tag] and lets the screen follow. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.touch(tag: String) {
    onNodeWithTag(tag).performClick()
    pass(200)
}

/** The same for something that may have to be scrolled to. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.scrollAndTouch(tag: String) {
    onNodeWithTag(tag).performScrollTo()
    pass(200)
    touch(tag)
}

/** The tag of the socket with [words] in [text], the first one. */
internal fun socketOf(text: String, words: String): String {
    val start = text.indexOf(words)
    return "socket-$start-${start + words.length}"
}

/** Gives the blocks the keyboard's focus. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.focusBlocks() {
    onNodeWithTag("block-pane").performSemanticsAction(SemanticsActions.RequestFocus)
    pass(100)
}
