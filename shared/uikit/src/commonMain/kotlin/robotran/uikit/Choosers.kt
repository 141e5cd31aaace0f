package robotran.uikit

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp

/** An icon above its label. */
@Composable
fun IconWord(
    icon: Icon,
    word: String,
    tag: String,
    onClick: () -> Unit,
    modifier: Modifier = Modifier,
    chosen: Boolean = false,
) {
    val colour = LocalRobotranColours.current.onPane
    SignWord(word, tag, onClick, modifier, chosen) { IconView(icon, colour) }
}

/**
 * The same with any content as icon.
 *
 * @param lettering how [word] is written, by default as it is.
 */
@Composable
fun SignWord(
    word: String,
    tag: String,
    onClick: () -> Unit,
    modifier: Modifier = Modifier,
    chosen: Boolean = false,
    lettering: SignLettering = SignLettering(word),
    sign: @Composable () -> Unit,
) {
    val colours = LocalRobotranColours.current
    Column(
        modifier
            .testTag(tag)
            .defaultMinSize(60.dp, 56.dp)
            .focusRing()
            .clip(Shapes.MEDIUM)
            .background(if (chosen) colours.runningLine else Color.Transparent)
            .clickable(role = Role.Button, onClick = onClick)
            .named(word)
            .padding(horizontal = SIGN_PADDING, vertical = 6.dp),
        Arrangement.spacedBy(3.dp, Alignment.CenterVertically),
        Alignment.CenterHorizontally,
    ) {
        sign()
        Text(
            lettering.text,
            style = TextStyle(fontSize = TextSizes.SIGN * lettering.scale, lineHeight = LineHeights.SIGN),
            textAlign = TextAlign.Center,
            maxLines = MAX_SIGN_LINES,
        )
    }
}

/** Beside what is in a [SignWord]. */
val SIGN_PADDING = 4.dp

/** A choice of several options, side by side. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
fun <T> ChipRow(title: String, choices: List<Pair<T, String>>, chosen: T, tag: String, onChoose: (T) -> Unit) {
    val colours = LocalRobotranColours.current
    Column(Modifier.fillMaxWidth().padding(top = 8.dp), Arrangement.spacedBy(4.dp)) {
        if (title.isNotEmpty()) Text(title, style = TextStyles.compact)
        FlowRow(Modifier.selectableGroup(), Arrangement.spacedBy(8.dp), Arrangement.spacedBy(4.dp)) {
            choices.forEachIndexed { place, (value, word) ->
                val isChosen = value == chosen
                Box(
                    Modifier
                        .testTag(KitTags.at(tag, place))
                        .defaultMinSize(Dimensions.TARGET, Dimensions.TARGET)
                        .focusRing()
                        .clip(Shapes.MEDIUM)
                        .background(if (isChosen) colours.onPane else colours.pane)
                        .border(1.dp, colours.quiet, Shapes.MEDIUM)
                        .selectable(isChosen, role = Role.RadioButton) { onChoose(value) }
                        .padding(horizontal = 12.dp, vertical = 8.dp),
                    Alignment.Center,
                ) { Text(word, style = TextStyles.compact, color = if (isChosen) colours.pane else colours.onPane) }
            }
        }
    }
}

/** A choice of many options, behind a button that shows the selected one. */
@Composable
fun <T> MenuRow(title: String, choices: List<Pair<T, String>>, shown: String, tag: String, onChoose: (T) -> Unit) {
    val colours = LocalRobotranColours.current
    var open by remember { mutableStateOf(false) }
    Row(Modifier.fillMaxWidth().padding(top = 4.dp), Arrangement.spacedBy(8.dp), Alignment.CenterVertically) {
        if (title.isNotEmpty()) Text(title, Modifier.weight(1f), TextStyles.compact)
        Box {
            Row(
                Modifier
                    .testTag(tag)
                    .defaultMinSize(minHeight = Dimensions.TARGET)
                    .focusRing()
                    .clip(Shapes.MEDIUM)
                    .border(1.dp, colours.quiet, Shapes.MEDIUM)
                    .clickable(role = Role.DropdownList) { open = true }
                    .semantics { contentDescription = if (title.isEmpty()) shown else "$title: $shown" }
                    .padding(horizontal = 12.dp),
                Arrangement.spacedBy(6.dp),
                Alignment.CenterVertically,
            ) {
                Text(
                    shown,
                    Modifier.weight(1f, fill = false),
                    TextStyles.compact,
                    maxLines = 2,
                    overflow = TextOverflow.Ellipsis,
                )
                IconView(EditIcons.DOWN, colours.onPane, size = 18.dp)
            }
            AppMenu(open, { open = false }) {
                choices.forEachIndexed { place, (value, word) ->
                    MenuItem(word, KitTags.at(tag, place)) {
                        open = false
                        onChoose(value)
                    }
                }
            }
        }
    }
}
