package robotran.uikit

import androidx.compose.material3.LocalContentColor
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.darkColorScheme
import androidx.compose.material3.lightColorScheme
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Density

/** Whether animations are reduced. */
val LocalLessMotion = staticCompositionLocalOf { false }

/**
 * [content] in [colours], calm greys with one accent colour.
 *
 * @param textScale by how much text is larger than the system's.
 * @param lessMotion see [LocalLessMotion].
 */
@Composable
fun KitTheme(
    colours: RobotranColours,
    textScale: Float = 1f,
    lessMotion: Boolean = false,
    content: @Composable () -> Unit,
) {
    val base = if (colours.isDark) darkColorScheme() else lightColorScheme()
    val scheme = base.copy(
        primary = RobotranColours.YELLOW,
        onPrimary = RobotranColours.ON_YELLOW,
        secondary = colours.focus,
        background = colours.pane,
        onBackground = colours.onPane,
        surface = colours.pane,
        onSurface = colours.onPane,
        surfaceContainer = colours.pane,
        surfaceContainerHigh = colours.pane,
        onSurfaceVariant = colours.quiet,
        secondaryContainer = colours.desk,
        onSecondaryContainer = colours.onPane,
        outline = colours.line,
        outlineVariant = colours.line,
        error = colours.error,
        errorContainer = colours.errorPane,
    )
    val density = LocalDensity.current
    CompositionLocalProvider(
        LocalRobotranColours provides colours,
        LocalLessMotion provides lessMotion,
        LocalDensity provides Density(density.density, density.fontScale * textScale),
    ) {
        MaterialTheme(colorScheme = scheme) {
            CompositionLocalProvider(LocalContentColor provides colours.onPane) { FocusWindow { content() } }
        }
    }
}
