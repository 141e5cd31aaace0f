package robotran.ui.workshop

import androidx.compose.runtime.Immutable

/**
 * How the world is shown.
 *
 * @property zoom how much larger than when the whole sheet is seen.
 */
@Immutable
data class SheetViewState(val zoom: Float = 1f)
