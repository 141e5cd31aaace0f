package robotran.ui.program.blocks.sheets

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.blocks_digit_erase
import robotran.ui.resources.blocks_digit_point
import robotran.ui.resources.blocks_digit_sign

/** A number pad, so that no on-screen keyboard is needed. [onKey] receives what [TypedNumber.with] takes. */
@Composable
internal fun NumberPad(onKey: (Char) -> Unit) = Column(verticalArrangement = Arrangement.spacedBy(6.dp)) {
    for (row in ROWS) {
        Row(horizontalArrangement = Arrangement.spacedBy(6.dp)) {
            for (key in row) {
                SheetButton("$key", "digit-$key", Modifier.width(KEY_WIDTH), spokenFor(key)) { onKey(key) }
            }
        }
    }
}

@Composable
private fun spokenFor(key: Char): String = when (key) {
    TypedNumber.ERASE -> stringResource(Res.string.blocks_digit_erase)
    '.' -> stringResource(Res.string.blocks_digit_point)
    '-' -> stringResource(Res.string.blocks_digit_sign)
    else -> "$key"
}

/** As on a telephone the low digits come first; the last column has what is no digit. */
private val ROWS = listOf("123${TypedNumber.ERASE}", "456-", "789.", "0").map { it.toList() }
private val KEY_WIDTH = 60.dp
