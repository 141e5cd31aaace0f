package robotran.ui.workshop

import androidx.compose.runtime.Immutable

/**
 * The project as a document.
 *
 * @property name what the pupil calls it; empty as long as it has none.
 */
@Immutable
data class DocumentState(val name: String = "")
