package robotran.ui.parts

import androidx.compose.runtime.Composable

/** The desktop has no Back gesture. */
@Composable
internal actual fun BackGesture(count: Int, onBack: () -> Unit) = Unit
