package robotran.ui.parts

import androidx.compose.runtime.Composable

/**
 * Back, as phones, tablets and browsers have it: [onBack] is done instead of leaving the app while there is something
 * to close. Of several, the one that was composed last counts. Menus and dialogs close by themselves. Platforms without
 * it do nothing.
 *
 * @param count how many times in a row Back finds something to close here.
 */
@Composable
internal expect fun BackGesture(count: Int = 1, onBack: () -> Unit)
