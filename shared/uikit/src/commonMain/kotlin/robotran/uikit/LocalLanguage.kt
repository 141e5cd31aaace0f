package robotran.uikit

import androidx.compose.runtime.Composable
import androidx.compose.runtime.ReadOnlyComposable
import androidx.compose.runtime.staticCompositionLocalOf
import robotran.language.Language

val LocalLanguage = staticCompositionLocalOf { Language.ENGLISH }

/** The language of what the screen says. */
val spoken: Language
    @Composable
    @ReadOnlyComposable
    get() = LocalLanguage.current
