package robotran.uikit

import androidx.compose.runtime.Composable

/**
 * Back on phones, tablets and browsers: calls [onBack] instead of leaving the app while something can be closed. The
 * handler composed last has priority. Menus and dialogs handle Back themselves. Does nothing on platforms without Back.
 *
 * @param count how many times in a row Back can close something here.
 */
@Composable
expect fun BackGesture(count: Int = 1, onBack: () -> Unit)
