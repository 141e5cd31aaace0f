package robotran.ui.workshop

import androidx.compose.runtime.Immutable
import org.jetbrains.compose.resources.StringResource

/**
 * One sentence at the lower edge of the screen that stays until it is read, or until another comes.
 *
 * @property text the sentence, with [arguments].
 * @property plain a sentence in a pupil's language that comes from elsewhere, in place of [text].
 * @property action what can be done about it, null for nothing.
 * @property onAction does it.
 * @property bad whether something went wrong.
 */
@Immutable
class Notice(
    val text: StringResource?,
    val arguments: List<Any> = emptyList(),
    val plain: String = "",
    val action: StringResource? = null,
    val bad: Boolean = false,
    val onAction: () -> Unit = {},
)
