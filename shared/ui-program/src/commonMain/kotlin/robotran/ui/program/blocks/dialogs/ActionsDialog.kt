package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.LocalClipboardManager
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.dp
import robotran.blockediting.Block
import robotran.blockediting.BlockEdit
import robotran.blockediting.BlockEditResult
import robotran.blockediting.BlockId
import robotran.blockediting.apply
import robotran.blockediting.formsFor
import robotran.language.source.SourceSpan
import robotran.robolang.words.LineForm
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*

/**
 * What can be done to the block [id], or to all selected ones if it is among them: the usual actions, all others behind a
 * button, and deleting apart from them.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun ActionsDialog(id: BlockId, scope: BlockScope, onClose: () -> Unit, modifier: Modifier) {
    val block = scope.state.program[id] ?: return
    val clipboard = LocalClipboardManager.current
    val actions = actionsOn(block, scope, clipboard, clipboardReader())
    var showsMore by remember(id) { mutableStateOf(false) }
    val act = { action: BlockAction ->
        onClose()
        action.act()
    }
    BlockDialogFrame(scope.wordsOf(block.head), onClose, modifier) {
        UsualActions(actions.usual, act)
        DialogButton(BlockTexts.moreActions(spoken), ProgramTags.ACTIONS_MORE, isChosen = showsMore) {
            showsMore = !showsMore
        }
        if (showsMore) {
            Forms(block, scope)
            FlowRow(
                horizontalArrangement = Arrangement.spacedBy(Space.SMALL),
                verticalArrangement = Arrangement.spacedBy(Space.SMALL),
            ) {
                for (action in actions.more) {
                    DialogButton(action.words(spoken), ProgramTags.action(action.tag)) { act(action) }
                }
            }
        }
        HorizontalDivider()
        DeleteRow(actions.delete, act)
    }
}

/** Two in a row, or one if words are large. */
@Composable
private fun UsualActions(actions: List<BlockAction>, onAct: (BlockAction) -> Unit) {
    val inRow = if (LocalDensity.current.fontScale > TWO_UP_TO) 1 else 2
    for (row in actions.chunked(inRow)) {
        Row(Modifier.fillMaxWidth().height(IntrinsicSize.Max), Arrangement.spacedBy(Space.SMALL)) {
            for (action in row) UsualAction(action, Modifier.weight(1f).fillMaxHeight()) { onAct(action) }
            repeat(inRow - row.size) { Spacer(Modifier.weight(1f)) }
        }
    }
}

@Composable
private fun UsualAction(action: BlockAction, modifier: Modifier, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    val frame = modifier.clip(Shapes.MEDIUM).border(1.dp, colours.quiet, Shapes.MEDIUM)
    SignedAction(action, colours.onPane, frame, onClick)
}

/** Deleting, in a row of its own, so that no finger touches it instead of something else. */
@Composable
private fun DeleteRow(action: BlockAction, onAct: (BlockAction) -> Unit) =
    SignedAction(action, LocalRobotranColours.current.error, Modifier.clip(Shapes.MEDIUM)) { onAct(action) }

/** A sign with its words beside it. */
@Composable
private fun SignedAction(action: BlockAction, colour: Color, modifier: Modifier, onClick: () -> Unit) {
    val words = action.words(spoken)
    Row(
        Modifier
            .testTag(ProgramTags.action(action.tag))
            .focusRing()
            .then(modifier)
            .defaultMinSize(minHeight = Dimensions.TARGET)
            .clickable(role = Role.Button, onClick = onClick)
            .named(words)
            .padding(horizontal = Space.MEDIUM, vertical = Space.SMALL),
        Arrangement.spacedBy(Space.MEDIUM),
        Alignment.CenterVertically,
    ) {
        action.sign?.let { IconView(it, colour) }
        Text(words, style = TextStyles.label.medium, color = colour)
    }
}

/** The other forms that the line can take, each as it would read then. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Forms(block: Block, scope: BlockScope) {
    val forms = block.head.form?.let { formsFor(it) }.orEmpty()
    val changes = remember(block, scope.state.program) { forms.mapNotNull { changeTo(it, block, scope) } }
    if (changes.isEmpty()) return
    DialogHeading(BlockTexts.forms(spoken))
    FlowRow(
        horizontalArrangement = Arrangement.spacedBy(Space.SMALL),
        verticalArrangement = Arrangement.spacedBy(Space.SMALL),
    ) {
        changes.forEachIndexed { index, (words, edit) ->
            DialogButton(words, ProgramTags.form(index)) {
                scope.show(null)
                scope.edit(edit)
            }
        }
    }
}

/** The line after it has taken [form], and the edit; null if it cannot. */
private fun changeTo(form: LineForm, block: Block, scope: BlockScope): Pair<String, BlockEdit>? {
    val edit = BlockEdit.ChangeForm(block.head.index, form)
    val done = apply(scope.state.program, edit) as? BlockEditResult.Success ?: return null
    val line = done.program.outline.lines[block.head.index]
    return SourceSpan(line.parts.first().span.start, line.parts.last().span.end).textIn(done.program.text) to edit
}

/** With larger text the words of two actions do not fit side by side. */
private const val TWO_UP_TO = 1.5f
