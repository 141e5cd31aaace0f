package robotran.ui.sheet

import androidx.compose.ui.graphics.ImageBitmap

/** Android notices changes of a bitmap by itself. */
internal actual fun ImageBitmap.finished(): ImageBitmap = this
