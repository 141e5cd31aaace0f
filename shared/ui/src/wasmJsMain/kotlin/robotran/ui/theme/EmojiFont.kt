package robotran.ui.theme

import androidx.compose.ui.text.font.Font
import androidx.compose.ui.text.platform.Font
import org.jetbrains.compose.resources.ExperimentalResourceApi
import robotran.ui.resources.Res

/** Fetches the font with emoji, which is not among those that Compose fetches by itself. */
@OptIn(ExperimentalResourceApi::class)
suspend fun emojiFont(): Font = Font("Noto Emoji", Res.readBytes("files/noto_emoji.ttf"))
