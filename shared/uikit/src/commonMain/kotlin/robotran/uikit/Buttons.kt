package robotran.uikit

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.RowScope
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.ButtonDefaults
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.material3.Button as MaterialButton

/**
 * A button with words.
 *
 * @param kind what it is for, which is how it looks.
 * @param help the action in a sentence, for screen readers.
 */
@Composable
fun Button(
    label: String,
    tag: String,
    kind: ButtonKind = ButtonKind.PRIMARY,
    modifier: Modifier = Modifier,
    enabled: Boolean = true,
    style: TextStyle = kind.style,
    help: String? = null,
    onClick: () -> Unit,
) = ButtonFrame(
    tag,
    kind,
    if (help == null) modifier else modifier.semantics { onClick(label = help, action = null) },
    enabled,
    onClick = onClick,
) { Text(label, style = style, textAlign = TextAlign.Center) }

/** A button with any content, which names it unless [modifier] does. */
@Composable
fun ButtonFrame(
    tag: String,
    kind: ButtonKind = ButtonKind.PRIMARY,
    modifier: Modifier = Modifier,
    enabled: Boolean = true,
    padding: PaddingValues = kind.form.padding,
    border: BorderStroke? = kind.border(enabled),
    onClick: () -> Unit,
    content: @Composable RowScope.() -> Unit,
) = MaterialButton(
    onClick,
    modifier
        .testTag(tag)
        .focusRing(kind.form.ring)
        .defaultMinSize(kind.form.minHeight, kind.form.minHeight),
    enabled,
    kind.form.shape,
    kind.colours(),
    if (kind.tone == ButtonTone.YELLOW) ButtonDefaults.buttonElevation() else null,
    border,
    padding,
    content = content,
)

/** The size of a button with [text], for measuring. */
@Composable
fun ButtonSize(text: String) = Box(
    Modifier.defaultMinSize(Dimensions.TARGET, Dimensions.TARGET).padding(ButtonForm.CARD.padding),
    Alignment.Center,
) { Text(text, style = ButtonKind.PRIMARY.style, textAlign = TextAlign.Center) }

@Composable
private fun ButtonKind.colours() = LocalRobotranColours.current.let {
    when (tone) {
        ButtonTone.YELLOW -> ButtonDefaults.buttonColors(RobotranColours.YELLOW, RobotranColours.ON_YELLOW)
        ButtonTone.LINK -> ButtonDefaults.textButtonColors(contentColor = it.focus, disabledContentColor = it.quiet)
        ButtonTone.STRONG_FRAME -> ButtonDefaults.outlinedButtonColors(
            contentColor = it.onPane,
            disabledContentColor = it.quiet.copy(alpha = DISABLED),
        )

        else -> ButtonDefaults.textButtonColors(contentColor = it.onPane)
    }
}

@Composable
private fun ButtonKind.border(enabled: Boolean): BorderStroke? = when (tone) {
    ButtonTone.FRAME -> edge(LocalRobotranColours.current.quiet)
    ButtonTone.FINE_FRAME -> edge()
    ButtonTone.STRONG_FRAME -> if (enabled) edge(LocalRobotranColours.current.onPane, Space.HAIR) else edge()
    else -> null
}

private const val DISABLED = 0.6f
