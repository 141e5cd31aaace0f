package robotran.ui.theme

import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.runtime.Composable
import robotran.uikit.*
import robotran.workshop.state.AppTheme
import robotran.workshop.state.Settings

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
) = KitTheme(coloursOf(settings.theme, dark), settings.textScale, lessMotion, content)

/** The colours of [theme]; [dark] is whether the system is dark. */
fun coloursOf(theme: AppTheme, dark: Boolean): RobotranColours = when (theme) {
    AppTheme.SYSTEM -> if (dark) RobotranColours.DARK else RobotranColours.LIGHT
    AppTheme.LIGHT -> RobotranColours.LIGHT
    AppTheme.DARK -> RobotranColours.DARK
    AppTheme.HIGH_CONTRAST -> RobotranColours.HIGH_CONTRAST
    AppTheme.HIGH_CONTRAST_DARK -> RobotranColours.HIGH_CONTRAST_DARK
}
