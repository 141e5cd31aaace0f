package robotran.ui.parts

import androidx.compose.runtime.Composable

/**
 * Back, as phones and tablets have it: [onBack] is done instead of leaving the app while [enabled]. Of several, the one that was composed
 * last counts. Menus and dialogs close by themselves. Platforms without it do nothing.
 */
@Composable
internal expect fun BackGesture(enabled: Boolean = true, onBack: () -> Unit)
