package robotran.ui.program.blocks

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import robotran.ui.empty.EmptyPicture
import robotran.ui.empty.EmptyPictureView
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.event.BlockEvent

/** The button that opens the palette where there is no room for a rail. Without words, it has a plus. */
@Composable
internal fun AddBar(scope: BlockScope, hasWords: Boolean) {
    val words = BlockTexts.add(spoken)
    Box(Modifier.fillMaxWidth().padding(12.dp), Alignment.CenterEnd) {
        ButtonFrame(
            ProgramTags.BLOCKS_ADD,
            ButtonKind.DIALOG_MAIN,
            Modifier.named(words),
            padding = PaddingValues(horizontal = if (hasWords) Space.PAGE else Space.LARGE),
            onClick = { scope.show(BlockDialog.Palette) },
        ) {
            if (hasWords) {
                Text(words, style = TextStyles.body.medium)
            } else {
                IconView(ThinIcons.PLUS, RobotranColours.ON_YELLOW, size = PLUS)
            }
        }
    }
}

/** The same in a rail beside the blocks, where a button over them would hide most of them. */
@Composable
internal fun AddRail(scope: BlockScope, modifier: Modifier) {
    val colours = LocalRobotranColours.current
    Box(modifier.background(colours.desk)) {
        Column(
            Modifier
                .fillMaxSize()
                .testTag(ProgramTags.BLOCKS_ADD)
                .focusRing()
                .clickable(role = Role.Button) { scope.show(BlockDialog.Palette) }
                .padding(4.dp),
            Arrangement.spacedBy(6.dp, Alignment.CenterVertically),
            Alignment.CenterHorizontally,
        ) {
            Box(
                Modifier.size(BADGE).background(RobotranColours.YELLOW, Shapes.SMALL),
                Alignment.Center,
            ) { IconView(ThinIcons.PLUS, RobotranColours.ON_YELLOW, size = PLUS) }
            Text(BlockTexts.add(spoken), style = TextStyles.signLines, textAlign = TextAlign.Center)
        }
    }
}

/** What to do first in a program without blocks, where its first block will be. */
@Composable
internal fun FirstBlockHint(hasRail: Boolean) {
    val colours = LocalRobotranColours.current
    val shape = BlockShape(notch = null, bump = null, isOpenAbove = false, isOpenBelow = false)
    val outline = BlockOutline(colours.quiet, 2.dp, isDashed = true)
    Column(
        Modifier.padding(start = BlockSizes.GUTTER, top = Space.LARGE, end = Space.PAGE).widthIn(max = HINT_WIDTH),
        Arrangement.spacedBy(Space.MEDIUM),
    ) {
        EmptyPictureView(EmptyPicture.BLOCK)
        Text(
            if (hasRail) BlockTexts.firstFromRail(spoken) else BlockTexts.first(spoken),
            Modifier.drawBehind { drawBlock(shape, Color.Transparent, Color.Transparent, outline) }.padding(20.dp),
            TextStyles.sentence,
        )
    }
}

/** Why an edit was impossible, over the lower end of the blocks. */
@Composable
internal fun EditErrorBar(sentence: String, scope: BlockScope) {
    val colours = LocalRobotranColours.current
    Surface(Modifier.fillMaxWidth().padding(8.dp), color = colours.errorPane, border = edge(colours.error)) {
        Row(
            Modifier.defaultMinSize(
                minHeight = Dimensions.TARGET,
            ).padding(start = 16.dp).testTag(ProgramTags.BLOCKS_ERROR),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            Text(sentence, Modifier.weight(1f).announced(), TextStyles.body)
            IconButton(Icon.CLOSE, CommonTexts.noticeClose(spoken), ProgramTags.BLOCKS_ERROR_CLOSE) {
                scope.onEvent(BlockEvent.ErrorDismissed)
            }
        }
    }
}

private val HINT_WIDTH = 420.dp
private val BADGE = 34.dp
private val PLUS = 16.dp
