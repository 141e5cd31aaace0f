package robotran.ui.theme

import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.darkColorScheme
import androidx.compose.material3.lightColorScheme
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Density
import robotran.workshop.state.AppTheme
import robotran.workshop.state.Settings

/** Whether animations are reduced. */
val LocalLessMotion = staticCompositionLocalOf { false }

/**
 * The app's theme, calm greys with one accent colour: light, [dark] or from [settings].
 *
 * @param lessMotion see [LocalLessMotion].
 */
@Composable
fun RobotranTheme(
    dark: Boolean = isSystemInDarkTheme(),
    settings: Settings = Settings(),
    lessMotion: Boolean = settings.lessMotion == true,
    content: @Composable () -> Unit,
) {
    val colours = coloursOf(settings.theme, dark)
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
        LocalDensity provides Density(density.density, density.fontScale * settings.textScale),
    ) {
        MaterialTheme(colorScheme = scheme) { FocusWindow { content() } }
    }
}

/** The colours of [theme]; [dark] is whether the system is dark. */
fun coloursOf(theme: AppTheme, dark: Boolean): RobotranColours = when (theme) {
    AppTheme.SYSTEM -> if (dark) RobotranColours.DARK else RobotranColours.LIGHT
    AppTheme.LIGHT -> RobotranColours.LIGHT
    AppTheme.DARK -> RobotranColours.DARK
    AppTheme.HIGH_CONTRAST -> RobotranColours.HIGH_CONTRAST
    AppTheme.HIGH_CONTRAST_DARK -> RobotranColours.HIGH_CONTRAST_DARK
}
