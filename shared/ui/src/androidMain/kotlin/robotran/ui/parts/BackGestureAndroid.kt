package robotran.ui.parts

import androidx.activity.compose.BackHandler
import androidx.compose.runtime.Composable

@Composable
internal actual fun BackGesture(count: Int, onBack: () -> Unit) = BackHandler(count > 0, onBack)
