package robotran.workshop.state

import androidx.compose.runtime.Immutable
import kotlinx.serialization.Serializable
import robotran.language.Language

/**
 * What a person has chosen for this machine, whatever they work on.
 *
 * @property language what the app speaks; null for what the machine speaks.
 * @property textScale how much larger than usual all text is, 1..2.
 * @property codeSize how large program text is, in sp, 10..40.
 * @property lessMotion whether things appear at their place at once.
 * @property site the address of the site that links lead to, where the app has none of its own; empty if nobody has
 * named one.
 */
@Immutable
@Serializable
data class Settings(
    val language: Language? = null,
    val theme: AppTheme = AppTheme.SYSTEM,
    val textScale: Float = 1f,
    val codeSize: Float = DEFAULT_CODE_SIZE,
    val soundOn: Boolean = true,
    val lessMotion: Boolean = false,
    val site: String = "",
) {
    companion object {
        const val DEFAULT_CODE_SIZE = 15f
    }
}

enum class AppTheme { SYSTEM, LIGHT, DARK, HIGH_CONTRAST, HIGH_CONTRAST_DARK }
