package robotran.web.window

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.font.createFontFamilyResolver
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import robotran.ui.theme.emojiFont
import kotlin.time.Duration.Companion.seconds

/**
 * Downloads an emoji font when the first text with an emoji appears. In a browser Skia has only the fonts of the page,
 * and most pupils never need this one.
 */
internal class PageFonts {
    /** Resolves the app's fonts and the emoji font; null until an emoji has appeared. */
    var withEmoji: FontFamily.Resolver? by mutableStateOf(null)
        private set

    private val scope = CoroutineScope(Dispatchers.Main)
    private var isAsked = false

    /** Searches [texts], which are currently on the screen, for emoji. */
    fun look(texts: Sequence<String>) {
        if (isAsked || texts.none(::holdsEmoji)) return
        isAsked = true
        scope.launch {
            try {
                withEmoji = loadEmoji()
            } catch (_: Exception) {
                // The network is down or has a captive portal. The texts are still readable.
                delay(PAUSE)
                isAsked = false
            }
        }
    }

    /** A new resolver makes Compose lay out all texts again, since old layouts keep their missing glyphs. */
    private suspend fun loadEmoji(): FontFamily.Resolver {
        val font = emojiFont()
        // Skia searches all loaded fonts for a character that the requested font lacks.
        return createFontFamilyResolver().apply { preload(FontFamily(font)) }
    }

    private companion object {
        val PAUSE = 10.seconds
    }
}

/** Whether [text] contains a character that only the emoji font has. */
private fun holdsEmoji(text: String): Boolean = text.any { letter -> EMOJI.any { letter in it } }

/** Symbols of one UTF-16 unit, the emoji variation selector, and the high surrogates of all other emoji. */
private val EMOJI = listOf(
    '\u231A'..'\u23FA',
    '\u2600'..'\u2712',
    // Without the check mark 2713, which is in the code font.
    '\u2714'..'\u27BF',
    '\u2B05'..'\u2B55',
    '\u20E3'..'\u20E3',
    '\uFE0F'..'\uFE0F',
    '\uD83C'..'\uD83E',
)
