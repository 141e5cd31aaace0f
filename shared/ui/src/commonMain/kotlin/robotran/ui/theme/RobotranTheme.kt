package robotran.ui.theme

import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.darkColorScheme
import androidx.compose.material3.lightColorScheme
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider

/** Calm greys, one accent: everything inside is drawn light or [dark]. */
@Composable
fun RobotranTheme(dark: Boolean = isSystemInDarkTheme(), content: @Composable () -> Unit) {
    val colours = if (dark) RobotranColours.DARK else RobotranColours.LIGHT
    val base = if (dark) darkColorScheme() else lightColorScheme()
    val scheme = base.copy(
        primary = RobotranColours.YELLOW,
        onPrimary = RobotranColours.ON_YELLOW,
        secondary = colours.focus,
        background = colours.pane,
        onBackground = colours.onPane,
        surface = colours.pane,
        onSurface = colours.onPane,
        onSurfaceVariant = colours.quiet,
        outline = colours.line,
        outlineVariant = colours.line,
        error = colours.mistake,
        errorContainer = colours.mistakePane,
    )
    CompositionLocalProvider(LocalRobotranColours provides colours) {
        MaterialTheme(colorScheme = scheme, content = content)
    }
}
