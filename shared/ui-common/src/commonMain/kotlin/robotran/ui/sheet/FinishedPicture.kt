package robotran.ui.sheet

import androidx.compose.ui.graphics.ImageBitmap

/** The same bitmap, which is not drawn into any more, so that a platform can keep it where it draws. */
internal expect fun ImageBitmap.finished(): ImageBitmap
