package robotran.uikit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import androidx.compose.ui.window.DialogProperties
import androidx.compose.ui.window.Dialog as Window

/**
 * A dialog over the workshop: its title, [content], [notice] in sight below it, and buttons at the bottom. Escape and a
 * touch outside close it.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
fun Dialog(
    title: String,
    onClose: () -> Unit,
    buttons: @Composable () -> Unit,
    notice: (@Composable () -> Unit)? = null,
    content: @Composable ColumnScope.() -> Unit,
) = DialogWindow(onClose) {
    DialogCard(title, KitTags.DOCUMENT_DIALOG, Modifier.widthIn(max = 520.dp)) {
        Column(Modifier.padding(24.dp), Arrangement.spacedBy(16.dp)) {
            DialogTitle(title)
            Column(
                Modifier.weight(1f, fill = false).verticalScroll(rememberScrollState()),
                Arrangement.spacedBy(12.dp),
                content = content,
            )
            notice?.invoke()
            FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp, Alignment.End)) { buttons() }
        }
    }
}

/**
 * A dialog of several steps, which is as large as its card. Escape closes it; a touch outside only if
 * [closesByTouchOutside].
 */
@Composable
fun StepsDialog(onClose: () -> Unit, closesByTouchOutside: Boolean, card: @Composable (Modifier) -> Unit) =
    DialogWindow(
        onClose,
        // The default width would be too narrow for a phone on its side.
        DialogProperties(dismissOnClickOutside = closesByTouchOutside, usePlatformDefaultWidth = false),
    ) { card(Modifier.padding(16.dp)) }

/** The [content] of one step of a [StepsDialog]. It has one size for all steps, so its buttons stay where they are. */
@Composable
fun StepsCard(
    title: String,
    tag: String,
    size: DpSize,
    modifier: Modifier = Modifier,
    maxTitleLines: Int = Int.MAX_VALUE,
    content: @Composable ColumnScope.() -> Unit,
) = DialogCard(title, tag, modifier.sized(size)) {
    Column(Modifier.padding(20.dp), Arrangement.spacedBy(12.dp)) {
        DialogTitle(title, maxTitleLines)
        content()
    }
}

/** The ground of a dialog with [title], which only screen readers get. */
@Composable
fun DialogCard(title: String, tag: String, modifier: Modifier = Modifier, content: @Composable () -> Unit) =
    Surface(modifier.testTag(tag).semantics { paneTitle = title }, Shapes.SHEET, content = content)

/** The title of a dialog, to read. */
@Composable
fun DialogTitle(title: String, maxLines: Int = Int.MAX_VALUE) = Text(
    title,
    Modifier.heading(),
    TextStyles.dialogTitle,
    maxLines = maxLines,
    overflow = TextOverflow.Ellipsis,
)

/** The size of a dialog for all its steps. With large text it is higher, and wider as long as lines do not get too long. */
@Composable
fun Modifier.sized(size: DpSize): Modifier {
    val scale = LocalDensity.current.fontScale
    return size(size.width * minOf(scale, MAX_WIDENING), size.height * scale)
}

/** A dialog that can show user text, with the fonts of [WithAddedFonts]. */
@Composable
fun DialogWindow(
    onClose: () -> Unit,
    properties: DialogProperties = DialogProperties(),
    content: @Composable () -> Unit,
) = Window(onClose, properties) { WithAddedFonts { FocusWindow { content() } } }

/** An explanatory sentence. */
@Composable
fun Explanation(label: String, modifier: Modifier = Modifier, bad: Boolean = false) {
    val colours = LocalRobotranColours.current
    Text(label, modifier, TextStyles.label, color = if (bad) colours.error else colours.onPane)
}

private const val MAX_WIDENING = 1.4f
