package robotran.uikit

import androidx.activity.compose.BackHandler
import androidx.compose.runtime.Composable

@Composable
actual fun BackGesture(count: Int, onBack: () -> Unit) = BackHandler(count > 0, onBack)
