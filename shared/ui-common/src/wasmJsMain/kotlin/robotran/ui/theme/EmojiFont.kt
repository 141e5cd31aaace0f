package robotran.ui.theme

import androidx.compose.ui.text.font.Font
import androidx.compose.ui.text.platform.Font
import org.jetbrains.compose.resources.ExperimentalResourceApi
import robotran.ui.resources.*

/** Downloads the emoji font, which Compose does not load by itself. */
@OptIn(ExperimentalResourceApi::class)
suspend fun emojiFont(): Font = Font("Noto Emoji", Res.readBytes("files/noto_emoji.ttf"))
