package robotran.ui.parts

import androidx.compose.runtime.Composable

/** There is none. */
@Composable
internal actual fun BackGesture(count: Int, onBack: () -> Unit) = Unit
