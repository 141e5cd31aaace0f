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
 * Fetches a font with emoji when the first text that holds one is there: in a browser Skia has no fonts but those that
 * the page brings, and most pupils never need this one.
 */
internal class PageFonts {
    /** What finds the app's fonts and that of the emoji; null as long as no emoji was seen. */
    var withEmoji: FontFamily.Resolver? by mutableStateOf(null)
        private set

    private val scope = CoroutineScope(Dispatchers.Main)
    private var isAsked = false

    /** Looks for emoji in [texts], which are on the screen now. */
    fun look(texts: Sequence<String>) {
        if (isAsked || texts.none(::holdsEmoji)) return
        isAsked = true
        scope.launch {
            try {
                withEmoji = loadEmoji()
            } catch (_: Exception) {
                // The network is away, or sends a page of its own. The texts can be read all the same.
                delay(PAUSE)
                isAsked = false
            }
        }
    }

    /**
     * Texts that are laid out already keep their boxes, so that this is a new resolver, which has all laid out anew.
     */
    private suspend fun loadEmoji(): FontFamily.Resolver {
        val font = emojiFont()
        // Skia looks for a letter that the wanted font does not have in all fonts that were loaded.
        return createFontFamilyResolver().apply { preload(FontFamily(font)) }
    }

    private companion object {
        val PAUSE = 10.seconds
    }
}

/** Whether any of [text] is among the signs that only a font for emoji has. */
private fun holdsEmoji(text: String): Boolean = text.any { letter -> EMOJI.any { letter in it } }

/** Symbols of one UTF-16 unit, what makes the sign before it an emoji, and the first halves of all other emoji. */
private val EMOJI = listOf(
    '\u231A'..'\u23FA',
    '\u2600'..'\u2712',
    // Not the tick 2713, which is in the font of code.
    '\u2714'..'\u27BF',
    '\u2B05'..'\u2B55',
    '\u20E3'..'\u20E3',
    '\uFE0F'..'\uFE0F',
    '\uD83C'..'\uD83E',
)
