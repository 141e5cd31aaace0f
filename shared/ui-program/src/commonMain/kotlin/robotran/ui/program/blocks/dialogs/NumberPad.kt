package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*

/**
 * A number pad, so that no on-screen keyboard is needed.
 *
 * @param isLow whether there is room for two rows only.
 * @param decimalSign what stands on the key of the point.
 * @param onKey receives what [TypedNumber.with] takes.
 */
@Composable
internal fun NumberPad(keyWidth: Dp, isLow: Boolean, decimalSign: Char, onDone: () -> Unit, onKey: (Char) -> Unit) =
    Column(verticalArrangement = Arrangement.spacedBy(GAP)) {
        for (row in if (isLow) LOW_ROWS else ROWS) {
            Row(Modifier.height(IntrinsicSize.Min), Arrangement.spacedBy(GAP)) {
                for (key in row) {
                    val label = if (key == POINT) decimalSign else key
                    PadKey("$label", ProgramTags.digit(key), keyWidth, spokenFor(key, decimalSign), signOf(key)) {
                        onKey(key)
                    }
                }
                if (isLow && row == LOW_ROWS.last()) DoneKey(keyWidth, onDone)
            }
        }
        if (!isLow) {
            Row(Modifier.height(IntrinsicSize.Min), Arrangement.spacedBy(GAP)) {
                val half = keyWidth * 2 + GAP
                PadKey("0", ProgramTags.DIGIT_0, half, "0") { onKey('0') }
                DoneKey(half, onDone)
            }
        }
    }

@Composable
private fun DoneKey(width: Dp, onDone: () -> Unit) =
    PadKey("✓", ProgramTags.NUMBER_DONE, width, BlockTexts.done(spoken), ThinIcons.CHECK, onDone)

@Composable
private fun PadKey(label: String, tag: String, width: Dp, spoken: String, sign: Icon? = null, onClick: () -> Unit) =
    DialogButton(label, tag, Modifier.width(width).fillMaxHeight(), spoken, sign = sign, onClick = onClick)

/** The width of a pad with keys of [keyWidth]; [isLow] as in [NumberPad]. */
internal fun padWidth(keyWidth: Dp, isLow: Boolean): Dp {
    val columns = if (isLow) LOW_ROWS.first().size else ROWS.first().size
    return keyWidth * columns + GAP * (columns - 1)
}

@Composable
private fun spokenFor(key: Char, decimalSign: Char): String = when (key) {
    TypedNumber.ERASE -> BlockTexts.digitErase(spoken)
    POINT -> if (decimalSign == POINT) BlockTexts.digitPoint(spoken) else BlockTexts.digitComma(spoken)
    '-' -> BlockTexts.digitSign(spoken)
    else -> "$key"
}

/** Drawn, since few fonts have it. */
private fun signOf(key: Char): Icon? = if (key == TypedNumber.ERASE) ThinIcons.ERASE else null

/** As on a telephone the low digits come first; the last column has what is no digit. */
private val ROWS = listOf("123${TypedNumber.ERASE}", "456-", "789.").map { it.toList() }
private val LOW_ROWS = listOf("12345-${TypedNumber.ERASE}", "67890.").map { it.toList() }
private val GAP = 4.dp

/** The key of the decimal sign. */
private const val POINT = '.'
