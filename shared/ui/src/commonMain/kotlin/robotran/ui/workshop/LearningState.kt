package robotran.ui.workshop

import androidx.compose.runtime.Immutable

/**
 * What is being learned from.
 *
 * @property page what is shown; null for nothing but the workshop.
 */
@Immutable
data class LearningState(val page: LearningPage? = null)
