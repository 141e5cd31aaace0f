package robotran.uikit

import androidx.compose.runtime.Composable

/** The desktop has no Back gesture. */
@Composable
actual fun BackGesture(count: Int, onBack: () -> Unit) = Unit
