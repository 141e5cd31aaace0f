package robotran.ui.sheet

import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.asSkiaBitmap

/** Skia copies a bitmap that may change each time it is drawn. */
internal actual fun ImageBitmap.finished(): ImageBitmap = also { it.asSkiaBitmap().setImmutable() }
