package robotran.ui.program.blocks

import androidx.compose.foundation.BorderStroke
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
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.Button
import androidx.compose.material3.ButtonDefaults
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Surface
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import robotran.ui.empty.EmptyPicture
import robotran.ui.empty.EmptyPictureView
import robotran.ui.texts.BlockTexts
import robotran.ui.texts.ScreenTexts
import robotran.uikit.*
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.event.BlockEvent

/** The button that opens the palette where there is no room for a rail. Without words, it has a plus. */
@Composable
internal fun AddBar(scope: BlockScope, hasWords: Boolean) {
    val words = BlockTexts.add(spoken)
    Box(Modifier.fillMaxWidth().padding(12.dp), Alignment.CenterEnd) {
        Button(
            { scope.show(BlockDialog.Palette) },
            Modifier
                .heightIn(min = Dimensions.TARGET)
                .testTag("blocks-add")
                .focusRing(24.dp)
                .semantics { contentDescription = words },
            colors = ButtonDefaults.buttonColors(
                MaterialTheme.colorScheme.primary,
                MaterialTheme.colorScheme.onPrimary,
            ),
            contentPadding = if (hasWords) ButtonDefaults.ContentPadding else PaddingValues(horizontal = 16.dp),
        ) {
            if (hasWords) {
                Text(words, fontSize = TextSizes.BODY, fontWeight = FontWeight.Medium)
            } else {
                SignPicture(Plus, MaterialTheme.colorScheme.onPrimary, PLUS)
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
                .testTag("blocks-add")
                .focusRing()
                .clickable(role = Role.Button) { scope.show(BlockDialog.Palette) }
                .padding(4.dp),
            Arrangement.spacedBy(6.dp, Alignment.CenterVertically),
            Alignment.CenterHorizontally,
        ) {
            Box(
                Modifier.size(BADGE).background(MaterialTheme.colorScheme.primary, Shapes.SMALL),
                Alignment.Center,
            ) { SignPicture(Plus, MaterialTheme.colorScheme.onPrimary, PLUS) }
            Text(
                BlockTexts.add(spoken),
                color = colours.onPane,
                fontSize = TextSizes.SIGN,
                lineHeight = LineHeights.SIGN,
                textAlign = TextAlign.Center,
            )
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
            color = colours.onPane,
            fontSize = TextSizes.BODY,
            lineHeight = LineHeights.BODY,
        )
    }
}

/** Why an edit was impossible, over the lower end of the blocks. */
@Composable
internal fun EditErrorBar(sentence: String, scope: BlockScope) {
    val colours = LocalRobotranColours.current
    Surface(
        Modifier.fillMaxWidth().padding(8.dp),
        Shapes.MEDIUM,
        colours.errorPane,
        border = BorderStroke(1.dp, colours.error),
    ) {
        Row(
            Modifier.defaultMinSize(minHeight = Dimensions.TARGET).padding(start = 16.dp).testTag("blocks-error"),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            Text(
                sentence,
                Modifier.weight(1f).semantics { liveRegion = LiveRegionMode.Polite },
                color = colours.onPane,
                fontSize = TextSizes.BODY,
            )
            IconTouch(Icon.CLOSE, ScreenTexts.noticeClose(spoken), "blocks-error-close", {
                scope.onEvent(BlockEvent.ErrorDismissed)
            })
        }
    }
}

private val HINT_WIDTH = 420.dp
private val BADGE = 34.dp
private val PLUS = 16.dp
